// SPDX-License-Identifier: MIT
// The Laplacian of a domain, and multigrid cycles that nearly invert it.
//
// Four right-hand sides are worked on side by side, as lanes: what is said of a node is loaded once
// for all four.

#ifndef SF_BALANCE_POISSON_H
#define SF_BALANCE_POISSON_H

#include "balance/handle/weights_domain.h"

#define SFI_LANES 4
// Levels: a box of 2^31 cells along an axis has no more.
#define SFI_LEVELS_MAX 33
// Nodes of the coarsest level at most, unless it is one cell that cannot be halved.
#define SFI_BOTTOM_NODES 64

// The Laplacian on one level: L x_i = sum over six neighbours of flow (x_i - x_neighbour).
typedef struct sfi_level {
    size_t count; // nodes
    uint32_t
        *neighbour;   // six a node: below in z, y, x, above in x, y, z; itself where there is none
    float *flow;      // six a node; 0 where there is no neighbour
    float *diagonal;  // their sum
    uint32_t *begin;  // count + 1: where each node's parents begin
    uint32_t *parent; // nodes of the next level, each with an equal share
    size_t parent_count;
} sfi_level;

typedef struct sfi_poisson {
    sf_allocator allocator;
    sfi_level level[SFI_LEVELS_MAX]; // from fine to coarse
    uint32_t level_count;
    double *mass; // of each node of the finest level: volume, in units^3
} sfi_poisson;

sf_status sfi_poisson_create(const sfi_domain *domain, sfi_poisson *poisson);
void sfi_poisson_destroy(sfi_poisson *poisson);

// out = L x on the finest level, for four lanes of doubles.
void sfi_poisson_apply(const sfi_poisson *poisson, const double *x, double *out);

// What a thread needs to run cycles: pins, and vectors of all levels.
typedef struct sfi_cycle {
    const sfi_poisson *poisson;
    float *memory;
    size_t memory_count;
    float *inverse[SFI_LEVELS_MAX]; // 1 / (diagonal + pin), 0 where fixed; four a node, as are all
    float *pin[SFI_LEVELS_MAX];
    float *x[SFI_LEVELS_MAX], *b[SFI_LEVELS_MAX];
    double *bottom; // a factor of the coarsest level's matrix
    size_t bottom_count;
} sfi_cycle;

sf_status sfi_cycle_create(const sfi_poisson *poisson, const sf_allocator *allocator,
                           sfi_cycle *cycle);
void sfi_cycle_destroy(sfi_cycle *cycle, const sf_allocator *allocator);

// Say what is held: nodes with `fixed` != 0 are 0 in all lanes; pin[4 i + lane], which may be NULL
// for none, is added to the diagonal of node i. Each connected piece must have something held.
void sfi_cycle_hold(sfi_cycle *cycle, const uint8_t *fixed, const float *pin);

// x[0] = V b[0], where V is nearly the inverse of L with what is held: one symmetric cycle. Fixed
// nodes are 0.
void sfi_cycle_run(sfi_cycle *cycle);

#endif
