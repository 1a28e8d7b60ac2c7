// SPDX-License-Identifier: MIT
// A cell and all cells that touch it, in an order that depends on nothing but how they touch.

#ifndef SF_GRADE_LIMIT_RING_H
#define SF_GRADE_LIMIT_RING_H

#include "grade/cage/complex.h"

enum { SFI_RING_CORNERS = 8 };

// A crease or a sharp point of a ring (then a is b), by the ring's own points.
typedef struct sfi_ring_sharp {
    uint32_t a, b;
    double sharpness;
} sfi_ring_sharp;

// The ring of a hexahedron (in dimension 2 of a quadrilateral). Corners are by their places: bit 0
// for x, 1 for y, 2 for z. All cells are turned so that their axes are those of the cells that they
// were reached from; the cell itself is the first, and its corners are the first points.
typedef struct sfi_ring {
    uint32_t dimension;
    uint32_t cells, points, sharps;
    uint32_t *items;       // the points of each cell, 1 << dimension of them
    uint32_t *outside;     // of each cell the sides on the boundary that touch the first cell:
                           // bit 2 * axis, and one more for the high side
    int8_t *shifts;        // of each cell, by how many cells it lies off the first along each axis
    sfi_ring_sharp *sharp; // what is sharp at the first cell's points, by a and b
} sfi_ring;

// What it takes to find rings in a complex of hexahedra or quadrilaterals, which must stay.
typedef struct sfi_ring_finder {
    sf_allocator allocator;
    const sfi_complex *complex;
    sfi_lists point_cells, point_edges, edge_faces;
    uint32_t *cell_marks, *point_marks; // of each: the round it was last seen in
    uint32_t *point_locals;
    uint32_t round;
    // The ring being found; cells_at and points_at name those of the complex.
    sfi_ring ring;
    uint32_t *cells_at, *points_at;
    size_t cell_capacity, item_capacity, outside_capacity, shift_capacity, point_capacity;
    size_t sharp_capacity;
} sfi_ring_finder;

// SF_ERR_MEMORY.
sf_status sfi_ring_finder_begin(const sfi_complex *complex, const sf_allocator *allocator,
                                sfi_ring_finder *finder);
void sfi_ring_finder_free(sfi_ring_finder *finder);

// The cell across a side of a cell; SFI_NONE on the boundary.
uint32_t sfi_ring_across(const sfi_ring_finder *finder, uint32_t cell, uint32_t axis,
                         uint32_t high);

// Find the ring of a cell, into the finder, until it finds another. SF_ERR_MEMORY.
sf_status sfi_ring_find(sfi_ring_finder *finder, uint32_t cell);

#endif
