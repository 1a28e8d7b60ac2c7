// SPDX-License-Identifier: MIT
// Every cage format, every variant: a cube and a wedge come out as two cells of volume 1.5, with
// what is sharp and what data they have, whatever the file around them looks like. Guards: issue 5
// part 1 (readers), the procedural twins of shared/data.

#include "cage_files.h"

static int is_model(const file *f, sf_cage_format format, const char *what)
{
    sf_cage *cage = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_cage_reading reading = {SF_CAGE_FORMAT_AUTO, 99, 99};
    sf_status status = read_cage(f->bytes, f->size, format, NULL, &cage, &reading, &fault);
    sf_cage_view view = sf_cage_get_view(cage);
    int good = status == SF_OK && view.dimension == 3 && view.point_count == 10 &&
               view.cell_count == 2 && view.starts[2] == 14 && reading.format != 0 &&
               reading.turned_cells == (strstr(what, "turned") != NULL);
    if (good) {
        sf_cage_report report = report_of(cage);
        good = fabs(report.volume_mm3 - 1.5) < 1e-12 && report.inverted_cells == 0 &&
               report.boundary_faces == 9;
    }
    if (!good) {
        printf("# %s: %s, %zu points, %zu cells, %zu turned, \"%s\"\n", what,
               sf_status_name(status), view.point_count, view.cell_count, reading.turned_cells,
               fault.message);
    }
    sf_cage_destroy(cage);
    return good;
}

static void reads_every_kind(void)
{
    static file f;
    const char *what;
    for (size_t i = 0; (what = make_any_cage(&f, i)) != NULL; i++) {
        CHECK(is_model(&f, SF_CAGE_FORMAT_AUTO, what));
    }
}

static void reads_short_reads(void)
{
    static file f;
    for (size_t i = 0; make_any_cage(&f, i) != NULL; i++) {
        sf_memory_cursor cursor = {f.bytes, f.size, 0};
        sf_source slow = {read_one_byte, &cursor};
        sf_cage *cage = NULL;
        CHECK_EQ(sf_cage_read(slow, NULL, NULL, &cage, NULL, NULL), SF_OK);
        CHECK_NEAR(report_of(cage).volume_mm3, 1.5, 1e-12);
        sf_cage_destroy(cage);
    }
}

static sf_cage *must_read(const char *text, sf_cage_reading *reading)
{
    sf_cage *cage = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status =
        read_cage(text, strlen(text), SF_CAGE_FORMAT_AUTO, NULL, &cage, reading, &fault);
    CHECK_EQ(status, SF_OK);
    if (status != SF_OK) {
        printf("# line %u: %s\n", fault.line, fault.message);
        exit(1);
    }
    return cage;
}

static int is_crease(const sf_crease *crease, uint32_t a, uint32_t b)
{
    return crease->points[0] == a && crease->points[1] == b && crease->sharpness == SF_SHARP;
}

static void keeps_what_is_sharp(void)
{
    static file f;
    sf_cage *cage = NULL;
    make_full_medit(&f);
    CHECK_EQ(read_cage(f.bytes, f.size, SF_CAGE_FORMAT_MEDIT, NULL, &cage, NULL, NULL), SF_OK);
    sf_cage_view view = sf_cage_get_view(cage);
    CHECK_EQ(view.crease_count, 2); // the third edge is no ridge
    CHECK(is_crease(&view.creases[0], 1, 8) && is_crease(&view.creases[1], 0, 1));
    CHECK_EQ(view.sharp_count, 2);
    CHECK(view.sharps[0].point == 0 && view.sharps[1].point == 8);
    CHECK(view.sharps[0].sharpness == SF_SHARP);
    sf_cage_destroy(cage);
}

// Materials: one value for each cell, in the order of the cells in the file.
static void makes_properties_of_references(void)
{
    static file f;
    sf_cage *cage = NULL;
    make_full_medit(&f);
    CHECK_EQ(read_cage(f.bytes, f.size, SF_CAGE_FORMAT_AUTO, NULL, &cage, NULL, NULL), SF_OK);
    sf_cage_view view = sf_cage_get_view(cage);
    CHECK_EQ(view.channel_count, 1);
    const sf_channel *c = &view.channels[0];
    CHECK_STR(c->property.name, "reference");
    CHECK_EQ(c->value_count, 2);
    CHECK(c->values[0] == 2 && c->values[1] == 1); // the wedge comes first
    for (uint32_t i = 0; i < 14; i++) {
        CHECK_EQ(c->indices[i], i < 6 ? 0 : 1);
    }
    sf_property named;
    CHECK_EQ(sf_property_named(c->property.name, &named), SF_OK);
    CHECK(memcmp(named.uuid, c->property.uuid, sizeof named.uuid) == 0);
    sf_cage_destroy(cage);
    make_medit(&f, "\n", 0); // all 7: nothing that differs, no property
    CHECK_EQ(read_cage(f.bytes, f.size, SF_CAGE_FORMAT_AUTO, NULL, &cage, NULL, NULL), SF_OK);
    CHECK_EQ(sf_cage_get_view(cage).channel_count, 0);
    sf_cage_destroy(cage);
}

#define SQUARE "Vertices 5\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n2 0 0 0\n"

static void makes_cages_of_faces_where_there_are_no_cells(void)
{
    sf_cage_reading reading;
    sf_cage *cage = must_read("MeshVersionFormatted 1 Dimension 3\n" SQUARE
                              "Triangles 1\n2 5 3 0\nQuadrilaterals 1\n1 2 3 4 0\nEnd\n",
                              &reading);
    sf_cage_view view = sf_cage_get_view(cage);
    CHECK(view.dimension == 2 && view.cell_count == 2 && view.point_count == 5);
    CHECK(view.starts[1] == 3 && view.starts[2] == 7 && view.corners[0] == 1);
    CHECK_EQ(reading.passed_over, 0);
    sf_cage_destroy(cage);
    cage = must_read("MeshVersionFormatted 1\nDimension 2\nVertices 3\n0 0 0\n1 0 0\n0 1 0\n"
                     "Triangles\n1\n1 2 3 0\nEnd\n",
                     &reading);
    view = sf_cage_get_view(cage);
    CHECK(view.dimension == 2 && view.positions[3] == 1 && view.positions[8] == 0);
    sf_cage_destroy(cage);
    cage = must_read("MFEM mesh v1.0\ndimension\n2\nelements\n2\n1 3 0 1 2 3\n3 2 1 4 2\nboundary\n"
                     "0\nvertices\n5\n2\n0 0\n1 0\n1 1\n0 1\n2 0\n",
                     &reading);
    view = sf_cage_get_view(cage);
    CHECK(view.dimension == 2 && view.cell_count == 2 && view.positions[12] == 2);
    CHECK_EQ(view.channel_count, 1);
    CHECK_STR(view.channels[0].property.name, "attribute");
    CHECK(view.channels[0].values[0] == 1 && view.channels[0].values[1] == 3);
    sf_cage_destroy(cage);
}

#define TET_POINTS                                                                                 \
    "MeshVersionFormatted 1 Dimension 3 Vertices 4\n0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 0\n"

// What is inverted everywhere is turned and counted; what is so in part is left and counted there.
static void turns_what_is_plainly_inverted(void)
{
    sf_cage_reading reading;
    sf_cage *cage = must_read(TET_POINTS "Tetrahedra 1\n1 3 2 4 0\nEnd\n", &reading);
    CHECK_EQ(reading.turned_cells, 1);
    CHECK_NEAR(report_of(cage).volume_mm3, 1.0 / 6, 1e-15);
    CHECK_EQ(report_of(cage).inverted_cells, 0);
    sf_cage_destroy(cage);
    cage = must_read(TET_POINTS "Tetrahedra 1\n1 2 3 4 0\nEnd\n", &reading);
    CHECK_EQ(reading.turned_cells, 0);
    CHECK_EQ(sf_cage_get_view(cage).corners[1], 1);
    sf_cage_destroy(cage);
    // A cube with one corner pulled through the opposite one.
    cage = must_read("MFEM mesh v1.0\ndimension 3\nelements 1\n1 5 0 1 2 3 4 5 6 7\nboundary 0\n"
                     "vertices 8 3\n0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 -1 -1 -1 0 1 1\n",
                     &reading);
    CHECK_EQ(reading.turned_cells, 0);
    CHECK_EQ(report_of(cage).inverted_cells, 1);
    sf_cage_destroy(cage);
}

// Data of points and cells of one component are properties; all else has gone by without a trace.
static void makes_properties_of_data(void)
{
    static file f;
    for (size_t k = 0; k < VTK_KINDS; k++) {
        sf_cage *cage = NULL;
        make_vtk(&f, &vtk_kinds[k]);
        CHECK_EQ(read_cage(f.bytes, f.size, SF_CAGE_FORMAT_VTK, NULL, &cage, NULL, NULL), SF_OK);
        sf_cage_view view = sf_cage_get_view(cage);
        CHECK_EQ(view.channel_count, 3);
        if (view.channel_count == 3) {
            const sf_channel *c = view.channels;
            CHECK_STR(c[0].property.name, "heat of cells");
            CHECK(c[0].value_count == 2 && c[0].values[0] == -3 && c[0].values[1] == 70000);
            CHECK(c[0].indices != NULL && c[0].indices[7] == 0 && c[0].indices[8] == 1);
            CHECK_STR(c[1].property.name, "heat");
            CHECK(c[1].value_count == 10 && c[1].values[9] == 4.5 && c[1].indices == NULL);
            CHECK_STR(c[2].property.name, "soft part");
            CHECK(c[2].values[9] == 9);
            CHECK(c[2].property.low == -INFINITY && c[2].property.high == INFINITY);
            CHECK(memcmp(c[1].property.uuid, c[2].property.uuid, 16) != 0);
        }
        sf_cage_destroy(cage);
    }
}

// The UUID of a foreign property is part of the interface; this one by sha256sum.
static void names_foreign_properties_for_ever(void)
{
    static const uint8_t heat[16] = {0x6e, 0x61, 0xa7, 0xa0, 0x60, 0x65, 0x8e, 0x91,
                                     0x9e, 0xa0, 0xdd, 0x55, 0x88, 0x00, 0x5a, 0x4b};
    static file f;
    sf_cage *cage = NULL;
    make_vtk(&f, &vtk_kinds[0]);
    CHECK_EQ(read_cage(f.bytes, f.size, SF_CAGE_FORMAT_VTK, NULL, &cage, NULL, NULL), SF_OK);
    CHECK(memcmp(sf_cage_get_view(cage).channels[1].property.uuid, heat, 16) == 0);
    sf_cage_destroy(cage);
}

#define VTK_HEAD "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n"
#define VTK_CUBE "POINTS 8 float\n0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n"

// Voxels and pixels have their corners in rows; lines and points beside cells are passed over, and
// the data of cells skip them, too.
static void reads_other_kinds_of_vtk_cells(void)
{
    sf_cage_reading reading;
    sf_cage *cage = must_read(VTK_HEAD VTK_CUBE
                              "CELLS 3 14\n1 3 8 0 1 2 3 4 5 6 7 2 0 1\nCELL_TYPES 3\n1 11 3\n"
                              "CELL_DATA 3\nSCALARS m int\nLOOKUP_TABLE default\n5 6 7\n",
                              &reading);
    sf_cage_view view = sf_cage_get_view(cage);
    CHECK(view.dimension == 3 && view.cell_count == 1);
    CHECK_EQ(reading.passed_over, 2);
    CHECK_EQ(reading.turned_cells, 0);
    CHECK_NEAR(report_of(cage).volume_mm3, 1, 1e-15);
    CHECK(view.channel_count == 1 && view.channels[0].value_count == 1);
    CHECK(view.channels[0].values[0] == 6);
    sf_cage_destroy(cage);
    // A pixel, a polygon and a triangle.
    cage = must_read(VTK_HEAD VTK_CUBE "CELLS 3 15\n4 0 1 2 3 5 2 3 7 4 6 3 0 5 1\n"
                                       "CELL_TYPES 3\n8 7 5\n",
                     &reading);
    view = sf_cage_get_view(cage);
    CHECK(view.dimension == 2 && view.cell_count == 3);
    CHECK(view.starts[1] == 4 && view.starts[2] == 9 && view.starts[3] == 12);
    CHECK(view.corners[2] == 3 && view.corners[3] == 2);
    sf_cage_destroy(cage);
}

// A regular prism over n corners of radius 1 and height 1: n sin(2 pi / n) / 2.
static void reads_prisms(void)
{
    for (int n = 5; n <= 6; n++) {
        static file f;
        sf_cage *cage = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        double step = 6.283185307179586 / n;
        f.size = 0;
        put_text(&f, VTK_HEAD "POINTS %d double\n", 2 * n);
        for (int i = 0; i < 2 * n; i++) {
            put_text(&f, "%.17g %.17g %d\n", cos(step * i), sin(step * i), i / n);
        }
        put_text(&f, "CELLS 1 %d\n%d", 2 * n + 1, 2 * n);
        for (int i = 0; i < 2 * n; i++) {
            put_text(&f, " %d", i);
        }
        put_text(&f, "\nCELL_TYPES 1\n%d\n", n + 10);
        CHECK_EQ(read_cage(f.bytes, f.size, SF_CAGE_FORMAT_AUTO, NULL, &cage, NULL, &fault), SF_OK);
        CHECK_NEAR(report_of(cage).volume_mm3, 0.5 * n * sin(step), 1e-14);
        sf_cage_destroy(cage);
    }
}

int main(void)
{
    TEST(reads_every_kind);
    TEST(reads_short_reads);
    TEST(keeps_what_is_sharp);
    TEST(makes_properties_of_references);
    TEST(makes_cages_of_faces_where_there_are_no_cells);
    TEST(turns_what_is_plainly_inverted);
    TEST(makes_properties_of_data);
    TEST(names_foreign_properties_for_ever);
    TEST(reads_other_kinds_of_vtk_cells);
    TEST(reads_prisms);
    return test_finish();
}
