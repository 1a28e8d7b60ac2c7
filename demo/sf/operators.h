// SPDX-License-Identifier: MIT
// The operators of libsf, one call for all of them.

#ifndef DEMO_SF_OPERATORS_H
#define DEMO_SF_OPERATORS_H

#include "job.h"
#include "masks.h"

// What to do to a grid.
typedef struct order {
    sf_operation operation;  // trim, grow, repair or preserve
    sf_terms terms;          // masks and, for preserve, what hangs and was accepted
    const sf_grid *brush;    // preserve: what is to go
    sf_preserve_mode mode;   // preserve: how
    uint32_t min_feature_vx; // repair: least width of what is added
} order;

// What an operation is called in a progress bar.
const char *operators_phase(sf_operation operation);

// Whether something may have to stay that cannot, so that a grid for culprits is worth its memory.
int operators_may_refuse(const order *o);

// Do it to a grid. On SF_ERR_INFEASIBLE `culprits`, where it is not NULL, holds the voxels that
// must stay and cannot, and the grid is as it was. `cost` is what the operator says of its own, or
// UINT64_MAX.
sf_status operators_apply(const order *o, sf_grid *grid, sf_grid *culprits, sf_task *task,
                          uint64_t *cost);

#endif
