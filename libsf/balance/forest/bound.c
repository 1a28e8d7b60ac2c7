// SPDX-License-Identifier: MIT
// Bound: the best that carving can reach, whatever hangs.
//
// Without anything to be carried each voxel is a choice of its own, and the least by a lever is the
// wall and those voxels for which the lever counts less than 0: all on one side of a plane, in
// every row an interval. With the multipliers over that, the best mixture is the optimum over
// voxels that may be kept in part, of which only as many are not whole as half-spaces bind. Nothing
// that is made of whole voxels is better, support-free or not; so what a carving misses of it is
// the price of being whole and support-free, and nothing else.

#include "balance/forest/bound.h"

#include "balance/forest/question.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>

// Row: keep x0 <= x < x1 of what is in it.
static void keep_part(uint64_t *row, size_t words, uint32_t x0, uint32_t x1)
{
    for (size_t i = 0; i < words; i++) {
        uint64_t mask = ~UINT64_C(0);
        if (x0 >= x1 || i < x0 / 64 || i > (x1 - 1) / 64) {
            mask = 0;
        } else {
            mask &= i == x0 / 64 ? ~UINT64_C(0) << (x0 % 64) : ~UINT64_C(0);
            mask &= i == (x1 - 1) / 64 ? sfi_tail_mask(x1) : ~UINT64_C(0);
        }
        row[i] &= mask;
    }
}

// The voxels of a row, counted from `from` at voxel 0 on by `step`, that count less than 0.
static void find_part(double from, double step, uint32_t width, uint32_t *x0, uint32_t *x1)
{
    *x0 = 0;
    *x1 = width;
    if (step == 0) {
        *x1 = from < 0 ? width : 0;
        return;
    }
    double zero = -from / step; // where it crosses
    double cut = floor(zero);
    cut = cut < -1 ? -1 : cut > (double)width ? (double)width : cut;
    uint32_t past = (uint32_t)(cut + 1); // the first voxel beyond the crossing
    if (step > 0) {
        *x1 = past > 0 && cut == zero ? past - 1 : past;
        *x1 = *x1 < width ? *x1 : width;
    } else {
        *x0 = past < width ? past : width;
    }
}

static sf_status fill_layer(const sfi_fractional *f, const sfi_lever *lever, uint32_t k, double z)
{
    sf_lattice l = sf_grid_lattice(f->solid);
    sf_slice out = sf_grid_slice(f->shape, k);
    SF_TRY(sf_slice_subtract(out, sf_grid_slice(f->solid, k), sf_grid_slice(f->given, k)));
    for (uint32_t y = 0; y < l.ny; y++) {
        uint32_t x0, x1;
        double from = sfi_lever_at(lever, l.origin_mm[0] + 0.5 * l.pitch_x_mm,
                                   l.origin_mm[1] + (y + 0.5) * l.pitch_y_mm, z);
        find_part(from, lever->pull[0] * l.pitch_x_mm, l.nx, &x0, &x1);
        keep_part(sfi_slice_row(out, y), sfi_row_words(l.nx), x0, x1);
    }
    return sf_slice_or(out, out, sf_grid_slice(f->given, k));
}

sf_status sfi_fractional_find(void *context, const sfi_lever *weight, sf_body *body)
{
    const sfi_fractional *f = context;
    sf_lattice l = sf_grid_lattice(f->solid);
    double bottom = l.origin_mm[2];
    if (sf_task_is_cancelled(f->task)) {
        return SF_ERR_CANCELLED;
    }
    for (uint32_t k = 0; k < l.nz; k++) {
        double height = sf_lattice_layer_height(&l, k);
        SF_TRY(fill_layer(f, weight, k, bottom + 0.5 * height));
        bottom += height;
    }
    sf_body own;
    SF_TRY(sf_grid_body(f->shape, f->density, NULL, &own));
    *body = sf_body_add(own, 1, f->rest);
    return SF_OK;
}

static sf_status find_bounds(const sfi_question *q, sfi_fractional *f, double *depth, double *mass)
{
    sfi_multipliers deepest, most = {.holds = 0};
    sfi_search search = sfi_question_search(q, SFI_FOREST_DEEPEST);
    search.find = sfi_fractional_find;
    search.context = f;
    SF_TRY(sfi_multipliers_find(&search, &deepest));
    if (mass != NULL) {
        search.goal = SFI_FOREST_MOST;
        SF_TRY(sfi_multipliers_find(&search, &most));
        *mass = most.holds ? most.bound : 0;
    }
    *depth = deepest.bound;
    return SF_OK;
}

sf_status sfi_carve_bound(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                          const sfi_forest_options *options, const sf_allocator *allocator,
                          sf_task *task, double *depth, double *mass)
{
    sfi_question q;
    sf_grid *given = NULL, *shape = NULL;
    if (depth == NULL || options == NULL || options->count == 0) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_question_create(solid, wall, terms, options, allocator, task, &q));
    sf_status status = sf_grid_create(&q.lattice, &q.allocator, &given);
    if (status == SF_OK) {
        status = sf_grid_create(&q.lattice, &q.allocator, &shape);
    }
    if (status == SF_OK) {
        status = sfi_question_given(solid, wall, terms, given);
    }
    if (status == SF_OK) {
        sfi_fractional f = {solid, given, options->density, options->rest, task, shape};
        status = find_bounds(&q, &f, depth, mass);
    }
    sf_grid_destroy(given);
    sf_grid_destroy(shape);
    sfi_question_destroy(&q);
    return status;
}
