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
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n", "names point 4", 0, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 2\n10 10\n", "1 cells and 2 types", 0,
         SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n12\n", "disagree", 0, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n5\n", "disagree", 0, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n7\n", "disagree", 0, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 3\n2 0 1\nCELL_TYPES 1\n3\n", "no cells", 0, SF_ERR_FORMAT},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n6\n", "type 6", 0, SF_ERR_UNSUPPORTED},
        {VTK_POINTS "CELLS 1 6\n5 0 1 2 3 0\nCELL_TYPES 1\n14\n", "type 14", 0, SF_ERR_UNSUPPORTED},
        {VTK_POINTS "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n4294967295\n", "type", 0,
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
    TEST(believes_no_count);
    return test_finish();
}
