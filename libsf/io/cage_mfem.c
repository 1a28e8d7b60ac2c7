// SPDX-License-Identifier: MIT
// MFEM meshes in: conforming ones, version 1.x, in text.
//
// Elements come before the points that they name. Points are vertices with coordinates, or a count
// of vertices and a finite element function, the nodes, whose first degrees of freedom are the
// values at the vertices as long as it is continuous (H1 of any order). Only those are taken: a
// cage is made smooth by subdivision, and what curves the mesh between its vertices is not asked
// for. Nodes that come x first, then y, then z, are read where they are of order 1: of a higher
// order, nothing in the file says where y begins, and a file that is cut short would be read as
// another shape.
//
// Meshes with hanging nodes (MFEM NC mesh, or a section vertex_parents) are refused: where a face
// meets half of another one, the two have no common limit surface.
//
// Source: the MFEM project, "MFEM mesh formats".

#include "io/cage_raw.h"

#include "base/status.h"
#include "io/number.h"

#include <string.h>

#define HANGING                                                                                    \
    "the mesh is not conforming: it has hanging nodes, faces that meet a part of another face, "   \
    "and those have no common limit; refine it evenly and write it as an MFEM mesh v1.0"

typedef struct geometry {
    uint32_t dimension, corners;
} geometry;

// By their numbers. MFEM and VTK order the corners of all of these alike.
static const geometry geometries[] = {
    {0, 1}, {1, 2}, {2, 3}, {2, 4}, {3, 4}, {3, 8}, {3, 6}, {3, 0},
};

static sf_status expect(sfi_raw *raw, const char *token, const char *word)
{
    return strcmp(token, word) == 0 ? SF_OK
                                    : sfi_cursor_fault_token(raw->cursor, raw->fault, word, token);
}

static sf_status expect_next(sfi_raw *raw, const char *word)
{
    char token[SFI_TOKEN_SIZE];
    sfi_raw_word(raw, token);
    return expect(raw, token, word);
}

// "MFEM mesh v1.x", the first line.
static sf_status read_title(sfi_raw *raw)
{
    char token[SFI_TOKEN_SIZE];
    SF_TRY(expect_next(raw, "MFEM"));
    sfi_raw_word(raw, token);
    if (strcmp(token, "NC") == 0) {
        return sfi_raw_unsupported(raw, HANGING);
    }
    if (strcmp(token, "mesh") != 0) {
        return sfi_raw_unsupported(raw, "this is a kind of MFEM file that is not read; write it as "
                                        "an MFEM mesh v1.0");
    }
    sfi_raw_word(raw, token);
    if (strncmp(token, "v1.", 3) != 0) {
        return sfi_raw_unsupported(raw, "this version of MFEM meshes is not read; write the mesh "
                                        "as an MFEM mesh v1.0");
    }
    return SF_OK;
}

// The rest of a row of elements: shape and corners. Those of a boundary are read and dropped.
static sf_status read_shape(sfi_raw *raw, double attribute, int keep)
{
    uint32_t kind, point;
    SF_TRY(sfi_raw_whole(raw, "the number of a shape, 0 to 7", 7, &kind));
    const geometry *shape = &geometries[kind];
    if (shape->corners == 0) {
        return sfi_raw_unsupported(raw,
                                   "the mesh has pyramids; four faces meet in the top of one, and "
                                   "no cell of a cage has such a corner");
    }
    if (keep) {
        SF_TRY(sfi_raw_cell_begin(raw, shape->dimension < 2 ? 1 : shape->dimension));
        sfi_raw_last_cell(raw)->reference = attribute;
    }
    for (uint32_t i = 0; i < shape->corners; i++) {
        SF_TRY(sfi_raw_whole(raw, "the number of a vertex", UINT32_MAX - 1, &point));
        if (keep) {
            SF_TRY(sfi_raw_corner(raw, point));
        }
    }
    return SF_OK;
}

static sf_status read_elements(sfi_raw *raw, int keep)
{
    uint32_t count;
    double attribute;
    SF_TRY(sfi_raw_whole(raw, "the number of elements", UINT32_MAX, &count));
    for (uint32_t i = 0; i < count; i++) {
        SF_TRY(sfi_raw_number(raw, "the attribute of an element", &attribute));
        SF_TRY(read_shape(raw, attribute, keep));
    }
    return SF_OK;
}

// Named sets of attributes: so many lines with a name in quotation marks.
static sf_status pass_over_sets(sfi_raw *raw)
{
    uint32_t count;
    char token[SFI_TOKEN_SIZE];
    SF_TRY(sfi_raw_whole(raw, "the number of attribute sets", UINT32_MAX, &count));
    for (uint32_t i = 0; i < count; i++) {
        if (sfi_raw_word(raw, token) == 0) {
            return sfi_cursor_fault_token(raw->cursor, raw->fault, "a set of attributes", token);
        }
        sfi_cursor_skip_line(raw->cursor);
    }
    return SF_OK;
}

// What may stand between the elements and the vertices. Leaves the first word behind it.
static sf_status read_between(sfi_raw *raw, char token[SFI_TOKEN_SIZE])
{
    for (;;) {
        sfi_raw_word(raw, token);
        if (strcmp(token, "boundary") == 0) {
            SF_TRY(read_elements(raw, 0));
        } else if (strcmp(token, "attribute_sets") == 0 ||
                   strcmp(token, "bdr_attribute_sets") == 0) {
            SF_TRY(pass_over_sets(raw));
        } else if (strcmp(token, "vertex_parents") == 0 || strcmp(token, "coarse_elements") == 0) {
            return sfi_raw_unsupported(raw, HANGING);
        } else {
            return expect(raw, token, "vertices");
        }
    }
}

static sf_status read_coordinates(sfi_raw *raw, uint32_t vertices, uint32_t dimension,
                                  const char *first)
{
    int64_t space;
    if (!sfi_integer_parse(first, &space) || space < dimension || space > 3) {
        return sfi_cursor_fault_token(raw->cursor, raw->fault,
                                      "the number of coordinates, or the word nodes", first);
    }
    for (uint32_t i = 0; i < vertices; i++) {
        double xyz[3] = {0, 0, 0};
        for (int64_t axis = 0; axis < space; axis++) {
            SF_TRY(sfi_raw_number(raw, "a coordinate", &xyz[axis]));
        }
        SF_TRY(sfi_raw_point(raw, xyz));
    }
    return SF_OK;
}

// --- nodes ---------------------------------------------------------------------------------------

typedef struct nodes {
    int is_linear; // as many values as vertices
    uint32_t dimension, by_point;
} nodes;

static int ends_in_order_one(const char *name)
{
    const char *order = strrchr(name, '_');
    return strcmp(name, "Linear") == 0 || (order != NULL && strcmp(order, "_P1") == 0);
}

static sf_status read_collection(sfi_raw *raw, nodes *n)
{
    char token[SFI_TOKEN_SIZE];
    static const char *const continuous[] = {"H1_",    "H1@",       "H1Pos_",
                                             "Linear", "Quadratic", "Cubic"};
    SF_TRY(expect_next(raw, "FiniteElementSpace"));
    SF_TRY(expect_next(raw, "FiniteElementCollection:"));
    if (sfi_raw_word(raw, token) == 0) {
        return sfi_cursor_fault_token(raw->cursor, raw->fault, "a collection", token);
    }
    n->is_linear = ends_in_order_one(token);
    for (size_t i = 0; i < sizeof continuous / sizeof continuous[0]; i++) {
        if (strncmp(token, continuous[i], strlen(continuous[i])) == 0) {
            return SF_OK;
        }
    }
    return sfi_raw_unsupported(raw, "the nodes belong to cells, not to vertices that cells share; "
                                    "write the mesh with nodes of a collection H1, or without");
}

static sf_status read_layout(sfi_raw *raw, uint32_t dimension, nodes *n)
{
    SF_TRY(expect_next(raw, "VDim:"));
    SF_TRY(sfi_raw_whole(raw, "the number of coordinates, 2 or 3", 3, &n->dimension));
    if (n->dimension < dimension) {
        return sfi_cursor_fault(raw->cursor, raw->fault,
                                "the nodes have fewer coordinates than the mesh has dimensions");
    }
    SF_TRY(expect_next(raw, "Ordering:"));
    SF_TRY(sfi_raw_whole(raw, "an ordering, 0 or 1", 1, &n->by_point));
    if (!n->by_point && !n->is_linear) {
        return sfi_raw_unsupported(raw, "the nodes are of an order above 1 and come x first, then "
                                        "y, then z; write them with Ordering: 1");
    }
    return SF_OK;
}

// All numbers up to the end. How many there must be is known for order 1 only.
static sf_status read_values(sfi_raw *raw, sfi_list *values)
{
    char token[SFI_TOKEN_SIZE];
    double value;
    while (sfi_raw_word(raw, token) > 0 && strcmp(token, "mfem_mesh_end") != 0) {
        if (!sfi_number_parse(token, &value)) {
            return sfi_cursor_fault_token(raw->cursor, raw->fault, "a coordinate", token);
        }
        SF_TRY(sfi_raw_push(raw, values, &value));
    }
    return SF_OK;
}

static sf_status take_values(sfi_raw *raw, const nodes *n, uint32_t vertices,
                             const sfi_list *values)
{
    uint64_t needed = (uint64_t)vertices * n->dimension;
    const double *value = values->items;
    if (values->count < needed || values->count % n->dimension != 0 ||
        (n->is_linear && values->count != needed)) {
        return sfi_cursor_fault(raw->cursor, raw->fault,
                                "the nodes are not as many as the vertices ask for; the file is "
                                "cut short");
    }
    for (size_t i = 0; i < vertices; i++) {
        double xyz[3] = {0, 0, 0};
        for (size_t axis = 0; axis < n->dimension; axis++) {
            xyz[axis] = n->by_point ? value[n->dimension * i + axis] : value[vertices * axis + i];
        }
        SF_TRY(sfi_raw_point(raw, xyz));
    }
    return SF_OK;
}

static sf_status read_nodes(sfi_raw *raw, uint32_t vertices, uint32_t dimension)
{
    nodes n = {0, 0, 0};
    sfi_list values = sfi_list_of(sizeof(double));
    SF_TRY(read_collection(raw, &n));
    SF_TRY(read_layout(raw, dimension, &n));
    sf_status status = read_values(raw, &values);
    if (status == SF_OK) {
        status = take_values(raw, &n, vertices, &values);
    }
    sfi_list_free(&raw->cursor->allocator, &values);
    return status;
}

// -------------------------------------------------------------------------------------------------

sf_status sfi_mfem_read(sfi_raw *raw)
{
    char token[SFI_TOKEN_SIZE];
    uint32_t dimension, vertices;
    raw->reference_name = "attribute";
    SF_TRY(read_title(raw));
    SF_TRY(expect_next(raw, "dimension"));
    SF_TRY(sfi_raw_whole(raw, "a dimension, 1 to 3", 3, &dimension));
    SF_TRY(expect_next(raw, "elements"));
    SF_TRY(read_elements(raw, 1));
    SF_TRY(read_between(raw, token));
    SF_TRY(sfi_raw_whole(raw, "the number of vertices", UINT32_MAX, &vertices));
    sfi_raw_word(raw, token);
    return strcmp(token, "nodes") == 0 ? read_nodes(raw, vertices, dimension)
                                       : read_coordinates(raw, vertices, dimension, token);
}
