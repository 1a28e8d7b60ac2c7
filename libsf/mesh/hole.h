// SPDX-License-Identifier: MIT
// Rows of voxels of a mesh with holes.

#ifndef SF_MESH_HOLE_H
#define SF_MESH_HOLE_H

#include "mesh/row.h"

// Boxes of 32, 16, 8, 4 and 2 voxels a side.
#define SFI_HOLE_LEVELS 5
// Side of the largest. Rows are best filled box by box, and box within box, not layer by layer.
#define SFI_HOLE_BOX 32u

// Surveys of the boxes around the current row; made when needed.
typedef struct sfi_hole_lane {
    sfi_winding_box *boxes[SFI_HOLE_LEVELS];
    unsigned char *known[SFI_HOLE_LEVELS]; // which of them are surveyed
    uint32_t counts[SFI_HOLE_LEVELS];
    uint32_t tile_y[SFI_HOLE_LEVELS], tile_k[SFI_HOLE_LEVELS]; // where the boxes stand
} sfi_hole_lane;

sf_status sfi_hole_lane_create(uint32_t nx, const sf_allocator *allocator, sfi_hole_lane *lane);
void sfi_hole_lane_destroy(sfi_hole_lane *lane, const sf_allocator *allocator);

// Write one row of a mesh with holes, the row y of layer k: solid where the winding number of the
// mesh without its patches is at least one half. Its changes are in the lane, by voxel.
void sfi_row_fill_open(sfi_lane *lane, sfi_hole_lane *holes, size_t change_count,
                       const sfi_frame *frame, const sfi_skin *skin, uint32_t y, uint32_t k,
                       uint64_t *words);

#endif
