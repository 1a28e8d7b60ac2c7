// SPDX-License-Identifier: MIT
// Trim, incremental: the printable part of a shape, brought up to date after a change in a box.
//
// Let the drawn shape D change within a box, and let T be the trim of what it was. Dilation
// commutes with union, so where two stacks of slices differ by C in one layer, what they carry
// differs within dilate(C). Hence the change of T in layer k + 1 lies within the box's rectangle
// there and within the dilation of the change in layer k; walking up with one rectangle around what
// really changed is exact, and once past the box the first layer without a change is the last to
// look at. In the rectangle T_{k+1} is recomputed from D, so that matter both goes and comes back.
//
// With bridges a change of what is carried at v can change T as far from v as a gap is long and its
// anchor: the rectangles grow by the span and the anchor, and are computed with as much margin
// again.
//
// Under slack what changes is how much a voxel may yet carry, which the grid does not hold; there
// all layers are computed anew, and the changes are found by comparing.
//
// When D and T are the same grid what was removed can no longer be seen by comparing, so in the
// layers of the box the whole rectangle counts as changed.
//
// Windows are aligned to words, computed with their margin into scratch, and written back bit by
// bit of the rectangle only.
//
// What was edited is a box, or an area: a rectangle for each layer, with gaps or none. What runs
// across a grid has a box that holds mostly what lies beside it.

#include "base/memory.h"
#include "base/status.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "support/trim/trim_area.h"
#include "voxel/grid.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

// One call.
typedef struct walk {
    sf_box box;             // around what was edited, or, where it is not NULL,
    const sfi_area *edited; // its rectangles
    sf_box *around;         // what changed: its box, or, where it is not NULL,
    sfi_area *changed;      // its rectangles
    const sf_grid *drawn;
    sf_grid *printable;
    const sf_rule *rule;
    uint32_t bed;     // the number of layers when there is no matter at all: all lie below it
    uint32_t margin;  // how far a bridge and its anchor reach within a layer
    sf_slice scratch; // as large as a slice
    sf_slice own, anchored, gaps; // the same again, for bridges
} walk;

// r grown by the element and a margin, clipped to the slice.
static sf_rect grow(sf_rect r, const sf_element *element, uint32_t margin, sf_slice slice)
{
    return sfi_rect_grow(r, element->half_width[0] + margin, element->reach_y + margin, slice);
}

// scratch = what layer k should be, right within r at least.
static sf_status compute(const walk *w, uint32_t k, sf_rect r, const sf_element *element)
{
    sf_slice drawn = sf_grid_slice(w->drawn, k);
    if (k < w->bed) {
        sf_rect part = sfi_rect_align(r, drawn);
        sf_slice out = sfi_slice_window(w->scratch, part);
        sf_rect all = {0, 0, out.width, out.height};
        return sf_slice_fill(out, all, 0);
    }
    if (k == w->bed) {
        sf_rect part = sfi_rect_align(r, drawn);
        return sf_slice_copy(sfi_slice_window(w->scratch, part), sfi_slice_window(drawn, part));
    }
    sf_rect part = sfi_rect_align(grow(r, element, w->margin, drawn), drawn);
    sf_slice below = sfi_slice_window(sf_grid_slice(w->printable, k - 1), part);
    sf_slice out = sfi_slice_window(w->scratch, part), solid = sfi_slice_window(drawn, part);
    if (w->margin == 0) {
        return sf_slice_and_dilate(out, solid, below, element);
    }
    sf_slice own = sfi_slice_window(w->own, part), gaps = sfi_slice_window(w->gaps, part);
    SF_TRY(sf_slice_and_dilate(own, solid, below, element));
    sfi_bridge_gaps(&w->rule->bridge, solid, own, sfi_slice_window(w->anchored, part), gaps);
    return sf_slice_or(out, own, gaps);
}

// Bring layer k of printable to what scratch says within r; returns the rectangle around what
// changed. Scratch is used up.
static sf_rect commit(const walk *w, uint32_t k, sf_rect r)
{
    sf_slice slice = sf_grid_slice(w->printable, k);
    size_t first = r.x0 / 64, last = (r.x1 - 1) / 64;
    uint64_t head = ~UINT64_C(0) << (r.x0 % 64), tail = sfi_tail_mask(r.x1);
    for (uint32_t y = r.y0; y < r.y1; y++) {
        uint64_t *row = sfi_slice_row(slice, y), *fresh = sfi_slice_row(w->scratch, y);
        for (size_t i = first; i <= last; i++) {
            uint64_t mask = (i == first ? head : ~UINT64_C(0)) & (i == last ? tail : ~UINT64_C(0));
            uint64_t difference = (row[i] ^ fresh[i]) & mask;
            row[i] ^= difference;
            fresh[i] = difference;
        }
    }
    sf_rect part = sfi_rect_align(r, slice);
    sf_rect changed = sf_slice_bounds(sfi_slice_window(w->scratch, part));
    if (!sfi_rect_is_empty(changed)) {
        changed.x0 += part.x0;
        changed.x1 += part.x0;
        changed.y0 += part.y0;
        changed.y1 += part.y0;
    }
    return changed;
}

// The rectangle of layer k that was edited.
static sf_rect edited_in(const walk *w, uint32_t k)
{
    sf_rect flat = {w->box.x0, w->box.y0, w->box.x1, w->box.y1}, none = {0, 0, 0, 0};
    if (w->edited != NULL) {
        return sfi_area_rect(w->edited, k);
    }
    return k >= w->box.z0 && k < w->box.z1 ? flat : none;
}

static void note(const walk *w, sf_rect changed, uint32_t k)
{
    if (w->changed != NULL) {
        sfi_area_add(w->changed, changed, k);
    } else {
        *w->around = sfi_box_union(*w->around, changed, k);
    }
}

static sf_status walk_up(const walk *w)
{
    sf_rect dirty = {0, 0, 0, 0};
    uint32_t nz = sf_grid_lattice(w->printable).nz;
    uint32_t z0 = w->edited != NULL ? w->edited->z0 : w->box.z0;
    uint32_t z1 = w->edited != NULL ? w->edited->z1 : w->box.z1;
    const sf_element still = {0, {0}};
    for (uint32_t k = z0; k < nz; k++) {
        sf_element element = still;
        if (k > 0) {
            SF_TRY(sf_rule_element(w->rule, k - 1, &element));
        }
        sf_rect edited = grow(edited_in(w, k), &still, w->margin, w->scratch);
        sf_rect r = sfi_rect_union(grow(dirty, &element, w->margin, w->scratch), edited);
        if (sfi_rect_is_empty(r)) {
            dirty = r;
            if (k >= z1) {
                break;
            }
            continue;
        }
        SF_TRY(compute(w, k, r, &element));
        dirty = commit(w, k, r);
        note(w, dirty, k);
        if (w->drawn == w->printable) {
            dirty = sfi_rect_union(dirty, edited);
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Slack: everything anew
// ---------------------------------------------------------------------------------------------

static sf_status recompute(const walk *w, const sf_allocator *allocator)
{
    sf_lattice lattice = sf_grid_lattice(w->printable);
    sf_terms terms = sf_terms_default();
    sf_grid *fresh;
    terms.rule = *w->rule;
    SF_TRY(sf_grid_create(&lattice, allocator, &fresh));
    sf_status status = sfi_trim_into(fresh, w->drawn, &terms, w->bed, allocator, NULL);
    sf_rect all = {0, 0, lattice.nx, lattice.ny};
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        walk one = *w;
        one.scratch = sf_grid_slice(fresh, k);
        note(w, commit(&one, k, all), k);
    }
    sf_grid_destroy(fresh);
    return status;
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

static sf_status check_box(const sf_grid *printable, sf_box box)
{
    sf_lattice lattice = sf_grid_lattice(printable);
    int inside = box.x1 <= lattice.nx && box.y1 <= lattice.ny && box.z1 <= lattice.nz;
    return inside ? SF_OK : SF_ERR_ARGUMENT;
}

// Where the bed is chosen by the shape and the change moved it, the box is everything. The trim
// keeps the whole bed slice, so it still shows where the bed was.
static sf_box widen_to_bed(const walk *w, uint32_t bed_layer)
{
    sf_lattice lattice = sf_grid_lattice(w->printable);
    sf_box all = {0, 0, 0, lattice.nx, lattice.ny, lattice.nz};
    int moved = bed_layer == SF_BED_AUTO && w->bed != sfi_first_matter(w->printable);
    return moved ? all : w->box;
}

// With scratch from one piece of memory.
static sf_status run(walk *w)
{
    sf_allocator allocator = sfi_grid_allocator(w->printable);
    if (w->rule->kind == SF_RULE_SLACK) {
        return recompute(w, &allocator);
    }
    sf_slice shape = sf_grid_slice(w->printable, 0);
    size_t one = shape.stride * shape.height; // as in the grid, so it does not overflow
    size_t slices = w->margin > 0 ? 4 : 1;
    uint64_t *words = sfi_alloc_array(&allocator, slices, one * sizeof *words);
    if (words == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_slice *places[4] = {&w->scratch, &w->own, &w->anchored, &w->gaps};
    for (size_t i = 0; i < slices; i++) {
        shape.words = words + i * one;
        *places[i] = shape;
    }
    sf_status status = walk_up(w);
    sfi_free_array(&allocator, words, slices, one * sizeof *words);
    return status;
}

sf_status sf_grid_trim_box(const sf_grid *drawn, sf_grid *printable, const sf_rule *rule,
                           uint32_t bed_layer, sf_box box, sf_box *changed)
{
    if (drawn == NULL || printable == NULL || rule == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_terms terms = sf_terms_default();
    sfi_ground ground;
    terms.rule = *rule;
    terms.bed_layer = bed_layer;
    SF_TRY(sfi_terms_check(&terms, drawn, &ground));
    SF_TRY(sfi_terms_match(&ground.lattice, printable));
    SF_TRY(check_box(printable, box));
    sf_box around = {0, 0, 0, 0, 0, 0};
    if (!sfi_box_is_empty(box)) {
        walk w = {.box = box,
                  .around = &around,
                  .drawn = drawn,
                  .printable = printable,
                  .rule = rule,
                  .bed = ground.bed,
                  .margin = sfi_bridge_margin(&rule->bridge)};
        w.box = widen_to_bed(&w, bed_layer);
        SF_TRY(run(&w));
    }
    if (changed != NULL) {
        *changed = around;
    }
    return SF_OK;
}

sf_status sfi_trim_area(const sf_grid *drawn, sf_grid *printable, const sf_rule *rule,
                        uint32_t bed_layer, const sfi_area *edited, sfi_area *changed)
{
    walk w = {.edited = edited,
              .changed = changed,
              .drawn = drawn,
              .printable = printable,
              .rule = rule,
              .bed = bed_layer,
              .margin = sfi_bridge_margin(&rule->bridge)};
    return sfi_area_is_empty(edited) ? SF_OK : run(&w);
}
