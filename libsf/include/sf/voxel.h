// SPDX-License-Identifier: MIT
// Voxels: slices (<sf/slice.h>) and grids of them (<sf/grid.h>).
//
// A slice is a plane of bits, a grid is a stack of slices on a lattice, z up. Said once, for the
// whole library: voxel x of row y is bit x % 64 of words[y * stride + x / 64]; bits past the width
// are zero in what a call writes and ignored on entry; a voxel is solid or not at its centre. What
// lies outside a slice is an argument of each call that looks there, never a global. Arrays of
// voxels are in (layer, y, x) order. Lengths are millimetres (_mm) or voxels (_vx).
//
// A slice is a view: it owns nothing. A grid owns its memory, with rows on 64-byte boundaries.

#ifndef SF_VOXEL_H
#define SF_VOXEL_H

#include <sf/grid.h>
#include <sf/slice.h>

#endif
