// SPDX-License-Identifier: MIT
// How safely voxels stand on their lowest layer.

#ifndef SF_ORIENT_STAND_H
#define SF_ORIENT_STAND_H

#include <sf/voxel.h>

// The least angle by which the grid's matter, of one density, must be tipped to fall over an edge
// of the convex hull of its first slice that holds any; negative where it falls as it is, 0 where
// nothing is solid. Layers have one height. SF_ERR_MEMORY.
sf_status sfi_stand_margin(const sf_grid *grid, const sf_allocator *allocator, double *margin_rad);

#endif
