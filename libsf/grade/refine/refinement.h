// SPDX-License-Identifier: MIT
// The inside of a refinement.

#ifndef SF_GRADE_REFINE_REFINEMENT_H
#define SF_GRADE_REFINE_REFINEMENT_H

#include <sf/refine.h>

#include "grade/refine/glue.h"
#include "grade/refine/layout.h"

// A property: how its values hang together, and what they are after each step.
typedef struct sfi_refined_channel {
    sf_property property;
    uint32_t layout;    // which of the refinement's layouts
    size_t value_count; // in the cage
    uint32_t *sources;  // of each point of the layout its value in the cage; NULL: its own
    double *values[SF_REFINE_STEP_MAX + 1];
} sfi_refined_channel;

struct sf_refinement {
    sf_allocator allocator;
    uint32_t dimension, steps;
    size_t cells[SF_REFINE_STEP_MAX + 1];
    uint32_t *starts[SF_REFINE_STEP_MAX + 1];
    double *positions[SF_REFINE_STEP_MAX + 1];
    // The first is that of the solid; the others are of properties that jump somewhere.
    uint32_t layout_count;
    sfi_layout layouts[1 + SF_PROPERTY_MAX];
    size_t channel_count;
    sfi_refined_channel channels[SF_PROPERTY_MAX];
    sf_channel views[SF_REFINE_STEP_MAX + 1][SF_PROPERTY_MAX];
};

#endif
