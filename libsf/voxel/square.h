// SPDX-License-Identifier: MIT
// Squares of any width, named by the voxel of least x and y in them.

#ifndef SF_VOXEL_SQUARE_H
#define SF_VOXEL_SQUARE_H

#include <sf/voxel.h>

// slice = the corners of all squares of `width` >= 1 voxels that lie in it. Padding must be zero.
void sfi_square_corners(sf_slice slice, uint32_t width);

// slice = all voxels of the squares that have a corner in it; what leaves the slice is cut off.
// Padding must be zero.
void sfi_square_fill(sf_slice slice, uint32_t width);

#endif
