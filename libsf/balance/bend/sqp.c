// SPDX-License-Identifier: MIT
// Moving handles until a shape stands, with as little bending as that takes.
//
// A step asks for the least energy among the poses that, to first order, put the centre of mass
// inside the safe set and every vertex above the ground: a quadratic program of some dozens of
// unknowns, because the energy is quadratic in scales and shifts, and nearly so in small turns. The
// true constraints bend away from their tangents, so the step is halved until the sum of energy and
// violations, these at a price above their multipliers, has become less. From outside the safe set
// a few steps reach its border and then run along it; nothing is projected, and nothing frozen.
//
// Where no step meets everything, one that comes nearest is wanted: each kind of row may be missed
// by an amount that is the same for all its rows, at a price far above what energy could gain.
//
// Unknowns are scales, shifts over the size, and turns, so that 1 is large for each.
//
// Source: the problem is that of R. Prevost and others, "Make It Stand", SIGGRAPH 2013, section 5,
// with an inequality in place of a weighed sum; for the method S.-P. Han, "A globally convergent
// method for nonlinear programming", 1977.

#include "balance/bend/sqp.h"

#include "balance/bend/quadratic.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"

#include <math.h>
#include <string.h>

// Price of missing rows by 1, in the program.
#define MISSING_PRICE 1e4
enum { AMOUNTS = 2 }; // of the safe set, of everything else
// Halvings of a step.
#define HALVINGS 10
// Added to the curvature: what no energy holds back must not run away.
#define RIDGE 1e-6
// A step or a gain below these is none.
#define STEP_NONE 1e-5
#define GAIN_NONE 1e-7

typedef struct run {
    const sfi_posture *posture;
    const sfi_freedom *freedom;
    sf_allocator allocator;
    sf_task *task;
    sfi_posture_scratch scratch;
    size_t handles, free_count, unknowns; // unknowns: those that are free, then AMOUNTS missed
    size_t *parameters;                   // of each free unknown
    double *memory;
    double *gradient, *hessian; // of the energy by all parameters
    double *pulled;             // one row by all parameters
    double *slope, *curvature, *rows, *bounds, *step, *multipliers; // of the program
    double *change;                                                 // of all parameters
    sf_pose *poses, *tried;
    size_t memory_count, row_capacity;
} run;

static int is_scale(size_t parameter)
{
    return parameter % SFI_POSE_SIZE == SFI_POSE_SCALE;
}

static int is_shift(size_t parameter)
{
    size_t kind = parameter % SFI_POSE_SIZE;
    return kind >= SFI_POSE_SHIFT && kind < SFI_POSE_TURN;
}

static double lesser(double a, double b)
{
    return a < b ? a : b;
}

static double greater(double a, double b)
{
    return a > b ? a : b;
}

// What an unknown of 1 is in units of its parameter.
static double unit_of(const run *r, size_t parameter)
{
    return is_shift(parameter) ? r->posture->size_mm : 1;
}

// --- Memory --------------------------------------------------------------------------------------

static sf_status take_numbers(run *r)
{
    size_t all = SFI_POSE_SIZE * r->handles, n = r->unknowns;
    r->row_capacity = r->scratch.row_capacity + 2 * n;
    size_t rows, hessian, curvature, sum;
    if (!sfi_size_mul(r->row_capacity, n + 2, &rows) || !sfi_size_mul(all, all, &hessian) ||
        !sfi_size_mul(n, n, &curvature) || !sfi_size_add(rows, hessian, &sum) ||
        !sfi_size_add(sum, curvature, &sum) || !sfi_size_add(sum, 3 * all + 2 * n, &sum)) {
        return SF_ERR_MEMORY;
    }
    r->memory_count = sum;
    r->memory = sfi_alloc_array(&r->allocator, sum, sizeof *r->memory);
    if (r->memory == NULL) {
        return SF_ERR_MEMORY;
    }
    double *at = r->memory;
    r->gradient = sfi_cut(&at, all);
    r->pulled = sfi_cut(&at, all);
    r->change = sfi_cut(&at, all);
    r->hessian = sfi_cut(&at, hessian);
    r->slope = sfi_cut(&at, n);
    r->step = sfi_cut(&at, n);
    r->curvature = sfi_cut(&at, curvature);
    r->rows = sfi_cut(&at, r->row_capacity * n);
    r->bounds = sfi_cut(&at, r->row_capacity);
    r->multipliers = sfi_cut(&at, r->row_capacity);
    return SF_OK;
}

static void free_run(run *r)
{
    size_t all = SFI_POSE_SIZE * r->handles;
    sfi_posture_scratch_free(&r->scratch);
    sfi_free_array(&r->allocator, r->parameters, all, sizeof *r->parameters);
    sfi_free_array(&r->allocator, r->memory, r->memory_count, sizeof *r->memory);
    sfi_free_array(&r->allocator, r->poses, r->handles, sizeof *r->poses);
    sfi_free_array(&r->allocator, r->tried, r->handles, sizeof *r->tried);
}

static sf_status make_run(run *r, const sf_pose *poses)
{
    size_t all = SFI_POSE_SIZE * r->handles;
    SF_TRY(sfi_posture_scratch_make(r->posture, &r->allocator, &r->scratch));
    r->parameters = sfi_alloc_array(&r->allocator, all, sizeof *r->parameters);
    r->poses = sfi_alloc_array(&r->allocator, r->handles, sizeof *r->poses);
    r->tried = sfi_alloc_array(&r->allocator, r->handles, sizeof *r->tried);
    if (r->parameters == NULL || r->poses == NULL || r->tried == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t p = 0; p < all; p++) {
        if (r->freedom->free[p]) {
            r->parameters[r->free_count++] = p;
        }
    }
    r->unknowns = r->free_count + AMOUNTS;
    memcpy(r->poses, poses, r->handles * sizeof *poses);
    return take_numbers(r);
}

// --- The program ---------------------------------------------------------------------------------

// Energy: slope and curvature in the unknowns.
static void write_energy(run *r)
{
    size_t all = SFI_POSE_SIZE * r->handles, n = r->unknowns;
    double terms[3];
    sfi_energy_at(r->posture->energy, r->poses, r->scratch.energy, terms, r->gradient, r->hessian);
    memset(r->curvature, 0, n * n * sizeof *r->curvature);
    for (size_t i = 0; i < r->free_count; i++) {
        size_t p = r->parameters[i];
        r->slope[i] = unit_of(r, p) * r->gradient[p];
        for (size_t j = 0; j < r->free_count; j++) {
            size_t q = r->parameters[j];
            r->curvature[i * n + j] = unit_of(r, p) * unit_of(r, q) * r->hessian[p * all + q];
        }
        r->curvature[i * n + i] += RIDGE;
    }
    for (size_t i = r->free_count; i < n; i++) {
        r->slope[i] = MISSING_PRICE;
        r->curvature[i * n + i] = 1;
    }
}

// What is asked of the shape, each row with the amount by which its kind may be missed.
static size_t write_shape_rows(run *r)
{
    const sfi_posture_rows *rows = &r->scratch.rows;
    size_t n = r->unknowns, coefficients = 12 * r->handles;
    for (size_t k = 0; k < rows->count; k++) {
        double *row = r->rows + k * n;
        sfi_pose_pull(r->poses, r->handles, rows->gradients + coefficients * k, r->pulled);
        for (size_t i = 0; i < r->free_count; i++) {
            row[i] = unit_of(r, r->parameters[i]) * r->pulled[r->parameters[i]];
        }
        row[r->free_count] = k < rows->safe_count;
        row[r->free_count + 1] = k >= rows->safe_count;
        r->bounds[k] = -rows->values[k];
    }
    return rows->count;
}

static void write_bound(run *r, size_t row, size_t unknown, double sign, double bound)
{
    memset(r->rows + row * r->unknowns, 0, r->unknowns * sizeof *r->rows);
    r->rows[row * r->unknowns + unknown] = sign;
    r->bounds[row] = bound;
}

// Narrow a step from `now` to what ends between two bounds; from beyond them it may not go on.
static void keep_within(double least, double most, double now, double *low, double *high)
{
    *low = lesser(greater(*low, least - now), 0);
    *high = greater(lesser(*high, most - now), 0);
}

// How far each unknown may go; what is missed is never less than nothing.
static size_t write_bounds(run *r, size_t row)
{
    for (size_t i = 0; i < r->free_count; i++) {
        size_t p = r->parameters[i];
        double low = -r->freedom->step_max, high = r->freedom->step_max;
        const sf_pose *pose = &r->poses[p / SFI_POSE_SIZE];
        if (is_scale(p)) {
            keep_within(r->freedom->scale_low, r->freedom->scale_high, pose->scale, &low, &high);
        } else if (is_shift(p)) {
            double most = r->freedom->shift_max_mm / r->posture->size_mm;
            double shift = pose->shift_mm[p % SFI_POSE_SIZE - SFI_POSE_SHIFT];
            keep_within(-most, most, shift / r->posture->size_mm, &low, &high);
        }
        write_bound(r, row++, i, 1, low);
        write_bound(r, row++, i, -1, -high);
    }
    for (size_t i = 0; i < AMOUNTS; i++) {
        write_bound(r, row++, r->free_count + i, 1, 0);
    }
    return row;
}

static sf_status find_step(run *r)
{
    write_energy(r);
    size_t rows = write_bounds(r, write_shape_rows(r));
    sfi_quadratic program = {r->unknowns, r->curvature, r->slope, rows, r->rows, r->bounds};
    return sfi_quadratic_solve(&program, &r->allocator, r->step, r->multipliers);
}

// --- The step ------------------------------------------------------------------------------------

// What violations must cost so that a step towards the constrained minimum makes the sum less.
static double price_of(const run *r)
{
    double sum = 1;
    for (size_t k = 0; k < r->scratch.rows.count; k++) {
        sum += 2 * r->multipliers[k];
    }
    return sum;
}

static double merit_of(const sfi_posture_state *state, double price)
{
    return state->energy + price * (state->unsafe + state->sunk + state->crushed);
}

static double longest(const run *r)
{
    double most = 0;
    for (size_t i = 0; i < r->free_count; i++) {
        most = greater(most, fabs(r->step[i]));
    }
    return most;
}

static sf_status try_share(run *r, double share)
{
    memset(r->change, 0, SFI_POSE_SIZE * r->handles * sizeof *r->change);
    for (size_t i = 0; i < r->free_count; i++) {
        size_t p = r->parameters[i];
        r->change[p] = share * unit_of(r, p) * r->step[i];
    }
    memcpy(r->tried, r->poses, r->handles * sizeof *r->poses);
    for (size_t j = 0; j < r->handles; j++) {
        SF_TRY(sfi_pose_move(&r->tried[j], r->change + SFI_POSE_SIZE * j));
    }
    return SF_OK;
}

// Take the longest share of the step that is a gain; the state and its rows are those of the poses
// at the end. Settled where there is none.
static sf_status take_step(run *r, sfi_posture_state *state, int *settled)
{
    double price = price_of(r), before = merit_of(state, price), share = 1;
    int small = longest(r) < STEP_NONE;
    for (int i = 0; i < HALVINGS; i++, share *= 0.5) {
        sfi_posture_state found;
        sf_status status = try_share(r, share);
        if (status == SF_OK) {
            status = sfi_posture_look(r->posture, r->tried, r->task, &r->scratch, &found);
        }
        if (status == SF_OK && merit_of(&found, price) < before) {
            *settled = small || before - merit_of(&found, price) < GAIN_NONE * (1 + before);
            memcpy(r->poses, r->tried, r->handles * sizeof *r->poses);
            *state = found;
            return SF_OK;
        }
        if (status != SF_OK && status != SF_ERR_ARGUMENT) {
            return status;
        }
    }
    *settled = 1;
    return sfi_posture_look(r->posture, r->poses, r->task, &r->scratch, state);
}

static sf_status go(run *r, uint32_t steps_max, sfi_sqp_report *report)
{
    SF_TRY(sfi_posture_look(r->posture, r->poses, r->task, &r->scratch, &report->state));
    report->steps = 0;
    report->settled = r->free_count == 0;
    while (!report->settled && report->steps < steps_max) {
        if (sf_task_is_cancelled(r->task)) {
            return SF_ERR_CANCELLED;
        }
        sf_status status = find_step(r);
        if (status == SF_ERR_MEMORY) {
            return status;
        }
        if (status != SF_OK) {
            break; // rounding has eaten the program up: what there is must do
        }
        SF_TRY(take_step(r, &report->state, &report->settled));
        report->steps++;
    }
    return SF_OK;
}

sf_status sfi_sqp_run(const sfi_posture *posture, const sfi_freedom *freedom, uint32_t steps_max,
                      const sf_allocator *allocator, sf_task *task, sf_pose *poses,
                      sfi_sqp_report *report)
{
    run r;
    sfi_sqp_report found;
    memset(&r, 0, sizeof r);
    r.posture = posture;
    r.freedom = freedom;
    r.allocator = *allocator;
    r.task = task;
    r.handles = posture->energy->handle_count;
    sf_status status = make_run(&r, poses);
    if (status == SF_OK) {
        status = go(&r, steps_max, &found);
    }
    if (status == SF_OK) {
        memcpy(poses, r.poses, r.handles * sizeof *poses);
        *report = found;
    }
    free_run(&r);
    return status;
}
