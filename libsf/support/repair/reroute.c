// SPDX-License-Identifier: MIT
// Reroute: take one branch of the supports away and carry what hung on it by a cheaper one.
//
// A branch is an addition u with all additions below that carry nothing else. Its heads are the
// voxels above that have only u. It is worth trying where it begins: where its heads are more than
// one addition. The branch is taken out, the cheapest path from a place that all heads can rest on
// down to what still stands is sought (path.c), and if that is not cheaper the branch goes back.
//
// So each change saves something, and what was support-free stays so: heads rest on the path's
// first cell, cells on the next, and the last one stands; everything else never lost a supporter
// that it needed. This is what draws neighbouring pillars together, which the forest does only
// within a layer. Only for rules that are elements.
//
// A sweep ends early when it has looked at LOOK_MOST cells, in searches and around branches; a roof
// of 1980 x 1980 voxels at layer 100 looks at a sixth of that.
//
// Source: rip-up and reroute is what wires on circuit boards have been improved by since the 1970s.

#include "support/repair/repair.h"

#include "base/memory.h"
#include "base/status.h"
#include "support/check/row.h"
#include "support/repair/path.h"
#include "voxel/slice.h"

#define LOOK_MOST (UINT64_C(1) << 31)

typedef struct router {
    const sfi_job *job;
    sf_grid *grid;
    sfi_path_finder finder;
    sfi_path_cell *cells; // heads, or the branch
    size_t count, capacity;
    sfi_path_cell *heads;
    size_t head_count, head_capacity;
} router;

static sf_status note(router *r, sfi_path_cell **cells, size_t *count, size_t *capacity,
                      sfi_path_cell cell)
{
    void *memory = *cells;
    int good = sfi_grow_array(r->job->allocator, &memory, capacity, *count + 1, sizeof **cells);
    *cells = memory;
    if (good) {
        (*cells)[(*count)++] = cell;
    }
    return good ? SF_OK : SF_ERR_MEMORY;
}

static void flip(const router *r, const sfi_path_cell *at)
{
    uint64_t *row = sfi_slice_row(sf_grid_slice(r->grid, at->k), at->y);
    row[at->x / 64] ^= UINT64_C(1) << (at->x % 64);
}

static int is_addition(const router *r, uint32_t k, uint32_t x, uint32_t y)
{
    return sf_slice_get(sf_grid_slice(r->grid, k), x, y) &&
           !sf_slice_get(sf_grid_slice(r->job->drawn, k), x, y);
}

// heads = voxels above that rest on u alone; at most `most`.
static sf_status find_heads(router *r, const sfi_path_cell *u, size_t most)
{
    const sfi_job *job = r->job;
    r->head_count = 0;
    if (u->k + 1 == job->lattice.nz) {
        return SF_OK;
    }
    const sf_element *e = &r->finder.elements[u->k];
    sf_slice above = sf_grid_slice(r->grid, u->k + 1), slice = sf_grid_slice(r->grid, u->k);
    r->finder.looked += (2 * (uint64_t)e->reach_y + 1) * (2 * (uint64_t)e->half_width[0] + 1);
    for (uint32_t y = u->y > e->reach_y ? u->y - e->reach_y : 0;
         y < above.height && y <= u->y + e->reach_y; y++) {
        uint32_t w = e->half_width[y > u->y ? y - u->y : u->y - y], end = u->x + w + 1;
        const uint64_t *row = sfi_slice_row(above, y);
        end = end < above.width ? end : above.width;
        for (uint32_t x = sfi_row_find(row, end, u->x > w ? u->x - w : 0, 0); x < end;
             x = sfi_row_find(row, end, x + 1, 0)) {
            int is_free =
                job->exempt != NULL && sf_slice_get(sf_grid_slice(job->exempt, u->k + 1), x, y);
            if (!is_free && !sfi_has_other(slice, e, x, y, u->x, u->y)) {
                sfi_path_cell head = {u->k + 1, x, y};
                SF_TRY(note(r, &r->heads, &r->head_count, &r->head_capacity, head));
                if (r->head_count == most) {
                    return SF_OK;
                }
            }
        }
    }
    return SF_OK;
}

// Take u away, and all below it that then carries nothing. `cost` is what that saves.
static sf_status rip(router *r, sfi_path_cell u, uint64_t *cost)
{
    const sfi_job *job = r->job;
    r->count = 0;
    *cost = sfi_job_add(job, u.k, u.x, u.y);
    flip(r, &u);
    SF_TRY(note(r, &r->cells, &r->count, &r->capacity, u));
    for (size_t i = 0; i < r->count; i++) {
        sfi_path_cell at = r->cells[i];
        if (at.k == job->bed) {
            continue;
        }
        const sf_element *e = &r->finder.elements[at.k - 1];
        for (uint32_t y = at.y > e->reach_y ? at.y - e->reach_y : 0;
             y < job->lattice.ny && y <= at.y + e->reach_y; y++) {
            uint32_t w = e->half_width[y > at.y ? y - at.y : at.y - y];
            for (uint32_t x = at.x > w ? at.x - w : 0; x < job->lattice.nx && x <= at.x + w; x++) {
                sfi_path_cell below = {at.k - 1, x, y};
                if (!is_addition(r, below.k, x, y)) {
                    continue;
                }
                SF_TRY(find_heads(r, &below, 1));
                if (r->head_count == 0) {
                    *cost += sfi_job_add(job, below.k, x, y);
                    flip(r, &below);
                    SF_TRY(note(r, &r->cells, &r->count, &r->capacity, below));
                }
            }
        }
    }
    return SF_OK;
}

static sf_status reroute_one(router *r, const sfi_path_cell *u)
{
    SF_TRY(find_heads(r, u, SIZE_MAX));
    if (r->head_count == 1 && is_addition(r, r->heads[0].k, r->heads[0].x, r->heads[0].y)) {
        return SF_OK; // not where a branch begins
    }
    uint64_t cost;
    SF_TRY(rip(r, *u, &cost));
    // Ripping asked for heads of others. With u gone, the same voxels are those with no supporter.
    flip(r, u);
    SF_TRY(find_heads(r, u, SIZE_MAX));
    flip(r, u);
    r->finder.count = 0;
    if (r->head_count > 0) {
        SF_TRY(sfi_path_find(&r->finder, u->k, r->heads, r->head_count, cost));
        for (size_t i = 0; r->finder.count == 0 && i < r->count; i++) {
            flip(r, &r->cells[i]);
        }
    }
    for (uint32_t i = 0; i < r->finder.count; i++) {
        flip(r, &r->finder.cells[i]);
    }
    return SF_OK;
}

static sf_status reroute_layer(router *r, uint32_t k, sfi_sweep *sweep)
{
    sf_slice slice = sf_grid_slice(r->grid, k), drawn = sf_grid_slice(r->job->drawn, k);
    SF_TRY(sfi_sweep_layer(sweep));
    for (uint32_t y = 0; y < slice.height && r->finder.looked < LOOK_MOST; y++) {
        SF_TRY(sfi_sweep_pause(sweep));
        const uint64_t *row = sfi_slice_row(slice, y), *given = sfi_slice_row(drawn, y);
        for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
            for (uint64_t w = row[i] & ~given[i]; w != 0; w &= w - 1) {
                sfi_path_cell u = {k, (uint32_t)i * 64 + sfi_lowest_bit(w), y};
                // A path of this layer's may have taken it away.
                if (is_addition(r, u.k, u.x, u.y)) {
                    SF_TRY(reroute_one(r, &u));
                }
            }
        }
    }
    return SF_OK;
}

sf_status sfi_reroute(const sfi_job *job, sf_grid *result)
{
    router r = {.job = job, .grid = result};
    sf_status status = sfi_path_finder_create(job, &r.finder);
    r.finder.grid = result;
    sfi_sweep sweep = sfi_sweep_begin(job->pace, job->lattice.nz - job->bed);
    for (uint32_t k = job->lattice.nz; status == SF_OK && k-- > job->bed;) {
        status = reroute_layer(&r, k, &sweep);
    }
    sfi_path_finder_destroy(&r.finder);
    sfi_free_array(job->allocator, r.cells, r.capacity, sizeof *r.cells);
    sfi_free_array(job->allocator, r.heads, r.head_capacity, sizeof *r.heads);
    return status;
}
