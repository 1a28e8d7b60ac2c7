// SPDX-License-Identifier: MIT
// Exact reverse delete: leave out of a support-free shape what it can spare.

#ifndef SF_SUPPORT_SPARE_H
#define SF_SUPPORT_SPARE_H

#include "support/rule/terms.h"

// Remove from `grid`, voxel by voxel from the top down and by rows, each one outside `needed`
// without which all of `needed` would still be alive, and all that is lost with it. The grid is
// support-free before, holds `needed`, and is support-free after; then no voxel outside `needed`
// can be left out any more. A failing call leaves it half done: SF_ERR_MEMORY, SF_ERR_OVERFLOW,
// SF_ERR_CANCELLED.
sf_status sfi_spare(sf_grid *grid, const sf_grid *needed, const sf_terms *terms, uint32_t bed,
                    const sf_allocator *allocator, sf_task *task);

#endif
