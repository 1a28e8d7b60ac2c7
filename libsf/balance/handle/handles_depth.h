// SPDX-License-Identifier: MIT
// How deep cells lie in the solid, and how far they are from each other through it.

#ifndef SF_BALANCE_HANDLES_DEPTH_H
#define SF_BALANCE_HANDLES_DEPTH_H

#include "balance/handle/weights_domain.h"

// depth[cell] = distance in mm of the middle of a cell to the closest point outside all cells.
// SF_ERR_OVERFLOW, SF_ERR_MEMORY.
sf_status sfi_domain_depth(const sfi_domain *domain, const sf_allocator *allocator, double *depth);

// A heap of cells by their distance, for sfi_domain_spread().
typedef struct sfi_spread {
    uint32_t *heap, *where; // a place for each cell
    size_t count;
} sfi_spread;

// Lower distance[cell] to what it is from the cells whose distance is given as 0 and that are
// listed, where it is lower so: steps go from the middle of a cell to those of the 26 around.
void sfi_domain_spread(const sfi_domain *domain, const uint32_t *from, size_t from_count,
                       sfi_spread *spread, double *distance);

#endif
