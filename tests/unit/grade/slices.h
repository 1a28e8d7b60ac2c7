// SPDX-License-Identifier: MIT
// What tests of slices share: lattices around cages, and samplers on them.

#ifndef SF_TEST_GRADE_SLICES_H
#define SF_TEST_GRADE_SLICES_H

#include "limits.h"

#include <sf/sample.h>

static inline sf_lattice lattice_around(const test_cage *c, double pitch)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (size_t i = 0; i < 3 * c->points; i++) {
        low[i % 3] = fmin(low[i % 3], c->positions[i]);
        high[i % 3] = fmax(high[i % 3], c->positions[i]);
    }
    sf_lattice l = {0};
    l.nx = (uint32_t)((high[0] - low[0]) / pitch) + 2;
    l.ny = (uint32_t)((high[1] - low[1]) / pitch * 0.8) + 2;
    l.nz = (uint32_t)((high[2] - low[2]) / pitch * 1.3) + 2;
    l.pitch_x_mm = pitch;
    l.pitch_y_mm = pitch / 0.8; // no two alike
    l.layer_mm = pitch / 1.3;
    for (int axis = 0; axis < 3; axis++) {
        l.origin_mm[axis] = low[axis] - pitch / 3;
    }
    return l;
}

static inline sf_sampler *sampler_of(const sf_limit *limit, const sf_lattice *l, size_t channels)
{
    static const size_t numbers[2] = {0, 1};
    sf_sampler *sampler = NULL;
    CHECK_EQ(sf_sampler_create(limit, l, NULL, channels, numbers, NULL, NULL, &sampler, NULL),
             SF_OK);
    return sampler;
}

static inline int bit(sf_slice s, uint32_t x, uint32_t y)
{
    return (int)(s.words[(size_t)y * s.stride + x / 64] >> x % 64 & 1);
}

#endif
