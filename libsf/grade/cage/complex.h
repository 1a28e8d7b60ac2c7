// SPDX-License-Identifier: MIT
// The points, edges, faces and cells of a mesh, and how they hang together.

#ifndef SF_GRADE_CAGE_COMPLEX_H
#define SF_GRADE_CAGE_COMPLEX_H

#include <sf/cage.h>

#include "grade/cage/shape.h"

#define SFI_NONE UINT32_MAX

// A list for each of many things: those of i are items[starts[i]] to items[starts[i + 1] - 1].
typedef struct sfi_lists {
    uint32_t *starts; // one more than there are lists
    uint32_t *items;
} sfi_lists;

// In dimension 2 there are no cells, and all of it is surface.
typedef struct sfi_complex {
    sf_allocator allocator;
    sfi_shapes *shapes;
    uint32_t dimension;
    uint32_t points, edges, faces, cells;
    uint32_t *edge_points;   // two of each edge
    sfi_lists face_points;   // around each face; of a boundary face seen from outside
    uint32_t *face_edges;    // as face_points: from that point to the next one
    uint32_t *face_cells;    // two of each face; the second SFI_NONE on the boundary
    sfi_lists cell_points;   // corners, in the order of <sf/cage.h>
    sfi_lists cell_faces;    // in the order of the cell's shape
    sfi_lists cell_edges;    // in the order of the cell's shape
    uint8_t *point_outside;  // on the boundary; in dimension 2 on an open edge
    uint8_t *edge_outside;   // on the boundary; in dimension 2 open, which is sharp for ever
    double *point_sharpness; // above 0 on the surface only
    double *edge_sharpness;  // above 0 on the surface only
} sfi_complex;

// Cells, or in dimension 2 faces, by their corners.
typedef struct sfi_corners {
    uint32_t dimension, points, cells;
    const uint32_t *starts, *items;
} sfi_corners;

// Build a complex from corners that are in range. SF_ERR_ARGUMENT, SF_ERR_UNSUPPORTED with a
// sentence: a cell of a shape that is not served or with a point twice, a face of three cells, two
// cells that see a face the same way round; SF_ERR_OVERFLOW; SF_ERR_MEMORY. Nothing is sharp.
sf_status sfi_complex_build(const sfi_corners *corners, const sf_allocator *allocator,
                            sfi_complex *complex, sf_fault *fault);

// Cut a complex once: points are those of points, edges, faces and cells, in that order; what was
// sharp is less so by 1. Child j of a cell keeps its corner j.
sf_status sfi_complex_split(const sfi_complex *parent, const sf_allocator *allocator,
                            sfi_complex *child);

// Points of a complex once it is cut; 0 if they are too many.
uint32_t sfi_complex_split_points(const sfi_complex *parent);

// The corners alone of the pieces that a complex is cut into: 8 of each, in dimension 2 4.
void sfi_complex_split_cells(const sfi_complex *parent, uint32_t *corners);

// Free what a complex holds; one of zeros holds nothing.
void sfi_complex_free(sfi_complex *complex);

// Take memory for all of a complex whose counts are set, with `face_corners`, `cell_corners`,
// `cell_faces` and `cell_edges` items in its lists. Nothing is sharp and nothing outside, faces
// have no cells. Without memory the complex is all zeros.
sf_status sfi_complex_alloc(sfi_complex *complex, size_t face_corners, size_t cell_corners,
                            size_t cell_faces, size_t cell_edges);

// What is on the boundary, by the faces of one cell or the edges of one face.
void sfi_complex_find_outside(sfi_complex *complex);

// Turn lists around: for each of `targets` things the lists that name it, in their order.
sf_status sfi_lists_turn(const sf_allocator *allocator, uint32_t count, const uint32_t *starts,
                         const uint32_t *items, uint32_t targets, sfi_lists *turned);

// The same for `count` lists of two each, where one that is SFI_NONE counts for nothing.
sf_status sfi_pairs_turn(const sf_allocator *allocator, uint32_t count, const uint32_t *pairs,
                         uint32_t targets, sfi_lists *turned);

// Memory for lists: `count` of them with `items` items. Returns 0, holding nothing, without it.
int sfi_lists_alloc(const sf_allocator *allocator, size_t count, size_t items, sfi_lists *lists);

// A sharpness after one step.
static inline double sfi_less_sharp(double sharpness)
{
    return sharpness >= SF_SHARP ? sharpness : sharpness > 1 ? sharpness - 1 : 0;
}

// Whether a face belongs to the surface.
static inline int sfi_on_surface(const sfi_complex *complex, uint32_t face)
{
    return complex->dimension == 2 || complex->face_cells[2 * (size_t)face + 1] == SFI_NONE;
}

// Free lists of `count` things; of zeros does nothing.
void sfi_lists_free(const sf_allocator *allocator, uint32_t count, sfi_lists *lists);

#endif
