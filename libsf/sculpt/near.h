// SPDX-License-Identifier: MIT
// How near the voxels of a patch are to what stands in it, in steps of an element.

#ifndef SF_SCULPT_NEAR_H
#define SF_SCULPT_NEAR_H

#include "sculpt/patch.h"

// A question, and planes of one patch for it; empty, but for `wanted` and `reached`.
typedef struct sfi_near {
    const sf_element *element;
    sfi_patch patch;
    const uint64_t *wanted; // what is to be reached
    sfi_rows rows;          // that hold it
    uint32_t limit;         // steps after which the patch may end; 0: it need not
    uint64_t *reached;      // what stands; used up
    uint64_t *rings[3];     // rings[d % 3]: what is d steps away, as far as it was looked for
    uint64_t *other, *wide, *inside; // scratch
} sfi_near;

// Fill the rings until all that is wanted is reached, or nothing more is, or the limit is; then in
// the rows of `wanted` and a step beside them they are right. *steps = how many were made, *is_all
// = whether all is reached.
sf_status sfi_find_near(sfi_near *near, uint32_t *steps, int *is_all);

#endif
