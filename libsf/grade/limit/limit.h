// SPDX-License-Identifier: MIT
// The inside of a limit.

#ifndef SF_GRADE_LIMIT_LIMIT_H
#define SF_GRADE_LIMIT_LIMIT_H

#include <sf/limit.h>

#include "grade/limit/chart.h"
#include "grade/refine/refinement.h"

struct sf_limit {
    sf_allocator allocator;
    sf_refinement *refined;                // by one step
    sfi_chart charts[1 + SF_PROPERTY_MAX]; // one for each of its layouts
};

// The values of a channel after the step, and their chart. SF_PROPERTY_MAX stands for positions.
typedef struct sfi_field {
    const sfi_chart *chart;
    uint32_t width;
    const double *values;
} sfi_field;

sfi_field sfi_limit_field(const sf_limit *limit, size_t channel);

#endif
