// SPDX-License-Identifier: MIT
// An order of points in which neighbours in space are mostly neighbours in memory.
//
// The box of the points is cut into 2^10 steps along each axis; interleaving the bits of a point's
// steps gives its place along a curve that fills the box (G. M. Morton, "A computer oriented
// geodetic data base", 1966). Four stable counting passes of 8 bits sort them. A mesh whose
// vertices come in this order finds the neighbours of most vertices in the cache.

#include "mesh/morton.h"

#include "base/memory.h"

#include <string.h>

enum { STEPS = 1024, DIGITS = 256, PASSES = 4 };

// Every third bit, from 10 bits.
static uint32_t spread(uint32_t v)
{
    uint32_t out = 0;
    for (unsigned i = 0; i < 10; i++) {
        out |= (v >> i & 1) << 3 * i;
    }
    return out;
}

static void find_box(const double *points, size_t count, double low[3], double scale[3])
{
    for (size_t d = 0; d < 3; d++) {
        double high = count > 0 ? points[d] : 0;
        low[d] = high;
        for (size_t i = 1; i < count; i++) {
            double at = points[3 * i + d];
            low[d] = at < low[d] ? at : low[d];
            high = at > high ? at : high;
        }
        scale[d] = high > low[d] ? STEPS / (high - low[d]) : 0;
    }
}

static uint32_t key_of(const double *p, const double low[3], const double scale[3])
{
    uint32_t key = 0;
    for (unsigned d = 0; d < 3; d++) {
        uint32_t step = (uint32_t)((p[d] - low[d]) * scale[d]);
        key |= spread(step < STEPS ? step : STEPS - 1) << d;
    }
    return key;
}

// One pass of a radix sort: from -> to by 8 bits of the keys.
static void pass(const uint32_t *keys, const uint32_t *from, size_t count, unsigned shift,
                 uint32_t *to)
{
    size_t places[DIGITS + 1] = {0};
    for (size_t i = 0; i < count; i++) {
        places[(keys[i] >> shift) % DIGITS + 1]++;
    }
    for (size_t d = 0; d < DIGITS; d++) {
        places[d + 1] += places[d];
    }
    for (size_t i = 0; i < count; i++) {
        to[places[(keys[from[i]] >> shift) % DIGITS]++] = from[i];
    }
}

sf_status sfi_morton_order(const double *points, size_t count, const sf_allocator *allocator,
                           uint32_t *order)
{
    if (count == 0) {
        return SF_OK;
    }
    uint32_t *keys = sfi_alloc_array(allocator, count, sizeof *keys);
    uint32_t *other = sfi_alloc_array(allocator, count, sizeof *other);
    if (keys != NULL && other != NULL) {
        double low[3], scale[3];
        find_box(points, count, low, scale);
        for (size_t i = 0; i < count; i++) {
            keys[i] = key_of(points + 3 * i, low, scale);
            order[i] = (uint32_t)i;
        }
        for (unsigned p = 0; p < PASSES; p += 2) {
            pass(keys, order, count, 8 * p, other);
            pass(keys, other, count, 8 * p + 8, order);
        }
    }
    sf_status status = keys != NULL && other != NULL ? SF_OK : SF_ERR_MEMORY;
    sfi_free_array(allocator, keys, count, sizeof *keys);
    sfi_free_array(allocator, other, count, sizeof *other);
    return status;
}
