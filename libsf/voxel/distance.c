// SPDX-License-Identifier: MIT
// The exact Euclidean distance transform of a slice, in integers.
//
// Two passes down and up the columns give every voxel its distance g to the closest solid voxel of
// its column. Then in each row
//
//     D(x)^2 = min over i of (x - i)^2 + g(i)^2,
//
// the lower envelope of parabolas, one for each column that holds matter. They are kept on a stack,
// each with the place from which on it is the lowest; a new one (at u) takes over from the top of
// the stack (at i) behind
//
//     sep(i, u) = floor((u^2 - i^2 + g(u)^2 - g(i)^2) / (2 (u - i))),
//
// and removes it where that lies before the top's own beginning. Each column is put on the stack
// once and taken off at most once, so the whole is linear in the voxels. All numbers are integers
// below 2^34, so the result is exact, and the same everywhere.
//
// Source: A. Meijster, J. B. T. M. Roerdink, W. H. Hesselink, "A General Algorithm for Computing
// Distance Transforms in Linear Time", 2000.

#include "voxel/distance.h"

#include "voxel/slice.h"

#include <math.h>

// More than any distance in a column, and its square fits.
#define NO_MATTER UINT32_C(0x1ffff)

uint32_t sfi_distance_steps(uint32_t squared)
{
    if (squared == SFI_DISTANCE_NONE) {
        return 1;
    }
    uint64_t root = (uint64_t)sqrt((double)squared);
    return (uint32_t)(root * root < squared ? root + 1 : root);
}

// squared = distance to the closest solid voxel of the column, or NO_MATTER.
static void measure_columns(sf_slice slice, uint32_t *squared)
{
    size_t width = slice.width;
    for (uint32_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(slice, y);
        uint32_t *at = squared + y * width;
        for (uint32_t x = 0; x < slice.width; x++) {
            uint32_t above = y > 0 ? at[(ptrdiff_t)x - (ptrdiff_t)width] : NO_MATTER;
            at[x] = (row[x / 64] >> (x % 64) & 1) != 0 ? 0
                    : above < NO_MATTER                ? above + 1
                                                       : NO_MATTER;
        }
    }
    for (uint32_t y = slice.height - 1; y > 0; y--) {
        const uint32_t *below = squared + y * width;
        uint32_t *at = squared + (y - 1) * width;
        for (uint32_t x = 0; x < slice.width; x++) {
            at[x] = at[x] <= below[x] + 1 ? at[x] : below[x] + 1;
        }
    }
}

static uint64_t parabola(const uint32_t *g, uint32_t i, uint32_t x)
{
    uint64_t d = x > i ? x - i : i - x;
    return d * d + (uint64_t)g[i] * g[i];
}

// Where the parabola at u > i falls below the one at i; asked only where that is not negative.
static uint64_t separation(const uint32_t *g, uint32_t i, uint32_t u)
{
    uint64_t later = (uint64_t)u * u + (uint64_t)g[u] * g[u];
    uint64_t sooner = (uint64_t)i * i + (uint64_t)g[i] * g[i];
    return (later - sooner) / (2 * (uint64_t)(u - i));
}

// The envelope of a row: columns of its parabolas and where each begins. Returns their number.
static uint32_t build_envelope(const uint32_t *g, uint32_t width, uint32_t *column, uint32_t *begin)
{
    uint32_t count = 0;
    for (uint32_t u = 0; u < width; u++) {
        if (g[u] == NO_MATTER) {
            continue;
        }
        while (count > 0 && parabola(g, column[count - 1], begin[count - 1]) >
                                parabola(g, u, begin[count - 1])) {
            count--;
        }
        uint64_t from = count > 0 ? separation(g, column[count - 1], u) + 1 : 0;
        if (from < width) {
            column[count] = u;
            begin[count++] = (uint32_t)from;
        }
    }
    return count;
}

static void measure_row(uint32_t *row, uint32_t width, uint32_t *scratch)
{
    uint32_t *g = scratch, *column = scratch + width, *begin = scratch + 2 * (size_t)width;
    for (uint32_t x = 0; x < width; x++) {
        g[x] = row[x];
    }
    uint32_t count = build_envelope(g, width, column, begin);
    for (uint32_t x = 0, i = 0; x < width; x++) {
        while (i + 1 < count && begin[i + 1] <= x) {
            i++;
        }
        uint64_t d = count > 0 ? parabola(g, column[i], x) : SFI_DISTANCE_NONE;
        uint64_t most = count > 0 ? SFI_DISTANCE_NONE - 1 : SFI_DISTANCE_NONE;
        row[x] = (uint32_t)(d < most ? d : most);
    }
}

void sfi_slice_distance(sf_slice slice, uint32_t *squared, uint32_t *scratch)
{
    measure_columns(slice, squared);
    for (uint32_t y = 0; y < slice.height; y++) {
        measure_row(squared + (size_t)y * slice.width, slice.width, scratch);
    }
}
