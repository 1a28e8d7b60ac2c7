// SPDX-License-Identifier: MIT
// What the library itself asks of grids.

#ifndef SF_VOXEL_GRID_H
#define SF_VOXEL_GRID_H

#include <sf/voxel.h>

// The allocator that the grid took its memory from: for working memory of calls that change the
// grid, and so have it to themselves.
sf_allocator sfi_grid_allocator(const sf_grid *grid);

// to = from, whose counts are the same. Cannot fail then; a status for SF_TRY.
sf_status sfi_grid_copy(sf_grid *to, const sf_grid *from);

// Whether all solid voxels of `part` are solid in `whole`, whose counts are the same.
int sfi_grid_within(const sf_grid *part, const sf_grid *whole);

#endif
