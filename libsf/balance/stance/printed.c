// SPDX-License-Identifier: MIT
// The connected pieces of what is printed so far, layer by layer.
//
// The sets are those of voxel/layered.h. A piece is kept for each that stands on the bed or that
// the latest layer has voxels of; others float, and nothing can reach them any more. Where sets
// grow together all is added to the root: integer sums, boxes, and, of pieces that stand, the
// corners of their hulls on the bed, whose hull is that of both. Pieces keep their order, old ones
// first. So memory is the runs of two layers, a record for each piece, and few more corners than
// the hulls have.
//
// Moments are kept for each piece: those of the layer as a whole let a piece that leans be balanced
// by one that it is not connected with.

#include "balance/stance/printed.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "voxel/rect.h"

#include <string.h>

// ---------------------------------------------------------------------------------------------
// The pieces of a layer
// ---------------------------------------------------------------------------------------------

// Sums over the voxels of a run, each `weight` times at twice the height `middle`.
static void add_run(sfi_piece *piece, const sf_run *run, uint32_t layer, uint64_t weight,
                    uint64_t middle)
{
    uint64_t n = run->x1 - run->x0, twice_x = (uint64_t)run->x0 + run->x1 - 1;
    sf_rect rect = {run->x0, run->y, run->x1, run->y + 1};
    sfi_exact mass = sfi_exact_widen(n, weight);
    piece->voxels += n;
    piece->mass = sfi_exact_add(piece->mass, mass);
    piece->x = sfi_exact_add(piece->x, sfi_exact_widen(n * twice_x / 2, weight));
    piece->y = sfi_exact_add(piece->y, sfi_exact_widen(n * run->y, weight));
    piece->z = sfi_exact_add(piece->z, sfi_exact_times(mass, (int64_t)middle));
    piece->box = sfi_box_union(piece->box, rect, layer);
}

// A piece for each node of the sets, those of the layer with what its runs weigh.
static sf_status add_pieces(sfi_printed *p, const sfi_layer *layer)
{
    const sfi_layered *sets = &p->sets;
    if (!sfi_grow_array(&sets->allocator, (void **)&p->list, &p->capacity, sets->count,
                        sizeof *p->list)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < sets->old; i++) {
        p->list[i].is_here = p->list[i].is_new = 0;
    }
    for (uint32_t i = sets->old; i < sets->count; i++) {
        sfi_piece fresh = {.is_on_bed = layer->is_bed != 0, .is_here = 1, .is_new = 1};
        p->list[i] = fresh;
    }
    for (size_t i = 0; i < sets->here.count; i++) {
        const sf_run *run = &sets->here.runs[i];
        add_run(&p->list[run->label], run, layer->index, layer->top - layer->bottom,
                layer->top + layer->bottom);
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// What they stand on
// ---------------------------------------------------------------------------------------------

static sf_status reserve_corners(sfi_printed *p, size_t more)
{
    size_t need;
    if (!sfi_size_add(p->corner_count, more, &need)) {
        return SF_ERR_OVERFLOW;
    }
    return sfi_grow_array(&p->sets.allocator, (void **)&p->corners, &p->corner_capacity, need,
                          sizeof *p->corners)
               ? SF_OK
               : SF_ERR_MEMORY;
}

static int is_root(const sfi_printed *p, uint32_t i)
{
    return sfi_layered_root(&p->sets, i) == i;
}

// Count the corners of each set that gets a new hull: from its runs in the bed layer, from its
// members' hulls above. Returns how many in all.
static size_t count_gathered(sfi_printed *p, const sfi_layer *layer)
{
    size_t total = 0;
    for (uint32_t i = 0; i < p->sets.count; i++) {
        p->list[i].gathered = 0;
    }
    for (size_t i = 0; layer->is_bed && i < p->sets.here.count; i++) {
        p->list[sfi_layered_root(&p->sets, p->sets.here.runs[i].label)].gathered += 4;
    }
    for (uint32_t i = 0; i < p->sets.old; i++) {
        if (!is_root(p, i)) {
            p->list[sfi_layered_root(&p->sets, i)].gathered += p->list[i].corners;
        }
    }
    for (uint32_t i = 0; i < p->sets.count; i++) {
        sfi_piece *piece = &p->list[i];
        if (is_root(p, i) && piece->gathered > 0) {
            piece->gathered += piece->corners;
            piece->start = piece->end = p->corner_count + total;
            total += piece->gathered;
        }
    }
    return total;
}

// Append the corners of a run's rectangle, or of a hull, to those of a set.
static void append_run(sfi_printed *p, sfi_piece *root, const sf_run *run)
{
    for (int i = 0; i < 4; i++) {
        sfi_corner c = {i & 1 ? run->x1 : run->x0, (int64_t)run->y + i / 2, 0};
        p->corners[root->end++] = c;
    }
}

static void append_hull(sfi_printed *p, sfi_piece *root, const sfi_piece *piece)
{
    if (root->gathered > 0 && piece->corners > 0) {
        memcpy(p->corners + root->end, p->corners + piece->first,
               piece->corners * sizeof *p->corners);
        root->end += piece->corners;
    }
}

// Move the hulls of roots together, into an array that has room for them.
static sf_status compact(sfi_printed *p)
{
    size_t at = 0;
    if (!sfi_grow_array(&p->sets.allocator, (void **)&p->spare_corners, &p->spare_corner_capacity,
                        p->corner_count, sizeof *p->corners)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < p->sets.count; i++) {
        sfi_piece *piece = &p->list[i];
        if (is_root(p, i) && piece->corners > 0) {
            memcpy(p->spare_corners + at, p->corners + piece->first,
                   piece->corners * sizeof *p->corners);
            piece->first = at;
            at += piece->corners;
        }
    }
    sfi_corner *corners = p->corners;
    size_t capacity = p->corner_capacity;
    p->corners = p->spare_corners;
    p->corner_capacity = p->spare_corner_capacity;
    p->spare_corners = corners;
    p->spare_corner_capacity = capacity;
    p->corner_count = at;
    return SF_OK;
}

// Find the hulls of sets that have grown together, and of those that begin on the bed.
static sf_status gather(sfi_printed *p, const sfi_layer *layer)
{
    size_t total = count_gathered(p, layer);
    if (total == 0) {
        return SF_OK;
    }
    SF_TRY(reserve_corners(p, total));
    for (size_t i = 0; layer->is_bed && i < p->sets.here.count; i++) {
        append_run(p, &p->list[sfi_layered_root(&p->sets, p->sets.here.runs[i].label)],
                   &p->sets.here.runs[i]);
    }
    for (uint32_t i = 0; i < p->sets.old; i++) {
        append_hull(p, &p->list[sfi_layered_root(&p->sets, i)], &p->list[i]);
    }
    for (uint32_t i = 0; i < p->sets.count; i++) {
        sfi_piece *piece = &p->list[i];
        if (is_root(p, i) && piece->gathered > 0) {
            piece->first = piece->start;
            piece->corners = sfi_polygon_hull(p->corners + piece->start, piece->gathered);
        }
    }
    p->corner_count += total;
    return compact(p);
}

// ---------------------------------------------------------------------------------------------
// One layer
// ---------------------------------------------------------------------------------------------

// Add all nodes to their roots.
static void absorb(sfi_printed *p)
{
    for (uint32_t i = 0; i < p->sets.count; i++) {
        sfi_piece *piece = &p->list[i], *root = &p->list[sfi_layered_root(&p->sets, i)];
        if (root != piece) {
            root->voxels += piece->voxels;
            root->mass = sfi_exact_add(root->mass, piece->mass);
            root->x = sfi_exact_add(root->x, piece->x);
            root->y = sfi_exact_add(root->y, piece->y);
            root->z = sfi_exact_add(root->z, piece->z);
            root->is_on_bed |= piece->is_on_bed;
            root->is_here |= piece->is_here;
            root->is_new &= piece->is_new;
            root->box = sfi_box_join(root->box, piece->box);
        }
    }
}

// Keep the roots that can still grow or that stand, and forget all other nodes.
static sf_status renumber(sfi_printed *p)
{
    const sf_allocator *a = &p->sets.allocator;
    uint32_t kept = 0, count = p->sets.count;
    if (!sfi_grow_array(a, (void **)&p->spare, &p->spare_capacity, count, sizeof *p->spare) ||
        !sfi_grow_array(a, (void **)&p->number, &p->number_capacity, count, sizeof *p->number)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < count; i++) {
        if (is_root(p, i) && (p->list[i].is_on_bed || p->list[i].is_here)) {
            p->spare[kept] = p->list[i];
            p->number[i] = kept++;
        }
    }
    sfi_piece *list = p->list;
    size_t capacity = p->capacity;
    p->list = p->spare;
    p->capacity = p->spare_capacity;
    p->spare = list;
    p->spare_capacity = capacity;
    sfi_layered_settle(&p->sets, p->number, kept);
    return SF_OK;
}

sf_status sfi_printed_add(sfi_printed *p, sf_slice slice, const sfi_layer *layer)
{
    SF_TRY(sfi_layered_push(&p->sets, slice));
    SF_TRY(add_pieces(p, layer));
    SF_TRY(gather(p, layer));
    absorb(p);
    return renumber(p);
}

void sfi_printed_release(sfi_printed *p)
{
    sf_allocator a = p->sets.allocator;
    sfi_layered_release(&p->sets);
    sfi_free_array(&a, p->list, p->capacity, sizeof *p->list);
    sfi_free_array(&a, p->spare, p->spare_capacity, sizeof *p->spare);
    sfi_free_array(&a, p->number, p->number_capacity, sizeof *p->number);
    sfi_free_array(&a, p->corners, p->corner_capacity, sizeof *p->corners);
    sfi_free_array(&a, p->spare_corners, p->spare_corner_capacity, sizeof *p->spare_corners);
}
