// SPDX-License-Identifier: MIT
// Painting positions: moving and smoothing points.

#include "grade/paint/weights.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

static sf_status put_in_place(sf_cage *cage, const double *fresh, size_t *changed)
{
    size_t count = 0;
    SF_TRY(sfi_positions_check(cage->points, fresh, NULL));
    for (size_t i = 0; i < cage->points; i++) {
        count += memcmp(fresh + 3 * i, cage->positions + 3 * i, 3 * sizeof *fresh) != 0;
    }
    memcpy(cage->positions, fresh, 3 * (size_t)cage->points * sizeof *fresh);
    if (changed != NULL) {
        *changed = count;
    }
    return SF_OK;
}

sf_status sf_paint_move(sf_cage *cage, const double *weights, const double vector_mm[3],
                        const sf_allocator *allocator, size_t *changed)
{
    if (cage == NULL || weights == NULL || vector_mm == NULL ||
        !sfi_weights_are_good(weights, cage->points)) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    double *fresh = sfi_alloc_array(&kept, cage->points, 3 * sizeof *fresh);
    if (fresh == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < 3 * (size_t)cage->points; i++) {
        double step = weights[i / 3] * vector_mm[i % 3];
        fresh[i] = step != 0 ? cage->positions[i] + step : cage->positions[i]; // -0 stays -0
    }
    sf_status status = put_in_place(cage, fresh, changed);
    sfi_free_array(&kept, fresh, cage->points, 3 * sizeof *fresh);
    return status;
}

// Sums of the neighbours that count: for a point of the boundary those on it.
static void sum_neighbours(const sfi_complex *c, const double *positions, double *sums,
                           uint32_t *counts)
{
    for (size_t e = 0; e < c->edges; e++) {
        for (size_t end = 0; end < 2; end++) {
            size_t to = c->edge_points[2 * e + end], from = c->edge_points[2 * e + 1 - end];
            if (c->point_outside[to] && !c->edge_outside[e]) {
                continue;
            }
            for (size_t axis = 0; axis < 3; axis++) {
                sums[3 * to + axis] += positions[3 * from + axis];
            }
            counts[to]++;
        }
    }
}

sf_status sf_paint_smooth(sf_cage *cage, const double *weights, double amount,
                          const sf_allocator *allocator, size_t *changed)
{
    if (cage == NULL || weights == NULL || !(amount >= 0 && amount <= 1) ||
        !sfi_weights_are_good(weights, cage->points)) {
        return SF_ERR_ARGUMENT;
    }
    sf_allocator kept = sfi_allocator_or_default(allocator);
    double *fresh = sfi_alloc_array(&kept, cage->points, 3 * sizeof *fresh);
    uint32_t *counts = sfi_alloc_array(&kept, cage->points, sizeof *counts);
    sf_status status = SF_ERR_MEMORY;
    if (fresh != NULL && counts != NULL) {
        for (size_t i = 0; i < 3 * (size_t)cage->points; i++) {
            fresh[i] = 0;
        }
        memset(counts, 0, cage->points * sizeof *counts);
        sum_neighbours(&cage->complex, cage->positions, fresh, counts);
        for (size_t i = 0; i < 3 * (size_t)cage->points; i++) {
            double here = cage->positions[i];
            uint32_t count = counts[i / 3];
            fresh[i] = count == 0 || weights[i / 3] == 0
                           ? here
                           : here + weights[i / 3] * amount * (fresh[i] / count - here);
        }
        status = put_in_place(cage, fresh, changed);
    }
    sfi_free_array(&kept, counts, cage->points, sizeof *counts);
    sfi_free_array(&kept, fresh, cage->points, 3 * sizeof *fresh);
    return status;
}
