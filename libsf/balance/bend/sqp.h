// SPDX-License-Identifier: MIT
// Moving handles until a shape stands, with as little bending as that takes.

#ifndef SF_BALANCE_SQP_H
#define SF_BALANCE_SQP_H

#include "balance/bend/posture.h"

// What handles may do.
typedef struct sfi_freedom {
    const uint8_t *free;          // of each parameter, 7 a handle: 1 where it may change
    double scale_low, scale_high; // bounds of scales that are free
    double shift_max_mm;          // and of shifts, along each axis
    double step_max; // longest step: of a scale, a shift over the size, a turn in radians
} sfi_freedom;

typedef struct sfi_sqp_report {
    sfi_posture_state state; // at the poses that were reached
    uint32_t steps;          // quadratic programs solved
    int settled;             // 1: another step would change next to nothing
} sfi_sqp_report;

// Up to `steps_max` steps from `poses`, which receive the result. SF_ERR_MEMORY, SF_ERR_CANCELLED,
// SF_ERR_ARGUMENT: nothing has changed.
sf_status sfi_sqp_run(const sfi_posture *posture, const sfi_freedom *freedom, uint32_t steps_max,
                      const sf_allocator *allocator, sf_task *task, sf_pose *poses,
                      sfi_sqp_report *report);

#endif
