// SPDX-License-Identifier: MIT
// Drain holes: a way out for what is in a void.
//
// Voids are connected pieces of what is empty; those that touch no face of the grid are closed.
// They are drilled from the lowest up, so that a shaft may end in a void that is open by now. Where
// to drill is outlet.c's to say, how a shaft goes drill.c's. That a shaft leaves everything above
// it supported is a theorem only where all around it is solid, which it is not under a slanting
// floor: so a hole is drilled into a copy, the copy is looked at as a whole, and only what passes
// counts. Places next to one that failed fail as well, more often than not, and are not tried
// again.
//
// What the part did not support before the first hole counts as exempt: it is not made worse.

#include "balance/apart.h"
#include "balance/bases.h"
#include "balance/drill.h"
#include "balance/levels.h"
#include "balance/outlet.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

#define TRIES 32u // of each kind for one void

typedef struct drainer {
    const sf_drain_options *options;
    sf_grid *made, *trial, *hanging;
    sf_terms terms; // with what hung before as exempt, and the bed that it had
    int has_terms;
    sf_allocator allocator;
    sf_task *task;
    sfi_ground_plan plan;
    sfi_pieces pieces;
    uint8_t *is_open, *marks; // of each piece
    double *levels;
    sfi_closed_void *voids;
    size_t void_count;
    double (*ups)[3];
    sfi_levers levers;
    sfi_outlets outlets;
    sf_slice slices[3];
    size_t slice_words;
    sf_drain *drains; // found
    size_t drain_capacity;
    sf_drain_report report;
} drainer;

sf_drain_options sf_drain_options_default(void)
{
    sf_drain_options options;
    memset(&options, 0, sizeof options);
    options.struct_size = sizeof options;
    options.count = 1;
    return options;
}

// ---------------------------------------------------------------------------------------------
// Voids
// ---------------------------------------------------------------------------------------------

static int touches_side(const sf_lattice *l, const sf_run *run, uint32_t k)
{
    return k == 0 || k + 1 == l->nz || run->y == 0 || run->y + 1 == l->ny || run->x0 == 0 ||
           run->x1 == l->nx;
}

// Where each piece lies and how large it is, in an array with a place for each.
static void measure_pieces(drainer *d, sfi_closed_void *all)
{
    for (uint32_t i = 0; i < d->pieces.count; i++) {
        sfi_closed_void none = {i, 0, {0, 0, 0, 0, 0, 0}};
        all[i] = none;
    }
    for (uint32_t k = 0; k < d->plan.lattice.nz; k++) {
        for (size_t i = d->pieces.first[k]; i < d->pieces.first[k + 1]; i++) {
            const sf_run *run = &d->pieces.runs[i];
            sfi_closed_void *v = &all[run->label];
            sf_rect rect = {run->x0, run->y, run->x1, run->y + 1};
            v->voxels += run->x1 - run->x0;
            v->box = sfi_box_union(v->box, rect, k);
            d->is_open[run->label] |= (uint8_t)touches_side(&d->plan.lattice, run, k);
        }
    }
}

// Closed ones only, those that begin lower first: pieces are numbered by their first voxel already.
static sf_status find_voids(drainer *d)
{
    size_t count = d->pieces.count;
    d->is_open = sfi_alloc_array(&d->allocator, count + 1, 2);
    d->voids = sfi_alloc_array(&d->allocator, count + 1, sizeof *d->voids);
    if (d->is_open == NULL || d->voids == NULL) {
        return SF_ERR_MEMORY;
    }
    d->marks = d->is_open + count + 1;
    memset(d->is_open, 0, 2 * (count + 1));
    measure_pieces(d, d->voids);
    for (size_t i = 0; i < count; i++) {
        if (!d->is_open[i]) {
            d->report.void_voxels += d->voids[i].voxels;
            d->voids[d->void_count++] = d->voids[i];
        }
    }
    d->report.void_count = d->void_count;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Drilling
// ---------------------------------------------------------------------------------------------

static void locate(const drainer *d, const sfi_drill *at, double layer_share, double mm[3])
{
    const sf_lattice *l = &d->plan.lattice;
    int64_t k = at->layer < 0 ? 0 : at->layer;
    mm[0] = l->origin_mm[0] + ((double)at->x + 0.5) * l->pitch_x_mm;
    mm[1] = l->origin_mm[1] + ((double)at->y + 0.5) * l->pitch_y_mm;
    mm[2] = at->layer < 0 ? d->levels[0]
                          : d->levels[k] + layer_share * (d->levels[k + 1] - d->levels[k]);
}

static sf_status note(drainer *d, const sfi_closed_void *hollow, const sfi_drill *begin,
                      const sfi_bore *bore)
{
    sf_drain made = {{0, 0, 0}, {0, 0, 0}, bore->voxels, bore->body, hollow->voxels};
    locate(d, begin, 0, made.from_mm);
    locate(d, &bore->end, 1, made.to_mm);
    d->report.removed_voxels += bore->voxels;
    d->report.removed = sf_body_add(d->report.removed, 1, bore->body);
    if (d->report.drain_count >= d->options->drain_capacity) {
        d->report.drain_count++;
        d->report.drains_dropped++;
        return SF_OK;
    }
    if (!sfi_grow_array(&d->allocator, (void **)&d->drains, &d->drain_capacity,
                        (size_t)d->report.drain_count + 1, sizeof *d->drains)) {
        return SF_ERR_MEMORY;
    }
    d->drains[d->report.drain_count++] = made;
    return SF_OK;
}

static sf_status copy_layers(sf_grid *to, const sf_grid *from, int64_t first, int64_t end)
{
    for (int64_t k = first; k < end; k++) {
        SF_TRY(sf_slice_copy(sf_grid_slice(to, (uint32_t)k), sf_grid_slice(from, (uint32_t)k)));
    }
    return SF_OK;
}

// SF_OK: drilled; SF_ERR_INFEASIBLE: it may not be.
static sf_status try_outlet(drainer *d, const sfi_closed_void *hollow, const sfi_outlet *outlet)
{
    sfi_drill begin = sfi_drill_begin(outlet->x, outlet->y, outlet->layer, outlet->direction);
    sfi_bore bore = sfi_drill_measure(&d->plan, begin);
    int64_t low = bore.end.layer < 0 ? 0 : bore.end.layer, high = begin.layer;
    if (!bore.is_allowed || bore.voxels == 0) {
        return SF_ERR_INFEASIBLE;
    }
    if (!isfinite(bore.body.mass)) {
        return SF_ERR_ARGUMENT;
    }
    sfi_drill_remove(&d->plan, begin, d->trial);
    sf_status status = SF_OK;
    if (d->has_terms) {
        status = sf_grid_feasible(d->trial, d->trial, &d->terms, &d->allocator, NULL, NULL, NULL);
    }
    if (status != SF_OK) {
        SF_TRY(copy_layers(d->trial, d->made, low, high));
        return status;
    }
    sfi_drill_mark(&d->plan, begin, d->marks);
    SF_TRY(copy_layers(d->made, d->trial, low, high));
    return note(d, hollow, &begin, &bore);
}

// One more hole for a void, among the places that are left. `tries` counts down.
static sf_status drill_one(drainer *d, const sfi_closed_void *hollow, unsigned *tries)
{
    for (; *tries > 0; *tries -= 1) {
        sfi_outlet *best = sfi_outlets_best(&d->outlets);
        if (best == NULL) {
            break;
        }
        if (sf_task_is_cancelled(d->task)) {
            return SF_ERR_CANCELLED;
        }
        sf_status status = try_outlet(d, hollow, best);
        if (status == SF_OK) {
            best->state |= SFI_OUTLET_TAKEN;
        }
        if (status != SF_ERR_INFEASIBLE) {
            return status;
        }
        sfi_outlets_give_up(&d->outlets, &d->plan.lattice, best, d->options->diameter_mm);
        best->state |= SFI_OUTLET_VAIN;
    }
    return SF_ERR_INFEASIBLE;
}

// As far from the holes that the void has as half its length, or half of that, and so on.
static void keep_apart(const drainer *d, sf_box box)
{
    double x = (box.x1 - box.x0) * d->plan.lattice.pitch_x_mm;
    double y = (box.y1 - box.y0) * d->plan.lattice.pitch_y_mm;
    double least = 2 * d->options->diameter_mm, apart = 0.5 * sqrt(x * x + y * y);
    do {
        apart = apart > least ? apart : least;
        sfi_outlets_keep_apart(&d->outlets, &d->plan.lattice, apart);
        apart *= 0.5;
    } while (apart >= 0.5 * least && sfi_outlets_best(&d->outlets) == NULL);
}

// All holes of a void of one kind, straight or aslant; `left` counts down.
static sf_status drill_kind(drainer *d, const sfi_closed_void *hollow, int aslant, uint32_t *left)
{
    unsigned tries = TRIES;
    SF_TRY(sfi_outlets_find(&d->plan, hollow, aslant, &d->levers, d->slices, &d->allocator,
                            &d->outlets));
    while (*left > 0) {
        sf_status status = drill_one(d, hollow, &tries);
        if (status == SF_ERR_INFEASIBLE) {
            return SF_OK; // nowhere else
        }
        SF_TRY(status);
        *left -= 1;
        if (*left > 0) {
            keep_apart(d, hollow->box);
        }
    }
    return SF_OK;
}

static sf_status drain_void(drainer *d, const sfi_closed_void *hollow)
{
    uint32_t left = d->options->count;
    if (hollow->voxels < d->options->void_min || d->is_open[hollow->piece]) {
        return SF_OK;
    }
    memset(d->marks, 0, d->pieces.count);
    SF_TRY(drill_kind(d, hollow, 0, &left));
    if (left == d->options->count) {
        SF_TRY(drill_kind(d, hollow, 1, &left));
    }
    d->is_open[hollow->piece] |= left < d->options->count;
    for (uint32_t i = 0; i < d->pieces.count; i++) {
        d->is_open[i] |= d->marks[i];
    }
    return SF_OK;
}

static sf_status drain(drainer *d)
{
    sfi_progress progress = sfi_progress_begin(d->task);
    for (size_t i = 0; i < d->void_count; i++) {
        SF_TRY(drain_void(d, &d->voids[i]));
        sfi_progress_report(&progress, i + 1, d->void_count + 1);
    }
    for (size_t i = 0; i < d->void_count; i++) {
        int is_open = d->is_open[d->voids[i].piece];
        d->report.drained_count += (uint64_t)is_open;
        d->report.closed_count += (uint64_t)!is_open;
        d->report.closed_voxels += is_open ? 0 : d->voids[i].voxels;
    }
    sfi_progress_report(&progress, 1, 1);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Arguments and memory
// ---------------------------------------------------------------------------------------------

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
static sf_status settle_terms(drainer *d, const sf_grid *grid, const sf_terms *terms)
{
    sfi_ground ground;
    d->terms = *terms;
    d->has_terms = 1;
    SF_TRY(sfi_terms_check(terms, grid, &ground));
    if (ground.bed < ground.lattice.nz) {
        d->terms.bed_layer = ground.bed; // whatever holes do to the layer that it was chosen by
    }
    SF_TRY(sf_rule_measure(&terms->rule, &ground.lattice, &d->plan.angles));
    SF_TRY(sf_grid_create(&ground.lattice, &d->allocator, &d->hanging));
    sf_status status =
        sf_grid_feasible(grid, grid, &d->terms, &d->allocator, NULL, d->hanging, NULL);
    if (status != SF_OK && status != SF_ERR_INFEASIBLE) {
        return status;
    }
    for (uint32_t k = 0; terms->exempt != NULL && k < ground.lattice.nz; k++) {
        sf_slice hanging = sf_grid_slice(d->hanging, k);
        SF_TRY(sf_slice_or(hanging, hanging, sf_grid_slice(terms->exempt, k)));
    }
    d->terms.exempt = d->hanging;
    return SF_OK;
}

static sf_status settle_levers(drainer *d)
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

static sf_status create(drainer *d, const sf_grid *grid, const sf_terms *terms)
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
    SF_TRY(find_voids(d));
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

static void destroy(drainer *d)
{
    const sf_allocator *a = &d->allocator;
    size_t pieces = (size_t)d->pieces.count + 1;
    sfi_free_array(a, d->is_open, pieces, 2);
    sfi_free_array(a, d->voids, pieces, sizeof *d->voids);
    sfi_pieces_destroy(&d->pieces, a);
    sfi_free_array(a, d->slices[0].words, d->slice_words, 3 * sizeof *d->slices[0].words);
    sfi_free_array(a, d->ups, d->options->stance_count, sizeof *d->ups);
    sfi_free_array(a, d->outlets.list, d->outlets.capacity, sizeof *d->outlets.list);
    sfi_free_array(a, d->drains, d->drain_capacity, sizeof *d->drains);
    sfi_levels_destroy(d->levels, &d->plan.lattice, a);
    sf_grid_destroy(d->hanging);
    sf_grid_destroy(d->trial);
    sf_grid_destroy(d->made);
}

sf_status sf_grid_drain(sf_grid *grid, const sf_terms *terms, const sf_drain_options *options,
                        const sf_allocator *allocator, sf_task *task, sf_drain_report *report)
{
    SF_TRY(check(grid, terms, options));
    drainer d;
    memset(&d, 0, sizeof d);
    d.options = options;
    d.task = task;
    d.allocator = sfi_allocator_or_default(allocator);
    sf_status status = create(&d, grid, terms);
    if (status == SF_OK) {
        status = drain(&d);
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
