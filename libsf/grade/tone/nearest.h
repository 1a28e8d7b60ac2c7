// SPDX-License-Identifier: MIT
// The nearest point of a simplex.

#ifndef SF_GRADE_TONE_NEAREST_H
#define SF_GRADE_TONE_NEAREST_H

#include "grade/tone/solve.h"

// Corners of a simplex, in a space of `dimensions`.
typedef struct sfi_corners {
    const double *at[SFI_SOLVE_MAX];
    int count;
    int dimensions;
} sfi_corners;

// Weights, at least 0 and of sum 1, of the point nearest to p; returns its squared distance.
// Corners may lie in a plane of any dimension: of equally good weights it is the first that are
// found.
double sfi_nearest(const sfi_corners *corners, const double *p, double *weights);

#endif
