// SPDX-License-Identifier: MIT
// The digital line between two dabs.
//
// Source: J. E. Bresenham, "Algorithm for computer control of a digital plotter", IBM Systems
// Journal 4, 1965, along the longest of three axes.

#include "sculpt/tip.h"

static int64_t magnitude(int64_t a)
{
    return a < 0 ? -a : a;
}

// `way` times i / steps, rounded to the nearest, halves away from 0.
static int64_t part_of(int64_t way, int64_t i, int64_t steps)
{
    int64_t part = (2 * magnitude(way) * i + steps) / (2 * steps);
    return way < 0 ? -part : part;
}

sf_status sf_dab_line(sf_dab from, sf_dab to, sf_dab *dabs, size_t capacity, size_t *count)
{
    if (count == NULL || (dabs == NULL && capacity > 0) || !sfi_dab_is_valid(from) ||
        !sfi_dab_is_valid(to)) {
        return SF_ERR_ARGUMENT;
    }
    int64_t way[3] = {(int64_t)to.x - from.x, (int64_t)to.y - from.y, (int64_t)to.z - from.z};
    int64_t steps = 0;
    for (int i = 0; i < 3; i++) {
        steps = magnitude(way[i]) > steps ? magnitude(way[i]) : steps;
    }
    *count = (size_t)steps + 1;
    if ((uint64_t)steps + 1 > capacity) {
        return SF_ERR_CAPACITY;
    }
    dabs[0] = from;
    for (int64_t i = 1; i <= steps; i++) {
        sf_dab d = {(int32_t)(from.x + part_of(way[0], i, steps)),
                    (int32_t)(from.y + part_of(way[1], i, steps)),
                    (int32_t)(from.z + part_of(way[2], i, steps))};
        dabs[i] = d;
    }
    return SF_OK;
}
