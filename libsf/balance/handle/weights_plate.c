// SPDX-License-Identifier: MIT
// The energy of weights, and linear systems in it.
//
// The integral of the squared Laplacian of w is w . A w with A = L M^-1 L, M the volumes of the
// nodes: it is summed over all nodes, held or not, so that weights leave a ball or a base without a
// kink. On the free nodes A is L_ff M_f^-1 L_ff and a part of low rank, from the nodes that are
// held next to free ones. Conjugate gradients with V M V, two multigrid cycles, so need some twenty
// steps whatever the size; a step is two products with L and the two cycles.
//
// A correction V M V r is about the error itself, so it tells when to end, in units of weights.
//
// Lanes take their steps together, each with its own lengths; one that has ended stands still. Sums
// run in eight lanes, two nodes' worth of four, over stretches of a fixed length, and the stretches
// are added in their order.

#include "balance/handle/weights_plate.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

enum { STRETCH = 1024, STEPS_MAX = 2000 };

sf_status sfi_plate_create(const sfi_poisson *poisson, const uint8_t *fixed,
                           const sf_allocator *allocator, sfi_plate *plate)
{
    size_t count = poisson->level[0].count;
    memset(plate, 0, sizeof *plate);
    plate->poisson = poisson;
    plate->fixed = fixed;
    if (!sfi_size_mul(count, 4 * SFI_LANES, &plate->memory_count)) {
        return SF_ERR_OVERFLOW;
    }
    SF_TRY(sfi_cycle_create(poisson, allocator, &plate->cycle));
    plate->memory = sfi_alloc_array(allocator, plate->memory_count, sizeof *plate->memory);
    if (plate->memory == NULL) {
        sfi_cycle_destroy(&plate->cycle, allocator);
        return SF_ERR_MEMORY;
    }
    plate->residual = plate->memory;
    plate->direction = plate->residual + SFI_LANES * count;
    plate->image = plate->direction + SFI_LANES * count;
    plate->middle = plate->image + SFI_LANES * count;
    return SF_OK;
}

void sfi_plate_destroy(sfi_plate *plate, const sf_allocator *allocator)
{
    sfi_free_array(allocator, plate->memory, plate->memory_count, sizeof *plate->memory);
    sfi_cycle_destroy(&plate->cycle, allocator);
}

void sfi_plate_apply(sfi_plate *plate, const double *x, double *out)
{
    const sfi_poisson *p = plate->poisson;
    sfi_poisson_apply(p, x, plate->middle);
    for (size_t i = 0; i < p->level[0].count; i++) {
        double inverse = 1 / p->mass[i];
        for (size_t k = 0; k < SFI_LANES; k++) {
            plate->middle[SFI_LANES * i + k] *= inverse;
        }
    }
    sfi_poisson_apply(p, plate->middle, out);
    for (size_t i = 0; i < p->level[0].count; i++) {
        if (plate->fixed[i]) {
            memset(out + SFI_LANES * i, 0, SFI_LANES * sizeof *out);
        }
    }
}

// The greatest of |x| in each lane.
static void largest_of(const sfi_plate *plate, const double *x, double largest[SFI_LANES])
{
    memset(largest, 0, SFI_LANES * sizeof *largest);
    for (size_t i = 0; i < SFI_LANES * plate->poisson->level[0].count; i += SFI_LANES) {
        for (size_t k = 0; k < SFI_LANES; k++) {
            largest[k] = fabs(x[i + k]) > largest[k] ? fabs(x[i + k]) : largest[k];
        }
    }
}

// sums[lane] = a . b
static void dot(size_t count, const double *a, const double *b, double sums[SFI_LANES])
{
    memset(sums, 0, SFI_LANES * sizeof *sums);
    for (size_t from = 0; from < count; from += STRETCH) {
        size_t to = count - from > STRETCH ? from + STRETCH : count;
        double lanes[2 * SFI_LANES] = {0};
        const double *p = a + SFI_LANES * from, *q = b + SFI_LANES * from;
        size_t numbers = SFI_LANES * (to - from), n = 0;
        for (; n + 2 * SFI_LANES <= numbers; n += 2 * SFI_LANES) {
            for (size_t k = 0; k < 2 * SFI_LANES; k++) {
                lanes[k] += p[n + k] * q[n + k];
            }
        }
        for (size_t k = 0; n + k < numbers; k++) {
            lanes[k] += p[n + k] * q[n + k];
        }
        for (size_t k = 0; k < SFI_LANES; k++) {
            sums[k] += lanes[k] + lanes[SFI_LANES + k];
        }
    }
}

// cycle.x[0] = V M V residual; sums[lane] = residual . that; largest[lane] of its numbers.
static void precondition(sfi_plate *plate, double sums[SFI_LANES], double largest[SFI_LANES])
{
    const sfi_poisson *p = plate->poisson;
    size_t count = p->level[0].count;
    float *b = plate->cycle.b[0], *x = plate->cycle.x[0];
    for (size_t i = 0; i < SFI_LANES * count; i++) {
        b[i] = (float)plate->residual[i];
    }
    sfi_cycle_run(&plate->cycle);
    for (size_t i = 0; i < count; i++) {
        float mass = (float)p->mass[i];
        for (size_t k = 0; k < SFI_LANES; k++) {
            b[SFI_LANES * i + k] = mass * x[SFI_LANES * i + k];
        }
    }
    sfi_cycle_run(&plate->cycle);
    for (size_t i = 0; i < SFI_LANES * count; i++) {
        plate->middle[i] = (double)x[i];
    }
    dot(count, plate->residual, plate->middle, sums);
    largest_of(plate, plate->middle, largest);
}

// image = (A + penalty) direction; sums[lane] = direction . image.
static void multiply(sfi_plate *plate, const double *penalty, double sums[SFI_LANES])
{
    size_t count = plate->poisson->level[0].count;
    sfi_plate_apply(plate, plate->direction, plate->image);
    for (size_t i = 0; penalty != NULL && i < SFI_LANES * count; i++) {
        plate->image[i] += penalty[i] * plate->direction[i];
    }
    dot(count, plate->direction, plate->image, sums);
}

// Which lanes go on, from the corrections asked for: forward is 1 for them and 0 for others, back
// what of the last direction they keep. SF_ERR_INTERNAL: one must go on and cannot.
static sf_status choose_lanes(uint32_t step, const double next[SFI_LANES],
                              const double left[SFI_LANES], sfi_plate_goal goal[SFI_LANES],
                              double rho[SFI_LANES], double forward[SFI_LANES],
                              double back[SFI_LANES], int *any)
{
    *any = 0;
    for (size_t k = 0; k < SFI_LANES; k++) {
        sfi_plate_goal *g = &goal[k];
        g->first = step == 0 ? left[k] : g->first;
        g->left = left[k];
        // One that has stopped may not go on: its last direction is lost.
        int goes_on =
            (step == 0 || rho[k] > 0) && left[k] > g->enough && left[k] > g->part * g->first;
        if (goes_on && !(next[k] > 0)) {
            return SF_ERR_INTERNAL;
        }
        back[k] = goes_on && step > 0 ? next[k] / rho[k] : 0;
        forward[k] = goes_on ? 1 : 0;
        rho[k] = goes_on ? next[k] : 0;
        *any |= goes_on;
    }
    return SF_OK;
}

// y = scale x + keep y, lane by lane.
static void combine(size_t numbers, const double scale[SFI_LANES], const double *x,
                    const double keep[SFI_LANES], double *y)
{
    for (size_t i = 0; i < numbers; i += SFI_LANES) {
        for (size_t k = 0; k < SFI_LANES; k++) {
            y[i + k] = scale[k] * x[i + k] + keep[k] * y[i + k];
        }
    }
}

// x += length direction, residual -= length image.
static void advance(sfi_plate *plate, const double length[SFI_LANES], double *x)
{
    size_t numbers = SFI_LANES * plate->poisson->level[0].count;
    double *r = plate->residual;
    for (size_t i = 0; i < numbers; i += SFI_LANES) {
        for (size_t k = 0; k < SFI_LANES; k++) {
            x[i + k] += length[k] * plate->direction[i + k];
            r[i + k] -= length[k] * plate->image[i + k];
        }
    }
}

sf_status sfi_plate_solve(sfi_plate *plate, const double *penalty, const double *b,
                          const sf_task *task, double *x, sfi_plate_goal goal[SFI_LANES])
{
    size_t numbers = SFI_LANES * plate->poisson->level[0].count;
    double rho[SFI_LANES] = {0}, next[SFI_LANES], left[SFI_LANES], length[SFI_LANES],
           back[SFI_LANES];
    int any = 0;
    memset(x, 0, numbers * sizeof *x);
    memset(plate->direction, 0, numbers * sizeof *plate->direction);
    memcpy(plate->residual, b, numbers * sizeof *plate->residual);
    for (uint32_t step = 0;; step++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        precondition(plate, next, left);
        SF_TRY(choose_lanes(step, next, left, goal, rho, length, back, &any));
        if (!any) {
            return SF_OK;
        }
        if (step == STEPS_MAX) {
            return SF_ERR_INTERNAL;
        }
        combine(numbers, length, plate->middle, back, plate->direction);
        multiply(plate, penalty, next);
        for (size_t k = 0; k < SFI_LANES; k++) {
            length[k] = next[k] > 0 ? rho[k] / next[k] : 0;
        }
        advance(plate, length, x);
        plate->steps++;
    }
}
