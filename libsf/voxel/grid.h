// SPDX-License-Identifier: MIT
// What the library itself asks of grids.

#ifndef SF_VOXEL_GRID_H
#define SF_VOXEL_GRID_H

#include <sf/voxel.h>

// The allocator that the grid took its memory from: for working memory of calls that change the
// grid, and so have it to themselves.
sf_allocator sfi_grid_allocator(const sf_grid *grid);

#endif
