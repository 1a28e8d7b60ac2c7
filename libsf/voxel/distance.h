// SPDX-License-Identifier: MIT
// Exact distances within a slice.

#ifndef SF_VOXEL_DISTANCE_H
#define SF_VOXEL_DISTANCE_H

#include <sf/voxel.h>

// Distance in a slice where nothing is solid.
#define SFI_DISTANCE_NONE UINT32_MAX

// squared[y * width + x] = squared distance of voxel (x, y) to the closest solid one, in voxels; 0
// where it is solid itself, SFI_DISTANCE_NONE everywhere in an empty slice, and SFI_DISTANCE_NONE -
// 1 where the true number is larger than that. `scratch` has 3 * width places.
void sfi_slice_distance(sf_slice slice, uint32_t *squared, uint32_t *scratch);

// A squared distance as whole voxels, rounded up; 1 for SFI_DISTANCE_NONE.
uint32_t sfi_distance_steps(uint32_t squared);

#endif
