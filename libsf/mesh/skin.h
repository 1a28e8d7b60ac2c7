// SPDX-License-Identifier: MIT
// A mesh made ready for voxels: snapped, and turned right side out.

#ifndef SF_MESH_SKIN_H
#define SF_MESH_SKIN_H

#include "mesh/frame.h"

typedef struct sfi_skin {
    sfi_point *points;
    size_t point_count;
    const uint32_t *triangles; // three corners each, the caller's array
    size_t triangle_count;
    uint32_t mark;         // SFI_STEP_LEAVES where the whole mesh is read with the opposite sign
    size_t boundary_edges; // directed edges without an opposite
} sfi_skin;

// Snap a mesh into a frame and find out how its inside is to be told.
sf_status sfi_skin_create(sf_mesh_view mesh, const sfi_frame *frame, sf_fill fill,
                          const sf_allocator *allocator, sfi_skin *skin, sf_fault *fault);
void sfi_skin_destroy(sfi_skin *skin, const sf_allocator *allocator);

// What the steps of a triangle start from: SFI_STEP_LEAVES where it is turned around.
static inline uint32_t sfi_skin_mark(const sfi_skin *skin, uint32_t triangle)
{
    (void)triangle;
    return skin->mark;
}

#endif
