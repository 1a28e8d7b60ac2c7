// SPDX-License-Identifier: MIT
// The derivative of a blend by the point.

#ifndef SF_BALANCE_BLEND_JACOBIAN_H
#define SF_BALANCE_BLEND_JACOBIAN_H

#include "balance/blend/blend.h"
#include "balance/handle/weights.h"

// Where a point p goes, whose weights are those of a spot, and the derivative, row after row.
void sfi_jacobian(const sf_weights *weights, const sfi_map *maps, const sfi_spot *spot,
                  const double p[3], double bent[3], double jacobian[9]);

static inline double sfi_determinant(const double m[9])
{
    return (m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6])) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
}

#endif
