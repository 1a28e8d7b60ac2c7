// SPDX-License-Identifier: MIT
// The connected pieces of what is printed so far, layer by layer.
//
// One sweep with union-find over runs. A record, a node of the forest, is kept for each piece that
// stands on the bed or that the latest layer has voxels of; others float, and nothing can reach
// them any more. A layer makes one new node for each of its own components, joins new and old nodes
// where runs touch, and adds all nodes to their roots: integer sums, boxes, and, of pieces that
// stand, the corners of their hulls on the bed, whose hull is that of both. Then roots are numbered
// anew, old ones first and in their order, and old nodes are gone. So memory is the runs of two
// layers, a record for each piece, and few more corners than the hulls have.
//
// Moments are kept for each piece: those of the layer as a whole let a piece that leans be balanced
// by one that it is not connected with.
//
// Source of the forest: R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm",
// 1975.

#include "balance/pieces.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <string.h>

// ---------------------------------------------------------------------------------------------
// Forest
// ---------------------------------------------------------------------------------------------

static uint32_t find(sfi_piece *p, uint32_t i)
{
    while (p[i].parent != i) {
        p[i].parent = p[p[i].parent].parent;
        i = p[i].parent;
    }
    return i;
}

// The lower index becomes the root, so that old pieces keep their order.
static void join(sfi_piece *p, uint32_t a, uint32_t b)
{
    a = find(p, a);
    b = find(p, b);
    p[a < b ? b : a].parent = a < b ? a : b;
}

static void widen(sf_box *box, const sf_box *other)
{
    box->x0 = other->x0 < box->x0 ? other->x0 : box->x0;
    box->y0 = other->y0 < box->y0 ? other->y0 : box->y0;
    box->z0 = other->z0 < box->z0 ? other->z0 : box->z0;
    box->x1 = other->x1 > box->x1 ? other->x1 : box->x1;
    box->y1 = other->y1 > box->y1 ? other->y1 : box->y1;
    box->z1 = other->z1 > box->z1 ? other->z1 : box->z1;
}

// ---------------------------------------------------------------------------------------------
// The pieces of a layer
// ---------------------------------------------------------------------------------------------

static sf_status find_runs(sfi_pieces *p, sf_slice slice, uint32_t *components)
{
    size_t need;
    SF_TRY(sf_slice_run_count(slice, &need));
    if (!sfi_grow_array(&p->allocator, (void **)&p->here.runs, &p->here.capacity, need,
                        sizeof *p->here.runs)) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(sf_slice_runs(slice, p->here.runs, p->here.capacity, &p->here.count));
    return sf_runs_label(p->here.runs, p->here.count, p->connectivity, components);
}

// Sums over the voxels of a run, each `weight` times at twice the height `middle`.
static void add_run(sfi_piece *piece, const sf_run *run, uint32_t layer, uint64_t weight,
                    uint64_t middle)
{
    uint64_t n = run->x1 - run->x0, twice_x = (uint64_t)run->x0 + run->x1 - 1;
    sf_box box = {run->x0, run->y, layer, run->x1, run->y + 1, layer + 1};
    sfi_exact mass = sfi_exact_widen(n, weight);
    piece->voxels += n;
    piece->mass = sfi_exact_add(piece->mass, mass);
    piece->x = sfi_exact_add(piece->x, sfi_exact_widen(n * twice_x / 2, weight));
    piece->y = sfi_exact_add(piece->y, sfi_exact_widen(n * run->y, weight));
    piece->z = sfi_exact_add(piece->z, sfi_exact_times(mass, (int64_t)middle));
    widen(&piece->box, &box);
}

// One node for each component of the layer, after the old ones; labels become nodes.
static sf_status add_nodes(sfi_pieces *p, uint32_t components, const sfi_layer *layer)
{
    size_t need = (size_t)p->old + components;
    if (need >= UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (!sfi_grow_array(&p->allocator, (void **)&p->list, &p->capacity, need, sizeof *p->list)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < p->old; i++) {
        p->list[i].is_here = p->list[i].is_new = 0;
    }
    for (uint32_t i = p->old; i < need; i++) {
        sfi_piece fresh = {.parent = i,
                           .number = UINT32_MAX,
                           .is_on_bed = layer->is_bed != 0,
                           .is_here = 1,
                           .is_new = 1,
                           .box = {UINT32_MAX, UINT32_MAX, UINT32_MAX, 0, 0, 0}};
        p->list[i] = fresh;
    }
    for (size_t i = 0; i < p->here.count; i++) {
        sf_run *run = &p->here.runs[i];
        run->label += p->old;
        add_run(&p->list[run->label], run, layer->index, layer->top - layer->bottom,
                layer->top + layer->bottom);
    }
    p->count = (uint32_t)need;
    return SF_OK;
}

// Join nodes of the layer below with those of this one whose runs touch, `rise` rows apart. Both
// lists are in row order, so two cursors meet every such pair: of two runs the one that ends first
// can touch nothing further.
static void join_rows(sfi_pieces *p, int rise, uint32_t slack)
{
    size_t a = 0, b = 0;
    while (a < p->below.count && b < p->here.count) {
        const sf_run *q = &p->below.runs[a], *r = &p->here.runs[b];
        int64_t row = (int64_t)q->y + rise;
        if (row != r->y) {
            *(row < r->y ? &a : &b) += 1;
            continue;
        }
        if (q->x0 < r->x1 + slack && r->x0 < q->x1 + slack) {
            join(p->list, q->label, r->label);
        }
        *(q->x1 + slack <= r->x1 ? &a : &b) += 1;
    }
}

// ---------------------------------------------------------------------------------------------
// What they stand on
// ---------------------------------------------------------------------------------------------

static sf_status reserve_corners(sfi_pieces *p, size_t more)
{
    size_t need;
    if (!sfi_size_add(p->corner_count, more, &need)) {
        return SF_ERR_OVERFLOW;
    }
    return sfi_grow_array(&p->allocator, (void **)&p->corners, &p->corner_capacity, need,
                          sizeof *p->corners)
               ? SF_OK
               : SF_ERR_MEMORY;
}

static int is_root(const sfi_pieces *p, uint32_t i)
{
    return p->list[i].parent == i;
}

// Count the corners of each set that gets a new hull: from its runs in the bed layer, from its
// members' hulls above. Returns how many in all.
static size_t count_gathered(sfi_pieces *p, const sfi_layer *layer)
{
    size_t total = 0;
    for (uint32_t i = 0; i < p->count; i++) {
        p->list[i].gathered = 0;
    }
    for (size_t i = 0; layer->is_bed && i < p->here.count; i++) {
        p->list[find(p->list, p->here.runs[i].label)].gathered += 4;
    }
    for (uint32_t i = 0; i < p->old; i++) {
        if (!is_root(p, i)) {
            p->list[find(p->list, i)].gathered += p->list[i].corners;
        }
    }
    for (uint32_t i = 0; i < p->count; i++) {
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
static void append_run(sfi_pieces *p, sfi_piece *root, const sf_run *run)
{
    for (int i = 0; i < 4; i++) {
        sfi_corner c = {i & 1 ? run->x1 : run->x0, (int64_t)run->y + i / 2, 0};
        p->corners[root->end++] = c;
    }
}

static void append_hull(sfi_pieces *p, sfi_piece *root, const sfi_piece *piece)
{
    if (root->gathered > 0 && piece->corners > 0) {
        memcpy(p->corners + root->end, p->corners + piece->first,
               piece->corners * sizeof *p->corners);
        root->end += piece->corners;
    }
}

// Move the hulls of roots together, into an array that has room for them.
static sf_status compact(sfi_pieces *p)
{
    size_t at = 0;
    if (!sfi_grow_array(&p->allocator, (void **)&p->spare_corners, &p->spare_corner_capacity,
                        p->corner_count, sizeof *p->corners)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < p->count; i++) {
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
static sf_status gather(sfi_pieces *p, const sfi_layer *layer)
{
    size_t total = count_gathered(p, layer);
    if (total == 0) {
        return SF_OK;
    }
    SF_TRY(reserve_corners(p, total));
    for (size_t i = 0; layer->is_bed && i < p->here.count; i++) {
        append_run(p, &p->list[find(p->list, p->here.runs[i].label)], &p->here.runs[i]);
    }
    for (uint32_t i = 0; i < p->old; i++) {
        append_hull(p, &p->list[find(p->list, i)], &p->list[i]);
    }
    for (uint32_t i = 0; i < p->count; i++) {
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
static void absorb(sfi_pieces *p)
{
    for (uint32_t i = 0; i < p->count; i++) {
        sfi_piece *piece = &p->list[i], *root = &p->list[find(p->list, i)];
        if (root != piece) {
            root->voxels += piece->voxels;
            root->mass = sfi_exact_add(root->mass, piece->mass);
            root->x = sfi_exact_add(root->x, piece->x);
            root->y = sfi_exact_add(root->y, piece->y);
            root->z = sfi_exact_add(root->z, piece->z);
            root->is_on_bed |= piece->is_on_bed;
            root->is_here |= piece->is_here;
            root->is_new &= piece->is_new;
            widen(&root->box, &piece->box);
        }
    }
}

// Number the roots that can still grow or that stand, and forget all other nodes.
static sf_status renumber(sfi_pieces *p)
{
    uint32_t kept = 0;
    if (!sfi_grow_array(&p->allocator, (void **)&p->spare, &p->spare_capacity, p->count,
                        sizeof *p->spare)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < p->count; i++) {
        sfi_piece *piece = &p->list[i];
        if (is_root(p, i) && (piece->is_on_bed || piece->is_here)) {
            p->spare[kept] = *piece;
            p->spare[kept].parent = kept;
            p->spare[kept].number = UINT32_MAX;
            piece->number = kept++;
        }
    }
    for (size_t i = 0; i < p->here.count; i++) {
        sf_run *run = &p->here.runs[i];
        run->label = p->list[find(p->list, run->label)].number;
    }
    sfi_piece *list = p->list;
    size_t capacity = p->capacity;
    p->list = p->spare;
    p->capacity = p->spare_capacity;
    p->spare = list;
    p->spare_capacity = capacity;
    p->old = p->count = kept;
    sfi_layer_runs runs = p->below;
    p->below = p->here;
    p->here = runs;
    return SF_OK;
}

sf_status sfi_pieces_add(sfi_pieces *p, sf_slice slice, const sfi_layer *layer)
{
    uint32_t components;
    int reach = p->connectivity == SF_CONNECT_CORNERS;
    SF_TRY(find_runs(p, slice, &components));
    SF_TRY(add_nodes(p, components, layer));
    for (int rise = -reach; rise <= reach; rise++) {
        join_rows(p, rise, (uint32_t)reach);
    }
    SF_TRY(gather(p, layer));
    absorb(p);
    return renumber(p);
}

void sfi_pieces_release(sfi_pieces *p)
{
    const sf_allocator *a = &p->allocator;
    sfi_free_array(a, p->below.runs, p->below.capacity, sizeof *p->below.runs);
    sfi_free_array(a, p->here.runs, p->here.capacity, sizeof *p->here.runs);
    sfi_free_array(a, p->list, p->capacity, sizeof *p->list);
    sfi_free_array(a, p->spare, p->spare_capacity, sizeof *p->spare);
    sfi_free_array(a, p->corners, p->corner_capacity, sizeof *p->corners);
    sfi_free_array(a, p->spare_corners, p->spare_corner_capacity, sizeof *p->spare_corners);
}
