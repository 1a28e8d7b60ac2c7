// SPDX-License-Identifier: MIT
// Ranks by void and cluster.

#ifndef SF_GRADE_TONE_VOID_CLUSTER_H
#define SF_GRADE_TONE_VOID_CLUSTER_H

#include "grade/tone/spread.h"

// Ranks of all voxels of a period of valid options, in (layer, y, x) order.
sf_status sfi_void_and_cluster(const sf_mask_options *options, const sf_allocator *allocator,
                               sf_task *task, uint32_t *ranks);

#endif
