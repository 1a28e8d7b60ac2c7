// SPDX-License-Identifier: MIT
// Stamp: one grid's voxels put into another, moved by whole voxels.

#ifndef SF_VOXEL_STAMP_H
#define SF_VOXEL_STAMP_H

#include <sf/voxel.h>

// to |= from, moved: voxel v of `from` comes to lie on v + by; what leaves `to` is lost. Returns
// the part of the moved grid that lies within `to`; empty where none does. |by| up to 2^40.
sf_box sfi_grid_stamp(sf_grid *to, const sf_grid *from, const int64_t by[3]);

#endif
