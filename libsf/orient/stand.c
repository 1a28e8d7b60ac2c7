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
// beside it. Going up in y, each side is one pass over a stack of corners that turn one way (A. M.
// Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions", 1979), in integers.

#include "orient/stand.h"

#include "base/bits.h"
#include "base/math.h"
#include "base/memory.h"
#include "base/status.h"
#include "voxel/slice.h"

#include <math.h>

typedef struct corner {
    int64_t x, y;
} corner;

// Corners of one side of the hull, from low y to high y.
typedef struct side {
    corner *corners;
    size_t count;
} side;

// Add a corner to the left side (sign 1) or the right side (sign -1).
static void push(side *s, int64_t x, int64_t y, int64_t sign)
{
    while (s->count >= 2) {
        corner a = s->corners[s->count - 2], b = s->corners[s->count - 1];
        if (sign * ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) < 0) {
            break;
        }
        s->count--;
    }
    corner made = {x, y};
    s->corners[s->count++] = made;
}

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

static void find_hull(sf_slice slice, side *left, side *right)
{
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
        push(left, first, (int64_t)y, 1);
        push(right, end, (int64_t)y, -1);
    }
}

// Centre of mass in mm from the grid's lower corner.
static void find_centre(const sf_moments *m, const sf_lattice *lattice, double centre[3])
{
    const sf_wide *sums[3] = {&m->x, &m->y, &m->z};
    double pitch[3] = {lattice->pitch_x_mm, lattice->pitch_y_mm, lattice->layer_mm};
    for (int i = 0; i < 3; i++) {
        double sum = ldexp((double)sums[i]->high, 64) + (double)sums[i]->low;
        centre[i] = (sum / (double)m->count + 0.5) * pitch[i];
    }
}

// Distance of the centre to the line from a to b, positive to the left of it.
static double inside(const double centre[3], corner a, corner b, const sf_lattice *lattice)
{
    double ax = (double)a.x * lattice->pitch_x_mm, ay = (double)a.y * lattice->pitch_y_mm;
    double dx = (double)b.x * lattice->pitch_x_mm - ax, dy = (double)b.y * lattice->pitch_y_mm - ay;
    return (dx * (centre[1] - ay) - dy * (centre[0] - ax)) / sqrt(dx * dx + dy * dy);
}

// The least distance to an edge; counter-clockwise: up the right side, down the left one.
static double least_inside(const double centre[3], const side *left, const side *right,
                           const sf_lattice *lattice)
{
    double least = inside(centre, left->corners[0], right->corners[0], lattice);
    double top =
        inside(centre, right->corners[right->count - 1], left->corners[left->count - 1], lattice);
    least = top < least ? top : least;
    for (size_t i = 1; i < right->count; i++) {
        double d = inside(centre, right->corners[i - 1], right->corners[i], lattice);
        least = d < least ? d : least;
    }
    for (size_t i = 1; i < left->count; i++) {
        double d = inside(centre, left->corners[i], left->corners[i - 1], lattice);
        least = d < least ? d : least;
    }
    return least;
}

sf_status sfi_stand_margin(const sf_grid *grid, const sf_allocator *allocator, double *margin_rad)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_moments moments;
    double centre[3];
    uint32_t bed = 0;
    SF_TRY(sf_grid_measure(grid, NULL, &moments));
    *margin_rad = 0;
    if (moments.count == 0) {
        return SF_OK;
    }
    while (!sfi_slice_any(sf_grid_slice(grid, bed))) {
        bed++;
    }
    size_t most = (size_t)lattice.ny + 1;
    corner *corners = sfi_alloc_array(allocator, 2 * most, sizeof *corners);
    if (corners == NULL) {
        return SF_ERR_MEMORY;
    }
    side left = {corners, 0}, right = {corners + most, 0};
    find_hull(sf_grid_slice(grid, bed), &left, &right);
    find_centre(&moments, &lattice, centre);
    double height = centre[2] - bed * lattice.layer_mm;
    *margin_rad = sfi_atan(least_inside(centre, &left, &right, &lattice) / height);
    sfi_free_array(allocator, corners, 2 * most, sizeof *corners);
    return SF_OK;
}
