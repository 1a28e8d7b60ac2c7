// SPDX-License-Identifier: MIT
// How strongly voxels of a mask push each other apart.

#ifndef SF_GRADE_TONE_SPREAD_H
#define SF_GRADE_TONE_SPREAD_H

#include <sf/halftone.h>

// A voxel pushes the one at (dx, dy, dz) from it, taken around the torus, by `weight`; offsets may
// lead to one voxel more than once.
typedef struct sfi_push {
    uint32_t dx, dy, dz; // each below the period
    uint32_t weight;     // above 0; all of a spread add up to less than 2^31
} sfi_push;

typedef struct sfi_spread {
    sfi_push *pushes;
    size_t count;
} sfi_spread;

// The pushes of valid options.
sf_status sfi_spread_create(const sf_mask_options *options, const sf_allocator *allocator,
                            sfi_spread *spread);
void sfi_spread_destroy(sfi_spread *spread, const sf_allocator *allocator);

#endif
