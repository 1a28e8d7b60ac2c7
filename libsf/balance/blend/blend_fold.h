// SPDX-License-Identifier: MIT
// Where a blend folds the solid over itself.

#ifndef SF_BALANCE_BLEND_FOLD_H
#define SF_BALANCE_BLEND_FOLD_H

#include "balance/handle/weights.h"

#include <sf/blend.h>

// As sf_weights_fold(), and some of the places that are folded, spread over the solid: spots with
// the cell whose slopes they have. The same whatever the threads.
sf_status sfi_weights_folds(const sf_weights *weights, const sf_pose *poses, sf_task *task,
                            size_t capacity, sf_fold *fold, sfi_spot *spots, size_t *count);

#endif
