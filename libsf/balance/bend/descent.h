// SPDX-License-Identifier: MIT
// Balancing as the paper does it: gradient descent on a weighed sum.

#ifndef SF_BALANCE_DESCENT_H
#define SF_BALANCE_DESCENT_H

#include "balance/bend/sqp.h"

// What the schedule remembers from step to step.
typedef struct sfi_descent {
    double mu;   // share of the shape's energy in the sum, 0 to 1
    double step; // share of the longest step that cannot overshoot
    int ended;   // 1: mu is used up, nothing improves any more
} sfi_descent;

// The schedule at its beginning.
sfi_descent sfi_descent_begin(double mu);

// One step from `poses`, which receive the result; with `ended` set nothing happens but that the
// state is filled in. `free` as in sfi_freedom; scales have no bounds. The descent forgets nothing
// on failure: SF_ERR_MEMORY, SF_ERR_ARGUMENT leave all as it was.
sf_status sfi_descent_step(const sfi_posture *posture, const uint8_t *free,
                           const sf_allocator *allocator, sf_task *task, sfi_descent *descent,
                           sf_pose *poses, sfi_posture_state *state);

#endif
