// SPDX-License-Identifier: MIT
// Cubic splines over a grid of four points along each axis.

#ifndef SF_GRADE_LIMIT_SPLINE_H
#define SF_GRADE_LIMIT_SPLINE_H

#include "grade/limit/atlas.h"

enum { SFI_SPLINE_WIDTH = 3 }; // numbers at a point, at the most

// Coefficients of one regular cell, less those of its first point.
typedef struct sfi_spline {
    uint32_t dimension, width;
    double base[SFI_SPLINE_WIDTH];
    double
        rest[64 * SFI_SPLINE_WIDTH]; // x fastest, then y, then z; the numbers of a point together
} sfi_spline;

// The coefficients of a regular kind from the `width` values of each of its ring's points.
void sfi_spline_gather(const sfi_net *net, uint32_t dimension, uint32_t width, const double *values,
                       sfi_spline *spline);

// The value at u, within 0 to 1 along each axis or near to it, and, unless NULL, its derivatives:
// of each number by each axis, axes together.
void sfi_spline_at(const sfi_spline *spline, const double *u, double *value, double *derivatives);

// One half of a spline of three parameters and three numbers along an axis, by inserting a knot in
// the middle.
void sfi_spline_halve(const sfi_spline *from, uint32_t axis, uint32_t high, sfi_spline *to);

#endif
