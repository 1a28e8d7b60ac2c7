// SPDX-License-Identifier: MIT
// A complex from the corners of its cells.
//
// Edges are told apart by their two points, faces by their loops of points: in hash tables with
// open addressing, whose entries are numbered in the order in which they are first met, so that the
// numbers depend on nothing but the cells. The second cell of a face must go around it the other
// way, or one of the two is inside out.

#include "grade/cage/complex.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

// Numbers of things, placed by a hash of what they are. Slots hold SFI_NONE or a number.
typedef struct table {
    uint32_t *slots;
    size_t size; // a power of two, at least twice what it will hold
} table;

static int table_alloc(const sf_allocator *allocator, size_t most, table *t)
{
    size_t size = 16;
    while (size < 2 * most) {
        size *= 2;
    }
    t->size = size;
    t->slots = sfi_alloc_array(allocator, size, sizeof *t->slots);
    if (t->slots == NULL) {
        return 0;
    }
    memset(t->slots, 0xff, size * sizeof *t->slots);
    return 1;
}

static size_t hash(uint32_t a, uint32_t b)
{
    uint64_t x = ((uint64_t)a << 32 | b) * 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 29) * 0xbf58476d1ce4e5b9u;
    return (size_t)(x ^ x >> 32);
}

// What is being built. Edges and faces lie in arrays for as many as there may be at the most.
typedef struct builder {
    const sf_allocator *allocator;
    const sfi_corners *corners;
    sfi_shapes *shapes;
    sf_fault *fault;
    table edge_table, face_table;
    uint32_t edges, faces;
    size_t edge_most, face_most, loop_most; // edges, faces and their corners, counted once a cell
    uint32_t *edge_points;                  // two each
    uint32_t *loops, *loop_edges;           // around each face, and its edges
    uint32_t *loop_starts;
    uint32_t *face_cells;      // two each
    uint32_t *cell_edges;      // of each cell in turn
    uint32_t *cell_faces;      // of each cell in turn
    uint32_t edge_at, face_at; // how far the last two are filled
} builder;

static void free_builder(builder *b)
{
    sfi_free_array(b->allocator, b->shapes, 1, sizeof *b->shapes);
    sfi_free_array(b->allocator, b->edge_table.slots, b->edge_table.size, sizeof(uint32_t));
    sfi_free_array(b->allocator, b->face_table.slots, b->face_table.size, sizeof(uint32_t));
    sfi_free_array(b->allocator, b->edge_points, 2 * b->edge_most, sizeof(uint32_t));
    sfi_free_array(b->allocator, b->loops, b->loop_most, sizeof(uint32_t));
    sfi_free_array(b->allocator, b->loop_edges, b->loop_most, sizeof(uint32_t));
    sfi_free_array(b->allocator, b->loop_starts, b->face_most + 1, sizeof(uint32_t));
    sfi_free_array(b->allocator, b->face_cells, 2 * b->face_most, sizeof(uint32_t));
    sfi_free_array(b->allocator, b->cell_edges, b->edge_most, sizeof(uint32_t));
    sfi_free_array(b->allocator, b->cell_faces, b->face_most, sizeof(uint32_t));
}

static sf_status alloc_builder(builder *b)
{
    b->edge_points = sfi_alloc_array(b->allocator, 2 * b->edge_most, sizeof(uint32_t));
    b->loops = sfi_alloc_array(b->allocator, b->loop_most, sizeof(uint32_t));
    b->loop_edges = sfi_alloc_array(b->allocator, b->loop_most, sizeof(uint32_t));
    b->loop_starts = sfi_alloc_array(b->allocator, b->face_most + 1, sizeof(uint32_t));
    b->face_cells = sfi_alloc_array(b->allocator, 2 * b->face_most, sizeof(uint32_t));
    b->cell_edges = sfi_alloc_array(b->allocator, b->edge_most, sizeof(uint32_t));
    b->cell_faces = sfi_alloc_array(b->allocator, b->face_most, sizeof(uint32_t));
    if (b->edge_points == NULL || b->loops == NULL || b->loop_edges == NULL ||
        b->loop_starts == NULL || b->face_cells == NULL || b->cell_edges == NULL ||
        b->cell_faces == NULL || !table_alloc(b->allocator, b->edge_most, &b->edge_table) ||
        !table_alloc(b->allocator, b->face_most, &b->face_table)) {
        return SF_ERR_MEMORY;
    }
    b->loop_starts[0] = 0;
    return SF_OK;
}

// Check the cells by themselves, and count what there may be of everything.
static sf_status count_cells(builder *b)
{
    const sfi_corners *c = b->corners;
    for (uint32_t i = 0; i < c->cells; i++) {
        uint32_t count = c->starts[i + 1] - c->starts[i];
        const uint32_t *points = c->items + c->starts[i];
        int exists = c->dimension == 3 ? sfi_shape_exists(count)
                                       : count >= 3 && count <= SF_CAGE_POLYGON_MAX;
        if (!exists) {
            return sfi_fault_set(
                b->fault, SF_ERR_UNSUPPORTED, 0, 0, "cell %lu has %lu corners; served are %s",
                (unsigned long)i, (unsigned long)count,
                c->dimension == 3 ? "tetrahedra (4), wedges (6), hexahedra (8) and other prisms"
                                  : "faces of 3 to 32 corners");
        }
        for (uint32_t j = 1; j < count; j++) {
            for (uint32_t k = 0; k < j; k++) {
                if (points[j] == points[k]) {
                    return sfi_fault_set(b->fault, SF_ERR_ARGUMENT, 0, 0,
                                         "cell %lu has point %lu at two of its corners",
                                         (unsigned long)i, (unsigned long)points[j]);
                }
            }
        }
        const sfi_shape *shape = c->dimension == 3 ? sfi_shapes_get(b->shapes, count) : NULL;
        b->edge_most += shape != NULL ? shape->edges : count;
        b->face_most += shape != NULL ? shape->faces : 1;
        b->loop_most += shape != NULL ? shape->face_starts[shape->faces] : count;
    }
    return b->loop_most <= INT32_MAX ? SF_OK : SF_ERR_OVERFLOW;
}

static uint32_t find_edge(builder *b, uint32_t from, uint32_t to)
{
    uint32_t low = from < to ? from : to, high = from < to ? to : from;
    size_t at = hash(low, high) & (b->edge_table.size - 1);
    for (; b->edge_table.slots[at] != SFI_NONE; at = (at + 1) & (b->edge_table.size - 1)) {
        const uint32_t *ends = b->edge_points + 2 * (size_t)b->edge_table.slots[at];
        if (ends[0] == low && ends[1] == high) {
            return b->edge_table.slots[at];
        }
    }
    b->edge_points[2 * (size_t)b->edges] = low;
    b->edge_points[2 * (size_t)b->edges + 1] = high;
    b->edge_table.slots[at] = b->edges;
    return b->edges++;
}

// Whether a face has these points: 1 the same way round, -1 the other way, 0 not.
static int same_loop(const builder *b, uint32_t face, uint32_t count, const uint32_t *loop)
{
    const uint32_t *other = b->loops + b->loop_starts[face];
    uint32_t first = 0;
    if (b->loop_starts[face + 1] - b->loop_starts[face] != count) {
        return 0;
    }
    while (first < count && other[first] != loop[0]) {
        first++;
    }
    if (first == count) {
        return 0;
    }
    int same = 1, reverse = 1;
    for (uint32_t i = 1; i < count; i++) {
        same &= other[(first + i) % count] == loop[i];
        reverse &= other[(first + count - i) % count] == loop[i];
    }
    return same ? 1 : reverse ? -1 : 0;
}

// Of the points themselves, in any order: were it of their sum, or of the least of them, all faces
// around one point could share a slot.
static size_t hash_loop(uint32_t count, const uint32_t *loop)
{
    size_t sum = 0;
    for (uint32_t i = 0; i < count; i++) {
        sum += hash(loop[i], count);
    }
    return sum;
}

static uint32_t add_face(builder *b, uint32_t cell, uint32_t count, const uint32_t *loop)
{
    uint32_t start = b->loop_starts[b->faces];
    for (uint32_t i = 0; i < count; i++) {
        b->loops[start + i] = loop[i];
        b->loop_edges[start + i] = find_edge(b, loop[i], loop[(i + 1) % count]);
    }
    b->face_cells[2 * (size_t)b->faces] = cell;
    b->face_cells[2 * (size_t)b->faces + 1] = SFI_NONE;
    b->loop_starts[b->faces + 1] = start + count;
    return b->faces++;
}

static sf_status join_face(builder *b, uint32_t face, uint32_t cell, int direction)
{
    uint32_t *cells = b->face_cells + 2 * (size_t)face;
    if (cells[1] != SFI_NONE) {
        return sfi_fault_set(b->fault, SF_ERR_ARGUMENT, 0, 0,
                             "cells %lu, %lu and %lu share one face; at most two can",
                             (unsigned long)cells[0], (unsigned long)cells[1], (unsigned long)cell);
    }
    if (direction > 0) {
        return sfi_fault_set(b->fault, SF_ERR_ARGUMENT, 0, 0,
                             "cells %lu and %lu lie on the same side of the face they share; one "
                             "of them is inverted, or they are the same cell",
                             (unsigned long)cells[0], (unsigned long)cell);
    }
    cells[1] = cell;
    return SF_OK;
}

static sf_status find_face(builder *b, uint32_t cell, uint32_t count, const uint32_t *loop,
                           uint32_t *face)
{
    size_t at = hash_loop(count, loop) & (b->face_table.size - 1);
    for (; b->face_table.slots[at] != SFI_NONE; at = (at + 1) & (b->face_table.size - 1)) {
        *face = b->face_table.slots[at];
        int direction = same_loop(b, *face, count, loop);
        if (direction != 0) {
            return join_face(b, *face, cell, direction);
        }
    }
    *face = add_face(b, cell, count, loop);
    b->face_table.slots[at] = *face;
    return SF_OK;
}

static sf_status add_cell(builder *b, uint32_t cell)
{
    const uint32_t *points = b->corners->items + b->corners->starts[cell];
    uint32_t count = b->corners->starts[cell + 1] - b->corners->starts[cell];
    const sfi_shape *shape = sfi_shapes_get(b->shapes, count);
    for (uint32_t f = 0; f < shape->faces; f++) {
        uint32_t loop[SF_CAGE_POLYGON_MAX], start = shape->face_starts[f];
        uint32_t corners = shape->face_starts[f + 1] - start;
        for (uint32_t i = 0; i < corners; i++) {
            loop[i] = points[shape->face_corners[start + i]];
        }
        SF_TRY(find_face(b, cell, corners, loop, &b->cell_faces[b->face_at]));
        b->face_at++;
    }
    for (uint32_t e = 0; e < shape->edges; e++) {
        b->cell_edges[b->edge_at++] =
            find_edge(b, points[shape->edge_corners[e][0]], points[shape->edge_corners[e][1]]);
    }
    return SF_OK;
}

// Copy what was built into arrays of its size.
static sf_status finish(const builder *b, sfi_complex *complex)
{
    const sfi_corners *c = b->corners;
    sfi_complex made = {0};
    made.allocator = *b->allocator;
    made.dimension = c->dimension;
    made.points = c->points;
    made.edges = b->edges;
    made.faces = b->faces;
    made.cells = c->dimension == 3 ? c->cells : 0;
    size_t corners = c->dimension == 3 ? c->starts[c->cells] : 0;
    uint32_t loops = b->loop_starts[b->faces];
    SF_TRY(sfi_complex_alloc(&made, loops, corners, b->face_at, b->edge_at));
    memcpy(made.edge_points, b->edge_points, 2 * (size_t)b->edges * sizeof(uint32_t));
    memcpy(made.face_points.starts, b->loop_starts, ((size_t)b->faces + 1) * sizeof(uint32_t));
    memcpy(made.face_points.items, b->loops, loops * sizeof(uint32_t));
    memcpy(made.face_edges, b->loop_edges, loops * sizeof(uint32_t));
    memcpy(made.face_cells, b->face_cells, 2 * (size_t)b->faces * sizeof(uint32_t));
    memcpy(made.cell_points.items, c->items, corners * sizeof(uint32_t));
    memcpy(made.cell_faces.items, b->cell_faces, b->face_at * sizeof(uint32_t));
    memcpy(made.cell_edges.items, b->cell_edges, b->edge_at * sizeof(uint32_t));
    made.cell_points.starts[0] = made.cell_faces.starts[0] = made.cell_edges.starts[0] = 0;
    for (uint32_t i = 0; i < made.cells; i++) {
        const sfi_shape *shape = sfi_shapes_get(made.shapes, c->starts[i + 1] - c->starts[i]);
        made.cell_points.starts[i + 1] = made.cell_points.starts[i] + shape->corners;
        made.cell_faces.starts[i + 1] = made.cell_faces.starts[i] + shape->faces;
        made.cell_edges.starts[i + 1] = made.cell_edges.starts[i] + shape->edges;
    }
    *complex = made;
    return SF_OK;
}

// In dimension 2 an edge stands for what a face is in dimension 3: two at most may share it, and go
// along it in opposite directions.
static sf_status check_edges(builder *b)
{
    // The table is done with: its slots become those of the faces along an edge, upwards and down.
    memset(b->edge_table.slots, 0xff, b->edge_table.size * sizeof(uint32_t));
    for (uint32_t f = 0; f < b->faces; f++) {
        for (uint32_t i = b->loop_starts[f]; i < b->loop_starts[f + 1]; i++) {
            uint32_t edge = b->loop_edges[i];
            int down = b->loops[i] != b->edge_points[2 * (size_t)edge];
            uint32_t *user = &b->edge_table.slots[2 * (size_t)edge + (size_t)down];
            if (*user != SFI_NONE) {
                return sfi_fault_set(b->fault, SF_ERR_ARGUMENT, 0, 0,
                                     "faces %lu and %lu go along the edge of points %lu and %lu in "
                                     "the same direction; an edge has two faces at most, which go "
                                     "opposite ways",
                                     (unsigned long)*user, (unsigned long)f,
                                     (unsigned long)b->edge_points[2 * (size_t)edge],
                                     (unsigned long)b->edge_points[2 * (size_t)edge + 1]);
            }
            *user = f;
        }
    }
    return SF_OK;
}

static sf_status build(builder *b, sfi_complex *complex)
{
    const sfi_corners *c = b->corners;
    SF_TRY(count_cells(b));
    SF_TRY(alloc_builder(b));
    for (uint32_t i = 0; i < c->cells; i++) {
        if (c->dimension == 3) {
            SF_TRY(add_cell(b, i));
        } else {
            add_face(b, SFI_NONE, c->starts[i + 1] - c->starts[i], c->items + c->starts[i]);
        }
    }
    if (c->dimension == 2) {
        SF_TRY(check_edges(b));
    }
    return finish(b, complex);
}

sf_status sfi_complex_build(const sfi_corners *corners, const sf_allocator *allocator,
                            sfi_complex *complex, sf_fault *fault)
{
    builder b = {0};
    b.allocator = allocator;
    b.corners = corners;
    b.fault = fault;
    b.shapes = sfi_alloc_array(allocator, 1, sizeof *b.shapes);
    sf_status status = SF_ERR_MEMORY;
    if (b.shapes != NULL) {
        memset(b.shapes, 0, sizeof *b.shapes);
        status = build(&b, complex);
    }
    free_builder(&b);
    if (status == SF_OK) {
        sfi_complex_find_outside(complex);
    }
    return status;
}
