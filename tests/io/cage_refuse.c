// SPDX-License-Identifier: MIT
// What must not be read as a cage is refused with one sentence that names a line, takes no memory
// in proportion to what a file claims, and leaves nothing behind. Guards: issue 5 (bad input),
// TRUST B4, B5, B6 (counts, indices and tokens from a file), and the strong guarantee under a
// failing allocator.

#include "cage_files.h"

static void refuses_what_is_no_cage_file(void)
{
    static const bad cases[] = {
        {"", "the file is empty", WHOLE, SF_ERR_FORMAT},
        {"Dear reader, this is a letter.\n", "no Medit", WHOLE, SF_ERR_FORMAT},
        {"# only a comment\n", "no Medit", WHOLE, SF_ERR_FORMAT},
        {"solid x\nendsolid\n", "no Medit", WHOLE, SF_ERR_FORMAT},
    };
    refuses_all(cases, sizeof cases / sizeof cases[0], "");
}

#define MEDIT "MeshVersionFormatted 2\nDimension 3\n"
#define TRIANGLE "Vertices 3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n" // lines 3 to 6

static void refuses_broken_medit(void)
{
    static const bad heads[] = {
        {"MeshVersionFormatted\n5\n", "\"5\"", 2, SF_ERR_FORMAT},
        {"MeshVersionFormatted x\n", "version", 1, SF_ERR_FORMAT},
        {"MeshVersionFormatted 1\nDimension 4\n", "\"4\"", 2, SF_ERR_FORMAT},
        {"MeshVersionFormatted 1\nDimension 1\n", "dimension", 2, SF_ERR_FORMAT},
        {"MeshVersionFormatted 1\nVertices 0\n", "before Dimension", 2, SF_ERR_FORMAT},
        {"MeshVersionFormatted 1\nDimension 3\nEnd\n", "no cells", 3, SF_ERR_FORMAT},
        {"MeshVersionFormatted 1\nDimension 3\nHexahedron 1\n", "\"Hexahedron\"", 3, SF_ERR_FORMAT},
    };
    static const bad cases[] = {
        {"Triangles 1\n1 2 3 0\n", "cut short", 0, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 4 0\nEnd\n", "names point 4", 8, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 0 0\nEnd\n", "counted from 1", 8, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 -3 0\nEnd\n", "\"-3\"", 8, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 2.5 0\nEnd\n", "\"2.5\"", 8, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 99999999999999999999 0\nEnd\n", "999", 8, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 3\nEnd\n", "reference", 9, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 2 0\nEnd\n", "", 0, SF_ERR_FORMAT},
        {"Triangles 2\n1 2 3 0\nEnd\n", "\"End\"", 9, SF_ERR_FORMAT},
        {"Triangles -1\nEnd\n", "\"-1\"", 7, SF_ERR_FORMAT},
        {"Triangles many\nEnd\n", "\"many\"", 7, SF_ERR_FORMAT},
        {"Vertices 0\nEnd\n", "twice", 7, SF_ERR_FORMAT},
        {"Vertice 0\nEnd\n", "\"Vertice\"", 7, SF_ERR_FORMAT},
        {"Pyramids 1\n1 2 3 4 5 0\nEnd\n", "pyramids", 7, SF_ERR_UNSUPPORTED},
        {"TrianglesP2 0\nEnd\n", "TrianglesP2", 7, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 3 0\nEdges 1\n1 2 0\nRidges 1\n2\nEnd\n", "edge 2", 12, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 3 0\nEdges 1\n1 1 0\nRidges 1\n1\nEnd\n", "no edge", 0, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 3 0\nCorners 1\n4\nEnd\n", "sharp point", 0, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 3 0\nCorners 2\n1\nEnd\n", "\"End\"", 11, SF_ERR_FORMAT},
        {"Triangles 1\n1 2 3 inf\nTriangles 1\n1 2 3 0\nEnd\n", "", 0, SF_ERR_FORMAT},
        {"Normals 3\n", "cut short", 0, SF_ERR_FORMAT},
        {"Edges 1\n1 2 0\nEnd\n", "no cells", 0, SF_ERR_FORMAT},
    };
    static const bad points[] = {
        {"Vertices 1\n0 nan 0 0\nEnd\n", "not a number", 4, SF_ERR_FORMAT},
        {"Vertices 1\n0 0 1e999 0\nEnd\n", "infinite", 4, SF_ERR_FORMAT},
        {"Vertices 1\n0 0 zero 0\nEnd\n", "\"zero\"", 4, SF_ERR_FORMAT},
        {"Vertices 1\n0 0 0\nEnd\n", "reference", 5, SF_ERR_FORMAT},
        {"Vertices 3\n0 0 0 0\n1e13 0 0 0\n0 1 0 0\nTriangles 1\n1 2 3 0\nEnd\n", "10^12", 0,
         SF_ERR_FORMAT},
    };
    refuses_all(heads, sizeof heads / sizeof heads[0], "");
    refuses_all(cases, sizeof cases / sizeof cases[0], MEDIT TRIANGLE);
    refuses_all(points, sizeof points / sizeof points[0], MEDIT);
}

#define MFEM "MFEM mesh v1.0\ndimension 2\nelements 1\n1 2 0 1 2\nboundary 0\n" // lines 1 to 5

static void refuses_broken_mfem(void)
{
    static const bad heads[] = {
        {"MFEM NC mesh v1.0\n\ndimension\n3\n", "hanging nodes", 1, SF_ERR_UNSUPPORTED},
        {"MFEM INLINE mesh v1.0\n", "not read", 1, SF_ERR_UNSUPPORTED},
        {"MFEM NURBS mesh v1.0\n", "not read", 1, SF_ERR_UNSUPPORTED},
        {"MFEM mesh v2.0\n", "version", 1, SF_ERR_UNSUPPORTED},
        {"MFEM mesh v1.0\nelements\n0\n", "\"elements\"", 2, SF_ERR_FORMAT},
        {"MFEM mesh v1.0\ndimension\n4\n", "\"4\"", 3, SF_ERR_FORMAT},
        {"MFEM mesh v1.0\ndimension 3\nelements 1\n1 8 0 1\n", "\"8\"", 4, SF_ERR_FORMAT},
        {"MFEM mesh v1.0\ndimension 3\nelements 1\n1 7 0 1 2 3 4\n", "pyramids", 4,
         SF_ERR_UNSUPPORTED},
        {"MFEM mesh v1.0\ndimension 3\nelements 1\n1 4 0 1 2\nboundary\n", "\"boundary\"", 5,
         SF_ERR_FORMAT},
        {"MFEM mesh v1.0\ndimension 3\nelements 1\n1 4 0 1 2 -1\n", "\"-1\"", 4, SF_ERR_FORMAT},
        {"MFEM mesh v1.0\ndimension 3\nelements 1\nx 4 0 1 2 3\n", "\"x\"", 4, SF_ERR_FORMAT},
        {"MFEM mesh v1.0\ndimension 3\nelements 0\nboundary 0\nvertices 0 3\n", "no cells", 0,
         SF_ERR_FORMAT},
        {"MFEM mesh v1.0\ndimension 1\nelements 1\n1 1 0 1\nboundary 0\nvertices 2 1\n0 1\n",
         "no cells", 0, SF_ERR_FORMAT},
    };
    static const bad cases[] = {
        {"vertex_parents 1\n2 0 1\n", "hanging nodes", 6, SF_ERR_UNSUPPORTED},
        {"coarse_elements 1\n", "hanging nodes", 6, SF_ERR_UNSUPPORTED},
        {"corners 3\n", "\"corners\"", 6, SF_ERR_FORMAT},
        {"vertices 3 1\n", "\"1\"", 6, SF_ERR_FORMAT},
        {"vertices 3 4\n", "\"4\"", 6, SF_ERR_FORMAT},
        {"vertices 3\n2\n0 0\n1 0\n0 inf\n", "infinite", 10, SF_ERR_FORMAT},
        {"vertices 3\n2\n0 0\n1 0\n0\n", "cut short", 0, SF_ERR_FORMAT},
        {"vertices 2\n2\n0 0\n1 0\n", "names point 2", 4, SF_ERR_FORMAT},
        {"vertices 3\n2\n0 0\n1 0\n0 one\n", "\"one\"", 10, SF_ERR_FORMAT},
        {"attribute_sets 3\n\"a\" 1 1\n", "cut short", 0, SF_ERR_FORMAT},
        {"vertices 3\nnodes\nFiniteElements\n", "\"FiniteElements\"", 8, SF_ERR_FORMAT},
    };
    static const bad nodes[] = {
        {"L2_T1_2D_P1\nVDim: 2\nOrdering: 1\n0 0 1 0 0 1\n", "belong to cells", 8,
         SF_ERR_UNSUPPORTED},
        {"NURBS2\n", "belong to cells", 8, SF_ERR_UNSUPPORTED},
        {"", "cut short", 0, SF_ERR_FORMAT},
        {"H1_2D_P2\nVDim: 2\nOrdering: 0\n0 0 1 0 0 1\n", "Ordering: 1", 10, SF_ERR_UNSUPPORTED},
        {"H1_2D_P2\nVDim: 1\nOrdering: 1\n0 1 2\n", "fewer coordinates", 9, SF_ERR_FORMAT},
        {"H1_2D_P2\nVDim: 4\nOrdering: 1\n0 1 2\n", "\"4\"", 9, SF_ERR_FORMAT},
        {"H1_2D_P1\nVDim: 2\nOrdering: 2\n", "\"2\"", 10, SF_ERR_FORMAT},
        {"H1_2D_P1\nVDim: 2\nOrdering: 1\n0 0 1 0 0\n", "cut short", 0, SF_ERR_FORMAT},
        {"H1_2D_P1\nVDim: 2\nOrdering: 0\n0 0 1 0 0 1 1 1\n", "as many", 0, SF_ERR_FORMAT},
        {"H1_2D_P3\nVDim: 2\nOrdering: 1\n0 0 1 0 0 1 1\n", "cut short", 0, SF_ERR_FORMAT},
        {"H1_2D_P3\nVDim: 2\nOrdering: 1\n0 0 1 nan 0 1\n", "not a number", 0, SF_ERR_FORMAT},
        {"H1_2D_P3\nVDim: 2\nOrdering: 1\n0 0 1 end\n", "\"end\"", 11, SF_ERR_FORMAT},
    };
    refuses_all(heads, sizeof heads / sizeof heads[0], "");
    refuses_all(cases, sizeof cases / sizeof cases[0], MFEM);
    refuses_all(nodes, sizeof nodes / sizeof nodes[0],
                MFEM "vertices 3\nnodes\nFiniteElementSpace FiniteElementCollection: ");
}

// A file cut at any byte is read or refused, never half of both; and whatever is left of it says so
// in its last byte: Medit files have an End.
static void survives_every_truncation(void)
{
    static file f;
    const char *what;
    for (size_t i = 0; (what = make_any_cage(&f, i)) != NULL; i++) {
        for (size_t size = 0; size < f.size; size++) {
            void *exact = malloc(size + !size); // so that a sanitizer sees the first byte too many
            memcpy(exact, f.bytes, size);
            failing_allocator memory;
            failing_begin(&memory, -1);
            sf_cage *cage = NULL;
            sf_fault fault = {SF_OK, 0, 0, ""};
            sf_status status =
                read_cage(exact, size, SF_CAGE_FORMAT_AUTO, &memory.allocator, &cage, NULL, &fault);
            CHECK(status == SF_OK ? sf_cage_get_view(cage).cell_count == 2
                                  : cage_refused_well(status, &fault, cage));
            sf_cage_destroy(cage);
            CHECK(memory.live == 0 && memory.faults == 0);
            free(exact);
        }
    }
}

// Bytes changed at random must never do more than change the cage or refuse it.
static void survives_changed_bytes(void)
{
    static file f;
    for (size_t i = 0; make_any_cage(&f, i) != NULL; i++) {
        for (int round = 0; round < 300; round++) {
            make_any_cage(&f, i);
            for (uint32_t k = 1 + test_random_below(3); k > 0; k--) {
                f.bytes[test_random_below((uint32_t)f.size)] = (unsigned char)test_random();
            }
            sf_cage *cage = NULL;
            sf_fault fault = {SF_OK, 0, 0, ""};
            sf_status status =
                read_cage(f.bytes, f.size, SF_CAGE_FORMAT_AUTO, NULL, &cage, NULL, &fault);
            CHECK(status == SF_OK ? cage != NULL : cage_refused_well(status, &fault, cage));
            sf_cage_destroy(cage);
        }
    }
}

static void survives_every_refused_allocation(void)
{
    static file f;
    for (size_t i = 0; make_any_cage(&f, i) != NULL; i++) {
        sf_status status = SF_ERR_MEMORY;
        for (long k = 0; status != SF_OK && k < 1000; k++) {
            failing_allocator memory;
            failing_begin(&memory, k);
            sf_cage *cage = NULL;
            sf_cage_reading reading = {SF_CAGE_FORMAT_AUTO, 99, 99};
            sf_fault fault = {SF_OK, 0, 0, ""};
            status = read_cage(f.bytes, f.size, SF_CAGE_FORMAT_AUTO, &memory.allocator, &cage,
                               &reading, &fault);
            CHECK(status == SF_OK ||
                  (status == SF_ERR_MEMORY && cage_refused_well(status, &fault, cage) &&
                   reading.passed_over == 99));
            sf_cage_destroy(cage);
            CHECK(memory.live == 0 && memory.faults == 0);
        }
        CHECK_EQ(status, SF_OK);
    }
}

static void believes_no_count(void)
{
    static const char *const liars[] = {
        MEDIT "Vertices 4000000000\n0 0 0 0\n",
        MEDIT TRIANGLE "Triangles 4000000000\n1 2 3 0\n",
        MEDIT TRIANGLE "Edges 4294967295\n1 2 3\n",
        MEDIT TRIANGLE "Corners 4294967295\n1 2 3\n",
        "MFEM mesh v1.0\ndimension 3\nelements 4294967295\n1 4 0 1 2 3\n",
        MFEM "vertices 4294967295\n3\n0 0 0\n",
        MFEM "vertices 4294967295\nnodes\nFiniteElementSpace FiniteElementCollection: H1_3D_P1\n"
             "VDim: 3\nOrdering: 0\n0 0 0\n",
    };
    for (size_t i = 0; i < sizeof liars / sizeof liars[0]; i++) {
        CHECK(asks_little(liars[i], strlen(liars[i])));
    }
}

static sf_status read_within(const file *f, const sf_cage_read_options *options, sf_fault *fault)
{
    sf_memory_cursor cursor = {f->bytes, f->size, 0};
    sf_cage *cage = NULL;
    sf_status status = sf_cage_read(sf_memory_source(&cursor), options, NULL, &cage, NULL, fault);
    sf_cage_destroy(cage);
    return status;
}

static void obeys_limits(void)
{
    static file f;
    sf_fault fault;
    for (size_t i = 0; make_any_cage(&f, i) != NULL; i++) {
        sf_cage_read_options options = sf_cage_read_options_default();
        options.points_max = 10;
        options.corners_max = 14 + 16; // some files have faces, too
        CHECK_EQ(read_within(&f, &options, &fault), SF_OK);
        options.points_max = 9;
        CHECK_EQ(read_within(&f, &options, &fault), SF_ERR_OVERFLOW);
        CHECK(strstr(fault.message, "points_max") != NULL);
        options.points_max = 10;
        options.corners_max = 13;
        CHECK_EQ(read_within(&f, &options, &fault), SF_ERR_OVERFLOW);
        CHECK(strstr(fault.message, "corners_max") != NULL);
        options.corners_max = SIZE_MAX;
        options.bytes_max = 100;
        CHECK_EQ(read_within(&f, &options, &fault), SF_ERR_OVERFLOW);
        CHECK(strstr(fault.message, "bytes_max") != NULL);
    }
}

static sf_status fail_after(void *user, void *data, size_t capacity, size_t *size)
{
    sf_memory_cursor *cursor = user;
    size_t left = cursor->size - cursor->position;
    if (left == 0) {
        return SF_ERR_CANCELLED;
    }
    *size = capacity < left ? capacity : left;
    memcpy(data, (const char *)cursor->data + cursor->position, *size);
    cursor->position += *size;
    return SF_OK;
}

// However far a file goes, a source that fails is named as the reason, and what it said comes out.
static void passes_a_failing_source_on(void)
{
    static file f;
    for (size_t i = 0; make_any_cage(&f, i) != NULL; i++) {
        for (size_t size = 0; size < 200; size++) {
            sf_memory_cursor cursor = {f.bytes, size, 0};
            sf_source source = {fail_after, &cursor};
            sf_cage *cage = NULL;
            sf_fault fault = {SF_OK, 0, 0, ""};
            CHECK_EQ(sf_cage_read(source, NULL, NULL, &cage, NULL, &fault), SF_ERR_CANCELLED);
            CHECK(cage_refused_well(SF_ERR_CANCELLED, &fault, cage));
        }
    }
}

static void refuses_wrong_arguments(void)
{
    sf_cage *cage = NULL;
    sf_source none = {NULL, NULL};
    sf_memory_cursor cursor = {"", 0, 0};
    sf_cage_read_options options = sf_cage_read_options_default();
    CHECK_EQ(sf_cage_read(none, NULL, NULL, &cage, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_cage_read(sf_memory_source(&cursor), NULL, NULL, NULL, NULL, NULL),
             SF_ERR_ARGUMENT);
    options.format = (sf_cage_format)4;
    CHECK_EQ(sf_cage_read(sf_memory_source(&cursor), &options, NULL, &cage, NULL, NULL),
             SF_ERR_ARGUMENT);
    CHECK(cage == NULL);
}

int main(void)
{
    TEST(refuses_what_is_no_cage_file);
    TEST(refuses_broken_medit);
    TEST(refuses_broken_mfem);
    TEST(survives_every_truncation);
    TEST(survives_changed_bytes);
    TEST(survives_every_refused_allocation);
    TEST(believes_no_count);
    TEST(obeys_limits);
    TEST(passes_a_failing_source_on);
    TEST(refuses_wrong_arguments);
    return test_finish();
}
