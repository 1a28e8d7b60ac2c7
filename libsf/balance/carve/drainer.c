// SPDX-License-Identifier: MIT
// Drain holes: a way out for what is in a void, or nothing in it.
//
// Voids are connected pieces of what is empty; those that touch no face of the grid are closed.
// They are drilled from the lowest up, so that a shaft may end in a void that is open by now. Where
// to drill is outlet.c's to say, how a shaft goes drill.c's. That a shaft leaves everything above
// it supported is a theorem only where all around it is solid, which it is not under a slanting
// floor: so a hole is drilled into a copy, the copy is looked at as a whole, and only what passes
// counts. Places next to one that failed fail as well, more often than not, and are not tried
// again. Where none is found, the first place counts at which little hangs afterwards: around the
// lower end of a hole through a shallow underside, whose rim stood on what is drilled out. That
// goes with it, and the hole is a little wider there.
//
// What is filled was solid once, in whoever's part this is a cavity of, but that is not known here:
// it is looked at like a hole.

#include "balance/carve/drainer.h"

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/terms.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

#include <math.h>
#include <string.h>

#define TRIES 32u   // of each kind for one void
#define WIDENING 4u // a hole takes no more with it than one part in so many

// ---------------------------------------------------------------------------------------------
// Voids
// ---------------------------------------------------------------------------------------------

static int touches_side(const sf_lattice *l, const sf_run *run, uint32_t k)
{
    return k == 0 || k + 1 == l->nz || run->y == 0 || run->y + 1 == l->ny || run->x0 == 0 ||
           run->x1 == l->nx;
}

// Where each piece lies and how large it is, in an array with a place for each.
static void measure_pieces(sfi_drainer *d, sfi_closed_void *all)
{
    for (uint32_t i = 0; i < d->pieces.count; i++) {
        sfi_closed_void none = {i, 0, {0, 0, 0, 0, 0, 0}, 0};
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
sf_status sfi_drainer_find(sfi_drainer *d)
{
    size_t count = d->pieces.count;
    d->is_open = sfi_alloc_array(&d->allocator, count + 1, 2);
    d->voids = sfi_alloc_array(&d->allocator, count + 1, sizeof *d->voids);
    d->marks.list = sfi_alloc_array(&d->allocator, count + 1, sizeof *d->marks.list);
    if (d->is_open == NULL || d->voids == NULL || d->marks.list == NULL) {
        return SF_ERR_MEMORY;
    }
    d->marks.is_marked = d->is_open + count + 1;
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

static void locate(const sfi_drainer *d, const sfi_drill *at, double layer_share, double mm[3])
{
    const sf_lattice *l = &d->plan.lattice;
    int64_t k = at->layer < 0 ? 0 : at->layer;
    mm[0] = l->origin_mm[0] + ((double)at->x + 0.5) * l->pitch_x_mm;
    mm[1] = l->origin_mm[1] + ((double)at->y + 0.5) * l->pitch_y_mm;
    mm[2] = at->layer < 0 ? d->levels[0]
                          : d->levels[k] + layer_share * (d->levels[k + 1] - d->levels[k]);
}

static sf_status note(sfi_drainer *d, const sfi_closed_void *hollow, const sfi_drill *begin,
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

// Whether all that hangs now may be taken away as well.
static int may_lose(const sfi_drainer *d, sf_box box)
{
    for (uint32_t k = box.z0; k < box.z1; k++) {
        sf_slice lost = sf_grid_slice(d->lost, k), act = sfi_mask_slice(d->terms.act, k);
        for (uint32_t i = 0; i < (box.x1 - box.x0) * (box.y1 - box.y0); i++) {
            uint32_t x = box.x0 + i % (box.x1 - box.x0), y = box.y0 + i / (box.x1 - box.x0);
            if (sf_slice_get(lost, x, y) && (sf_slice_get(sfi_mask_slice(d->terms.keep, k), x, y) ||
                                             (act.words != NULL && !sf_slice_get(act, x, y)))) {
                return 0;
            }
        }
    }
    return 1;
}

// Take away what hangs, as part of the hole. What then is left does not hang: it is the trim.
static sf_status take_lost(sfi_drainer *d, sf_box box, sfi_bore *bore)
{
    sf_body body;
    SF_TRY(sf_grid_body(d->lost, d->options->density, NULL, &body));
    bore->body = sf_body_add(bore->body, 1, body);
    bore->voxels += sf_grid_popcount(d->lost);
    for (uint32_t k = box.z0; k < box.z1; k++) {
        sf_slice trial = sf_grid_slice(d->trial, k);
        SF_TRY(sf_slice_subtract(trial, trial, sf_grid_slice(d->lost, k)));
    }
    sfi_drill_mark_around(&d->plan, d->lost, box, &d->marks);
    return SF_OK;
}

// SF_OK: drilled; SF_ERR_INFEASIBLE: it may not be. Where no more than a share of what is drilled
// would hang, it is `nearly` possible, and done where `widen` says so.
static sf_status try_outlet(sfi_drainer *d, const sfi_closed_void *hollow, const sfi_outlet *outlet,
                            int widen, int *nearly)
{
    sfi_drill begin = sfi_drill_begin(outlet->x, outlet->y, outlet->layer, outlet->direction);
    sfi_bore bore = sfi_drill_measure(&d->plan, begin);
    sf_box box = {0, 0, 0, 0, 0, 0};
    int64_t low = bore.end.layer < 0 ? 0 : bore.end.layer, high = begin.layer;
    uint64_t lost = 0;
    *nearly = 0;
    if (!bore.is_allowed || bore.voxels == 0) {
        return SF_ERR_INFEASIBLE;
    }
    if (!isfinite(bore.body.mass)) {
        return SF_ERR_ARGUMENT;
    }
    sfi_drill_remove(&d->plan, begin, d->trial);
    sf_status status = SF_OK;
    if (d->has_terms) {
        status =
            sf_grid_feasible(d->trial, d->trial, &d->terms, &d->allocator, NULL, d->lost, &lost);
    }
    if (status == SF_ERR_INFEASIBLE && lost <= bore.voxels / WIDENING) {
        box = sf_grid_bounds(d->lost);
        *nearly = may_lose(d, box);
        status = *nearly && widen ? take_lost(d, box, &bore) : status;
    }
    if (status != SF_OK) {
        SF_TRY(copy_layers(d->trial, d->made, low, high));
        return status;
    }
    sfi_drill_mark(&d->plan, begin, &d->marks);
    SF_TRY(copy_layers(d->made, d->trial, low, high));
    SF_TRY(copy_layers(d->made, d->trial, box.z0, box.z1));
    return note(d, hollow, &begin, &bore);
}

// One more hole for a void, among the places that are left. `tries` counts down.
static sf_status drill_one(sfi_drainer *d, const sfi_closed_void *hollow, unsigned *tries)
{
    sfi_outlet *fallback = NULL;
    int nearly;
    for (; *tries > 0; *tries -= 1) {
        sfi_outlet *best = sfi_outlets_best(&d->outlets);
        if (best == NULL) {
            break;
        }
        if (sf_task_is_cancelled(d->task)) {
            return SF_ERR_CANCELLED;
        }
        sf_status status = try_outlet(d, hollow, best, 0, &nearly);
        if (status == SF_OK) {
            best->state |= SFI_OUTLET_TAKEN;
        }
        if (status != SF_ERR_INFEASIBLE) {
            return status;
        }
        fallback = nearly && fallback == NULL ? best : fallback;
        sfi_outlets_give_up(&d->outlets, &d->plan.lattice, best, d->options->diameter_mm);
        best->state |= SFI_OUTLET_VAIN;
    }
    if (fallback == NULL) {
        return SF_ERR_INFEASIBLE;
    }
    fallback->state |= SFI_OUTLET_TAKEN;
    return try_outlet(d, hollow, fallback, 1, &nearly);
}

// As far from the holes that the void has as half its length, or half of that, and so on.
static void keep_apart(const sfi_drainer *d, sf_box box)
{
    double x = (box.x1 - box.x0) * d->plan.lattice.pitch_x_mm;
    double y = (box.y1 - box.y0) * d->plan.lattice.pitch_y_mm;
    double least = 2 * d->options->diameter_mm, apart = 0.5 * sqrt(x * x + y * y);
    apart = apart > least ? apart : least;
    sfi_outlets_keep_apart(&d->outlets, &d->plan.lattice, apart);
    while (apart > least && sfi_outlets_best(&d->outlets) == NULL) {
        apart = 0.5 * apart > least ? 0.5 * apart : least;
        sfi_outlets_keep_apart(&d->outlets, &d->plan.lattice, apart);
    }
}

// All holes of a void of one kind, straight or aslant; `left` counts down.
static sf_status drill_kind(sfi_drainer *d, const sfi_closed_void *hollow, int aslant,
                            uint32_t *left)
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

static sf_status drain_void(sfi_drainer *d, sfi_closed_void *hollow)
{
    uint32_t left = d->options->count;
    if (d->is_open[hollow->piece]) {
        return SF_OK;
    }
    if (hollow->voxels < d->options->void_min) {
        hollow->is_narrow = 1;
        return SF_OK;
    }
    SF_TRY(drill_kind(d, hollow, 0, &left));
    hollow->is_narrow = d->outlets.count == 0;
    if (left == d->options->count) {
        SF_TRY(drill_kind(d, hollow, 1, &left));
    }
    d->is_open[hollow->piece] |= left < d->options->count;
    // There may be as many voids as voxels: none of them looks at all pieces.
    for (size_t i = 0; i < d->marks.count; i++) {
        d->is_open[d->marks.list[i]] = 1;
        d->marks.is_marked[d->marks.list[i]] = 0;
    }
    d->marks.count = 0;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Filling
// ---------------------------------------------------------------------------------------------

// Whether matter may be added in all of a run.
static int may_fill(const sfi_drainer *d, const sf_run *run, uint32_t k)
{
    int may = 1;
    for (uint32_t x = run->x0; d->has_terms && may && x < run->x1; x++) {
        sf_slice act = sfi_mask_slice(d->terms.act, k);
        may = !sf_slice_get(sfi_mask_slice(d->terms.forbid, k), x, run->y) &&
              (act.words == NULL || sf_slice_get(act, x, run->y));
    }
    return may;
}

// Solid again in the trial; returns whether all of it may be.
static int fill_trial(const sfi_drainer *d, const sfi_closed_void *hollow)
{
    for (uint32_t k = hollow->box.z0; k < hollow->box.z1; k++) {
        for (size_t i = d->pieces.first[k]; i < d->pieces.first[k + 1]; i++) {
            const sf_run *run = &d->pieces.runs[i];
            sf_rect rect = {run->x0, run->y, run->x1, run->y + 1};
            if (run->label == hollow->piece &&
                (!may_fill(d, run, k) ||
                 sf_slice_fill(sf_grid_slice(d->trial, k), rect, 1) != SF_OK)) {
                return 0;
            }
        }
    }
    return 1;
}

static sf_status fill_void(sfi_drainer *d, const sfi_closed_void *hollow, int *is_filled)
{
    int64_t low = hollow->box.z0, high = hollow->box.z1;
    if (sf_task_is_cancelled(d->task)) {
        return SF_ERR_CANCELLED;
    }
    *is_filled = fill_trial(d, hollow);
    if (*is_filled && d->has_terms) {
        sf_status status =
            sf_grid_feasible(d->trial, d->trial, &d->terms, &d->allocator, NULL, NULL, NULL);
        *is_filled = status == SF_OK;
        if (status != SF_OK && status != SF_ERR_INFEASIBLE) {
            return status;
        }
    }
    return *is_filled ? copy_layers(d->made, d->trial, low, high)
                      : copy_layers(d->trial, d->made, low, high);
}

static sf_status finish_void(sfi_drainer *d, const sfi_closed_void *hollow)
{
    int is_open = d->is_open[hollow->piece], is_filled = 0;
    if (!is_open && hollow->is_narrow && d->options->fill) {
        SF_TRY(fill_void(d, hollow, &is_filled));
    }
    d->report.drained_count += (uint64_t)is_open;
    d->report.filled_count += (uint64_t)is_filled;
    d->report.filled_voxels += is_filled ? hollow->voxels : 0;
    d->report.closed_count += (uint64_t)(!is_open && !is_filled);
    d->report.closed_voxels += is_open || is_filled ? 0 : hollow->voxels;
    return SF_OK;
}

sf_status sfi_drainer_run(sfi_drainer *d)
{
    sfi_progress progress = sfi_progress_begin(d->task);
    for (size_t i = 0; i < d->void_count; i++) {
        SF_TRY(drain_void(d, &d->voids[i]));
        sfi_progress_report(&progress, i + 1, d->void_count + 1);
    }
    for (size_t i = 0; i < d->void_count; i++) {
        SF_TRY(finish_void(d, &d->voids[i]));
    }
    sfi_progress_report(&progress, 1, 1);
    return SF_OK;
}
