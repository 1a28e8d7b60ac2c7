// SPDX-License-Identifier: MIT
// Balancing as the paper does it: gradient descent on a weighed sum.
//
//     E = (1 - mu) sum over stances of |(c - c*)_h|^2 / 2 size^2  +  mu E_shape / 2
//
// with c* the point of the safe region that is closest to the centre of mass c, at c's height: so
// is the target found anew at every step. Where nothing is safe at that height, of which the paper
// says nothing, it is the point that is closest to being so. A step that does not make E less by a
// hundredth is taken back, and the next is shorter by a fifth; when steps have come down to 0.4 of
// the first, the shape is taken to hold the balance back, and mu falls by 0.05; when it is used up,
// nothing can be improved. This is a comparison and an oracle for balance/bend/sqp.h, which needs
// no schedule.
//
// The paper starts with steps of 1 in units that it does not give. Here 1 is the longest step that
// cannot overshoot where E is quadratic: one over the largest curvature, found by power iteration.
//
// Source: R. Prevost and others, "Make It Stand", SIGGRAPH 2013, equations 5 and 14, section 5.3.

#include "balance/bend/descent.h"

#include "balance/stance/target.h"
#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "mesh/vector.h"

#include <math.h>
#include <string.h>

#define STEP_FIRST 1.0
#define STEP_SHRINK 0.8
#define STEP_LEAST 0.4
#define MU_STEP 0.05
#define ENOUGH 0.01
#define NOTHING 1e-14 // what the sum may change by rounding alone
#define REACH 1e3     // in sizes: no target lies farther away
enum { POWER_ROUNDS = 40 };

typedef struct run {
    const sfi_posture *posture;
    const uint8_t *free;
    sf_allocator allocator;
    sfi_posture_scratch scratch;
    size_t all; // parameters
    double *memory;
    size_t memory_count;
    double *gradient, *hessian, *change, *vector, *image;
    double *lever, *by_coefficients; // one direction of the centre of mass by parameters
    double *sections;                // scratch for targets
    sf_pose *tried;
} run;

sfi_descent sfi_descent_begin(double mu)
{
    sfi_descent made = {mu, STEP_FIRST, 0};
    return made;
}

static sf_status make_run(run *r)
{
    size_t handles = r->posture->energy->handle_count, sections = 0;
    r->all = SFI_POSE_SIZE * handles;
    SF_TRY(sfi_posture_scratch_make(r->posture, &r->allocator, &r->scratch));
    for (size_t k = 0; k < r->posture->standing_count; k++) {
        size_t one = sfi_base_scratch(r->posture->standings[k].safe_count);
        sections = one > sections ? one : sections;
    }
    if (!sfi_size_mul(r->all, r->all, &r->memory_count) ||
        !sfi_size_add(r->memory_count, 5 * r->all + 12 * handles + sections, &r->memory_count)) {
        return SF_ERR_MEMORY;
    }
    r->memory = sfi_alloc_array(&r->allocator, r->memory_count, sizeof *r->memory);
    r->tried = sfi_alloc_array(&r->allocator, handles, sizeof *r->tried);
    if (r->memory == NULL || r->tried == NULL) {
        return SF_ERR_MEMORY;
    }
    double *at = r->memory;
    r->gradient = sfi_cut(&at, r->all);
    r->change = sfi_cut(&at, r->all);
    r->vector = sfi_cut(&at, r->all);
    r->image = sfi_cut(&at, r->all);
    r->lever = sfi_cut(&at, r->all);
    r->by_coefficients = sfi_cut(&at, 12 * handles);
    r->sections = sfi_cut(&at, sections);
    r->hessian = at;
    return SF_OK;
}

static void free_run(run *r)
{
    sfi_posture_scratch_free(&r->scratch);
    sfi_free_array(&r->allocator, r->memory, r->memory_count, sizeof *r->memory);
    sfi_free_array(&r->allocator, r->tried, r->posture->energy->handle_count, sizeof *r->tried);
}

// Where c should go at its height, along the two axes across up.
static void find_way(const run *r, const sfi_standing *s, const double c[3], double axes[2][3],
                     double way[2])
{
    sfi_base base = {
        {s->up[0], s->up[1], s->up[2]}, r->posture->safe + s->safe_first, s->safe_count};
    sfi_base_across(&base, axes);
    sfi_offset to =
        sfi_base_target(&base, c, SFI_TARGET_NEAREST, REACH * r->posture->size_mm, r->sections);
    memcpy(way, to.along, sizeof to.along);
}

// lever = derivatives of axis . c / size by the parameters, 0 for those that are not free.
static void find_lever(run *r, const sf_pose *poses, const sf_body *body, const double axis[3])
{
    size_t handles = r->posture->energy->handle_count;
    double at = sfi_dot(axis, body->moment) / body->mass;
    for (size_t b = 0; b < 4 * handles; b++) {
        const double *by = r->scratch.by_body + 12 * b;
        for (int d = 0; d < 3; d++) {
            double moved = axis[0] * by[3 + d] + axis[1] * by[6 + d] + axis[2] * by[9 + d];
            r->by_coefficients[3 * b + (size_t)d] =
                (moved - at * by[d]) / (body->mass * r->posture->size_mm);
        }
    }
    sfi_pose_pull(poses, handles, r->by_coefficients, r->lever);
}

static int is_shift(size_t parameter)
{
    size_t kind = parameter % SFI_POSE_SIZE;
    return kind >= SFI_POSE_SHIFT && kind < SFI_POSE_TURN;
}

// Parameters in units in which 1 is large, and nothing of those that are not free.
static double unit_of(const run *r, size_t parameter)
{
    return !r->free[parameter] ? 0 : is_shift(parameter) ? r->posture->size_mm : 1;
}

// The sum's value where the scratch has been filled; with `derive` also gradient and curvature.
static sf_status sum_up(run *r, const sfi_posture_state *state, double mu, const sf_pose *poses,
                        int derive, double *value)
{
    double com[3], size = r->posture->size_mm, terms[3];
    SF_TRY(sf_body_com(state->body, com));
    *value = 0.5 * mu * state->energy;
    if (derive) {
        sfi_energy_at(r->posture->energy, poses, r->scratch.energy, terms, r->gradient, r->hessian);
        for (size_t i = 0; i < r->all; i++) {
            r->gradient[i] *= 0.5 * mu * unit_of(r, i);
            for (size_t j = 0; j < r->all; j++) {
                r->hessian[i * r->all + j] *= 0.5 * mu * unit_of(r, i) * unit_of(r, j);
            }
        }
    }
    for (size_t k = 0; k < r->posture->standing_count; k++) {
        double axes[2][3], way[2];
        find_way(r, &r->posture->standings[k], com, axes, way);
        for (int a = 0; a < 2; a++) {
            *value += 0.5 * (1 - mu) * (way[a] / size) * (way[a] / size);
            if (!derive) {
                continue;
            }
            find_lever(r, poses, &state->body, axes[a]);
            for (size_t i = 0; i < r->all; i++) {
                double lever = unit_of(r, i) * r->lever[i];
                r->gradient[i] -= (1 - mu) * way[a] / size * lever;
                for (size_t j = 0; j < r->all; j++) {
                    r->hessian[i * r->all + j] += (1 - mu) * lever * unit_of(r, j) * r->lever[j];
                }
            }
        }
    }
    return SF_OK;
}

// The largest curvature, from below but closely.
static double find_curvature(run *r)
{
    double largest = 0;
    for (size_t i = 0; i < r->all; i++) {
        r->vector[i] = r->free[i] ? 1 : 0;
    }
    for (int round = 0; round < POWER_ROUNDS; round++) {
        double square = 0;
        for (size_t i = 0; i < r->all; i++) {
            r->image[i] = 0;
            for (size_t j = 0; j < r->all; j++) {
                r->image[i] += r->hessian[i * r->all + j] * r->vector[j];
            }
            square += r->image[i] * r->image[i];
        }
        largest = sqrt(square);
        for (size_t i = 0; i < r->all && largest > 0; i++) {
            r->vector[i] = r->image[i] / largest;
        }
    }
    return largest;
}

// After a step that was not worth it.
static void slow_down(sfi_descent *d)
{
    d->step *= STEP_SHRINK;
    if (d->step < STEP_LEAST) {
        d->step = STEP_FIRST;
        d->mu -= MU_STEP;
        d->ended = d->mu < 0;
        d->mu = d->mu < 0 ? 0 : d->mu;
    }
}

static sf_status go(run *r, sf_task *task, sfi_descent *d, sf_pose *poses, sfi_posture_state *state)
{
    size_t handles = r->posture->energy->handle_count;
    sfi_posture_state found;
    double before, after;
    SF_TRY(sfi_posture_look(r->posture, poses, task, &r->scratch, state));
    SF_TRY(sum_up(r, state, d->mu, poses, 1, &before));
    double curvature = find_curvature(r);
    if (d->ended || !(curvature > 0)) {
        d->ended = 1;
        return SF_OK;
    }
    for (size_t i = 0; i < r->all; i++) {
        r->change[i] = -d->step / curvature * unit_of(r, i) * r->gradient[i];
    }
    memcpy(r->tried, poses, handles * sizeof *poses);
    for (size_t j = 0; j < handles; j++) {
        SF_TRY(sfi_pose_move(&r->tried[j], r->change + SFI_POSE_SIZE * j));
    }
    SF_TRY(sfi_posture_look(r->posture, r->tried, task, &r->scratch, &found));
    SF_TRY(sum_up(r, &found, d->mu, r->tried, 0, &after));
    if (before - after >= ENOUGH * before + NOTHING) {
        memcpy(poses, r->tried, handles * sizeof *poses);
        *state = found;
    } else {
        slow_down(d);
    }
    return SF_OK;
}

sf_status sfi_descent_step(const sfi_posture *posture, const uint8_t *free,
                           const sf_allocator *allocator, sf_task *task, sfi_descent *descent,
                           sf_pose *poses, sfi_posture_state *state)
{
    run r;
    sfi_descent next = *descent;
    sfi_posture_state found;
    memset(&r, 0, sizeof r);
    r.posture = posture;
    r.free = free;
    r.allocator = *allocator;
    sf_status status = make_run(&r);
    if (status == SF_OK) {
        status = go(&r, task, &next, poses, &found);
    }
    free_run(&r);
    if (status == SF_OK) {
        *descent = next;
        *state = found;
    }
    return status;
}
