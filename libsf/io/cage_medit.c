// SPDX-License-Identifier: MIT
// Medit meshes in: sections, each a word, a count and so many rows of numbers, in text.
//
// Points are counted from 1. The last number of a row is a reference: the material of a cell, the
// patch of a face. Corners and Ridges say what is sharp, a ridge by the number of an edge of the
// section Edges; in which order these sections stand is free, so edges are kept until the end.
// Sections that say nothing of a cage (normals, tangents, what a remesher must keep) are known by
// name and passed over; a word that is in no list is refused, because a section of cells with a
// name that was mistyped would be missed without a word.
//
// Source: P. Frey, "MEDIT: An interactive mesh visualization software", INRIA technical report 253,
// 2001; the key words of libMeshb, L. Marechal, 2018.

#include "io/cage_raw.h"

#include "base/status.h"
#include "io/number.h"

#include <string.h>

typedef struct element {
    const char *word;
    uint32_t dimension, corners; // 0 corners: what cannot be a cell of a cage
} element;

static const element elements[] = {
    {"Triangles", 2, 3}, {"Quadrilaterals", 2, 4}, {"Tetrahedra", 3, 4},
    {"Prisms", 3, 6},    {"Wedges", 3, 6},         {"Pentahedra", 3, 6},
    {"Hexahedra", 3, 8}, {"Hexaedra", 3, 8},       {"Pyramids", 3, 0},
};

// Passed over, whatever numbers and names in quotation marks follow.
static const char *const passed[] = {
    "RequiredVertices",
    "RequiredEdges",
    "RequiredTriangles",
    "RequiredQuadrilaterals",
    "Normals",
    "NormalAtVertices",
    "NormalAtTriangleVertices",
    "NormalAtQuadrilateralVertices",
    "Tangents",
    "TangentAtVertices",
    "TangentAtEdges",
    "TangentAtEdgeVertices",
    "AngleOfCornerBound",
    "BoundingBox",
    "Geometry",
    "Identifier",
    "SubDomain",
    "SubDomainFromMesh",
    "SubDomainFromGeom",
    "VertexOnGeometricVertex",
    "VertexOnGeometricEdge",
    "VertexOnGeometricTriangle",
    "VertexOnGeometricQuadrilateral",
    "EdgeOnGeometricEdge",
    "VertexOnSupportVertex",
    "VertexOnSupportEdge",
    "VertexOnSupportTriangle",
    "EquivalencedEdges",
    "ParallelVertices",
    "PeriodicVertices",
    "IsolatedVertices",
    "Time",
    "Iterations",
    "Ridge",
    "PrivateTable",
    "DomainPrivateTable",
};

typedef struct ridge {
    uint32_t edge, line;
} ridge;

typedef struct medit {
    sfi_raw *raw;
    uint32_t dimension; // of space; 0: not yet said
    int has_vertices;
    sfi_list edges;  // uint32_t[2]
    sfi_list ridges; // ridge
} medit;

// A number of something that the file counts from 1, as counted from 0.
static sf_status read_index(medit *m, const char *expected, uint32_t *index)
{
    SF_TRY(sfi_raw_whole(m->raw, expected, UINT32_MAX - 1, index));
    if (*index == 0) {
        return sfi_cursor_fault_token(m->raw->cursor, m->raw->fault,
                                      "a number counted from 1, as Medit does", "0");
    }
    *index -= 1;
    return SF_OK;
}

static sf_status read_count(medit *m, uint32_t *count)
{
    return sfi_raw_whole(m->raw, "the number of rows of a section", UINT32_MAX, count);
}

// The number behind Dimension, which may stand on the next line.
static sf_status read_dimension(medit *m)
{
    SF_TRY(sfi_raw_whole(m->raw, "a dimension, 2 or 3", 3, &m->dimension));
    if (m->dimension < 2) {
        return sfi_cursor_fault_token(m->raw->cursor, m->raw->fault, "a dimension, 2 or 3", "less");
    }
    return SF_OK;
}

static sf_status read_vertices(medit *m)
{
    uint32_t count;
    if (m->dimension == 0 || m->has_vertices) {
        return sfi_cursor_fault(m->raw->cursor, m->raw->fault,
                                "Vertices stand before Dimension, or twice; correct the file");
    }
    m->has_vertices = 1;
    SF_TRY(read_count(m, &count));
    for (uint32_t i = 0; i < count; i++) {
        double xyz[3] = {0, 0, 0}, reference;
        for (uint32_t axis = 0; axis < m->dimension; axis++) {
            SF_TRY(sfi_raw_number(m->raw, "a coordinate", &xyz[axis]));
        }
        SF_TRY(sfi_raw_point(m->raw, xyz));
        SF_TRY(sfi_raw_number(m->raw, "the reference of a vertex", &reference));
    }
    return SF_OK;
}

static sf_status read_elements(medit *m, const element *kind)
{
    uint32_t count, point;
    SF_TRY(read_count(m, &count));
    if (kind->corners == 0 && count > 0) {
        return sfi_raw_unsupported(m->raw,
                                   "the file has pyramids; four faces meet in the top of one, and "
                                   "no cell of a cage has such a corner");
    }
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t j = 0; j < kind->corners; j++) {
            SF_TRY(read_index(m, "the number of a vertex", &point));
            if (j == 0) {
                SF_TRY(sfi_raw_cell_begin(m->raw, kind->dimension));
            }
            SF_TRY(sfi_raw_corner(m->raw, point));
        }
        SF_TRY(sfi_raw_number(m->raw, "the reference of an element",
                              &sfi_raw_last_cell(m->raw)->reference));
    }
    return SF_OK;
}

static sf_status read_edges(medit *m)
{
    uint32_t count, ends[2];
    double reference;
    SF_TRY(read_count(m, &count));
    for (uint32_t i = 0; i < count; i++) {
        SF_TRY(read_index(m, "the number of a vertex", &ends[0]));
        SF_TRY(read_index(m, "the number of a vertex", &ends[1]));
        SF_TRY(sfi_raw_number(m->raw, "the reference of an edge", &reference));
        SF_TRY(sfi_raw_push(m->raw, &m->edges, ends));
    }
    return SF_OK;
}

static sf_status read_ridges(medit *m)
{
    uint32_t count;
    SF_TRY(read_count(m, &count));
    for (uint32_t i = 0; i < count; i++) {
        ridge one = {0, 0};
        SF_TRY(read_index(m, "the number of an edge", &one.edge));
        one.line = m->raw->cursor->line;
        SF_TRY(sfi_raw_push(m->raw, &m->ridges, &one));
    }
    return SF_OK;
}

static sf_status read_corners(medit *m)
{
    uint32_t count, point;
    SF_TRY(read_count(m, &count));
    for (uint32_t i = 0; i < count; i++) {
        SF_TRY(read_index(m, "the number of a vertex", &point));
        SF_TRY(sfi_raw_mark_sharp(m->raw, &m->raw->sharps, point, point));
    }
    return SF_OK;
}

// Up to the next word that is no number and no name.
static size_t pass_over(medit *m, char token[SFI_TOKEN_SIZE])
{
    size_t length;
    double number;
    do {
        length = sfi_raw_word(m->raw, token);
        if (length > 0 && token[0] == '"') { // blanks may stand in a name
            sfi_cursor_skip_line(m->raw->cursor);
        }
    } while (length > 0 && (token[0] == '"' || sfi_number_parse(token, &number)));
    return length;
}

static int is_passed(const char *word)
{
    for (size_t i = 0; i < sizeof passed / sizeof passed[0]; i++) {
        if (strcmp(word, passed[i]) == 0) {
            return 1;
        }
    }
    return 0;
}

static sf_status read_section(medit *m, const char *word)
{
    static const struct {
        const char *word;
        sf_status (*read)(medit *m);
    } sections[] = {
        {"Dimension", read_dimension}, {"Vertices", read_vertices}, {"Edges", read_edges},
        {"Ridges", read_ridges},       {"Corners", read_corners},
    };
    for (size_t i = 0; i < sizeof sections / sizeof sections[0]; i++) {
        if (strcmp(word, sections[i].word) == 0) {
            return sections[i].read(m);
        }
    }
    for (size_t i = 0; i < sizeof elements / sizeof elements[0]; i++) {
        if (strcmp(word, elements[i].word) == 0) {
            return read_elements(m, &elements[i]);
        }
    }
    return sfi_cursor_fault_token(m->raw->cursor, m->raw->fault,
                                  "a section of a Medit mesh, or End", word);
}

static sf_status read_sections(medit *m)
{
    char token[SFI_TOKEN_SIZE];
    size_t length = sfi_raw_word(m->raw, token);
    while (length > 0 && strcmp(token, "End") != 0) {
        if (is_passed(token)) {
            length = pass_over(m, token);
            continue;
        }
        SF_TRY(read_section(m, token));
        length = sfi_raw_word(m->raw, token);
    }
    if (length == 0) {
        return sfi_cursor_fault(m->raw->cursor, m->raw->fault,
                                "the file has no End; it is cut short");
    }
    return SF_OK;
}

static sf_status read_header(medit *m)
{
    char token[SFI_TOKEN_SIZE];
    uint32_t version;
    sfi_raw_word(m->raw, token);
    if (strcmp(token, "MeshVersionFormatted") != 0) {
        return sfi_cursor_fault_token(m->raw->cursor, m->raw->fault,
                                      "the word MeshVersionFormatted", token);
    }
    SF_TRY(sfi_raw_whole(m->raw, "the version of a Medit mesh, 1 to 4", 4, &version));
    return SF_OK;
}

// Ridges name edges by number, now that all are there.
static sf_status mark_ridges(medit *m)
{
    for (size_t i = 0; i < m->ridges.count; i++) {
        ridge one = ((const ridge *)m->ridges.items)[i];
        if (one.edge >= m->edges.count) {
            return sfi_fault_set(m->raw->fault, SF_ERR_FORMAT, one.line, 0,
                                 "a ridge names edge %lu; the file has %zu, counted from 1",
                                 (unsigned long)one.edge + 1, m->edges.count);
        }
        const uint32_t *ends = (const uint32_t *)m->edges.items + 2 * (size_t)one.edge;
        SF_TRY(sfi_raw_mark_sharp(m->raw, &m->raw->creases, ends[0], ends[1]));
    }
    return SF_OK;
}

sf_status sfi_medit_read(sfi_raw *raw)
{
    const sf_allocator *allocator = &raw->cursor->allocator;
    medit m = {raw, 0, 0, sfi_list_of(2 * sizeof(uint32_t)), sfi_list_of(sizeof(ridge))};
    raw->first_number = 1;
    raw->reference_name = "reference";
    sf_status status = read_header(&m);
    if (status == SF_OK) {
        status = read_sections(&m);
    }
    if (status == SF_OK) {
        status = mark_ridges(&m);
    }
    sfi_list_free(allocator, &m.ridges);
    sfi_list_free(allocator, &m.edges);
    return status;
}
