// SPDX-License-Identifier: MIT
// Convex hulls of points in the plane, with integer coordinates.

#ifndef SF_BASE_POLYGON_H
#define SF_BASE_POLYGON_H

#include <stddef.h>
#include <stdint.h>

// No coordinate lies further than this from 0.
#define SFI_CORNER_MAX (INT64_C(1) << 61)

typedef struct sfi_corner {
    int64_t x, y;
    uint32_t name; // the caller's
} sfi_corner;

// Leave in front the corners of the convex hull of the points, counter-clockwise, beginning with
// the one of least x (then least y), and return how many they are: 1 where all points are one, 2
// where they lie on a line. No three corners lie on a line. What stands behind them is lost. Of
// points in one place any one stays, and always the same.
size_t sfi_polygon_hull(sfi_corner *points, size_t count);

// The least distance of (x, y) to the line through an edge, positive inside, and the edge: the one
// from corner `edge` to the next. A unit along x and y is worth pitch_x and pitch_y; count >= 3.
double sfi_polygon_inside(const sfi_corner *corners, size_t count, double x, double y,
                          double pitch_x, double pitch_y, size_t *edge);

#endif
