// SPDX-License-Identifier: MIT
// Drain holes as callers meet them: arguments, memory, and a part that changes at once or not at
// all. What is done is drainer.c's.
//
// What nothing carried in the part before the first hole counts as exempt: it is not made worse.
// And its bed stays the layer that it was, even where a hole takes all that rested on it.

#include "balance/carve/drainer.h"
#include "balance/wall/apart.h"
#include "balance/wall/levels.h"
#include "base/memory.h"
#include "base/status.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

sf_drain_options sf_drain_options_default(void)
{
    sf_drain_options options;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    options.count = 1;
    return options;
}

static sf_status check(const sf_grid *grid, const sf_terms *terms, const sf_drain_options *o)
{
    sfi_ground ground;
    double com[3];
    if (grid == NULL || o == NULL || o->struct_size < sizeof *o || !(o->diameter_mm > 0) ||
        !isfinite(o->diameter_mm) || o->count == 0 ||
        (o->drains == NULL && o->drain_capacity > 0)) {
        return SF_ERR_ARGUMENT;
    }
    for (int i = 0; o->stance_count > 0 && i < 3; i++) {
        if (!isfinite(o->body.mass) || !isfinite(o->body.moment[i]) ||
            sf_body_com(o->body, com) != SF_OK) {
            return SF_ERR_ARGUMENT;
        }
    }
    if (terms != NULL) {
        SF_TRY(sfi_terms_check(terms, grid, &ground));
        if (sfi_terms_mask(terms, grid)) {
            return SF_ERR_ARGUMENT;
        }
    }
    sf_lattice l = sf_grid_lattice(grid);
    return sfi_apart_fits(0.5 * o->diameter_mm, l.pitch_x_mm, l.pitch_y_mm) ? SF_OK
                                                                            : SF_ERR_UNSUPPORTED;
}

// Terms under which the part as it came is support-free.
static sf_status settle_terms(sfi_drainer *d, const sf_grid *grid, const sf_terms *terms)
{
    sfi_ground ground;
    d->terms = *terms;
    d->has_terms = 1;
    SF_TRY(sfi_terms_check(terms, grid, &ground));
    if (ground.bed < ground.lattice.nz) {
        d->terms.bed_layer = ground.bed; // whatever holes do to the layer that it was chosen by
    }
    SF_TRY(sf_rule_measure(&terms->rule, &ground.lattice, &d->plan.angles));
    SF_TRY(sf_grid_create(&ground.lattice, &d->allocator, &d->lost));
    SF_TRY(sf_grid_create(&ground.lattice, &d->allocator, &d->hanging));
    SF_TRY(sf_grid_unsupported(grid, &d->terms, &d->allocator, NULL, d->hanging, NULL));
    for (uint32_t k = 0; terms->exempt != NULL && k < ground.lattice.nz; k++) {
        sf_slice hanging = sf_grid_slice(d->hanging, k);
        SF_TRY(sf_slice_or(hanging, hanging, sf_grid_slice(terms->exempt, k)));
    }
    d->terms.exempt = d->hanging;
    return SF_OK;
}

static sf_status settle_levers(sfi_drainer *d)
{
    const sf_drain_options *o = d->options;
    d->levers.diagonal = sfi_levels_diagonal(&d->plan.lattice, d->levels);
    if (o->stance_count == 0) {
        return SF_OK;
    }
    SF_TRY(sf_body_com(o->body, d->levers.com));
    d->ups = sfi_alloc_array(&d->allocator, o->stance_count, sizeof *d->ups);
    if (d->ups == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < o->stance_count; i++) {
        if (o->stances == NULL || o->stances[i] == NULL) {
            return SF_ERR_ARGUMENT;
        }
        sf_stance_options stance = sf_stance_get_options(o->stances[i]);
        memcpy(d->ups[i], stance.up, sizeof d->ups[i]);
    }
    d->levers.ups = (const double(*)[3])d->ups;
    d->levers.count = o->stance_count;
    return SF_OK;
}

static sf_status create(sfi_drainer *d, const sf_grid *grid, const sf_terms *terms)
{
    sfi_ground_plan *plan = &d->plan;
    double radius = 0.5 * d->options->diameter_mm;
    plan->lattice = sf_grid_lattice(grid);
    d->levels = sfi_levels_create(&plan->lattice, &d->allocator);
    if (d->levels == NULL) {
        return SF_ERR_MEMORY;
    }
    // Every voxel that the disk around a voxel's middle touches: never empty.
    (void)!sfi_apart_element(radius * radius, 0.5, plan->lattice.pitch_x_mm,
                             plan->lattice.pitch_y_mm, &plan->disk);
    SF_TRY(settle_levers(d));
    SF_TRY(sf_grid_clone(grid, &d->allocator, &d->made));
    SF_TRY(sf_grid_clone(grid, &d->allocator, &d->trial));
    if (terms != NULL) {
        SF_TRY(settle_terms(d, grid, terms));
        plan->terms = &d->terms;
    }
    SF_TRY(sfi_pieces_create(grid, SFI_PIECES_EMPTY, &d->allocator, d->task, &d->pieces));
    SF_TRY(sfi_drainer_find(d));
    plan->made = d->made;
    plan->levels = d->levels;
    plan->density = d->options->density;
    plan->pieces = &d->pieces;
    plan->is_open = d->is_open;
    sf_slice slice = sf_grid_slice(d->made, 0);
    d->slice_words = slice.stride * slice.height;
    slice.words = sfi_alloc_array(&d->allocator, d->slice_words, 3 * sizeof *slice.words);
    if (slice.words == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < 3; i++) {
        d->slices[i] = slice;
        d->slices[i].words += i * d->slice_words;
        sfi_slice_clear(d->slices[i]);
    }
    return SF_OK;
}

static void destroy(sfi_drainer *d)
{
    const sf_allocator *a = &d->allocator;
    size_t pieces = (size_t)d->pieces.count + 1;
    sfi_free_array(a, d->is_open, pieces, 2);
    sfi_free_array(a, d->voids, pieces, sizeof *d->voids);
    sfi_free_array(a, d->marks.list, pieces, sizeof *d->marks.list);
    sfi_pieces_destroy(&d->pieces, a);
    sfi_free_array(a, d->slices[0].words, d->slice_words, 3 * sizeof *d->slices[0].words);
    sfi_free_array(a, d->ups, d->options->stance_count, sizeof *d->ups);
    sfi_free_array(a, d->outlets.list, d->outlets.capacity, sizeof *d->outlets.list);
    sfi_free_array(a, d->drains, d->drain_capacity, sizeof *d->drains);
    sfi_levels_destroy(d->levels, &d->plan.lattice, a);
    sf_grid_destroy(d->lost);
    sf_grid_destroy(d->hanging);
    sf_grid_destroy(d->trial);
    sf_grid_destroy(d->made);
}

sf_status sf_grid_drain(sf_grid *grid, const sf_terms *terms, const sf_drain_options *options,
                        const sf_allocator *allocator, sf_task *task, sf_drain_report *report)
{
    SF_TRY(check(grid, terms, options));
    sfi_drainer d;
    memset(&d, 0, sizeof d);
    d.options = options;
    d.task = task;
    d.allocator = sfi_allocator_or_default(allocator);
    sf_status status = create(&d, grid, terms);
    if (status == SF_OK) {
        status = sfi_drainer_run(&d);
    }
    if (status == SF_OK) {
        status = sfi_grid_copy(grid, d.made);
    }
    if (status == SF_OK) {
        for (uint64_t i = 0; i < d.report.drain_count - d.report.drains_dropped; i++) {
            options->drains[i] = d.drains[i];
        }
        if (report != NULL) {
            *report = d.report;
        }
    }
    destroy(&d);
    return status;
}
