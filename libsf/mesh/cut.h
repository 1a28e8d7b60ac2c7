// SPDX-License-Identifier: MIT
// A mesh while it is cut in two.

#ifndef SF_MESH_CUT_H
#define SF_MESH_CUT_H

#include "mesh/mesh.h"

// Where a vertex lies.
enum { SFI_LOW, SFI_HIGH, SFI_ON };

// A corner that the mesh has not: where the edge from `low` to `high` crosses the plane; or one of
// a lid, between both.
typedef struct sfi_crossing {
    uint32_t low, high; // corners
    double at[3];
} sfi_crossing;

// Corners are numbers of vertices, and beyond those of crossings.
typedef struct sfi_cutting {
    sf_allocator allocator;
    sf_mesh *merged;
    sf_mesh_view mesh; // of it
    int axis;
    double at_mm;
    uint8_t *sides; // of vertices
    sfi_crossing *crossings;
    uint32_t *table; // of crossings, by their ends
    size_t crossing_count, crossing_capacity, slot_count;
} sfi_cutting;

// A half as it is put together.
typedef struct sfi_half {
    uint32_t *triangles; // of corners
    size_t count, capacity;
    uint32_t *edges; // corners of its edges in the plane, two each; as many as triangles at most
    uint32_t *order; // scratch: of the edges
    size_t edge_count;
    uint32_t *caps; // triangles of its lid
    size_t cap_count, cap_capacity;
} sfi_half;

// Where a corner lies, on the plane exactly where it lies on the plane.
void sfi_cut_corner(const sfi_cutting *cut, uint32_t corner, double p[3]);

// Close a half, whose triangles are complete, with what it lacks in the plane. SF_ERR_MEMORY,
// SF_ERR_OVERFLOW; what the half holds then is to be freed as always.
sf_status sfi_lid_make(sfi_cutting *cut, sfi_half *half, int is_high);

#endif
