// SPDX-License-Identifier: MIT
// The inverse of a blend, for many points.
//
// A point's search begins from the better of two: the guess that came with it, and what the point
// before it leads to. What fails is tried from the other, and in a second round from the cells
// that are bent to where it lies. So is what was found outside the domain: a rest point in it is
// worth more. Stretches of points have a fixed length and the first of each
// knows of none before it, so that the result does not depend on threads.
//
// Memory is taken before anything is written.

#include "balance/blend/blend_bins.h"
#include "balance/blend/blend_newton.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"

#include <math.h>
#include <string.h>

enum { STRETCH = 1024 };

typedef struct inverse {
    sfi_unbend unbend;
    const double *bent;
    size_t count;
    double *rest, *residual;
    sfi_bins bins;
    sfi_map maps[SF_HANDLE_MAX];
} inverse;

static size_t stretch_end(const inverse *v, size_t index)
{
    return v->count - index * STRETCH > STRETCH ? (index + 1) * STRETCH : v->count;
}

// First round, one point: from its guess or from the point before, if there is one.
static sfi_rest find(const inverse *v, size_t i, const sfi_rest *before)
{
    const double *bent = v->bent + 3 * i;
    sfi_rest guess = sfi_unbend_try(&v->unbend, bent, v->rest + 3 * i), other = guess;
    if (before != NULL && guess.residual > v->unbend.tolerance) {
        double by[3] = {bent[0] - bent[-3], bent[1] - bent[-2], bent[2] - bent[-1]}, at[3];
        sfi_unbend_follow(&v->unbend, before, by, at);
        if (isfinite(at[0]) && isfinite(at[1]) && isfinite(at[2])) {
            sfi_rest led = sfi_unbend_try(&v->unbend, bent, at);
            other = led.residual < guess.residual ? guess : led;
            guess = led.residual < guess.residual ? led : guess;
        }
    }
    guess = sfi_unbend_newton(&v->unbend, bent, guess);
    if (before != NULL && guess.residual > v->unbend.tolerance) {
        other = sfi_unbend_newton(&v->unbend, bent, other);
        guess = other.residual < guess.residual ? other : guess;
    }
    return guess;
}

static void run_first(void *context, size_t index)
{
    inverse *v = context;
    sfi_rest before = {{0, 0, 0}, INFINITY};
    for (size_t i = index * STRETCH; i < stretch_end(v, index); i++) {
        sfi_rest found = find(v, i, before.residual <= v->unbend.tolerance ? &before : NULL);
        memcpy(v->rest + 3 * i, found.at, sizeof found.at);
        v->residual[i] = found.residual;
        before = found;
    }
}

typedef struct visitor {
    const inverse *inverse;
    const double *bent;
    sfi_rest best;
    int within; // whether `best` is a rest point in the domain
} visitor;

static int is_within(const inverse *v, const sfi_rest *rest)
{
    return rest->residual <= v->unbend.tolerance &&
           sfi_domain_find(&v->unbend.weights->domain, rest->at).square == 0;
}

// Try from the middle of a cell. Returns whether to go on.
static int try_cell(void *user, uint32_t cell)
{
    visitor *v = user;
    const sfi_unbend *u = &v->inverse->unbend;
    double middle[3];
    sfi_domain_middle(&u->weights->domain, cell, middle);
    sfi_rest found = sfi_unbend_newton(u, v->bent, sfi_unbend_try(u, v->bent, middle));
    if (is_within(v->inverse, &found)) {
        v->best = found;
        v->within = 1;
        return 0;
    }
    v->best = found.residual < v->best.residual ? found : v->best;
    return 1;
}

static void run_second(void *context, size_t index)
{
    inverse *v = context;
    for (size_t i = index * STRETCH; i < stretch_end(v, index); i++) {
        const double *at = v->rest + 3 * i;
        visitor by = {v, v->bent + 3 * i, {{at[0], at[1], at[2]}, v->residual[i]}, 0};
        if (is_within(v, &by.best)) {
            continue;
        }
        uint32_t closest = sfi_bins_visit(&v->bins, by.bent, try_cell, &by);
        if (by.best.residual > v->unbend.tolerance && closest != SFI_NO_CELL) {
            try_cell(&by, closest);
        }
        memcpy(v->rest + 3 * i, by.best.at, sizeof by.best.at);
        v->residual[i] = by.best.residual;
    }
}

static size_t count_missed(const inverse *v)
{
    size_t missed = 0;
    for (size_t i = 0; i < v->count; i++) {
        missed += !(v->residual[i] <= v->unbend.tolerance);
    }
    return missed;
}

static int all_finite(const double *x, size_t count)
{
    int finite = 1;
    for (size_t i = 0; i < count && finite; i++) {
        finite = isfinite(x[i]);
    }
    return finite;
}

static sf_status reserve(inverse *v, const sf_allocator *a, double *residual_mm)
{
    SF_TRY(sfi_bins_create(v->unbend.weights, a, &v->bins));
    v->residual = residual_mm;
    if (residual_mm == NULL && v->count > 0) {
        v->residual = sfi_alloc_array(a, v->count, sizeof *v->residual);
        if (v->residual == NULL) {
            sfi_bins_destroy(&v->bins, a);
            return SF_ERR_MEMORY;
        }
    }
    return SF_OK;
}

sf_status sf_weights_unbend(const sf_weights *weights, const sf_pose *poses, const double *bent_mm,
                            size_t count, double tolerance_mm, const sf_allocator *allocator,
                            sf_task *task, double *rest_mm, double *residual_mm, size_t *missed)
{
    inverse v = {.bent = bent_mm, .count = count, .rest = rest_mm};
    sf_allocator from = sfi_allocator_or_default(allocator);
    if (weights == NULL || poses == NULL || (count > 0 && (bent_mm == NULL || rest_mm == NULL)) ||
        !(tolerance_mm > 0 && isfinite(tolerance_mm)) ||
        !sfi_maps_make(poses, weights->centers, weights->count, v.maps) ||
        !all_finite(bent_mm, 3 * count) || !all_finite(rest_mm, 3 * count)) {
        return SF_ERR_ARGUMENT;
    }
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    v.unbend.weights = weights;
    v.unbend.maps = v.maps;
    v.unbend.tolerance = tolerance_mm;
    SF_TRY(reserve(&v, &from, residual_mm));
    size_t pieces = count / STRETCH + (count % STRETCH != 0);
    sfi_task_for(task, pieces, run_first, &v);
    sfi_bins_fill(&v.bins, v.maps);
    sfi_task_for(task, pieces, run_second, &v);
    if (missed != NULL) {
        *missed = count_missed(&v);
    }
    if (residual_mm == NULL) {
        sfi_free_array(&from, v.residual, count, sizeof *v.residual);
    }
    sfi_bins_destroy(&v.bins, &from);
    return SF_OK;
}
