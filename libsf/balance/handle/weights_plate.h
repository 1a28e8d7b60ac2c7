// SPDX-License-Identifier: MIT
// The energy of weights, and linear systems in it.

#ifndef SF_BALANCE_WEIGHTS_PLATE_H
#define SF_BALANCE_WEIGHTS_PLATE_H

#include "balance/handle/poisson.h"

// Four systems side by side: (A + penalty) x = b on free nodes, x = 0 on fixed ones, where A = L
// M^-1 L on all nodes.
typedef struct sfi_plate {
    const sfi_poisson *poisson;
    const uint8_t *fixed; // of each node
    sfi_cycle cycle;
    double *memory;
    size_t memory_count;
    double *residual, *direction, *image, *middle;
    uint32_t steps; // taken so far, in all
} sfi_plate;

sf_status sfi_plate_create(const sfi_poisson *poisson, const uint8_t *fixed,
                           const sf_allocator *allocator, sfi_plate *plate);
void sfi_plate_destroy(sfi_plate *plate, const sf_allocator *allocator);

// out = A x on free nodes, 0 on fixed ones, where x may be anything.
void sfi_plate_apply(sfi_plate *plate, const double *x, double *out);

// When a solve ends: where the largest correction asked for is at most `enough`, or `part` of the
// first one.
typedef struct sfi_plate_goal {
    double enough, part;
    double first, left; // filled by the solve: the largest correction asked for at first, and last
} sfi_plate_goal;

// Solve for x, from zero, until each lane has reached its goal. `penalty`, which may be NULL, has
// four numbers a node, not below 0; the cycle must hold what is fixed, with pins that go with the
// penalty. SF_ERR_CANCELLED leaves x unfinished; SF_ERR_INTERNAL: no end was seen.
sf_status sfi_plate_solve(sfi_plate *plate, const double *penalty, const double *b,
                          const sf_task *task, double *x, sfi_plate_goal goal[SFI_LANES]);

#endif
