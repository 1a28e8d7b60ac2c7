// SPDX-License-Identifier: MIT
// Small cage files made in memory, in every format: a unit cube and, on its side, a wedge of half
// its volume. Ten points, two cells, volume 1.5, whatever the file around them looks like.

#ifndef SF_TEST_CAGE_FILES_H
#define SF_TEST_CAGE_FILES_H

#include <sf/cage_io.h>

#include "files.h"

static const double model_points[10][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1},
                                           {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {2, 0, 0}, {2, 0, 1}};
static const int model_cube[8] = {0, 1, 2, 3, 4, 5, 6, 7};
static const int model_wedge[6] = {1, 8, 2, 5, 9, 6};
static const int model_turned[6] = {5, 9, 6, 1, 8, 2}; // as one half of all programs writes it

// Numbers in a row, each `add` larger, and the end of the line.
static inline void put_row(file *f, const int *numbers, int count, int add, const char *end)
{
    for (int i = 0; i < count; i++) {
        put_text(f, i > 0 ? " %d" : "%d", numbers[i] + add);
    }
    put_text(f, "%s", end);
}

// --- Medit ---------------------------------------------------------------------------------------

static inline void put_medit_points(file *f, const char *end)
{
    put_text(f, "Vertices%s10%s", end, end);
    for (int i = 0; i < 10; i++) {
        const double *p = model_points[i];
        put_text(f, "%.17g %.3f %e 0%s", p[0], p[1], p[2], end);
    }
}

static inline void make_medit(file *f, const char *end, int turned)
{
    char reference[16];
    snprintf(reference, sizeof reference, " 7%s", end);
    f->size = 0;
    put_text(f, "MeshVersionFormatted 2%s%sDimension%s3%s", end, end, end, end);
    put_medit_points(f, end);
    put_text(f, "Quadrilaterals%s1%s1 2 3 4 0%s", end, end, end);
    put_text(f, "Hexahedra%s1%s", end, end);
    put_row(f, model_cube, 8, 1, reference);
    put_text(f, "Prisms%s1%s", end, end);
    put_row(f, turned ? model_turned : model_wedge, 6, 1, reference);
    put_text(f, "End%s", end);
}

// Sections in an odd order, those that are passed over, comments, what is sharp, two materials.
static inline void make_full_medit(file *f)
{
    f->size = 0;
    put_text(f, "# made by hand\n\n MeshVersionFormatted 1 # old\n\tDimension 3\n"
                "Ridges 2\n2\n1\nWedges\n1\n");
    put_row(f, model_wedge, 6, 1, " 2\n");
    put_text(f, "Identifier\n\"a name 5 End\"\nNormals 1\n0 0 1\nNormalAtVertices 1\n1 1\n");
    put_medit_points(f, "\n");
    put_text(f, "RequiredVertices\n2\n1 2\nEdges 3\n1 2 0\n2 9 0 # an edge\n3 4 0\nCorners 2\n"
                "1 9\nHexahedra 1\n");
    put_row(f, model_cube, 8, 1, " 1\n");
    put_text(f, "Triangles 0\nPyramids 0\nEnd\nbeyond the end");
}

// --- MFEM ----------------------------------------------------------------------------------------

static inline void put_mfem_head(file *f, const char *version, const char *end)
{
    put_text(f, "MFEM mesh %s%s%s# a comment%sdimension%s3%s%selements%s2%s", version, end, end,
             end, end, end, end, end, end);
    put_text(f, "1 5 ");
    put_row(f, model_cube, 8, 0, end);
    put_text(f, "1 6 ");
    put_row(f, model_wedge, 6, 0, end);
    if (strcmp(version, "v1.3") == 0) {
        put_text(f, "%sattribute_sets%s2%s\"all of 1\" 1 1%s\"none\" 0%s", end, end, end, end, end);
    }
    put_text(f, "%sboundary%s2%s1 3 0 3 2 1%s2 2 1 2 8%s%s", end, end, end, end, end, end);
}

static inline void make_mfem(file *f, const char *version, const char *end)
{
    f->size = 0;
    put_mfem_head(f, version, end);
    put_text(f, "vertices%s10%s3%s", end, end, end);
    for (int i = 0; i < 10; i++) {
        put_text(f, "%g %g %g%s", model_points[i][0], model_points[i][1], model_points[i][2], end);
    }
    if (strcmp(version, "v1.0") != 0) {
        put_text(f, "%smfem_mesh_end%s", end, end);
    }
}

// Nodes: of a higher order with values that belong to no vertex, or of order 1, axis by axis.
static inline void make_mfem_nodes(file *f, int by_point)
{
    f->size = 0;
    put_mfem_head(f, "v1.0", "\n");
    put_text(f,
             "vertices\n10\n\nnodes\nFiniteElementSpace\nFiniteElementCollection: %s\nVDim: 3\n"
             "Ordering: %d\n\n",
             by_point ? "H1_3D_P2" : "Linear", by_point);
    for (int i = 0; i < 30; i++) {
        put_text(f, "%g\n", by_point ? model_points[i / 3][i % 3] : model_points[i % 10][i / 10]);
    }
    put_text(f, by_point ? "9 9 9\n8 8 8\n" : "");
}

// --- VTK -----------------------------------------------------------------------------------------

typedef struct vtk_kind {
    const char *version, *end;
    int binary;
    int offsets; // 5.1: two arrays for the cells
    const char *real, *whole;
    int real_size, whole_size;
} vtk_kind;

static const vtk_kind vtk_kinds[] = {
    {"2.0", "\n", 0, 0, "float", "int", 4, 4},
    {"3.0", "\n", 1, 0, "double", "int", 8, 4},
    {"4.2", "\r\n", 0, 0, "double", "short", 8, 2},
    {"4.2", "\n", 1, 0, "float", "unsigned_char", 4, 1},
    {"5.1", "\n", 0, 1, "double", "vtktypeint64", 8, 8},
    {"5.1", "\n", 1, 1, "double", "vtktypeint64", 8, 8},
    {"5.0", "\n", 1, 1, "float", "vtkIdType", 4, 4},
};
#define VTK_KINDS (sizeof vtk_kinds / sizeof vtk_kinds[0])

static inline void put_real(file *f, const vtk_kind *k, double value)
{
    if (!k->binary) {
        put_text(f, "%.9g ", value);
    } else if (k->real_size == 8) {
        put_double(f, value, 1);
    } else {
        put_float(f, value, 1);
    }
}

static inline void put_whole(file *f, const vtk_kind *k, int value, int size)
{
    if (k->binary) {
        put_bits(f, (uint64_t)(int64_t)value, size, 1);
    } else {
        put_text(f, "%d ", value);
    }
}

static inline void put_vtk_cells(file *f, const vtk_kind *k)
{
    put_text(f, k->offsets ? "CELLS 3 14%s" : "CELLS 2 16%s", k->end);
    if (k->offsets) {
        put_text(f, "OFFSETS %s%s", k->whole, k->end);
        put_whole(f, k, 0, k->whole_size);
        put_whole(f, k, 8, k->whole_size);
        put_whole(f, k, 14, k->whole_size);
        put_text(f, "%sCONNECTIVITY %s%s", k->end, k->whole, k->end);
    }
    for (int i = -1; i < 8; i++) {
        if (i >= 0 || !k->offsets) {
            put_whole(f, k, i < 0 ? 8 : model_cube[i], k->offsets ? k->whole_size : 4);
        }
    }
    for (int i = -1; i < 6; i++) {
        if (i >= 0 || !k->offsets) {
            put_whole(f, k, i < 0 ? 6 : model_wedge[i], k->offsets ? k->whole_size : 4);
        }
    }
    put_text(f, "%sCELL_TYPES 2%s", k->end, k->end);
    put_whole(f, k, 12, 4);
    put_whole(f, k, 13, 4);
    put_text(f, "%s", k->end);
}

// Every form of data of points, some of them properties, with what may stand between them.
static inline void put_vtk_point_data(file *f, const vtk_kind *k)
{
    put_text(f, "POINT_DATA 10%sSCALARS heat %s%sLOOKUP_TABLE mine%s", k->end, k->real, k->end,
             k->end);
    for (int i = 0; i < 10; i++) {
        put_real(f, k, 0.5 * i);
    }
    put_text(f, "%sLOOKUP_TABLE mine 1%s", k->end, k->end);
    for (int i = 0; i < 4; i++) {
        put_whole(f, k, 1, 1);
    }
    put_text(f, "%sVECTORS way %s%s", k->end, k->real, k->end);
    for (int i = 0; i < 30; i++) {
        put_real(f, k, 0.25);
    }
    put_text(f, "%sCOLOR_SCALARS rgb 3%s", k->end, k->end);
    for (int i = 0; i < 30; i++) {
        put_whole(f, k, 1, 1);
    }
    put_text(f, "%sTEXTURE_COORDINATES uv 2 %s%s", k->end, k->real, k->end);
    for (int i = 0; i < 20; i++) {
        put_real(f, k, 0.125);
    }
    put_text(f, "%sFIELD FieldData 2%ssoft%%20part 1 10 %s%s", k->end, k->end, k->whole, k->end);
    for (int i = 0; i < 10; i++) {
        put_whole(f, k, i, k->whole_size);
    }
    put_text(f,
             "%sMETADATA%sINFORMATION 1%sNAME L2_NORM_RANGE LOCATION vtkDataArray%sDATA 2 0 "
             "1%s%sthree 3 10 bit%s",
             k->end, k->end, k->end, k->end, k->end, k->end, k->end);
    for (int i = 0; i < (k->binary ? 4 : 30); i++) {
        put_whole(f, k, k->binary ? 0x5a : i % 2, 1);
    }
    put_text(f, "%s", k->end);
}

static inline void make_vtk(file *f, const vtk_kind *k)
{
    f->size = 0;
    put_text(f,
             "# vtk DataFile Version %s%sa title, POINTS 3 float%s%s%sDATASET "
             "UNSTRUCTURED_GRID%sFIELD FieldData 1%sTIME 1 1 %s%s",
             k->version, k->end, k->end, k->binary ? "BINARY" : "ASCII", k->end, k->end, k->end,
             k->real, k->end);
    put_real(f, k, 3.5);
    put_text(f, "%sPOINTS 10 %s%s", k->end, k->real, k->end);
    for (int i = 0; i < 30; i++) {
        put_real(f, k, model_points[i / 3][i % 3]);
    }
    put_text(f, "%s", k->end);
    put_vtk_cells(f, k);
    put_text(f, "CELL_DATA 2%sscalars heat int 1%sLOOKUP_TABLE default%s", k->end, k->end, k->end);
    put_whole(f, k, -3, 4);
    put_whole(f, k, 70000, 4);
    put_text(f, "%s", k->end);
    put_vtk_point_data(f, k);
}

// --- all of them ---------------------------------------------------------------------------------

// Every small valid file there is, by number; NULL when there are no more. What it is, for
// messages.
static inline const char *make_any_cage(file *f, size_t number)
{
    if (number >= 8 && number - 8 < VTK_KINDS) {
        make_vtk(f, &vtk_kinds[number - 8]);
        return "VTK";
    }
    switch (number) {
    case 0:
        make_medit(f, "\n", 0);
        return "Medit";
    case 1:
        make_medit(f, "\r\n", 1);
        return "Medit, CRLF, a turned wedge";
    case 2:
        make_medit(f, "\r", 0);
        return "Medit, CR";
    case 3:
        make_full_medit(f);
        return "Medit, all sections";
    case 4:
        make_mfem(f, "v1.0", "\n");
        return "MFEM";
    case 5:
        make_mfem(f, "v1.3", "\r\n");
        return "MFEM, CRLF, sets of attributes";
    case 6:
        make_mfem_nodes(f, 1);
        return "MFEM, nodes by point";
    case 7:
        make_mfem_nodes(f, 0);
        return "MFEM, nodes by axis";
    default:
        return NULL;
    }
}

static inline sf_status read_cage(const void *data, size_t size, sf_cage_format format,
                                  const sf_allocator *allocator, sf_cage **cage,
                                  sf_cage_reading *reading, sf_fault *fault)
{
    sf_memory_cursor cursor = {data, size, 0};
    sf_cage_read_options options = sf_cage_read_options_default();
    options.format = format;
    return sf_cage_read(sf_memory_source(&cursor), &options, allocator, cage, reading, fault);
}

static inline sf_cage_report report_of(const sf_cage *cage)
{
    sf_cage_report report;
    memset(&report, 0, sizeof report);
    CHECK_EQ(sf_cage_check(cage, NULL, &report, NULL), cage != NULL ? SF_OK : SF_ERR_ARGUMENT);
    return report;
}

// Whether a refusal says something: its own status, a sentence that ends, and no cage.
static inline int cage_refused_well(sf_status status, const sf_fault *fault, const sf_cage *cage)
{
    size_t length = strlen(fault->message);
    return status != SF_OK && fault->status == status && cage == NULL && length > 20 &&
           length < SF_FAULT_MESSAGE_SIZE - 1;
}

#define WHOLE UINT32_MAX // for a line: what is wrong is wrong with the file, and has no line

// Whether bytes are refused as they should be, with nothing left behind or written.
static inline int refused(const void *data, size_t size, sf_status expected, const char *words,
                          uint32_t line)
{
    sf_cage *cage = NULL;
    sf_cage_reading reading = {SF_CAGE_FORMAT_AUTO, 99, 99};
    sf_fault fault = {SF_OK, 0, 0, ""};
    failing_allocator memory;
    failing_begin(&memory, -1);
    sf_status status =
        read_cage(data, size, SF_CAGE_FORMAT_AUTO, &memory.allocator, &cage, &reading, &fault);
    int good = status == expected && cage_refused_well(status, &fault, cage) &&
               strstr(fault.message, words) != NULL &&
               (line == 0 || fault.line == (line == WHOLE ? 0 : line)) && memory.live == 0 &&
               memory.faults == 0 && reading.turned_cells == 99;
    if (!good) {
        printf("# expected \"%s\" at line %u; got %s, line %u, byte %llu: \"%s\"\n", words, line,
               sf_status_name(status), fault.line, (unsigned long long)fault.offset, fault.message);
    }
    sf_cage_destroy(cage);
    return good;
}

typedef struct bad {
    const char *text, *words;
    uint32_t line; // 0: any
    sf_status status;
} bad;

static inline void refuses_all(const bad *cases, size_t count, const char *head)
{
    static file f;
    for (size_t i = 0; i < count; i++) {
        f.size = 0;
        put(&f, head, strlen(head));
        put(&f, cases[i].text, strlen(cases[i].text));
        CHECK(refused(f.bytes, f.size, cases[i].status, cases[i].words, cases[i].line));
    }
}

typedef struct counting {
    size_t largest;
    failing_allocator inner;
} counting;

static inline void *count_alloc(void *user, size_t size, size_t align)
{
    counting *c = user;
    c->largest = size > c->largest ? size : c->largest;
    return size < (size_t)1 << 24 ? failing_alloc(&c->inner, size, align) : NULL;
}

static inline void count_free(void *user, void *memory, size_t size)
{
    counting *c = user;
    failing_free(&c->inner, memory, size);
}

// Whether a file is refused without memory in proportion to what it claims.
static inline int asks_little(const void *data, size_t size)
{
    counting c = {0, {0}};
    failing_begin(&c.inner, -1);
    sf_allocator allocator = {count_alloc, count_free, &c};
    sf_cage *cage = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = read_cage(data, size, SF_CAGE_FORMAT_AUTO, &allocator, &cage, NULL, &fault);
    if (c.largest > 100000 || status != SF_ERR_FORMAT) {
        printf("# %s; %zu bytes asked for at once by a file of %zu\n", sf_status_name(status),
               c.largest, size);
    }
    sf_cage_destroy(cage);
    return status == SF_ERR_FORMAT && cage == NULL && c.largest <= 100000;
}

#endif
