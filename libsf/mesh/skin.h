// SPDX-License-Identifier: MIT
// A mesh made ready for voxels: snapped, and turned right side out.

#ifndef SF_MESH_SKIN_H
#define SF_MESH_SKIN_H

#include "mesh/winding.h"

// Low bits of a step along a row: it leaves the mesh; it belongs to a patch and not to the mesh.
#define SFI_STEP_LEAVES 1u
#define SFI_STEP_CAP 2u

typedef struct sfi_skin {
    sfi_point *points;
    size_t point_count;
    const uint32_t *triangles; // three corners each: those of the mesh, then patches over its holes
    uint32_t *owned;           // NULL where they stand in the caller's array
    size_t triangle_count;
    size_t mesh_count;     // triangles of the mesh itself
    uint32_t mark;         // SFI_STEP_LEAVES where the whole mesh is read with the opposite sign
    int flipped;           // whether it was turned as a whole, by the mark or in `owned`
    size_t boundary_edges; // directed edges without an opposite
    sfi_winding winding;   // of the patches
} sfi_skin;

// Snap a mesh into a frame and find out how its inside is to be told.
sf_status sfi_skin_create(sf_mesh_view mesh, const sfi_frame *frame, sf_fill fill,
                          const sf_allocator *allocator, sfi_skin *skin, sf_fault *fault);
void sfi_skin_destroy(sfi_skin *skin, const sf_allocator *allocator);

// What the steps of a triangle start from.
static inline uint32_t sfi_skin_mark(const sfi_skin *skin, uint32_t triangle)
{
    return triangle < skin->mesh_count ? skin->mark : skin->mark | SFI_STEP_CAP;
}

#endif
