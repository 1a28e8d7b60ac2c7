// SPDX-License-Identifier: MIT
// Between the axes of the input and build axes.
//
// An axis of one is an axis of the other, perhaps turned around, so that boxes stay boxes and sides
// that are infinitely far away stay there.

#ifndef DEMO_SF_TURNED_H
#define DEMO_SF_TURNED_H

#include "part.h"

// The direction of an axis.
void turned_axis(axis which, double direction[3]);

// A direction, or a point in mm; `to` may be `from`.
void turned_to_build(const cli_job *job, const double from[3], double to[3]);
void turned_to_input(const cli_job *job, const double from[3], double to[3]);

// The two corners of a box.
void turned_box(const cli_job *job, const double low[3], const double high[3], double to_low[3],
                double to_high[3]);

#endif
