// SPDX-License-Identifier: MIT
// The wall: voxels of a solid that come nearer to its surface than a given thickness.
//
// A voxel is a box, and any of its points counts: distances of centres leave walls that are up to
// 0.87 voxels short, and those from centre to centre twice that. The distance of a box to a
// triangle is exact but dear, so it is asked only where cheaper bounds say nothing. Let T be the
// voxels that the surface touches. For a voxel v and one t of T
//
//     gap(v, t)   the distance of the two boxes: no point of the surface in t is nearer to v
//     far(v, t)   the distance of the two centres: every point of t is at least that near to v
//
// and both depend on nothing but how many voxels the two are apart. So the slices of T, dilated by
// the elements of all (dx, dy) with gap < wall, hold all of the wall, and by those with far < wall
// they are part of it. Between the two lies about one layer of voxels, which asks the triangles
// (near.c). What T holds may be not quite touched, so both bounds are taken `error` to the safe
// side.
//
// Rounding: lengths are sums and products of what people write as decimals, so a wall of just three
// voxels would come out as three or as four by chance. What is nearer by less than one part in 2^40
// of the largest coordinate counts as not nearer; everything else errs far less than that.

#include "balance/wall/apart.h"
#include "balance/wall/levels.h"
#include "balance/wall/near.h"
#include "balance/wall/touched.h"
#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

#include <sf/carve.h>

#include <math.h>
#include <string.h>

#define PIECES 16u    // slabs that are looked at side by side
#define SLAB 8u       // layers of a slab
#define ERROR 0x1p-20 // of a voxel: more than rounding hides
#define FARTHEST 1e12 // coordinates, in mm, as in a lattice

// Scratch of one slab.
typedef struct slab {
    sf_slice maybe, surely, here;
} slab;

typedef struct search {
    const sf_grid *solid;
    sf_grid *wall; // what is found
    sf_lattice lattice;
    sf_allocator allocator;
    double limit, error;
    int fits;            // whether the bounds' elements reach as far as they must
    sfi_touched touched; // T
    sfi_near near;
    uint64_t *words; // of all slabs
    size_t slice_words;
    slab slabs[PIECES];
    uint32_t first_slab; // of those under way
} search;

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

// How near is near, and how far T is trusted.
static void set_limits(search *s, double wall_mm, const double low[3], const double high[3])
{
    const sf_lattice *l = &s->lattice;
    double farthest = 0, layer = 0;
    for (int i = 0; i < 3; i++) {
        farthest = fabs(low[i]) > farthest ? fabs(low[i]) : farthest;
        farthest = fabs(high[i]) > farthest ? fabs(high[i]) : farthest;
    }
    for (uint32_t k = 0; k < (l->heights_mm != NULL ? l->nz : 1); k++) {
        double height = sf_lattice_layer_height(l, k);
        layer = height > layer ? height : layer;
    }
    s->limit = sfi_levels_forgive(l, wall_mm, farthest);
    s->error = ERROR * (l->pitch_x_mm + l->pitch_y_mm + layer);
    s->fits = sfi_apart_fits(s->limit + s->error, l->pitch_x_mm, l->pitch_y_mm);
}

static sf_status create(search *s, sf_mesh_view surface, sf_task *task)
{
    double reach = s->limit + 2 * s->error;
    SF_TRY(sfi_touched_create(surface, &s->lattice, reach, &s->allocator, task, &s->touched));
    SF_TRY(sfi_near_create(surface, &s->allocator, &s->near));
    SF_TRY(sf_grid_create(&s->lattice, &s->allocator, &s->wall));
    sf_slice whole = sf_grid_slice(s->touched.grid, 0);
    s->slice_words = whole.stride * whole.height;
    s->words = sfi_alloc_array(&s->allocator, s->slice_words, 3 * PIECES * sizeof *s->words);
    if (s->words == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(s->words, 0, s->slice_words * 3 * PIECES * sizeof *s->words);
    for (uint32_t i = 0; i < PIECES; i++) {
        sf_slice slices[3];
        for (uint32_t j = 0; j < 3; j++) {
            slices[j] = whole;
            slices[j].words = s->words + (3 * i + j) * s->slice_words;
        }
        slab made = {slices[0], slices[1], slices[2]};
        s->slabs[i] = made;
    }
    return SF_OK;
}

static void destroy(search *s)
{
    sfi_touched_destroy(&s->touched, &s->allocator);
    sf_grid_destroy(s->wall);
    sfi_near_destroy(&s->near, &s->allocator);
    sfi_free_array(&s->allocator, s->words, s->slice_words, 3 * PIECES * sizeof *s->words);
}

// ---------------------------------------------------------------------------------------------
// Bounds
// ---------------------------------------------------------------------------------------------

// sum |= touched, dilated by all that is across by less than what `along` leaves of a limit.
static void add_bound(sf_slice sum, sf_slice touched, sf_slice scratch, double limit, double along,
                      double less, const sf_lattice *l)
{
    sf_element element;
    double left = limit > along ? limit * limit - along * along : 0;
    // The slices are sound and of one size, and so is the element: neither call can fail.
    if (sfi_apart_element(left, less, l->pitch_x_mm, l->pitch_y_mm, &element) &&
        sf_slice_dilate(scratch, touched, &element, SF_BORDER_EMPTY) == SF_OK) {
        (void)!sf_slice_or(sum, sum, scratch);
    }
}

// What layer j of the touched lattice says about layer k of it. Returns 0 where it is too far off,
// and so are all beyond it.
static int add_layer(const search *s, uint32_t j, uint32_t k, sf_rect window, const slab *scratch)
{
    const double *z = s->touched.levels;
    double gap = j > k ? z[j] - z[k + 1] : j < k ? z[k] - z[j + 1] : 0;
    double far = j > k ? z[j + 1] - z[k + 1] : j < k ? z[k] - z[j] : 0;
    if (gap >= s->limit + s->error) {
        return 0;
    }
    sf_slice touched = sfi_slice_window(sf_grid_slice(s->touched.grid, j), window);
    if (sfi_slice_any(touched)) {
        add_bound(scratch->maybe, touched, scratch->here, s->limit + s->error, gap, SFI_APART_BOXES,
                  &s->lattice);
        add_bound(scratch->surely, touched, scratch->here, s->limit - s->error, far,
                  SFI_APART_CENTRES, &s->lattice);
    }
    return 1;
}

static void bound_layer(const search *s, uint32_t k, sf_rect window, const slab *scratch)
{
    sfi_slice_clear(scratch->maybe);
    sfi_slice_clear(scratch->surely);
    for (uint32_t j = k; j < s->touched.layers && add_layer(s, j, k, window, scratch);) {
        j++;
    }
    for (uint32_t j = k; j > 0 && add_layer(s, j - 1, k, window, scratch);) {
        j--;
    }
}

// ---------------------------------------------------------------------------------------------
// Layers
// ---------------------------------------------------------------------------------------------

static int voxel_is_near(const search *s, uint32_t x, uint32_t y, uint32_t k)
{
    const sf_lattice *l = &s->lattice;
    const double *z = s->touched.levels + s->touched.before[2] + k;
    double middle[3] = {l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm,
                        l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm, 0.5 * (z[0] + z[1])};
    double half[3] = {0.5 * l->pitch_x_mm, 0.5 * l->pitch_y_mm, 0.5 * (z[1] - z[0])};
    return sfi_near_any(&s->near, middle, half, s->limit);
}

// Of a layer's voxels within a rectangle: the wall. The window is where the bounds were made.
static void settle(const search *s, uint32_t k, sf_rect solid, sf_rect window, const slab *bounds)
{
    sf_slice in = sf_grid_slice(s->solid, k), out = sf_grid_slice(s->wall, k);
    // The solid's word 0 among the window's; it may lie before them, and then wraps around.
    size_t first = (size_t)(s->touched.before[0] / 64) - window.x0 / 64;
    for (uint32_t y = solid.y0; y < solid.y1; y++) {
        uint32_t at = y + s->touched.before[1] - window.y0;
        const uint64_t *maybe = sfi_slice_row(bounds->maybe, at);
        const uint64_t *surely = sfi_slice_row(bounds->surely, at);
        for (size_t i = solid.x0 / 64; i <= (solid.x1 - 1) / 64; i++) {
            uint64_t matter = sfi_row_word(sfi_slice_row(in, y), i, in.width);
            uint64_t found = matter & surely[first + i];
            uint64_t open = matter & (s->fits ? maybe[first + i] : ~UINT64_C(0)) & ~found;
            for (; open != 0; open &= open - 1) {
                uint32_t bit = sfi_lowest_bit(open);
                if (voxel_is_near(s, (uint32_t)(64 * i) + bit, y, k)) {
                    found |= UINT64_C(1) << bit;
                }
            }
            sfi_slice_row(out, y)[i] = found;
        }
    }
}

static uint32_t voxels_of(double length_mm, double pitch_mm)
{
    double count = floor(length_mm / pitch_mm) + 2;
    return count < SF_EXTENT_MAX ? (uint32_t)count : SF_EXTENT_MAX;
}

static void find_layer(const search *s, uint32_t k, const slab *scratch)
{
    const sf_lattice *l = &s->lattice;
    sf_slice whole = sf_grid_slice(s->touched.grid, 0);
    sf_rect solid = sf_slice_bounds(sf_grid_slice(s->solid, k));
    if (sfi_rect_is_empty(solid)) {
        return;
    }
    double reach = s->limit + s->error;
    sf_rect moved = {solid.x0 + s->touched.before[0], solid.y0 + s->touched.before[1],
                     solid.x1 + s->touched.before[0], solid.y1 + s->touched.before[1]};
    sf_rect window = sfi_rect_grow(moved, voxels_of(reach, l->pitch_x_mm),
                                   voxels_of(reach, l->pitch_y_mm), whole);
    window = sfi_rect_align(window, whole);
    slab part = {sfi_slice_window(scratch->maybe, window),
                 sfi_slice_window(scratch->surely, window),
                 sfi_slice_window(scratch->here, window)};
    bound_layer(s, k + s->touched.before[2], window, &part);
    settle(s, k, solid, window, &part);
}

static void find_slab(void *context, size_t index)
{
    const search *s = context;
    uint32_t first = (s->first_slab + (uint32_t)index) * SLAB;
    for (uint32_t k = first; k < s->lattice.nz && k < first + SLAB; k++) {
        find_layer(s, k, &s->slabs[index]);
    }
}

static sf_status find_wall(search *s, sfi_progress *progress, sf_task *task)
{
    uint32_t slabs = (s->lattice.nz - 1) / SLAB + 1;
    while (s->first_slab < slabs) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        uint32_t left = slabs - s->first_slab, count = left < PIECES ? left : PIECES;
        sfi_task_for(task, count, find_slab, s);
        s->first_slab += count;
        sfi_progress_report(progress, s->first_slab, slabs);
    }
    return SF_OK;
}

sf_status sf_grid_wall(const sf_grid *solid, sf_mesh_view surface, double wall_mm,
                       const sf_allocator *allocator, sf_task *task, sf_grid *wall)
{
    double low[3], high[3];
    if (solid == NULL || wall == NULL || solid == wall || !(wall_mm >= 0) || !isfinite(wall_mm)) {
        return SF_ERR_ARGUMENT;
    }
    search s = {.solid = solid, .lattice = sf_grid_lattice(solid)};
    s.allocator = sfi_allocator_or_default(allocator);
    SF_TRY(sfi_terms_match(&s.lattice, wall));
    SF_TRY(sf_mesh_bounds(surface, low, high));
    for (int i = 0; i < 3; i++) {
        if (low[i] < -FARTHEST || high[i] > FARTHEST) {
            return SF_ERR_OVERFLOW;
        }
    }
    sfi_progress progress = sfi_progress_begin(task);
    set_limits(&s, wall_mm, low, high);
    sf_status status = create(&s, surface, task);
    if (status == SF_OK) {
        status = find_wall(&s, &progress, task);
    }
    if (status == SF_OK) {
        status = sfi_grid_copy(wall, s.wall);
    }
    destroy(&s);
    return status;
}
