// SPDX-License-Identifier: MIT
// Trim: the largest support-free part of a shape, whole and incremental.
//
// T_bed = S_bed, T_{k+1} = S_{k+1} and dilate(T_k). Support-free sets are closed under union, so a
// greatest one within S exists, and by induction it lies within T, which is support-free itself:
// one sweep from the bottom up, reading each slice once, is exact.
//
// Incremental: let the drawn shape D change within a box, and let T be the trim of what it was.
// Dilation commutes with union, so where two stacks of slices differ by A in one layer, what they
// carry differs within dilate(A). Hence the change of T in layer k + 1 lies within the box's
// rectangle there and within the dilation of the change in layer k; walking up with one rectangle
// around what really changed is exact, and once past the box the first layer without a change is
// the last to look at. In the rectangle T_{k+1} is recomputed from D, so that matter both goes and
// comes back.
//
// When D and T are the same grid what was removed can no longer be seen by comparing, so in the
// layers of the box the whole rectangle counts as changed.
//
// Windows are aligned to words, computed with their dilation's margin into one slice of scratch,
// and written back bit by bit of the rectangle only.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 3.2 (the sweep).

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

// The first layer that holds matter; SF_BED_AUTO when none does.
static uint32_t first_matter(const sf_grid *grid)
{
    uint32_t nz = sf_grid_lattice(grid).nz;
    for (uint32_t k = 0; k < nz; k++) {
        if (sf_slice_bounds(sf_grid_slice(grid, k)).x1 > 0) {
            return k;
        }
    }
    return SF_BED_AUTO;
}

static sf_status check_bed(const sf_grid *grid, const sf_rule *rule, uint32_t bed_layer)
{
    uint32_t nz = sf_grid_lattice(grid).nz;
    if (bed_layer != SF_BED_AUTO && bed_layer >= nz) {
        return SF_ERR_ARGUMENT;
    }
    return sfi_rule_check(rule, 0, nz);
}

// ---------------------------------------------------------------------------------------------
// The whole grid
// ---------------------------------------------------------------------------------------------

static sf_status clear(sf_slice slice)
{
    sf_rect all = {0, 0, slice.width, slice.height};
    return sf_slice_fill(slice, all, 0);
}

// Layer k of the trim, in place, given the layer below.
static sf_status trim_slice(sf_grid *grid, const sf_rule *rule, uint32_t bed, uint32_t k)
{
    sf_slice slice = sf_grid_slice(grid, k);
    if (k < bed) {
        return clear(slice);
    }
    if (k == bed) {
        return SF_OK;
    }
    sf_element element;
    SF_TRY(sf_rule_element(rule, k - 1, &element));
    return sf_slice_and_dilate(slice, slice, sf_grid_slice(grid, k - 1), &element);
}

sf_status sf_grid_trim(sf_grid *grid, const sf_rule *rule, uint32_t bed_layer, sf_task *task,
                       sf_trim_report *report)
{
    if (grid == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(check_bed(grid, rule, bed_layer));
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    uint32_t bed = bed_layer == SF_BED_AUTO ? first_matter(grid) : bed_layer;
    uint32_t nz = sf_grid_lattice(grid).nz;
    sf_trim_report counts = {0, 0, bed};
    sfi_progress progress = sfi_progress_begin(task);
    for (uint32_t k = 0; bed != SF_BED_AUTO && k < nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        uint64_t solid = report != NULL ? sf_slice_popcount(slice) : 0;
        SF_TRY(trim_slice(grid, rule, bed, k));
        if (report != NULL) {
            uint64_t kept = sf_slice_popcount(slice);
            counts.kept_voxels += kept;
            counts.removed_voxels += solid - kept;
        }
        sfi_progress_report(&progress, k + 1, nz);
    }
    sfi_progress_report(&progress, 1, 1);
    if (report != NULL) {
        *report = counts;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// After a change in a box
// ---------------------------------------------------------------------------------------------

// One call of sf_grid_trim_box().
typedef struct walk {
    const sf_grid *drawn;
    sf_grid *printable;
    const sf_rule *rule;
    uint32_t bed;     // SF_BED_AUTO: there is no matter at all, so all layers lie below it
    sf_slice scratch; // as large as a slice
} walk;

static int is_empty(sf_rect r)
{
    return r.x0 >= r.x1 || r.y0 >= r.y1;
}

static sf_rect unite(sf_rect a, sf_rect b)
{
    if (is_empty(a) || is_empty(b)) {
        return is_empty(a) ? b : a;
    }
    sf_rect r = {a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0, a.x1 > b.x1 ? a.x1 : b.x1,
                 a.y1 > b.y1 ? a.y1 : b.y1};
    return r;
}

// r grown by the element, clipped to the slice.
static sf_rect grow(sf_rect r, const sf_element *element, sf_slice slice)
{
    if (is_empty(r)) {
        return r;
    }
    uint32_t rx = element->half_width[0], ry = element->reach_y;
    r.x0 = r.x0 > rx ? r.x0 - rx : 0;
    r.y0 = r.y0 > ry ? r.y0 - ry : 0;
    r.x1 = slice.width - r.x1 > rx ? r.x1 + rx : slice.width;
    r.y1 = slice.height - r.y1 > ry ? r.y1 + ry : slice.height;
    return r;
}

// The smallest rectangle around r that starts and ends with a word.
static sf_rect align(sf_rect r, sf_slice slice)
{
    r.x0 -= r.x0 % 64;
    uint32_t end = (r.x1 + 63) / 64 * 64;
    r.x1 = end < slice.width ? end : slice.width;
    return r;
}

// The part of a slice in a rectangle that starts with a word.
static sf_slice window(sf_slice slice, sf_rect r)
{
    sf_slice part = {sfi_slice_row(slice, r.y0) + r.x0 / 64, r.x1 - r.x0, r.y1 - r.y0,
                     slice.stride};
    return part;
}

// scratch = what layer k should be, right within r at least.
static sf_status compute(const walk *w, uint32_t k, sf_rect r, const sf_element *element)
{
    sf_slice drawn = sf_grid_slice(w->drawn, k);
    if (k < w->bed) {
        return clear(window(w->scratch, align(r, drawn)));
    }
    if (k == w->bed) {
        sf_rect part = align(r, drawn);
        return sf_slice_copy(window(w->scratch, part), window(drawn, part));
    }
    sf_rect part = align(grow(r, element, drawn), drawn);
    sf_slice below = sf_grid_slice(w->printable, k - 1);
    return sf_slice_and_dilate(window(w->scratch, part), window(drawn, part), window(below, part),
                               element);
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
    sf_rect part = align(r, slice);
    sf_rect changed = sf_slice_bounds(window(w->scratch, part));
    if (!is_empty(changed)) {
        changed.x0 += part.x0;
        changed.x1 += part.x0;
        changed.y0 += part.y0;
        changed.y1 += part.y0;
    }
    return changed;
}

static void widen_box(sf_box *box, sf_rect rect, uint32_t k)
{
    if (is_empty(rect)) {
        return;
    }
    sf_rect flat = {box->x0, box->y0, box->x1, box->y1};
    flat = unite(flat, rect);
    box->z0 = box->z1 == 0 ? k : box->z0;
    box->z1 = k + 1;
    box->x0 = flat.x0;
    box->y0 = flat.y0;
    box->x1 = flat.x1;
    box->y1 = flat.y1;
}

static sf_status walk_up(const walk *w, sf_box box, sf_box *changed)
{
    sf_rect flat = {box.x0, box.y0, box.x1, box.y1}, none = {0, 0, 0, 0}, dirty = none;
    uint32_t nz = sf_grid_lattice(w->printable).nz;
    for (uint32_t k = box.z0; k < nz; k++) {
        sf_element element = {0, {0}};
        if (k > 0) {
            SF_TRY(sf_rule_element(w->rule, k - 1, &element));
        }
        sf_rect edited = k < box.z1 ? flat : none;
        sf_rect r = unite(grow(dirty, &element, w->scratch), edited);
        if (is_empty(r)) {
            break;
        }
        SF_TRY(compute(w, k, r, &element));
        dirty = commit(w, k, r);
        widen_box(changed, dirty, k);
        if (w->drawn == w->printable) {
            dirty = unite(dirty, edited);
        }
    }
    return SF_OK;
}

static sf_status check_box(const sf_grid *drawn, const sf_grid *printable, sf_box box)
{
    if (drawn == NULL || printable == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_lattice a = sf_grid_lattice(drawn), b = sf_grid_lattice(printable);
    if (a.nx != b.nx || a.ny != b.ny || a.nz != b.nz) {
        return SF_ERR_SHAPE;
    }
    return box.x1 <= a.nx && box.y1 <= a.ny && box.z1 <= a.nz ? SF_OK : SF_ERR_ARGUMENT;
}

sf_status sf_grid_trim_box(const sf_grid *drawn, sf_grid *printable, const sf_rule *rule,
                           uint32_t bed_layer, sf_box box, sf_box *changed)
{
    SF_TRY(check_box(drawn, printable, box));
    SF_TRY(check_bed(printable, rule, bed_layer));
    sf_box around = {0, 0, 0, 0, 0, 0};
    if (box.x0 < box.x1 && box.y0 < box.y1 && box.z0 < box.z1) {
        sf_slice scratch = sf_grid_slice(printable, 0);
        sf_allocator allocator = sfi_grid_allocator(printable);
        size_t words = scratch.stride * scratch.height; // as in the grid, so it does not overflow
        scratch.words = sfi_alloc_array(&allocator, words, sizeof *scratch.words);
        if (scratch.words == NULL) {
            return SF_ERR_MEMORY;
        }
        walk w = {drawn, printable, rule, bed_layer, scratch};
        if (bed_layer == SF_BED_AUTO) {
            // The trim keeps the whole bed slice, so it still shows where the bed was.
            w.bed = first_matter(drawn);
            if (w.bed != first_matter(printable)) {
                sf_lattice lattice = sf_grid_lattice(printable);
                sf_box all = {0, 0, 0, lattice.nx, lattice.ny, lattice.nz};
                box = all;
            }
        }
        sf_status status = walk_up(&w, box, &around);
        sfi_free_array(&allocator, scratch.words, words, sizeof *scratch.words);
        SF_TRY(status);
    }
    if (changed != NULL) {
        *changed = around;
    }
    return SF_OK;
}
