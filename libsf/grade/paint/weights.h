// SPDX-License-Identifier: MIT
// Weights of a selection, and means of neighbours.

#ifndef SF_GRADE_PAINT_WEIGHTS_H
#define SF_GRADE_PAINT_WEIGHTS_H

#include <sf/paint.h>

#include "grade/cage/cage.h"

// Whether all weights lie from 0 to 1.
int sfi_weights_are_good(const double *weights, size_t count);

#endif
