// SPDX-License-Identifier: MIT
// A complex after each of some steps, without values.

#ifndef SF_GRADE_REFINE_LAYOUT_H
#define SF_GRADE_REFINE_LAYOUT_H

#include <sf/refine.h>

#include "grade/cage/complex.h"
#include "grade/refine/matrix.h"

typedef struct sfi_layout {
    sf_allocator allocator;
    uint32_t steps;
    uint32_t points[SF_REFINE_STEP_MAX + 1];
    size_t corner_counts[SF_REFINE_STEP_MAX + 1];
    uint32_t *corners[SF_REFINE_STEP_MAX + 1]; // of all cells
    sfi_matrix matrices[SF_REFINE_STEP_MAX];   // from a step to the next
    size_t crease_counts[SF_REFINE_STEP_MAX + 1], sharp_counts[SF_REFINE_STEP_MAX + 1];
    sf_crease *creases[SF_REFINE_STEP_MAX + 1]; // what is still sharp
    sf_sharp_point *sharps[SF_REFINE_STEP_MAX + 1];
} sfi_layout;

// Refine a complex, which is left as it is. SF_ERR_OVERFLOW; SF_ERR_MEMORY; SF_ERR_CANCELLED.
sf_status sfi_layout_make(const sfi_complex *complex, const sf_refine_options *options,
                          const sf_allocator *allocator, sf_task *task, sfi_layout *layout);
void sfi_layout_free(sfi_layout *layout);

#endif
