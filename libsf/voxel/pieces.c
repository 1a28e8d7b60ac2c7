// SPDX-License-Identifier: MIT
// Connected pieces of a grid, by its runs.
//
// As components.c does for a slice: runs are joined in a forest (voxel/run_forest.h), and one pass
// in order turns parents into numbers. Two runs touch when their rows are neighbours, in one layer
// or in two, and their intervals overlap, or, where corners connect, overlap once one of them is
// widened by a voxel. Rows of a layer are found by walking all of its runs together with those of
// the rows that touch them, so nothing but the runs themselves takes memory.

#include "voxel/pieces.h"

#include "base/memory.h"
#include "base/status.h"
#include "voxel/run_forest.h"
#include "voxel/slice.h"

#include <string.h>

// ---------------------------------------------------------------------------------------------
// Joining
// ---------------------------------------------------------------------------------------------

// A place in the runs of a layer that moves on from row to row.
typedef struct cursor {
    size_t at, end; // runs of the layer that are left
} cursor;

// Runs of row y, all of which lie at or behind the cursor; it moves behind those of earlier rows.
static cursor row_at(const sf_run *runs, cursor *layer, uint32_t y)
{
    while (layer->at < layer->end && runs[layer->at].y < y) {
        layer->at++;
    }
    cursor row = *layer;
    row.end = row.at;
    while (row.end < layer->end && runs[row.end].y == y) {
        row.end++;
    }
    return row;
}

static void join_rows(sf_run *runs, cursor a, cursor b, uint32_t slack)
{
    while (a.at < a.end && b.at < b.end) {
        const sf_run *p = &runs[a.at], *q = &runs[b.at];
        if (p->x0 < q->x1 + slack && q->x0 < p->x1 + slack) {
            sfi_run_join(runs, (uint32_t)a.at, (uint32_t)b.at);
        }
        // Whichever ends first meets nothing further: behind a run comes at least one voxel that is
        // of none.
        *(p->x1 < q->x1 ? &a.at : &b.at) += 1;
    }
}

// Join the rows of one layer with those rows of another that are `dy` further on.
static void join_layers(sf_run *runs, cursor here, cursor there, int dy, uint32_t slack)
{
    while (here.at < here.end) {
        uint32_t y = runs[here.at].y;
        cursor row = row_at(runs, &here, y);
        here.at = row.end;
        if (dy >= 0 || y > 0) {
            join_rows(runs, row, row_at(runs, &there, y + (uint32_t)dy), slack);
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Runs
// ---------------------------------------------------------------------------------------------

static void complement(sf_slice dst, sf_slice src)
{
    size_t words = sfi_row_words(src.width);
    for (uint32_t y = 0; y < src.height; y++) {
        const uint64_t *in = sfi_slice_row(src, y);
        uint64_t *out = sfi_slice_row(dst, y);
        for (size_t i = 0; i < words; i++) {
            out[i] = ~in[i];
        }
        out[words - 1] &= sfi_tail_mask(src.width);
    }
}

static sf_status add_runs(sf_slice slice, const sf_allocator *allocator, sfi_pieces *p)
{
    size_t need, all;
    SF_TRY(sf_slice_run_count(slice, &need));
    if (!sfi_size_add(p->run_count, need, &all) || all >= UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (need == 0) {
        return SF_OK;
    }
    if (!sfi_grow_array(allocator, (void **)&p->runs, &p->run_capacity, all, sizeof *p->runs)) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(sf_slice_runs(slice, p->runs + p->run_count, need, &need));
    for (size_t i = p->run_count; i < all; i++) {
        p->runs[i].label = (uint32_t)i;
    }
    p->run_count = all;
    return SF_OK;
}

static void join_layer(sfi_pieces *p, uint32_t k, uint32_t slack)
{
    int reach = slack != 0;
    cursor here = {p->first[k], p->first[k + 1]};
    join_layers(p->runs, here, here, 1, slack);
    if (k == 0) {
        return;
    }
    cursor below = {p->first[k - 1], p->first[k]};
    for (int dy = -reach; dy <= reach; dy++) {
        join_layers(p->runs, here, below, dy, slack);
    }
}

static sf_status collect(const sf_grid *grid, sfi_pieces_of what, sf_slice empty,
                         const sf_allocator *allocator, sf_task *task, sfi_pieces *p)
{
    for (uint32_t k = 0; k < p->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        if (what == SFI_PIECES_EMPTY) {
            complement(empty, slice);
            slice = empty;
        }
        SF_TRY(add_runs(slice, allocator, p));
        p->first[k + 1] = p->run_count;
        join_layer(p, k, what == SFI_PIECES_SOLID);
    }
    for (size_t i = 0; i < p->run_count; i++) {
        sf_run *run = &p->runs[i];
        run->label = run->label == i ? p->count++ : p->runs[run->label].label;
    }
    return SF_OK;
}

sf_status sfi_pieces_create(const sf_grid *grid, sfi_pieces_of what, const sf_allocator *allocator,
                            sf_task *task, sfi_pieces *pieces)
{
    memset(pieces, 0, sizeof *pieces);
    pieces->lattice = sf_grid_lattice(grid);
    sf_slice empty = sf_grid_slice(grid, 0);
    empty.stride = sfi_row_words(empty.width);
    size_t words = empty.stride * empty.height; // no more than a slice of the grid
    empty.words = sfi_alloc_array(allocator, words, sizeof *empty.words);
    pieces->first =
        sfi_alloc_array(allocator, (size_t)pieces->lattice.nz + 1, sizeof *pieces->first);
    sf_status status = SF_ERR_MEMORY;
    if (empty.words != NULL && pieces->first != NULL) {
        pieces->first[0] = 0;
        status = collect(grid, what, empty, allocator, task, pieces);
    }
    sfi_free_array(allocator, empty.words, words, sizeof *empty.words);
    if (status != SF_OK) {
        sfi_pieces_destroy(pieces, allocator);
    }
    return status;
}

void sfi_pieces_destroy(sfi_pieces *pieces, const sf_allocator *allocator)
{
    sfi_free_array(allocator, pieces->runs, pieces->run_capacity, sizeof *pieces->runs);
    sfi_free_array(allocator, pieces->first, (size_t)pieces->lattice.nz + 1, sizeof *pieces->first);
    memset(pieces, 0, sizeof *pieces);
}

uint32_t sfi_pieces_at(const sfi_pieces *pieces, uint32_t x, uint32_t y, uint32_t k)
{
    size_t low = pieces->first[k], end = pieces->first[k + 1], high = end;
    while (low < high) { // the first run that does not end before the voxel
        size_t middle = low + (high - low) / 2;
        const sf_run *run = &pieces->runs[middle];
        if (run->y < y || (run->y == y && run->x1 <= x)) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    const sf_run *run = &pieces->runs[low];
    return low < end && run->y == y && run->x0 <= x ? run->label : UINT32_MAX;
}
