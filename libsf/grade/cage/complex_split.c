// SPDX-License-Identifier: MIT
// A complex cut once: one piece of each cell for each of its corners.
//
// Nothing is searched for. The numbers of a piece's edges and faces follow from those of what they
// are pieces of, in this order:
//
//   points  points; edges (their middles); faces (their middles); cells (theirs)
//   edges   two halves of each edge, at its first point, then its second;
//           from each face's middle to each of its edges, in the order of the face;
//           from each cell's middle to each of its faces, in the order of the cell
//   faces   one of each face at each of its points, the same way round as the face;
//           one in each cell at each of its edges, between two pieces
//   cells   one in each cell at each of its corners
//
// In dimension 2 there is nothing of cells, and the faces are what is cut.

#include "grade/cage/complex.h"

#include "base/memory.h"
#include "base/status.h"

// Where each kind begins among the child's points, edges and faces.
typedef struct offsets {
    uint32_t edge_point, face_point, cell_point;
    uint32_t face_edge, cell_edge;
    uint32_t cell_face;
} offsets;

static offsets offsets_of(const sfi_complex *parent)
{
    uint32_t loops = parent->face_points.starts[parent->faces];
    offsets o = {parent->points,
                 parent->points + parent->edges,
                 parent->points + parent->edges + parent->faces,
                 2 * parent->edges,
                 2 * parent->edges + loops,
                 loops};
    return o;
}

// The place of `item` in a list that holds it.
static uint32_t place_of(const uint32_t *list, uint32_t item)
{
    uint32_t at = 0;
    while (list[at] != item) {
        at++;
    }
    return at;
}

static uint32_t half_edge(const sfi_complex *parent, uint32_t edge, uint32_t point)
{
    return 2 * edge + (parent->edge_points[2 * (size_t)edge] != point);
}

// The edge from a face's middle to that of one of its edges.
static uint32_t spoke(const sfi_complex *parent, const offsets *o, uint32_t face, uint32_t edge)
{
    uint32_t start = parent->face_points.starts[face];
    return o->face_edge + start + place_of(parent->face_edges + start, edge);
}

static void set_edge(sfi_complex *child, uint32_t edge, uint32_t a, uint32_t b)
{
    child->edge_points[2 * (size_t)edge] = a;
    child->edge_points[2 * (size_t)edge + 1] = b;
}

static void split_edges(const sfi_complex *parent, const offsets *o, sfi_complex *child)
{
    for (uint32_t e = 0; e < parent->edges; e++) {
        for (uint32_t half = 0; half < 2; half++) {
            uint32_t piece = 2 * e + half;
            set_edge(child, piece, parent->edge_points[piece], o->edge_point + e);
            child->edge_outside[piece] = parent->edge_outside[e];
            child->edge_sharpness[piece] = sfi_less_sharp(parent->edge_sharpness[e]);
        }
        child->point_outside[o->edge_point + e] = parent->edge_outside[e];
    }
    for (uint32_t v = 0; v < parent->points; v++) {
        child->point_outside[v] = parent->point_outside[v];
        child->point_sharpness[v] = sfi_less_sharp(parent->point_sharpness[v]);
    }
}

static void set_face(sfi_complex *child, uint32_t face, const uint32_t points[4],
                     const uint32_t edges[4])
{
    uint32_t start = 4 * face;
    child->face_points.starts[face] = start;
    for (uint32_t i = 0; i < 4; i++) {
        child->face_points.items[start + i] = points[i];
        child->face_edges[start + i] = edges[i];
    }
}

// The piece of a face at one of its corners, in the face's list. The piece of a quadrilateral has
// that corner where the quadrilateral has it, so that their axes are the same.
static void face_piece(const sfi_complex *parent, const offsets *o, uint32_t f, uint32_t corner,
                       uint32_t points[4], uint32_t edges[4])
{
    uint32_t start = parent->face_points.starts[f], end = parent->face_points.starts[f + 1];
    uint32_t before = corner > start ? corner - 1 : end - 1;
    uint32_t point = parent->face_points.items[corner];
    uint32_t next = parent->face_edges[corner], last = parent->face_edges[before];
    uint32_t around[4] = {point, o->edge_point + next, o->face_point + f, o->edge_point + last};
    uint32_t along[4] = {half_edge(parent, next, point), o->face_edge + corner,
                         o->face_edge + before, half_edge(parent, last, point)};
    uint32_t turn = end - start == 4 ? corner - start : 0;
    for (uint32_t i = 0; i < 4; i++) {
        points[(i + turn) % 4] = around[i];
        edges[(i + turn) % 4] = along[i];
    }
}

static void split_face(const sfi_complex *parent, const offsets *o, uint32_t f, sfi_complex *child)
{
    uint32_t start = parent->face_points.starts[f], end = parent->face_points.starts[f + 1];
    int outside = parent->dimension == 3 && parent->face_cells[2 * (size_t)f + 1] == SFI_NONE;
    for (uint32_t i = start; i < end; i++) {
        uint32_t points[4], edges[4];
        face_piece(parent, o, f, i, points, edges);
        set_face(child, i, points, edges);
        set_edge(child, o->face_edge + i, o->face_point + f, o->edge_point + parent->face_edges[i]);
        child->edge_outside[o->face_edge + i] = (uint8_t)outside;
    }
    child->point_outside[o->face_point + f] = (uint8_t)outside;
}

// Faces and edges that lie within a cell.
static void split_inside(const sfi_complex *parent, const offsets *o, uint32_t cell,
                         const sfi_shape *shape, sfi_complex *child)
{
    const uint32_t *faces = parent->cell_faces.items + parent->cell_faces.starts[cell];
    const uint32_t *edges = parent->cell_edges.items + parent->cell_edges.starts[cell];
    uint32_t middle = o->cell_point + cell;
    uint32_t to_faces = o->cell_edge + parent->cell_faces.starts[cell];
    for (uint32_t i = 0; i < shape->faces; i++) {
        set_edge(child, to_faces + i, middle, o->face_point + faces[i]);
    }
    for (uint32_t i = 0; i < shape->edges; i++) {
        uint32_t a = shape->edge_faces[i][0], b = shape->edge_faces[i][1];
        uint32_t points[4] = {o->edge_point + edges[i], o->face_point + faces[a], middle,
                              o->face_point + faces[b]};
        uint32_t around[4] = {spoke(parent, o, faces[a], edges[i]), to_faces + a, to_faces + b,
                              spoke(parent, o, faces[b], edges[i])};
        set_face(child, o->cell_face + parent->cell_edges.starts[cell] + i, points, around);
    }
}

// One corner of a cell: along which edges and faces of the cell, by axis, its piece lies.
typedef struct piece {
    const sfi_complex *parent;
    const offsets *o;
    uint32_t cell, point, flip;
    uint32_t edges[3], faces[3];             // in the complex
    uint32_t local_edges[3], local_faces[3]; // in the cell
} piece;

static piece piece_at(const sfi_complex *parent, const offsets *o, uint32_t cell,
                      const sfi_shape *shape, uint32_t corner)
{
    piece p = {parent, o, cell, 0, shape->flips[corner], {0}, {0}, {0}, {0}};
    p.point = parent->cell_points.items[parent->cell_points.starts[cell] + corner];
    for (uint32_t axis = 0; axis < 3; axis++) {
        p.local_edges[axis] = shape->axis_edges[corner][axis];
        p.local_faces[axis] = shape->axis_faces[corner][axis];
        p.edges[axis] =
            parent->cell_edges.items[parent->cell_edges.starts[cell] + p.local_edges[axis]];
        p.faces[axis] =
            parent->cell_faces.items[parent->cell_faces.starts[cell] + p.local_faces[axis]];
    }
    return p;
}

// The axis that a set of axes of one or of two has, or lacks.
static uint32_t axis_of(uint32_t bits)
{
    return bits == 1 || bits == 6 ? 0 : bits == 2 || bits == 5 ? 1 : 2;
}

// The point of a piece that lies away from the cell's corner along the axes in `away`.
static uint32_t piece_point(const piece *p, uint32_t away)
{
    switch (away) {
    case 0:
        return p->point;
    case 1:
    case 2:
    case 4:
        return p->o->edge_point + p->edges[axis_of(away)];
    case 7:
        return p->o->cell_point + p->cell;
    default:
        return p->o->face_point + p->faces[axis_of(away)];
    }
}

// Its edge along `axis` that lies away from the corner along the axes in `away`, `axis` not among
// them.
static uint32_t piece_edge(const piece *p, uint32_t axis, uint32_t away)
{
    uint32_t both = away | 1u << axis;
    if (away == 0) {
        return half_edge(p->parent, p->edges[axis], p->point);
    }
    if (both != 7) {
        return spoke(p->parent, p->o, p->faces[axis_of(both)], p->edges[axis_of(away)]);
    }
    return p->o->cell_edge + p->parent->cell_faces.starts[p->cell] + p->local_faces[axis_of(away)];
}

// Its face across `axis`: at the corner, or away from it.
static uint32_t piece_face(const piece *p, uint32_t axis, int away)
{
    if (away) {
        return p->o->cell_face + p->parent->cell_edges.starts[p->cell] + p->local_edges[axis];
    }
    uint32_t start = p->parent->face_points.starts[p->faces[axis]];
    return start + place_of(p->parent->face_points.items + start, p->point);
}

// A hexahedron's edge or face, by the places of its corners: the axes along which they differ, and
// where they lie together.
typedef struct span {
    uint32_t along, at;
} span;

static span span_of(const uint8_t *corners, uint32_t count)
{
    uint32_t all = 7, any = 0;
    for (uint32_t i = 0; i < count; i++) {
        all &= sfi_hex_bits(corners[i]);
        any |= sfi_hex_bits(corners[i]);
    }
    span found = {all ^ any, all};
    return found;
}

static void add_cell_to_face(sfi_complex *child, uint32_t face, uint32_t cell)
{
    uint32_t *cells = child->face_cells + 2 * (size_t)face;
    cells[cells[0] != SFI_NONE] = cell;
}

static void set_piece(const piece *p, const sfi_shape *cube, uint32_t number, sfi_complex *child)
{
    size_t n = number;
    child->cell_points.starts[n] = 8 * number;
    child->cell_faces.starts[n] = 6 * number;
    child->cell_edges.starts[n] = 12 * number;
    for (uint32_t i = 0; i < 8; i++) {
        child->cell_points.items[8 * n + i] = piece_point(p, sfi_hex_bits(i) ^ p->flip);
    }
    for (uint32_t i = 0; i < 12; i++) {
        span s = span_of(cube->edge_corners[i], 2);
        child->cell_edges.items[12 * n + i] =
            piece_edge(p, axis_of(s.along), (s.at ^ p->flip) & ~s.along);
    }
    for (uint32_t i = 0; i < 6; i++) {
        span s = span_of(cube->face_corners + cube->face_starts[i], 4);
        uint32_t axis = axis_of(s.along); // the one that it lacks
        uint32_t face = piece_face(p, axis, ((s.at ^ p->flip) >> axis & 1) != 0);
        child->cell_faces.items[6 * n + i] = face;
        add_cell_to_face(child, face, number);
    }
}

static void split_cell(const sfi_complex *parent, const offsets *o, uint32_t cell,
                       sfi_complex *child)
{
    uint32_t start = parent->cell_points.starts[cell];
    uint32_t corners = parent->cell_points.starts[cell + 1] - start;
    const sfi_shape *shape = sfi_shapes_get(parent->shapes, corners);
    const sfi_shape *cube = sfi_shapes_get(child->shapes, 8);
    split_inside(parent, o, cell, shape, child);
    for (uint32_t corner = 0; corner < corners; corner++) {
        piece p = piece_at(parent, o, cell, shape, corner);
        set_piece(&p, cube, start + corner, child);
    }
}

uint32_t sfi_complex_split_points(const sfi_complex *parent)
{
    uint64_t points = (uint64_t)parent->points + parent->edges + parent->faces + parent->cells;
    return points <= INT32_MAX ? (uint32_t)points : 0;
}

void sfi_complex_split_cells(const sfi_complex *parent, uint32_t *corners)
{
    offsets o = offsets_of(parent);
    for (uint32_t c = 0; c < parent->cells; c++) {
        uint32_t start = parent->cell_points.starts[c];
        uint32_t count = parent->cell_points.starts[c + 1] - start;
        const sfi_shape *shape = sfi_shapes_get(parent->shapes, count);
        for (uint32_t corner = 0; corner < count; corner++) {
            piece p = piece_at(parent, &o, c, shape, corner);
            for (uint32_t i = 0; i < 8; i++) {
                corners[8 * ((size_t)start + corner) + i] =
                    piece_point(&p, sfi_hex_bits(i) ^ p.flip);
            }
        }
    }
    for (uint32_t f = 0; parent->dimension == 2 && f < parent->faces; f++) {
        uint32_t start = parent->face_points.starts[f], end = parent->face_points.starts[f + 1];
        for (uint32_t i = start; i < end; i++) {
            uint32_t edges[4];
            face_piece(parent, &o, f, i, corners + 4 * (size_t)i, edges);
        }
    }
}

sf_status sfi_complex_split(const sfi_complex *parent, const sf_allocator *allocator,
                            sfi_complex *child)
{
    size_t loops = parent->face_points.starts[parent->faces];
    size_t corners = parent->cells == 0 ? 0 : parent->cell_points.starts[parent->cells];
    size_t cell_faces = parent->cells == 0 ? 0 : parent->cell_faces.starts[parent->cells];
    size_t cell_edges = parent->cells == 0 ? 0 : parent->cell_edges.starts[parent->cells];
    size_t edges = 2 * (size_t)parent->edges + loops + cell_faces, faces = loops + cell_edges;
    if (12 * corners > INT32_MAX || 4 * faces > INT32_MAX || edges > INT32_MAX ||
        sfi_complex_split_points(parent) == 0) {
        return SF_ERR_OVERFLOW;
    }
    sfi_complex made = {0};
    made.allocator = *allocator;
    made.dimension = parent->dimension;
    made.points = sfi_complex_split_points(parent);
    made.edges = (uint32_t)edges;
    made.faces = (uint32_t)faces;
    made.cells = (uint32_t)corners;
    SF_TRY(sfi_complex_alloc(&made, 4 * faces, 8 * corners, 6 * corners, 12 * corners));
    offsets o = offsets_of(parent);
    split_edges(parent, &o, &made);
    for (uint32_t f = 0; f < parent->faces; f++) {
        split_face(parent, &o, f, &made);
    }
    for (uint32_t c = 0; c < parent->cells; c++) {
        split_cell(parent, &o, c, &made);
    }
    *child = made;
    return SF_OK;
}
