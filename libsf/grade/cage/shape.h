// SPDX-License-Identifier: MIT
// What a cell of so many corners is made of.

#ifndef SF_GRADE_CAGE_SHAPE_H
#define SF_GRADE_CAGE_SHAPE_H

#include <sf/cage.h>

enum {
    SFI_CELL_CORNER_MAX = 2 * SF_CAGE_POLYGON_MAX,
    SFI_CELL_FACE_MAX = SF_CAGE_POLYGON_MAX + 2,
    SFI_CELL_EDGE_MAX = 3 * SF_CAGE_POLYGON_MAX,
    SFI_SHAPE_COUNT = SF_CAGE_POLYGON_MAX - 1 // 4, 6, 8, ... corners
};

// A kind of cell whose corners all have three edges and three faces. Numbers are corners, faces
// and edges of the cell, from 0.
typedef struct sfi_shape {
    uint32_t corners, faces, edges;
    uint32_t face_starts[SFI_CELL_FACE_MAX + 1];
    uint8_t face_corners[2 * SFI_CELL_EDGE_MAX]; // seen from outside counter-clockwise
    uint8_t edge_corners[SFI_CELL_EDGE_MAX][2];
    uint8_t edge_faces[SFI_CELL_EDGE_MAX][2];    // the two that meet there
    uint8_t corner_ends[SFI_CELL_CORNER_MAX][3]; // other ends of its edges, right-handed
    // The hexahedron that a step cuts out at a corner, along three axes of its own: those of the
    // cell where that is a hexahedron itself, else those of corner_ends.
    uint8_t axis_edges[SFI_CELL_CORNER_MAX][3]; // the edge along each axis
    uint8_t axis_faces[SFI_CELL_CORNER_MAX][3]; // the face that holds the two other axes
    uint8_t flips[SFI_CELL_CORNER_MAX];         // the corner's place in it, as sfi_hex_bits()
} sfi_shape;

// All kinds, each described when it is first asked for.
typedef struct sfi_shapes {
    sfi_shape at[SFI_SHAPE_COUNT];
} sfi_shapes;

// Whether there are cells of so many corners.
int sfi_shape_exists(uint32_t corners);

// Cells of so many corners, which exist. The kinds begin as zeros.
const sfi_shape *sfi_shapes_get(sfi_shapes *shapes, uint32_t corners);

// The place of a hexahedron's corner in its unit cube: x in bit 0, y in bit 1, z in bit 2. Its own
// inverse: the corner at a place.
static inline uint32_t sfi_hex_bits(uint32_t corner)
{
    return corner ^ (corner >> 1 & 1);
}

#endif
