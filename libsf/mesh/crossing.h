// SPDX-License-Identifier: MIT
// Where rows of voxel centres cross the triangles of a mesh.

#ifndef SF_MESH_CROSSING_H
#define SF_MESH_CROSSING_H

#include "mesh/frame.h"
#include "mesh/skin.h"

// A step: the crossing moves the winding number from voxel `step >> 2` on; SFI_STEP_LEAVES where
// it falls, SFI_STEP_CAP where the triangle is no part of the mesh.
#define SFI_STEP_SHIFT 2

// Rows y0..y1 of the layers k0..k1, half-open; row (k, y) has number (k - k0) * (y1 - y0) + y - y0.
typedef struct sfi_window {
    uint32_t k0, k1, y0, y1;
} sfi_window;

// Crossings in the order of discovery: row number in the high half, step in the low half.
typedef struct sfi_crossings {
    uint64_t *items;
    size_t count, capacity;
    uint32_t *row_counts; // crossings of each row of the window, kept up to date
} sfi_crossings;

// Append the crossings of some triangles of a skin with a window. Returns how many triangles of
// the list were done; fewer than `count` when the buffer could not hold all of the next one's.
size_t sfi_crossings_add(sfi_crossings *crossings, const sfi_frame *frame, const sfi_skin *skin,
                         const uint32_t *list, size_t count, sfi_window window);

#endif
