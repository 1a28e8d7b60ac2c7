// SPDX-License-Identifier: MIT
// Traps and cups: voids that nothing can leave, and voids that are shut while they print.
//
// Let E_k be the empty voxels of the layers from the bed to k, and look at its components through
// faces. Six neighbours for what is empty and 26 for what is solid is one of the two pairs for
// which a closed wall parts inside from outside, and the one that is true to liquids: they pass no
// edge and no corner.
//
// A component of E_k that touches a side of the grid (or the bed, where that is open) is vented;
// components only grow with k, so it stays so. Any other has no way out but through the plane of
// layer k. A resin printer builds downwards, hanging from its bed: that plane is the film, the
// component is "open only downwards", and lifting the part off the film pulls a vacuum in it. So:
// a void is a sealed component that does not go on into a larger sealed one, and there are just
// three ways for it to end at layer k + 1: nothing empty lies above it (a trap; it is then a
// component of the whole shape's empty space, and every trap is found this way), what lies above it
// is vented (a cup), or there is no layer k + 1 (a cup, open at the end). A trap was a cup as long
// as it was open.
//
// Area: the largest number of voxels that one sealed component of some E_j had in layer j. Two cups
// that meet later pulled one by one before, and together after.
//
// One sweep with union-find over runs. A record, a node of the forest, is kept for each component
// that the latest layer has voxels of; others have ended. A layer makes one new node for each of
// its own components (4 neighbours), joins new and old nodes where runs overlap, and settles: old
// nodes that joined nothing new are traps, sealed ones in a vented set are cups, all others are
// added to their root. Then roots are numbered anew by their first run, and old nodes are gone. So
// memory is the runs of two layers and one record for each component of one.
//
// Definition after ALGORITHMS 8.6 ("void components open only downward"); thresholds on area and
// height are those that resin slicers offer (PEERS 1.1).
//
// Source of the forest: R. E. Tarjan, "Efficiency of a Good But Not Linear Set Union Algorithm",
// 1975.

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

#include <sf/finding.h>

// What is known of a component.
typedef struct cavity {
    uint32_t parent;
    uint32_t number; // its index once the layer is done; UINT32_MAX before
    uint8_t is_vented;
    uint64_t volume, area; // of the layers below, and below and this one once it is done
    uint64_t here;         // voxels in this layer
    sf_box box;
} cavity;

// Runs of empty voxels of one layer; a label is the index of a cavity.
typedef struct layer_runs {
    sf_run *runs;
    size_t capacity, count;
} layer_runs;

typedef struct search {
    const sf_grid *grid;
    const sf_voids_options *options;
    sf_allocator allocator;
    sf_lattice lattice;
    uint32_t bed;
    sf_slice empty; // of the latest layer
    size_t empty_words;
    layer_runs below, here;
    cavity *cavities, *spare;
    size_t cavity_capacity, spare_capacity;
    uint32_t below_count, count; // old nodes; old and new ones
    sf_void *found;
    size_t found_capacity, found_count;
    sf_voids_report report;
} search;

// ---------------------------------------------------------------------------------------------
// Forest
// ---------------------------------------------------------------------------------------------

static uint32_t find(cavity *c, uint32_t i)
{
    while (c[i].parent != i) {
        c[i].parent = c[c[i].parent].parent;
        i = c[i].parent;
    }
    return i;
}

// The higher index becomes the root: new nodes come after old ones, so that the root of an old node
// is itself or a new one.
static void join(cavity *c, uint32_t a, uint32_t b)
{
    a = find(c, a);
    b = find(c, b);
    c[a < b ? a : b].parent = a < b ? b : a;
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
// One layer
// ---------------------------------------------------------------------------------------------

// The runs of what is empty in layer k, with a component of the layer as label.
static sf_status find_runs(search *s, uint32_t k, uint32_t *components)
{
    sf_slice solid = sf_grid_slice(s->grid, k);
    size_t words = sfi_row_words(solid.width), need;
    for (uint32_t y = 0; y < solid.height; y++) {
        const uint64_t *in = sfi_slice_row(solid, y);
        uint64_t *out = sfi_slice_row(s->empty, y);
        for (size_t i = 0; i < words; i++) {
            out[i] = ~in[i];
        }
        out[words - 1] &= sfi_tail_mask(solid.width);
    }
    SF_TRY(sf_slice_run_count(s->empty, &need));
    if (!sfi_grow_array(&s->allocator, (void **)&s->here.runs, &s->here.capacity, need,
                        sizeof *s->here.runs)) {
        return SF_ERR_MEMORY;
    }
    SF_TRY(sf_slice_runs(s->empty, s->here.runs, s->here.capacity, &s->here.count));
    return sf_runs_label(s->here.runs, s->here.count, SF_CONNECT_EDGES, components);
}

// One node for each component of layer k, after the old ones; labels become nodes.
static sf_status add_nodes(search *s, uint32_t k, uint32_t components)
{
    size_t need = (size_t)s->below_count + components;
    if (need > UINT32_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (!sfi_grow_array(&s->allocator, (void **)&s->cavities, &s->cavity_capacity, need,
                        sizeof *s->cavities)) {
        return SF_ERR_MEMORY;
    }
    uint8_t below_is_open = s->options->bed_is_open && k == s->bed;
    for (uint32_t i = s->below_count; i < need; i++) {
        cavity fresh = {
            i, UINT32_MAX, below_is_open, 0, 0, 0, {UINT32_MAX, UINT32_MAX, k, 0, 0, k + 1}};
        s->cavities[i] = fresh;
    }
    for (size_t i = 0; i < s->here.count; i++) {
        sf_run *run = &s->here.runs[i];
        run->label += s->below_count;
        cavity *c = &s->cavities[run->label];
        sf_box box = {run->x0, run->y, k, run->x1, run->y + 1, k + 1};
        widen(&c->box, &box);
        c->here += run->x1 - run->x0;
        c->is_vented |=
            run->x0 == 0 || run->x1 == s->lattice.nx || run->y == 0 || run->y + 1 == s->lattice.ny;
    }
    s->count = (uint32_t)need;
    return SF_OK;
}

// Join old and new nodes whose runs overlap. Both lists are in row order, so two cursors meet every
// such pair: of two runs the one that ends first can overlap nothing further.
static void join_layers(search *s)
{
    size_t a = 0, b = 0;
    while (a < s->below.count && b < s->here.count) {
        const sf_run *p = &s->below.runs[a], *q = &s->here.runs[b];
        if (p->y != q->y) {
            *(p->y < q->y ? &a : &b) += 1;
            continue;
        }
        if (p->x0 < q->x1 && q->x0 < p->x1) {
            join(s->cavities, p->label, q->label);
        }
        *(p->x1 < q->x1 ? &a : &b) += 1;
    }
}

// ---------------------------------------------------------------------------------------------
// What has ended
// ---------------------------------------------------------------------------------------------

static sf_status name(search *s, const cavity *c, sf_void_kind kind, uint32_t vent_layer)
{
    if (kind == SF_VOID_TRAP) {
        s->report.trap_count++;
        s->report.trap_voxels += c->volume;
    } else if (c->area < s->options->cup_area_min ||
               c->box.z1 - c->box.z0 < s->options->cup_layers_min) {
        s->report.small_cup_count++;
        return SF_OK;
    } else {
        s->report.cup_count++;
        s->report.cup_voxels += c->volume;
    }
    if (s->found_count == s->options->void_capacity) {
        s->report.voids_dropped++;
        return SF_OK;
    }
    if (!sfi_grow_array(&s->allocator, (void **)&s->found, &s->found_capacity, s->found_count + 1,
                        sizeof *s->found)) {
        return SF_ERR_MEMORY;
    }
    sf_void made = {kind, vent_layer, c->volume, c->area, c->box};
    s->found[s->found_count++] = made;
    return SF_OK;
}

// Say of each set whether it is vented, in its root; a set of one old node has ended.
static void vent(search *s)
{
    cavity *c = s->cavities;
    for (uint32_t i = 0; i < s->count; i++) {
        c[find(c, i)].is_vented |= c[i].is_vented;
    }
}

// Name the old nodes that end below layer k, and add the others to their roots.
static sf_status settle(search *s, uint32_t k)
{
    cavity *c = s->cavities;
    for (uint32_t i = 0; i < s->below_count; i++) {
        cavity *root = &c[find(c, i)];
        if (c[i].is_vented) {
            continue;
        }
        if (root == &c[i]) {
            SF_TRY(name(s, &c[i], SF_VOID_TRAP, UINT32_MAX));
        } else if (root->is_vented) {
            SF_TRY(name(s, &c[i], SF_VOID_CUP, k));
        } else {
            root->volume += c[i].volume;
            root->area = root->area > c[i].area ? root->area : c[i].area;
            widen(&root->box, &c[i].box);
        }
    }
    for (uint32_t i = s->below_count; i < s->count; i++) {
        cavity *root = &c[find(c, i)];
        if (root != &c[i]) {
            root->here += c[i].here;
            widen(&root->box, &c[i].box);
        }
    }
    return SF_OK;
}

// Number the roots by their first run in the layer, and forget all other nodes.
static sf_status renumber(search *s, uint32_t components)
{
    uint32_t count = 0;
    if (!sfi_grow_array(&s->allocator, (void **)&s->spare, &s->spare_capacity, components,
                        sizeof *s->spare)) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < s->here.count; i++) {
        cavity *root = &s->cavities[find(s->cavities, s->here.runs[i].label)];
        if (root->number == UINT32_MAX) {
            cavity *kept = &s->spare[count];
            root->number = count;
            *kept = *root;
            kept->parent = count++;
            kept->number = UINT32_MAX;
            kept->volume += root->here;
            kept->area = root->area > root->here ? root->area : root->here;
            kept->here = 0;
        }
        s->here.runs[i].label = root->number;
    }
    cavity *cavities = s->cavities;
    size_t capacity = s->cavity_capacity;
    s->cavities = s->spare;
    s->cavity_capacity = s->spare_capacity;
    s->spare = cavities;
    s->spare_capacity = capacity;
    s->below_count = count;
    layer_runs runs = s->below;
    s->below = s->here;
    s->here = runs;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The sweep
// ---------------------------------------------------------------------------------------------

static sf_status take_layer(search *s, uint32_t k)
{
    uint32_t components;
    SF_TRY(find_runs(s, k, &components));
    SF_TRY(add_nodes(s, k, components));
    join_layers(s);
    vent(s);
    SF_TRY(settle(s, k));
    return renumber(s, components);
}

// What is still sealed after the last layer opens only now.
static sf_status end(search *s)
{
    for (uint32_t i = 0; i < s->below_count; i++) {
        if (!s->cavities[i].is_vented) {
            SF_TRY(name(s, &s->cavities[i], SF_VOID_CUP, s->lattice.nz));
        }
    }
    return SF_OK;
}

static sf_status sweep(search *s, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    s->empty.width = s->lattice.nx;
    s->empty.height = s->lattice.ny;
    s->empty.stride = sfi_row_words(s->lattice.nx);
    if (!sfi_size_mul(s->empty.stride, s->lattice.ny, &s->empty_words)) {
        return SF_ERR_OVERFLOW;
    }
    s->empty.words = sfi_alloc_array(&s->allocator, s->empty_words, sizeof *s->empty.words);
    if (s->empty.words == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = s->bed; k < s->lattice.nz; k++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(take_layer(s, k));
        sfi_progress_report(&progress, k + 1 - s->bed, s->lattice.nz - s->bed);
    }
    return end(s);
}

static void release(search *s)
{
    const sf_allocator *a = &s->allocator;
    sfi_free_array(a, s->empty.words, s->empty_words, sizeof *s->empty.words);
    sfi_free_array(a, s->below.runs, s->below.capacity, sizeof *s->below.runs);
    sfi_free_array(a, s->here.runs, s->here.capacity, sizeof *s->here.runs);
    sfi_free_array(a, s->cavities, s->cavity_capacity, sizeof *s->cavities);
    sfi_free_array(a, s->spare, s->spare_capacity, sizeof *s->spare);
    sfi_free_array(a, s->found, s->found_capacity, sizeof *s->found);
}

sf_voids_options sf_voids_options_default(void)
{
    sf_voids_options options = {sizeof options, SF_BED_AUTO, 0, 0, 0, NULL, 0};
    return options;
}

sf_status sf_grid_voids(const sf_grid *grid, const sf_voids_options *options,
                        const sf_allocator *allocator, sf_task *task, sf_voids_report *report,
                        size_t *void_count)
{
    if (grid == NULL || options == NULL || report == NULL ||
        options->struct_size < sizeof *options ||
        (options->voids == NULL && options->void_capacity > 0)) {
        return SF_ERR_ARGUMENT;
    }
    sf_lattice lattice = sf_grid_lattice(grid);
    if (options->bed_layer != SF_BED_AUTO && options->bed_layer >= lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    search s = {.grid = grid, .options = options, .lattice = lattice};
    s.allocator = sfi_allocator_or_default(allocator);
    s.bed = options->bed_layer == SF_BED_AUTO ? sfi_first_matter(grid) : options->bed_layer;
    s.report.bed_layer = s.bed < lattice.nz ? s.bed : SF_BED_AUTO;
    sf_status status = sweep(&s, task);
    if (status == SF_OK) {
        for (size_t i = 0; i < s.found_count; i++) {
            options->voids[i] = s.found[i];
        }
        *report = s.report;
        if (void_count != NULL) {
            *void_count = s.found_count;
        }
    }
    release(&s);
    return status;
}
