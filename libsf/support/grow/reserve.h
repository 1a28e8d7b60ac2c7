// SPDX-License-Identifier: MIT
// What living voxels of a grid have to spare under slack, kept small.

#ifndef SF_SUPPORT_RESERVE_H
#define SF_SUPPORT_RESERVE_H

#include <sf/grow.h>

#include "support/rule/carry.h"

typedef struct sfi_reserve {
    sf_allocator allocator;
    uint32_t height;
    uint8_t top;    // the code of the cap
    sf_grid *below; // living voxels that have less than the cap
    size_t *starts; // by rows, layer after layer: the place of the first code of their voxels
    size_t row_count;
    uint8_t *codes;
    size_t count, capacity;
} sfi_reserve;

// Empty, for a grid under a rule with slack. SF_ERR_MEMORY, SF_ERR_OVERFLOW; then there is nothing
// to destroy. Destroying what was never created (all zero) does nothing.
sf_status sfi_reserve_create(const sf_rule *rule, const sf_lattice *lattice,
                             const sf_allocator *allocator, sfi_reserve *reserve);
void sfi_reserve_destroy(sfi_reserve *reserve);

// Note layer k, after all layers below it. SF_ERR_MEMORY, SF_ERR_OVERFLOW.
sf_status sfi_reserve_add(sfi_reserve *reserve, uint32_t k, const sfi_front *front);

// What a living voxel has to spare.
uint32_t sfi_reserve_slack(const sfi_reserve *reserve, sf_voxel v);

#endif
