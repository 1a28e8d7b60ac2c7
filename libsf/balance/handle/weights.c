// SPDX-License-Identifier: MIT
// Weights: the cells, what handles hold of them, the solve, and what is made of its result.
//
// Handles are worked on in groups of four, each for itself, so that any number of threads gives the
// same bytes. Groups run in waves of at most four, which bounds the memory and lets progress be
// told between them.
//
// CLAMPED: without bounds the weights of all handles together are 1 everywhere, because a constant
// has no energy. So what is cut off at 0 and 1 has a sum of at least 1, and dividing by it keeps 0
// and, where a handle holds, 1.

#include "balance/handle/weights.h"

#include "balance/handle/weights_bounds.h"
#include "balance/handle/weights_claim.h"
#include "balance/handle/weights_loose.h"
#include "balance/handle/weights_plate.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"

#include <math.h>
#include <string.h>

enum { WAVE = 4, GROUPS_MAX = SF_HANDLE_MAX / SFI_LANES };

// The error is up to ten times the largest correction that is asked for.
#define MARGIN 0.1

// What one group of a wave works with.
typedef struct team {
    sfi_plate plate;
    int has_plate;
    double *memory; // w, x, and what bounds need
    sf_status status;
    double left;
} team;

typedef struct work {
    sf_allocator allocator;
    sf_weights_options options;
    sf_task *task;
    sf_weights *weights;
    sfi_poisson poisson;
    uint8_t *owner, *fixed;
    uint32_t *piece, *queue;
    size_t nodes, handles, first; // of this wave's first group
    size_t team_numbers;
    team teams[WAVE];
} work;

// ---------------------------------------------------------------------------------------------
// One group
// ---------------------------------------------------------------------------------------------

// From the values of fixed nodes, which w holds, to those of all.
static sf_status solve_group(work *w, team *t, size_t lanes)
{
    size_t numbers = SFI_LANES * w->nodes;
    double *values = t->memory, *x = values + numbers, *scratch = x + numbers;
    double enough = MARGIN * w->options.tolerance;
    sfi_plate_goal goal[SFI_LANES];
    for (size_t k = 0; k < SFI_LANES; k++) {
        sfi_plate_goal g = {enough, 0, 0, 0};
        goal[k] = g;
    }
    sfi_cycle_hold(&t->plate.cycle, w->fixed, NULL);
    sfi_plate_apply(&t->plate, values, scratch);
    for (size_t n = 0; n < numbers; n++) {
        scratch[n] = -scratch[n];
    }
    SF_TRY(sfi_plate_solve(&t->plate, NULL, scratch, w->task, x, goal));
    for (size_t n = 0; n < numbers; n++) {
        values[n] += x[n];
    }
    for (size_t k = 0; k < SFI_LANES; k++) {
        t->left = goal[k].left > t->left ? goal[k].left : t->left;
    }
    if (w->options.method == SF_WEIGHTS_BOUNDED) {
        SF_TRY(sfi_bounds_solve(&t->plate, lanes, enough, w->task, scratch, values, &t->left));
    }
    t->left /= MARGIN;
    return SF_OK;
}

static void run_group(void *context, size_t index)
{
    work *w = context;
    team *t = &w->teams[index];
    size_t first = (w->first + index) * SFI_LANES;
    size_t lanes = w->handles - first < SFI_LANES ? w->handles - first : SFI_LANES;
    double *values = t->memory;
    for (size_t i = 0; i < w->nodes; i++) {
        for (size_t k = 0; k < SFI_LANES; k++) {
            values[SFI_LANES * i + k] = w->owner[i] == first + k;
        }
    }
    t->status = solve_group(w, t, lanes);
    for (size_t i = 0; i < w->nodes; i++) {
        memcpy(w->weights->values + i * w->handles + first, values + SFI_LANES * i,
               lanes * sizeof *values);
    }
}

// ---------------------------------------------------------------------------------------------
// All groups
// ---------------------------------------------------------------------------------------------

static sf_status make_teams(work *w, size_t count)
{
    size_t vectors = 3 + (w->options.method == SF_WEIGHTS_BOUNDED ? SFI_BOUNDS_VECTORS - 1 : 0);
    if (!sfi_size_mul(w->nodes, SFI_LANES * vectors, &w->team_numbers)) {
        return SF_ERR_OVERFLOW;
    }
    for (size_t i = 0; i < count; i++) {
        team *t = &w->teams[i];
        SF_TRY(sfi_plate_create(&w->poisson, w->fixed, &w->allocator, &t->plate));
        t->has_plate = 1;
        t->memory = sfi_alloc_array(&w->allocator, w->team_numbers, sizeof *t->memory);
        if (t->memory == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    return SF_OK;
}

static sf_status solve(work *w)
{
    sfi_progress progress = sfi_progress_begin(w->task);
    size_t groups = (w->handles + SFI_LANES - 1) / SFI_LANES;
    SF_TRY(make_teams(w, groups < WAVE ? groups : WAVE));
    sfi_progress_report(&progress, 1, 20);
    for (w->first = 0; w->first < groups; w->first += WAVE) {
        size_t count = groups - w->first < WAVE ? groups - w->first : WAVE;
        for (size_t i = 0; i < count; i++) {
            w->teams[i].left = 0;
        }
        sfi_task_for(w->task, count, run_group, w);
        for (size_t i = 0; i < count; i++) {
            sf_weights_facts *facts = &w->weights->facts;
            SF_TRY(w->teams[i].status);
            facts->residual =
                w->teams[i].left > facts->residual ? w->teams[i].left : facts->residual;
        }
        sfi_progress_report(&progress, 1 + 19 * (w->first + count), 1 + 19 * groups);
    }
    for (size_t i = 0; i < WAVE && w->teams[i].has_plate; i++) {
        w->weights->facts.iterations += w->teams[i].plate.steps;
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// What is made of the result
// ---------------------------------------------------------------------------------------------

// Cut a node's weights off at 0 and 1, and divide by their sum.
static void normalize(double *w, size_t count)
{
    double sum = 0;
    for (size_t j = 0; j < count; j++) {
        w[j] = !(w[j] > 0) ? 0 : w[j] > 1 ? 1 : w[j];
        sum += w[j];
    }
    for (size_t j = 0; j < count; j++) {
        // Bounded weights, each found for itself, might all be 0 far from every handle.
        w[j] = sum > 0 ? w[j] / sum : 1.0 / (double)count;
    }
}

// ---------------------------------------------------------------------------------------------
// The call
// ---------------------------------------------------------------------------------------------

static sf_status reserve(work *w)
{
    const sf_allocator *a = &w->allocator;
    sf_weights *made = w->weights;
    size_t numbers;
    w->nodes = made->domain.node_count;
    if (!sfi_size_mul(w->nodes, w->handles, &numbers)) {
        return SF_ERR_OVERFLOW;
    }
    made->values = sfi_alloc_array(a, numbers, sizeof *made->values);
    made->centers = sfi_alloc_array(a, 3 * w->handles, sizeof *made->centers);
    w->owner = sfi_alloc_array(a, w->nodes, sizeof *w->owner);
    w->fixed = sfi_alloc_array(a, w->nodes, sizeof *w->fixed);
    w->piece = sfi_alloc_array(a, w->nodes, sizeof *w->piece);
    w->queue = sfi_alloc_array(a, w->nodes, sizeof *w->queue);
    int all = made->values != NULL && made->centers != NULL && w->owner != NULL &&
              w->fixed != NULL && w->piece != NULL && w->queue != NULL;
    return all ? SF_OK : SF_ERR_MEMORY;
}

static void release(work *w)
{
    const sf_allocator *a = &w->allocator;
    for (size_t i = 0; i < WAVE; i++) {
        team *t = &w->teams[i];
        sfi_free_array(a, t->memory, w->team_numbers, sizeof *t->memory);
        if (t->has_plate) {
            sfi_plate_destroy(&t->plate, a);
        }
    }
    sfi_poisson_destroy(&w->poisson);
    sfi_free_array(a, w->owner, w->nodes, sizeof *w->owner);
    sfi_free_array(a, w->fixed, w->nodes, sizeof *w->fixed);
    sfi_free_array(a, w->piece, w->nodes, sizeof *w->piece);
    sfi_free_array(a, w->queue, w->nodes, sizeof *w->queue);
}

static void note_facts(work *w)
{
    const sfi_domain *d = &w->weights->domain;
    sf_weights_facts *f = &w->weights->facts;
    f->handle_count = w->handles;
    f->cell_count = d->cell_count;
    f->node_count = d->node_count;
    for (int axis = 0; axis < 3; axis++) {
        f->block[axis] = d->block[axis];
        f->cell_mm[axis] = (d->planes[axis][d->cells[axis]] - d->planes[axis][0]) / d->cells[axis];
    }
}

static sf_status make(work *w, const sf_grid *solid, const sf_handle *handles, sf_fault *fault)
{
    sf_weights *made = w->weights;
    const sf_weights_options *o = &w->options;
    SF_TRY(sfi_domain_create(solid, o->cell_mm, o->most_cells, &w->allocator, &made->domain));
    SF_TRY(reserve(w));
    note_facts(w);
    SF_TRY(sfi_domain_reach(&made->domain));
    SF_TRY(sfi_claim(&made->domain, handles, w->handles, w->owner, fault));
    SF_TRY(sfi_poisson_create(&made->domain, &w->poisson));
    made->facts.loose_count = sfi_claim_pieces(&w->poisson.level[0], w->owner, w->piece, w->queue);
    for (size_t i = 0; i < w->nodes; i++) {
        w->fixed[i] = w->owner[i] != SFI_NODE_FREE;
    }
    for (size_t j = 0; j < w->handles; j++) {
        memcpy(made->centers + 3 * j, handles[j].at_mm, 3 * sizeof(double));
    }
    SF_TRY(solve(w));
    for (size_t i = 0; i < w->nodes; i++) {
        normalize(made->values + i * w->handles, w->handles);
    }
    return made->facts.loose_count > 0 ? sfi_loose_settle(w->owner, w->piece, &w->allocator, made)
                                       : SF_OK;
}

static int is_handle(const sf_handle *h)
{
    int finite = isfinite(h->at_mm[0]) && isfinite(h->at_mm[1]) && isfinite(h->at_mm[2]);
    return finite && (h->kind == SF_HANDLE_POINT ||
                      (h->kind == SF_HANDLE_BALL && h->radius_mm > 0 && isfinite(h->radius_mm)) ||
                      (h->kind == SF_HANDLE_BASE && h->region != NULL));
}

static sf_status check(const sf_grid *solid, const sf_handle *handles, size_t count,
                       const sf_weights_options *o, sf_fault *fault)
{
    if (count < 1 || count > SF_HANDLE_MAX || o->struct_size < sizeof *o ||
        (o->method != SF_WEIGHTS_CLAMPED && o->method != SF_WEIGHTS_BOUNDED) || o->most_cells < 8 ||
        !(o->cell_mm >= 0 && o->cell_mm <= 1e12) ||
        !(o->tolerance >= 1e-9 && o->tolerance <= 1e-2)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "there must be 1 to %u handles, and options within their ranges",
                             SF_HANDLE_MAX);
    }
    if (sf_grid_popcount(solid) == 0) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "the solid has no voxels: there is nothing to give weights to");
    }
    sf_lattice l = sf_grid_lattice(solid);
    for (size_t j = 0; j < count; j++) {
        if (!is_handle(&handles[j])) {
            return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                                 "handle %u is no point, ball or base: its centre must be "
                                 "finite, a ball has a radius, a base a region",
                                 (unsigned)j + 1u);
        }
        if (handles[j].kind == SF_HANDLE_BASE) {
            sf_lattice r = sf_grid_lattice(handles[j].region);
            if (r.nx != l.nx || r.ny != l.ny || r.nz != l.nz) {
                return sfi_fault_set(fault, SF_ERR_SHAPE, 0, 0,
                                     "the region of handle %u is not on the solid's lattice",
                                     (unsigned)j + 1u);
            }
        }
    }
    return SF_OK;
}

sf_weights_options sf_weights_options_default(void)
{
    sf_weights_options options = {sizeof options, SF_WEIGHTS_CLAMPED, 32768, 0, 1e-5};
    return options;
}

sf_status sf_weights_create(const sf_grid *solid, const sf_handle *handles, size_t count,
                            const sf_weights_options *options, const sf_allocator *allocator,
                            sf_task *task, sf_weights **weights, sf_fault *fault)
{
    work w = {.allocator = sfi_allocator_or_default(allocator), .task = task, .handles = count};
    w.options = options != NULL ? *options : sf_weights_options_default();
    if (solid == NULL || handles == NULL || weights == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "a solid, handles and a place for the weights must be given");
    }
    SF_TRY(check(solid, handles, count, &w.options, fault));
    if (sf_task_is_cancelled(task)) {
        return sfi_fault_set(fault, SF_ERR_CANCELLED, 0, 0, "cancelled");
    }
    w.weights = sfi_alloc_array(&w.allocator, 1, sizeof *w.weights);
    if (w.weights == NULL) {
        return sfi_fault_set(fault, SF_ERR_MEMORY, 0, 0, "out of memory for weights");
    }
    memset(w.weights, 0, sizeof *w.weights);
    w.weights->allocator = w.allocator;
    w.weights->count = count;
    sf_fault found = {SF_OK, 0, 0, ""};
    sf_status status = make(&w, solid, handles, &found);
    release(&w);
    if (status != SF_OK) {
        sf_weights_destroy(w.weights);
        return found.status == status
                   ? sfi_fault_set(fault, status, 0, 0, "%s", found.message)
                   : sfi_fault_set(fault, status, 0, 0, "%s", sf_status_message(status));
    }
    *weights = w.weights;
    return SF_OK;
}

void sf_weights_destroy(sf_weights *weights)
{
    if (weights == NULL) {
        return;
    }
    sf_allocator a = weights->allocator;
    sfi_free_array(&a, weights->values, weights->count * weights->domain.node_count,
                   sizeof *weights->values);
    sfi_free_array(&a, weights->centers, 3 * weights->count, sizeof *weights->centers);
    if (weights->domain.box_count > 0) {
        sfi_domain_destroy(&weights->domain);
    }
    sfi_free_array(&a, weights, 1, sizeof *weights);
}
