// SPDX-License-Identifier: MIT
// The rest point of one bent point.

#ifndef SF_BALANCE_BLEND_NEWTON_H
#define SF_BALANCE_BLEND_NEWTON_H

#include "balance/blend/blend.h"
#include "balance/handle/weights.h"

typedef struct sfi_unbend {
    const sf_weights *weights;
    const sfi_map *maps;
    double tolerance;
} sfi_unbend;

// A rest point on its way.
typedef struct sfi_rest {
    double at[3];
    double residual; // how far its blend is from the bent point
} sfi_rest;

// Where a rest point is bent to, and how far that is from `bent`.
sfi_rest sfi_unbend_try(const sfi_unbend *unbend, const double bent[3], const double at[3]);

// Newton's method from a rest point, to within the tolerance or as near as it gets.
sfi_rest sfi_unbend_newton(const sfi_unbend *unbend, const double bent[3], sfi_rest from);

// The rest point of what lies `by` further on, to first order.
void sfi_unbend_follow(const sfi_unbend *unbend, const sfi_rest *rest, const double by[3],
                       double at[3]);

#endif
