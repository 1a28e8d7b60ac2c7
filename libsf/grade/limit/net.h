// SPDX-License-Identifier: MIT
// Regular rings as grids of spline coefficients.

#ifndef SF_GRADE_LIMIT_NET_H
#define SF_GRADE_LIMIT_NET_H

#include "grade/limit/atlas.h"

// Whether a ring is regular, and then its net.
int sfi_net_find(const sfi_ring *ring, sfi_net *net);

#endif
