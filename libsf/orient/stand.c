// SPDX-License-Identifier: MIT
// Standing: the angle by which a part may be tipped before it falls.
//
// A body on a plane falls over an edge of the convex hull of what touches the plane once its centre
// of mass has passed above that edge. With the centre at height h and at distance d inside of an
// edge's line, that is after a turn of atan(d / h); the least over all edges is the margin. Where
// the centre lies outside, d and the angle are negative: it falls by itself.
//
// What touches is the first slice that holds matter, as squares. The hull of a slice is that of the
// ends of its rows: for each height y between rows, the least and the greatest x of the two rows
// beside it. It is found in integers.

#include "orient/stand.h"

#include "base/bits.h"
#include "base/math.h"
#include "base/memory.h"
#include "base/polygon.h"
#include "base/status.h"
#include "voxel/slice.h"
#include "voxel/wide.h"

// First and last solid voxel of a row; returns 0 where there is none.
static int row_ends(sf_slice slice, uint32_t y, int64_t *first, int64_t *end)
{
    const uint64_t *row = sfi_slice_row(slice, y);
    size_t words = sfi_row_words(slice.width);
    int found = 0;
    for (size_t i = 0; i < words; i++) {
        uint64_t word = i + 1 < words ? row[i] : row[i] & sfi_tail_mask(slice.width);
        if (word != 0) {
            *first = found ? *first : (int64_t)(64 * i + sfi_lowest_bit(word));
            *end = (int64_t)(64 * i + sfi_highest_bit(word)) + 1;
            found = 1;
        }
    }
    return found;
}

// The ends of rows, two for each height; returns how many.
static size_t find_ends(sf_slice slice, sfi_corner *ends)
{
    size_t count = 0;
    for (uint32_t y = 0; y <= slice.height; y++) {
        int64_t first = 0, end = 0, other_first = 0, other_end = 0;
        int above = y < slice.height && row_ends(slice, y, &first, &end);
        int below = y > 0 && row_ends(slice, y - 1, &other_first, &other_end);
        if (!above && !below) {
            continue;
        }
        if (!above || (below && other_first < first)) {
            first = other_first;
        }
        if (!above || (below && other_end > end)) {
            end = other_end;
        }
        sfi_corner left = {first, (int64_t)y, 0}, right = {end, (int64_t)y, 0};
        ends[count++] = left;
        ends[count++] = right;
    }
    return count;
}

// Mean of a coordinate over the solid voxels' middles, in voxels.
static double middle(const sf_wide *sum, uint64_t count)
{
    return sfi_wide_double(*sum) / (double)count + 0.5;
}

sf_status sfi_stand_margin(const sf_grid *grid, const sf_allocator *allocator, double *margin_rad)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_moments moments;
    uint32_t bed = 0;
    SF_TRY(sf_grid_measure(grid, NULL, &moments));
    *margin_rad = 0;
    if (moments.count == 0) {
        return SF_OK;
    }
    while (!sfi_slice_any(sf_grid_slice(grid, bed))) {
        bed++;
    }
    size_t most = 2 * ((size_t)lattice.ny + 1), edge;
    sfi_corner *corners = sfi_alloc_array(allocator, most, sizeof *corners);
    if (corners == NULL) {
        return SF_ERR_MEMORY;
    }
    size_t count = sfi_polygon_hull(corners, find_ends(sf_grid_slice(grid, bed), corners));
    double inside = sfi_polygon_inside(corners, count, middle(&moments.x, moments.count),
                                       middle(&moments.y, moments.count), lattice.pitch_x_mm,
                                       lattice.pitch_y_mm, &edge);
    double height = (middle(&moments.z, moments.count) - bed) * lattice.layer_mm;
    *margin_rad = sfi_atan(inside / height);
    sfi_free_array(allocator, corners, most, sizeof *corners);
    return SF_OK;
}
