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
// The sets are those of voxel/layered.h, of what is empty. A record is kept for each component that
// the latest layer has voxels of; others have ended. When a layer has joined the sets, old nodes
// that joined nothing new are traps, sealed ones in a vented set are cups, and all others are added
// to their root. Roots are numbered by their first run. So memory is the runs of two layers and one
// record for each component of one.
//
// Definition after ALGORITHMS 8.6 ("void components open only downward"); thresholds on area and
// height are those that resin slicers offer (PEERS 1.1).

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"
#include "voxel/layered.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

#include <sf/finding.h>

// What is known of a component.
typedef struct cavity {
    uint8_t is_vented;     // as it was below
    uint8_t is_set_vented; // of a root: the whole set
    uint8_t goes_on;       // of a root: the layer has voxels of it
    uint64_t volume, area; // of the layers below, and below and this one once it is done
    uint64_t here;         // voxels in this layer
    sf_box box;
} cavity;

struct sf_void_search {
    sf_voids_options options;
    sf_allocator allocator;
    uint32_t layer;    // the next one, counted from 0
    uint32_t bed;      // SF_BED_AUTO until there is matter
    sf_status failure; // of a push, after which the sets are of no more use
    sf_slice empty;    // of the latest layer
    size_t empty_words;
    sfi_layered sets;         // of empty voxels
    cavity *cavities, *spare; // of each node
    uint32_t *number;         // of each root its index once the layer is done
    size_t cavity_capacity, spare_capacity, number_capacity;
    sf_void *found;
    size_t found_capacity, found_count;
    sf_voids_report report;
};

typedef sf_void_search search;

static cavity *root_of(const search *s, uint32_t i)
{
    return &s->cavities[sfi_layered_root(&s->sets, i)];
}

// ---------------------------------------------------------------------------------------------
// One layer
// ---------------------------------------------------------------------------------------------

// What is empty in a layer.
static void complement(search *s, sf_slice solid)
{
    size_t words = sfi_row_words(solid.width);
    for (uint32_t y = 0; y < solid.height; y++) {
        const uint64_t *in = sfi_slice_row(solid, y);
        uint64_t *out = sfi_slice_row(s->empty, y);
        for (size_t i = 0; i < words; i++) {
            out[i] = ~in[i];
        }
        out[words - 1] &= sfi_tail_mask(solid.width);
    }
}

// A cavity for each node of the sets, those of layer k with what its runs say.
static sf_status add_cavities(search *s, uint32_t k)
{
    const sfi_layered *sets = &s->sets;
    uint8_t below_is_open = s->options.bed_is_open && k == s->bed;
    if (!sfi_grow_array(&s->allocator, (void **)&s->cavities, &s->cavity_capacity, sets->count,
                        sizeof *s->cavities)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = sets->old; i < sets->count; i++) {
        cavity fresh = {.is_vented = below_is_open};
        s->cavities[i] = fresh;
    }
    for (size_t i = 0; i < sets->here.count; i++) {
        const sf_run *run = &sets->here.runs[i];
        cavity *c = &s->cavities[run->label];
        sf_rect rect = {run->x0, run->y, run->x1, run->y + 1};
        c->box = sfi_box_union(c->box, rect, k);
        c->here += run->x1 - run->x0;
        c->is_vented |= run->x0 == 0 || run->x1 == s->empty.width || run->y == 0 ||
                        run->y + 1 == s->empty.height;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// What has ended
// ---------------------------------------------------------------------------------------------

static sf_status name(search *s, const cavity *c, sf_void_kind kind, uint32_t vent_layer)
{
    if (kind == SF_VOID_TRAP) {
        s->report.trap_count++;
        s->report.trap_voxels += c->volume;
    } else if (c->area < s->options.cup_area_min ||
               c->box.z1 - c->box.z0 < s->options.cup_layers_min) {
        s->report.small_cup_count++;
        return SF_OK;
    } else {
        s->report.cup_count++;
        s->report.cup_voxels += c->volume;
    }
    if (s->found_count == s->options.void_capacity) {
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

// Say of each set, in its root, whether it is vented and whether it goes on in the layer.
static void look_at_sets(search *s)
{
    for (uint32_t i = 0; i < s->sets.count; i++) {
        s->cavities[i].is_set_vented = s->cavities[i].goes_on = 0;
    }
    for (uint32_t i = 0; i < s->sets.count; i++) {
        cavity *root = root_of(s, i);
        root->is_set_vented |= s->cavities[i].is_vented;
        root->goes_on |= i >= s->sets.old;
    }
}

// Add a node to the root of its set.
static void add_to(cavity *root, const cavity *c)
{
    if (root != c) {
        root->volume += c->volume;
        root->area = root->area > c->area ? root->area : c->area;
        root->here += c->here;
        root->box = sfi_box_join(root->box, c->box);
    }
}

// Name the old nodes that end below layer k, and add the others to their roots.
static sf_status settle(search *s, uint32_t k)
{
    for (uint32_t i = 0; i < s->sets.count; i++) {
        cavity *root = root_of(s, i), *c = &s->cavities[i];
        if (i < s->sets.old && !c->is_vented && !root->goes_on) {
            SF_TRY(name(s, c, SF_VOID_TRAP, UINT32_MAX));
        } else if (i < s->sets.old && !c->is_vented && root->is_set_vented) {
            SF_TRY(name(s, c, SF_VOID_CUP, k));
        } else {
            add_to(root, c);
        }
    }
    return SF_OK;
}

static cavity kept_of(const cavity *root)
{
    cavity kept = *root;
    kept.is_vented = root->is_set_vented;
    kept.volume += root->here;
    kept.area = root->area > root->here ? root->area : root->here;
    kept.here = 0;
    return kept;
}

// Number the roots by their first run in the layer, and forget all other nodes.
static sf_status renumber(search *s)
{
    uint32_t count = 0;
    if (!sfi_grow_array(&s->allocator, (void **)&s->spare, &s->spare_capacity, s->sets.count,
                        sizeof *s->spare) ||
        !sfi_grow_array(&s->allocator, (void **)&s->number, &s->number_capacity, s->sets.count,
                        sizeof *s->number)) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t i = 0; i < s->sets.count; i++) {
        s->number[i] = UINT32_MAX;
    }
    for (size_t i = 0; i < s->sets.here.count; i++) {
        uint32_t root = sfi_layered_root(&s->sets, s->sets.here.runs[i].label);
        if (s->number[root] == UINT32_MAX) {
            s->spare[count] = kept_of(&s->cavities[root]);
            s->number[root] = count++;
        }
    }
    cavity *cavities = s->cavities;
    size_t capacity = s->cavity_capacity;
    s->cavities = s->spare;
    s->cavity_capacity = s->spare_capacity;
    s->spare = cavities;
    s->spare_capacity = capacity;
    sfi_layered_settle(&s->sets, s->number, count);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The sweep
// ---------------------------------------------------------------------------------------------

static sf_status take_layer(search *s, sf_slice solid, uint32_t k)
{
    complement(s, solid);
    SF_TRY(sfi_layered_push(&s->sets, s->empty));
    SF_TRY(add_cavities(s, k));
    look_at_sets(s);
    SF_TRY(settle(s, k));
    return renumber(s);
}

// What is still sealed after the last layer opens only now.
static sf_status end(search *s)
{
    for (uint32_t i = 0; i < s->sets.old; i++) {
        if (!s->cavities[i].is_vented) {
            SF_TRY(name(s, &s->cavities[i], SF_VOID_CUP, s->layer));
        }
    }
    return SF_OK;
}

sf_voids_options sf_voids_options_default(void)
{
    sf_voids_options options = {sizeof options, SF_BED_AUTO, 0, 0, 0, NULL, 0};
    return options;
}

// ---------------------------------------------------------------------------------------------
// A search under way
// ---------------------------------------------------------------------------------------------

static sf_status check_options(const sf_voids_options *options)
{
    return options == NULL || options->struct_size < sizeof *options ||
                   (options->voids == NULL && options->void_capacity > 0) ||
                   (options->bed_layer != SF_BED_AUTO && options->bed_layer >= SF_LAYER_MAX)
               ? SF_ERR_ARGUMENT
               : SF_OK;
}

sf_status sf_void_search_create(const sf_voids_options *options, uint32_t width, uint32_t height,
                                const sf_allocator *allocator, sf_void_search **made)
{
    SF_TRY(check_options(options));
    if (made == NULL || width < 1 || width > SF_EXTENT_MAX || height < 1 ||
        height > SF_EXTENT_MAX) {
        return SF_ERR_ARGUMENT;
    }
    search fresh = {.options = *options, .bed = options->bed_layer};
    fresh.allocator = fresh.sets.allocator = sfi_allocator_or_default(allocator);
    fresh.sets.connectivity = SF_CONNECT_EDGES;
    fresh.report.bed_layer = options->bed_layer;
    fresh.empty.width = width;
    fresh.empty.height = height;
    fresh.empty.stride = sfi_row_words(width);
    if (!sfi_size_mul(fresh.empty.stride, height, &fresh.empty_words)) {
        return SF_ERR_OVERFLOW;
    }
    search *s = sfi_alloc_array(&fresh.allocator, 1, sizeof *s);
    if (s == NULL) {
        return SF_ERR_MEMORY;
    }
    *s = fresh;
    s->empty.words = sfi_alloc_array(&s->allocator, s->empty_words, sizeof *s->empty.words);
    if (s->empty.words == NULL) {
        sf_void_search_destroy(s);
        return SF_ERR_MEMORY;
    }
    *made = s;
    return SF_OK;
}

void sf_void_search_destroy(sf_void_search *s)
{
    if (s != NULL) {
        sf_allocator a = s->allocator;
        sfi_free_array(&a, s->empty.words, s->empty_words, sizeof *s->empty.words);
        sfi_layered_release(&s->sets);
        sfi_free_array(&a, s->number, s->number_capacity, sizeof *s->number);
        sfi_free_array(&a, s->cavities, s->cavity_capacity, sizeof *s->cavities);
        sfi_free_array(&a, s->spare, s->spare_capacity, sizeof *s->spare);
        sfi_free_array(&a, s->found, s->found_capacity, sizeof *s->found);
        sfi_free_array(&a, s, 1, sizeof *s);
    }
}

sf_status sf_void_search_push(sf_void_search *s, sf_slice layer)
{
    if (s == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(s->failure);
    SF_TRY(sfi_slice_validate_pair(layer, s->empty));
    if (s->layer == SF_LAYER_MAX) {
        return SF_ERR_OVERFLOW;
    }
    if (s->bed == SF_BED_AUTO && sfi_slice_any(layer)) {
        s->bed = s->report.bed_layer = s->layer;
    }
    if (s->layer >= s->bed) {
        s->failure = take_layer(s, layer, s->layer);
        SF_TRY(s->failure);
    }
    s->layer++;
    return SF_OK;
}

sf_status sf_void_search_finish(sf_void_search *s, sf_voids_report *report, size_t *void_count)
{
    if (s == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(s->failure);
    s->failure = end(s);
    SF_TRY(s->failure);
    for (size_t i = 0; i < s->found_count; i++) {
        s->options.voids[i] = s->found[i];
    }
    *report = s->report;
    if (void_count != NULL) {
        *void_count = s->found_count;
    }
    s->failure = SF_ERR_ARGUMENT; // what is finished takes nothing more
    return SF_OK;
}

static sf_status sweep(search *s, const sf_grid *grid, uint32_t nz, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    for (uint32_t k = 0; k < nz; k++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(sf_void_search_push(s, sf_grid_slice(grid, k)));
        sfi_progress_report(&progress, k + 1, nz);
    }
    return SF_OK;
}

sf_status sf_grid_voids(const sf_grid *grid, const sf_voids_options *options,
                        const sf_allocator *allocator, sf_task *task, sf_voids_report *report,
                        size_t *void_count)
{
    sf_void_search *s = NULL;
    if (grid == NULL || report == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_options(options));
    sf_lattice lattice = sf_grid_lattice(grid);
    if (options->bed_layer != SF_BED_AUTO && options->bed_layer >= lattice.nz) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_void_search_create(options, lattice.nx, lattice.ny, allocator, &s));
    sf_status status = sweep(s, grid, lattice.nz, task);
    if (status == SF_OK) {
        status = sf_void_search_finish(s, report, void_count);
    }
    sf_void_search_destroy(s);
    return status;
}
