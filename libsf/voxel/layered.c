// SPDX-License-Identifier: MIT
// Connected sets of voxels that grow layer by layer.
//
// One sweep with union-find over runs. A node of the forest is kept for each set that whoever
// sweeps still has a use for. A layer makes one new node for each of its own components, joins new
// and old nodes where runs touch, and lets the sweep add up what it wants to know of each set in
// its root. Then roots are numbered anew, and old nodes are gone. So memory is the runs of two
// layers and a number for each node.
//
// Through faces a run touches those that it overlaps in the row above it; through edges and corners
// also those of the rows beside that, and those that it meets once widened by a voxel.
//
// Source: R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm", 1975, with
// halving.

#include "voxel/layered.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

static uint32_t find(uint32_t *parent, uint32_t i)
{
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

uint32_t sfi_layered_root(const sfi_layered *sets, uint32_t node)
{
    return find(sets->parent, node);
}

static void join(uint32_t *parent, uint32_t a, uint32_t b)
{
    a = find(parent, a);
    b = find(parent, b);
    parent[a < b ? b : a] = a < b ? a : b;
}

// The runs of a layer, with a component of the layer as label.
static sf_status find_runs(sfi_layered *s, sf_slice slice, uint32_t *components)
{
    size_t need;
    SF_TRY(sf_slice_run_count(slice, &need));
    if (!sfi_grow_array(&s->allocator, (void **)&s->here.runs, &s->here.capacity, need,
                        sizeof *s->here.runs)) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(sf_slice_runs(slice, s->here.runs, s->here.capacity, &s->here.count));
    return sf_runs_label(s->here.runs, s->here.count, s->connectivity, components);
}

// Nodes for the components, after the old ones; labels become nodes.
static sf_status add_nodes(sfi_layered *s, uint32_t components)
{
    size_t need = (size_t)s->old + components;
    if (need >= UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (!sfi_grow_array(&s->allocator, (void **)&s->parent, &s->capacity, need,
                        sizeof *s->parent)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < need; i++) {
        s->parent[i] = i;
    }
    for (size_t i = 0; i < s->here.count; i++) {
        s->here.runs[i].label += s->old;
    }
    s->count = (uint32_t)need;
    return SF_OK;
}

// Join nodes of the layer below with those of this one whose runs touch, `rise` rows apart. Both
// lists are in row order, so two cursors meet every such pair: of two runs the one that ends first
// can touch nothing further.
static void join_rows(sfi_layered *s, int rise, uint32_t slack)
{
    size_t a = 0, b = 0;
    while (a < s->below.count && b < s->here.count) {
        const sf_run *q = &s->below.runs[a], *r = &s->here.runs[b];
        int64_t row = (int64_t)q->y + rise;
        if (row != r->y) {
            *(row < r->y ? &a : &b) += 1;
            continue;
        }
        if (q->x0 < r->x1 + slack && r->x0 < q->x1 + slack) {
            join(s->parent, q->label, r->label);
        }
        *(q->x1 + slack <= r->x1 ? &a : &b) += 1;
    }
}

sf_status sfi_layered_push(sfi_layered *sets, sf_slice slice)
{
    uint32_t components;
    int reach = sets->connectivity == SF_CONNECT_CORNERS;
    SF_TRY(find_runs(sets, slice, &components));
    SF_TRY(add_nodes(sets, components));
    for (int rise = -reach; rise <= reach; rise++) {
        join_rows(sets, rise, (uint32_t)reach);
    }
    return SF_OK;
}

void sfi_layered_settle(sfi_layered *sets, const uint32_t *number, uint32_t count)
{
    for (size_t i = 0; i < sets->here.count; i++) {
        sf_run *run = &sets->here.runs[i];
        run->label = number[find(sets->parent, run->label)];
    }
    sfi_layer_runs runs = sets->below;
    sets->below = sets->here;
    sets->here = runs;
    sets->here.count = 0;
    sets->old = sets->count = count;
}

void sfi_layered_release(sfi_layered *sets)
{
    const sf_allocator *a = &sets->allocator;
    sfi_free_array(a, sets->below.runs, sets->below.capacity, sizeof *sets->below.runs);
    sfi_free_array(a, sets->here.runs, sets->here.capacity, sizeof *sets->here.runs);
    sfi_free_array(a, sets->parent, sets->capacity, sizeof *sets->parent);
    memset(sets, 0, sizeof *sets);
}
