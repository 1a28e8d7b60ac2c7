// SPDX-License-Identifier: MIT
// What must not be read as a cage from a VTK file is refused with one sentence, takes no memory in
// proportion to what the file claims, and leaves nothing behind. Guards: issue 5 (bad input: a cell
// type that lies about its size), TRUST B4, B5, B6 (counts, indices and tokens from a file).

#include "cage_files.h"

#define VTK "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n" // lines 1 to 4
#define VTK_POINTS "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n"                  // 5 and 6
#define VTK_TET VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"           // to 10

static void refuses_broken_vtk(void)
{
    static const bad heads[] = {
        {"# vtk DataFile Version 6.0\n", "\"6.0\"", 1, SF_ERR_FORMAT},
        {"# vtk DataFile Version\n", "cut short", 1, SF_ERR_FORMAT},
        {"# vtk DataFile Version 3.0\nt\nTEXT\n", "\"text\"", 3, SF_ERR_FORMAT},
        {"# vtk DataFile Version 3.0\nt\nASCII\nPOINTS 3 float\n", "\"points\"", 4, SF_ERR_FORMAT},
        {"# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n", "another kind", 4,
         SF_ERR_UNSUPPORTED},
        {"# vtk DataFile Version 3.0\nt\nASCII\nDATASET\n", "DATASET", 4, SF_ERR_FORMAT},
    };
    static const bad cases[] = {
        {"", "cut short", 0, SF_ERR_FORMAT},
        {VTK_POINTS, "cut short", 0, SF_ERR_FORMAT},
        {VTK_POINTS VTK_POINTS, "twice", 7, SF_ERR_FORMAT},
        {"POINTS -1 float\n", "\"-1\"", 5, SF_ERR_FORMAT},
        {"POINTS 1\n", "cut short", 5, SF_ERR_FORMAT},
        {"POINTS 1 quad\n", "\"quad\"", 5, SF_ERR_FORMAT},
        {"POINTS 1 float\n0 nan 0\n", "not a number", 6, SF_ERR_FORMAT},
        {"POINTS 1 float\n0 0 x\n", "\"x\"", 6, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n3 0 1 2\nCELL_TYPES 1\n5\n", "fewer", 0, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n5 0 1 2 3\n", "more corners", 8, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 -3\n", "negative", 8, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3.5\n", "not whole", 8, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n", "names point 4", 8, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n10 10\n", "1 cells and 2 types", 0,
         SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n12\n", "disagree", 8, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n5\n", "disagree", 8, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n7\n", "disagree", 8, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n", "no cells", 0, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n6\n", "type 6", 8, SF_ERR_UNSUPPORTED},
        {VTK_POINTS "CELLS 1 6\n5 0 1 2 3 0\nCELL_TYPES 1\n14\n", "type 14", 8, SF_ERR_UNSUPPORTED},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n4294967295\n", "type", 8,
         SF_ERR_UNSUPPORTED},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 2\nCELL_TYPES 1\n10\n", "cell 0", 0, SF_ERR_FORMAT},
    };
    refuses_all(heads, sizeof heads / sizeof heads[0], "");
    refuses_all(cases, sizeof cases / sizeof cases[0], VTK);
}

static void refuses_broken_data(void)
{
    static const bad cases[] = {
        {VTK_TET "NONSENSE 3\n", "\"nonsense\"", 11, SF_ERR_FORMAT},
        {VTK_TET "POINT_DATA 4\nSCALARS a float\n1 2 3 4\n", "\"1\"", 13, SF_ERR_FORMAT},
        {VTK_TET "POINT_DATA 4\nSCALARS a float\nLOOKUP_TABLE x\n1 2 3\n", "cut short", 0,
         SF_ERR_FORMAT},
        {VTK_TET "POINT_DATA 4\nSCALARS a float\nLOOKUP_TABLE x\n1 2 3 inf\n", "not finite", 0,
         SF_ERR_FORMAT},
        {VTK_TET "POINT_DATA 3\nSCALARS a float\nLOOKUP_TABLE x\n1 2 3\n", "3 values for 4", 0,
         SF_ERR_FORMAT},
        {VTK_TET "CELL_DATA 2\nFIELD f 1\na 1 2 float\n1 2\n", "2 values for 1", 0, SF_ERR_FORMAT},
        {VTK_TET "CELL_DATA 1\nFIELD f 1\na 1 1 string\nx\n", "texts", 13, SF_ERR_UNSUPPORTED},
        {VTK_TET "CELL_DATA 1\nFIELD f 2\na 1 1 int\n1\na 1 1 int\n2\n", "name or the UUID", 0,
         SF_ERR_FORMAT},
        {VTK_TET "CELL_DATA 1\nSCALARS a-name-that-is-longer-than-any-property-can-have-it int\n"
                 "LOOKUP_TABLE x\n1\n",
         "longer than 47", 0, SF_ERR_FORMAT},
    };
    refuses_all(cases, sizeof cases / sizeof cases[0], VTK);
}

// What only our own files have, and not as our own files have it.
static void refuses_broken_fields(void)
{
    static const bad cases[] = {
        {"FIELD f 1\nsf_creases 2 1 int\n0 1\n" VTK_TET, "sf_creases", 0, SF_ERR_FORMAT},
        {"FIELD f 1\nsf_creases 3 1 int\n0 -1 3\n" VTK_TET, "sf_creases", 0, SF_ERR_FORMAT},
        {"FIELD f 1\nsf_creases 3 1 int\n0 7 3\n" VTK_TET, "no edge", 0, SF_ERR_FORMAT},
        {"FIELD f 1\nsf_sharps 2 1 float\n0.5 1\n" VTK_TET, "sf_sharps", 0, SF_ERR_FORMAT},
        {"FIELD f 1\nsf_property:a 1 1 int\n1\n" VTK_TET
         "CELL_DATA 1\nSCALARS a int\nLOOKUP_TABLE x\n1\n",
         "sf_property:a", 0, SF_ERR_FORMAT},
        {VTK_TET "POINT_DATA 4\nSCALARS sf_point int\nLOOKUP_TABLE x\n0 1 2 2\n", "sf_point", 0,
         SF_ERR_FORMAT},
        {VTK_TET "POINT_DATA 4\nSCALARS sf_point int\nLOOKUP_TABLE x\n0 1 2 4\n", "sf_point", 0,
         SF_ERR_FORMAT},
        {VTK_TET "POINT_DATA 4\nSCALARS sf_point int\nLOOKUP_TABLE x\n0 1 2 -4\n", "sf_point", 0,
         SF_ERR_FORMAT},
    };
    refuses_all(cases, sizeof cases / sizeof cases[0], VTK);
}

#define VTK5 "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n" VTK_POINTS

static void refuses_broken_offsets(void)
{
    static const bad cases[] = {
        {"CELLS 2 4\n4 0 1 2 3\n", "\"4\"", 8, SF_ERR_FORMAT},
        {"CELLS 2 4\nOFFSETS int\n0 5\n", "offsets", 9, SF_ERR_FORMAT},
        {"CELLS 2 4\nOFFSETS int\n1 4\n", "offsets", 9, SF_ERR_FORMAT},
        {"CELLS 3 4\nOFFSETS int\n0 4 3\n", "offsets", 9, SF_ERR_FORMAT},
        {"CELLS 2 4\nOFFSETS int\n0 3\n", "last offset", 9, SF_ERR_FORMAT},
        {"CELLS 2 4\nOFFSETS int\n0 -4\n", "negative", 9, SF_ERR_FORMAT},
        {"CELLS 2 4\nOFFSETS int\n0 4\nCELL_TYPES 1\n", "\"cell_types\"", 10, SF_ERR_FORMAT},
        {"CELLS 0 0\nOFFSETS int\nCONNECTIVITY int\nCELL_TYPES 0\n", "no cells", 0, SF_ERR_FORMAT},
    };
    refuses_all(cases, sizeof cases / sizeof cases[0], VTK5);
}

// The twin of hex_ellipsoid_coarse: 140 hexahedra that call themselves tetrahedra.
static void refuses_a_type_that_lies_about_its_size(void)
{
    static file f;
    for (int binary = 0; binary < 2; binary++) {
        make_vtk(&f, &vtk_kinds[binary]);
        unsigned char *types = f.bytes;
        while (memcmp(types, "CELL_TYPES 2\n", 13) != 0) {
            types++;
        }
        memcpy(types + 13, binary ? "\0\0\0\12" : "10", binary ? 4 : 2);
        CHECK(refused(f.bytes, f.size, SF_ERR_FORMAT, "type 10 and has 8 corners", 0));
    }
}

// Corner k of a cube of side `size` at a place of a lattice of 5 * 3 * 3 points.
static int lattice_point(const int at[3], int size, int k)
{
    static const int ring[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    return at[0] + size * ring[k][0] +
           5 * (at[1] + size * ring[k][1] + 3 * (at[2] + size * ring[k][2]));
}

// A cube of side 2, and beside it eight of side 1, or two of side 2 that meet in an edge.
static void make_uneven(file *f, int split, double scale)
{
    f->size = 0;
    put_text(f, VTK "POINTS 45 double\n");
    for (int i = 0; i < 45; i++) {
        put_text(f, "%.8g %.8g %.8g\n", scale * (i % 5) + 7.3, scale * (i / 5 % 3),
                 scale * (i / 15) - 0.1);
    }
    int cells = split ? 9 : 2;
    put_text(f, "CELLS %d %d\n", cells, 9 * cells);
    for (int i = 0; i < cells; i++) {
        int first[3] = {0, 0, 0}, j = i - 1;
        int fine[3] = {2 + (j & 1), j >> 1 & 1, j >> 2}, edge[3] = {1, 1, 0};
        put_text(f, "8");
        for (int k = 0; k < 8; k++) {
            put_text(f, " %d",
                     split ? lattice_point(i == 0 ? first : fine, i == 0 ? 2 : 1, k)
                           : lattice_point(i == 0 ? first : edge, 1, k));
        }
        put_text(f, "\n");
    }
    put_text(f, "CELL_TYPES %d\n", cells);
    for (int i = 0; i < cells; i++) {
        put_text(f, "12\n");
    }
}

// VTK does not say that a mesh has hanging nodes; where points are does, also when they are
// rounded.
static void says_why_hanging_nodes_are_refused(void)
{
    static file f;
    static const double scales[] = {1, 0.1, 1.0 / 3, 1e-3, 1e5};
    for (size_t i = 0; i < sizeof scales / sizeof scales[0]; i++) {
        make_uneven(&f, 1, scales[i]);
        CHECK(refused(f.bytes, f.size, SF_ERR_UNSUPPORTED, "hanging nodes", 0));
        make_uneven(&f, 0, scales[i]);
        CHECK(refused(f.bytes, f.size, SF_ERR_UNSUPPORTED, "meets itself in", 0));
    }
    make_uneven(&f, 1, 1); // the reason costs memory; without it the sentence is a plainer one
    int plain = 0;
    for (long k = 0; k < 100; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_cage *cage = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        sf_status status =
            read_cage(f.bytes, f.size, SF_CAGE_FORMAT_AUTO, &memory.allocator, &cage, NULL, &fault);
        CHECK(status == SF_ERR_MEMORY || status == SF_ERR_UNSUPPORTED);
        CHECK(cage_refused_well(status, &fault, cage) && memory.live == 0 && memory.faults == 0);
        plain += strstr(fault.message, "meets itself in") != NULL;
    }
    CHECK_EQ(plain, 3);
}

static void believes_no_count(void)
{
    static const char *const liars[] = {
        VTK "POINTS 2000000000 float\n0 0 0\n",
        VTK VTK_POINTS "CELLS 4000000000 4294967294\n4 0 1 2 3\n",
        VTK VTK_POINTS "CELL_TYPES 4000000000\n10\n",
        VTK VTK_TET "POINT_DATA 4000000000\nSCALARS a float\nLOOKUP_TABLE t\n1\n",
        VTK VTK_TET "POINT_DATA 4\nFIELD f 4000000000\na 4000000000 4000000000 float\n1\n",
        VTK VTK_TET "POINT_DATA 4000000000\nTEXTURE_COORDINATES a 0 float\nFIELD f 1\na 0 "
                    "4000000000 int\nLOOKUP_TABLE a 4000000000\n",
        VTK5 "CELLS 4000000000 4000000000\nOFFSETS int\n0 4 4 4\n",
    };
    for (size_t i = 0; i < sizeof liars / sizeof liars[0]; i++) {
        CHECK(asks_little(liars[i], strlen(liars[i])));
    }
}

int main(void)
{
    TEST(refuses_broken_vtk);
    TEST(refuses_broken_data);
    TEST(refuses_broken_fields);
    TEST(refuses_broken_offsets);
    TEST(refuses_a_type_that_lies_about_its_size);
    TEST(says_why_hanging_nodes_are_refused);
    TEST(believes_no_count);
    return test_finish();
}
