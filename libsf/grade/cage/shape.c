// SPDX-License-Identifier: MIT
// Kinds of cells: tetrahedra, and prisms over polygons, the cube among them.
//
// One step of subdivision cuts a cell into one piece for each corner, and the piece is a hexahedron
// where the corner has three edges. Tetrahedra and prisms are the cells with nothing but such
// corners that meshes are made of; a pyramid's tip has four edges and is refused.
//
// Only the loops of corners around the faces are written down; all else follows from them.

#include "grade/cage/shape.h"

#include <string.h>

int sfi_shape_exists(uint32_t corners)
{
    return corners == 4 || (corners >= 6 && corners % 2 == 0 && corners <= SFI_CELL_CORNER_MAX);
}

static void add_face(sfi_shape *shape, uint32_t count, const uint8_t *corners)
{
    uint32_t start = shape->face_starts[shape->faces];
    memcpy(shape->face_corners + start, corners, count);
    shape->face_starts[++shape->faces] = start + count;
}

static void add_tetrahedron(sfi_shape *shape)
{
    static const uint8_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (int i = 0; i < 4; i++) {
        add_face(shape, 3, faces[i]);
    }
}

// Below 0 to n - 1, seen from inside counter-clockwise; above the same again.
static void add_prism(sfi_shape *shape, uint32_t n)
{
    uint8_t below[SF_CAGE_POLYGON_MAX], above[SF_CAGE_POLYGON_MAX];
    for (uint32_t i = 0; i < n; i++) {
        below[i] = (uint8_t)(i == 0 ? 0 : n - i);
        above[i] = (uint8_t)(n + i);
    }
    add_face(shape, n, below);
    add_face(shape, n, above);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t next = (i + 1) % n;
        uint8_t side[4] = {(uint8_t)i, (uint8_t)next, (uint8_t)(n + next), (uint8_t)(n + i)};
        add_face(shape, 4, side);
    }
}

// Each edge lies on two faces, which go along it in opposite directions.
static void find_edges(sfi_shape *shape)
{
    for (uint32_t f = 0; f < shape->faces; f++) {
        uint32_t start = shape->face_starts[f], end = shape->face_starts[f + 1];
        for (uint32_t i = start; i < end; i++) {
            uint8_t a = shape->face_corners[i];
            uint8_t b = shape->face_corners[i + 1 < end ? i + 1 : start];
            uint32_t e = 0;
            while (e < shape->edges &&
                   !(shape->edge_corners[e][0] == b && shape->edge_corners[e][1] == a)) {
                e++;
            }
            if (e == shape->edges) {
                shape->edge_corners[e][0] = a;
                shape->edge_corners[e][1] = b;
                shape->edge_faces[e][0] = (uint8_t)f;
                shape->edges++;
            } else {
                shape->edge_faces[e][1] = (uint8_t)f;
            }
        }
    }
}

// The three faces of a corner, and how each goes through it.
typedef struct corner_fan {
    uint8_t face[3], entering[3], leaving[3]; // the face, the corner before, the corner after
} corner_fan;

static corner_fan find_fan(const sfi_shape *shape, uint32_t corner)
{
    corner_fan fan = {{0}, {0}, {0}};
    uint32_t found = 0;
    for (uint32_t f = 0; f < shape->faces; f++) {
        uint32_t start = shape->face_starts[f], end = shape->face_starts[f + 1];
        for (uint32_t i = start; i < end; i++) {
            if (shape->face_corners[i] == corner) {
                fan.face[found] = (uint8_t)f;
                fan.leaving[found] = shape->face_corners[i + 1 < end ? i + 1 : start];
                fan.entering[found] = shape->face_corners[i > start ? i - 1 : end - 1];
                found++;
            }
        }
    }
    return fan;
}

static uint8_t edge_between(const sfi_shape *shape, uint32_t a, uint32_t b)
{
    uint8_t e = 0;
    while (!(shape->edge_corners[e][0] == a && shape->edge_corners[e][1] == b) &&
           !(shape->edge_corners[e][0] == b && shape->edge_corners[e][1] == a)) {
        e++;
    }
    return e;
}

// A face comes in along one edge and leaves along another, by which the next comes in: that order
// of edges is right-handed, for faces are counter-clockwise from outside.
static void find_corner(sfi_shape *shape, uint32_t corner)
{
    corner_fan fan = find_fan(shape, corner);
    uint8_t across[3]; // the face between this edge and the one before
    uint32_t at = 0;
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t next = 0;
        while (fan.entering[next] != fan.leaving[at]) {
            next++;
        }
        shape->corner_ends[corner][i] = fan.leaving[at];
        across[i] = fan.face[at];
        at = next;
    }
    for (uint32_t i = 0; i < 3; i++) {
        uint32_t end = shape->corner_ends[corner][i], axis = i;
        if (shape->corners == 8) {
            uint32_t step = sfi_hex_bits(end) ^ sfi_hex_bits(corner); // 1, 2 or 4
            axis = step / 2;
        }
        shape->axis_edges[corner][axis] = edge_between(shape, corner, end);
        shape->axis_faces[corner][axis] = across[(i + 2) % 3];
    }
    shape->flips[corner] = (uint8_t)(shape->corners == 8 ? sfi_hex_bits(corner) : 0);
}

const sfi_shape *sfi_shapes_get(sfi_shapes *shapes, uint32_t corners)
{
    sfi_shape *shape = &shapes->at[corners / 2 - 2];
    if (shape->corners == corners) {
        return shape;
    }
    shape->corners = corners;
    if (corners == 4) {
        add_tetrahedron(shape);
    } else {
        add_prism(shape, corners / 2);
    }
    find_edges(shape);
    for (uint32_t corner = 0; corner < corners; corner++) {
        find_corner(shape, corner);
    }
    return shape;
}
