// SPDX-License-Identifier: MIT
// Question: what a carving is asked, checked before anything is done.
//
// Levers are divided by a unit, the mass of the whole times the diagonal of the lattice, so that
// whatever the size of a part in mm, what counts as nothing (1e-9 or less) means the same.

#include "balance/forest/question.h"

#include "base/bits.h"
#include "base/memory.h"
#include "base/status.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

#include <math.h>

static int is_finite(const double *numbers, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!isfinite(numbers[i])) {
            return 0;
        }
    }
    return 1;
}

static int are_finite(const sf_halfspace *halfspaces, size_t count)
{
    for (size_t e = 0; e < count; e++) {
        if (!is_finite(halfspaces[e].normal, 3) || !isfinite(halfspaces[e].offset_mm)) {
            return 0;
        }
    }
    return 1;
}

static sf_status check_options(const sfi_forest_options *o)
{
    int is_goal =
        o->goal == SFI_FOREST_MOST || o->goal == SFI_FOREST_LEAST || o->goal == SFI_FOREST_DEEPEST;
    if (!is_goal || o->strut_width > SF_REACH_MAX || (o->count > 0 && o->halfspaces == NULL)) {
        return SF_ERR_ARGUMENT;
    }
    if (!isfinite(o->rest.mass) || !is_finite(o->rest.moment, 3) ||
        !are_finite(o->halfspaces, o->count) ||
        (o->slopes != NULL && !are_finite(o->slopes, o->count))) {
        return SF_ERR_ARGUMENT;
    }
    return SF_OK;
}

// Densities of solid voxels are 0 or more; that they are finite their sum tells.
static sf_status check_density(const sfi_question *q)
{
    const float *density = q->options->density;
    size_t nx = q->lattice.nx, ny = q->lattice.ny;
    for (uint32_t k = 0; density != NULL && k < q->lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(q->solid, k);
        for (uint32_t y = 0; y < slice.height; y++) {
            const uint64_t *row = sfi_slice_row(slice, y);
            const float *here = density + ((size_t)k * ny + y) * nx;
            for (size_t i = 0; i < sfi_row_words(slice.width); i++) {
                for (uint64_t word = row[i]; word != 0; word &= word - 1) {
                    if (!(here[i * 64 + sfi_lowest_bit(word)] >= 0)) {
                        return SF_ERR_ARGUMENT;
                    }
                }
            }
        }
    }
    return SF_OK;
}

static sf_status check_grids(sfi_question *q)
{
    if (q->solid == NULL || q->wall == NULL || q->solid == q->wall || q->options == NULL) {
        return SF_ERR_ARGUMENT;
    }
    q->lattice = sf_grid_lattice(q->solid);
    if (q->terms != NULL) {
        sfi_ground ground;
        SF_TRY(sfi_terms_check(q->terms, q->solid, &ground));
        q->bed = ground.bed;
    }
    SF_TRY(sfi_terms_match(&q->lattice, q->wall));
    SF_TRY(check_options(q->options));
    q->width = q->options->strut_width > 0 ? q->options->strut_width : 1;
    SF_TRY(check_density(q));
    return sfi_grid_within(q->wall, q->solid) ? SF_OK : SF_ERR_INFEASIBLE;
}

static double diagonal(const sf_lattice *l)
{
    double x = l->nx * l->pitch_x_mm, y = l->ny * l->pitch_y_mm;
    double z = sf_lattice_layer_bottom(l, l->nz) - sf_lattice_layer_bottom(l, 0);
    return sqrt(x * x + y * y + z * z);
}

static sf_status make_levers(sfi_question *q)
{
    const sfi_forest_options *o = q->options;
    double unit = q->mass_unit * diagonal(&q->lattice);
    if (o->count == 0) {
        return SF_OK;
    }
    q->levers = sfi_alloc_array(&q->allocator, o->count, sizeof *q->levers);
    q->slopes = sfi_alloc_array(&q->allocator, o->count, sizeof *q->slopes);
    if (q->levers == NULL || q->slopes == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t e = 0; e < o->count; e++) {
        sf_halfspace distance = {{0, 0, 0}, -1}; // counts the mass
        q->levers[e] = sfi_lever_of(&o->halfspaces[e], unit);
        q->slopes[e] = sfi_lever_of(o->slopes != NULL ? &o->slopes[e] : &distance, unit);
        if (!(sfi_lever_body(&q->slopes[e], &q->whole) > 0)) {
            return SF_ERR_ARGUMENT;
        }
    }
    return SF_OK;
}

static sf_status create(sfi_question *q)
{
    SF_TRY(check_grids(q));
    sf_body own;
    SF_TRY(sf_grid_body(q->solid, q->options->density, NULL, &own));
    q->whole = sf_body_add(own, 1, q->options->rest);
    q->mass_unit = own.mass + fabs(q->options->rest.mass);
    if (q->options->count > 0 && !(q->whole.mass > 0)) {
        return SF_ERR_ARGUMENT;
    }
    q->mass_unit = q->mass_unit > 0 ? q->mass_unit : 1;
    return make_levers(q);
}

sf_status sfi_question_create(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                              const sfi_forest_options *options, const sf_allocator *allocator,
                              sf_task *task, sfi_question *question)
{
    *question = (sfi_question){.solid = solid,
                               .wall = wall,
                               .terms = terms,
                               .options = options,
                               .allocator = sfi_allocator_or_default(allocator),
                               .task = task};
    sf_status status = create(question);
    if (status != SF_OK) {
        sfi_question_destroy(question);
    }
    return status;
}

void sfi_question_destroy(sfi_question *q)
{
    size_t count = q->options != NULL ? q->options->count : 0;
    sfi_free_array(&q->allocator, q->levers, count, sizeof *q->levers);
    sfi_free_array(&q->allocator, q->slopes, count, sizeof *q->slopes);
    q->levers = q->slopes = NULL;
}

sfi_search sfi_question_search(const sfi_question *q, sfi_forest_goal goal)
{
    sfi_search search = {.goal = goal,
                         .levers = q->levers,
                         .slopes = q->slopes,
                         .count = q->options->count,
                         .mass_unit = q->mass_unit,
                         .start = q->whole,
                         .most = 60};
    return search;
}

sf_status sfi_question_given(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                             sf_grid *given)
{
    uint32_t nz = sf_grid_lattice(solid).nz;
    for (uint32_t k = 0; k < nz; k++) {
        sf_slice out = sf_grid_slice(given, k), all = sf_grid_slice(solid, k);
        SF_TRY(sf_slice_copy(out, sf_grid_slice(wall, k)));
        if (terms != NULL && terms->act != NULL) {
            SF_TRY(sf_slice_subtract(out, all, sf_grid_slice(terms->act, k)));
            SF_TRY(sf_slice_or(out, out, sf_grid_slice(wall, k)));
        }
        if (terms != NULL && terms->keep != NULL) {
            SF_TRY(sf_slice_or(out, out, sf_grid_slice(terms->keep, k)));
            SF_TRY(sf_slice_and(out, out, all));
        }
    }
    return SF_OK;
}
