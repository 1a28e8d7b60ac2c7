// SPDX-License-Identifier: MIT
// Complete, for the operators that are made of it.

#ifndef SF_SUPPORT_COMPLETE_H
#define SF_SUPPORT_COMPLETE_H

#include "support/rule/terms.h"

// What to complete. All grids have one size.
typedef struct sfi_completion {
    const sf_grid *shape;  // V, support-free
    const sf_grid *needed; // F, within V
    const sf_terms *terms; // checked; only the rule and the exempt voxels are looked at
    uint32_t bed;          // layer that rests on the bed, or the number of layers
    uint32_t strut_width;  // 0: as few voxels as greed finds; odd: thick
} sfi_completion;

// to = a support-free part of the shape that holds `needed`; no other grid of the call. A failing
// call leaves `to` half done: SF_ERR_INFEASIBLE where the shape is not support-free or does not
// hold what is needed, SF_ERR_MEMORY, SF_ERR_OVERFLOW, SF_ERR_CANCELLED.
sf_status sfi_complete_into(sf_grid *to, const sfi_completion *completion,
                            const sf_allocator *allocator, sf_task *task);

#endif
