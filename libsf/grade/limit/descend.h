// SPDX-License-Identifier: MIT
// The smooth shape at a place of a cell, from the values of its ring.

#ifndef SF_GRADE_LIMIT_DESCEND_H
#define SF_GRADE_LIMIT_DESCEND_H

#include "grade/limit/atlas.h"

// Numbers of scratch that sfi_limit_at() needs.
static inline size_t sfi_limit_scratch(const sfi_atlas *atlas, uint32_t width)
{
    return 2 * (size_t)atlas->most_points * width;
}

// The value at u, within 0 to 1, of a cell of a kind whose ring's points have `width` values each
// (at most SFI_SPLINE_WIDTH), and, unless NULL, its derivatives: of each number by each axis.
void sfi_limit_at(const sfi_atlas *atlas, uint32_t kind, uint32_t width, const double *values,
                  const double *u, double *scratch, double *value, double *derivatives);

#endif
