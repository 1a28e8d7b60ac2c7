// SPDX-License-Identifier: MIT
// Rows of voxels of a mesh with holes.

#ifndef SF_MESH_HOLE_H
#define SF_MESH_HOLE_H

#include "mesh/row.h"

// Write one row of a mesh with holes, the row y of layer k: solid where the winding number of the
// mesh without its patches is at least one half. Its changes are in the lane, by voxel.
void sfi_row_fill_open(sfi_lane *lane, size_t change_count, const sfi_frame *frame,
                       const sfi_skin *skin, uint32_t y, uint32_t k, uint64_t *words);

#endif
