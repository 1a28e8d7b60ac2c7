// SPDX-License-Identifier: MIT
// Every format, every variant: the unit cube must come out as twelve triangles of volume one,
// whatever the file around it looks like. Guards: issue 2 part 4 (readers), the procedural twins of
// shared/data.

#include "files.h"

static double volume(const sf_mesh *mesh)
{
    sf_mass mass;
    return sf_mesh_measure(sf_mesh_get_view(mesh), &mass) == SF_OK ? mass.volume_mm3 : -1.0;
}

static int is_cube(const file *f, sf_mesh_format format, const char *what)
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = read_bytes(f->bytes, f->size, format, NULL, NULL, &mesh, &fault);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    int good = status == SF_OK && view.triangle_count == 12 && fabs(volume(mesh) - 1.0) < 1e-12;
    if (!good) {
        printf("# %s: %s, %zu triangles, volume %g, \"%s\"\n", what, sf_status_name(status),
               view.triangle_count, volume(mesh), fault.message);
    }
    sf_mesh_destroy(mesh);
    return good;
}

static void reads_every_kind(void)
{
    static file f;
    const char *what;
    for (size_t i = 0; (what = make_any(&f, i)) != NULL; i++) {
        CHECK(is_cube(&f, SF_MESH_FORMAT_AUTO, what));
    }
}

static void reads_short_reads(void)
{
    static file f;
    for (size_t i = 0; make_any(&f, i) != NULL; i++) {
        sf_memory_cursor cursor = {f.bytes, f.size, 0};
        sf_source slow = {read_one_byte, &cursor};
        sf_mesh *mesh = NULL;
        CHECK_EQ(sf_mesh_read(slow, SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, NULL), SF_OK);
        CHECK_NEAR(volume(mesh), 1.0, 1e-12);
        sf_mesh_destroy(mesh);
    }
}

static int text_is(const char *text, sf_mesh_format format, size_t vertices, size_t triangles)
{
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = read_bytes(text, strlen(text), format, NULL, NULL, &mesh, &fault);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    int good = status == SF_OK && view.vertex_count == vertices && view.triangle_count == triangles;
    if (!good) {
        printf("# %s: %s, %zu vertices, %zu triangles, \"%s\"\n", text, sf_status_name(status),
               view.vertex_count, view.triangle_count, fault.message);
    }
    sf_mesh_destroy(mesh);
    return good;
}

static void reads_odd_but_valid_text(void)
{
    // No line end at the end, tabs, capitals, words that are in no specification.
    CHECK(
        text_is("SOLID\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVertex\t1 0 0\nvertex 0 +1. "
                ".0e0\nENDLOOP foo\nENDFACET bar\nENDSOLID some blah",
                SF_MESH_FORMAT_AUTO, 3, 1));
    CHECK(text_is("v 0 0 0 1\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0\nl 1 2\nfo 1 2 3", SF_MESH_FORMAT_AUTO,
                  3, 1));
    CHECK(text_is("v 0 0 0\nv 1 0 0\nv 1 1 0\nv .5 2 0\nv 0 1 0\nf 1 2 3 4 5\n",
                  SF_MESH_FORMAT_AUTO, 5, 3));
    CHECK(text_is("OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2", SF_MESH_FORMAT_AUTO, 3, 1));
    CHECK(text_is("STCNOFF\n3 1 0\n0 0 0 9 9\n1 0 0\n0 1 0\n3 0 1 2\n", SF_MESH_FORMAT_AUTO, 3, 1));
    // Lines that end in a return alone, and a mark in front.
    CHECK(text_is("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", SF_MESH_FORMAT_AUTO, 3, 1));
    CHECK(text_is("g x\rv 0 0 0\rv 1 0 0\r\rv 0 1 0\rf 1 2 3", SF_MESH_FORMAT_AUTO, 3, 1));
    CHECK(text_is("\xef\xbb\xbfv 0 0 0\r\nv 1 0 0\nv 0 1 0\nf 1 2 3", SF_MESH_FORMAT_AUTO, 3, 1));
    CHECK(text_is("\xef\xbb\xbfsolid\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendsolid",
                  SF_MESH_FORMAT_AUTO, 3, 1));
    // Corners listed twice, under both names: the first list counts.
    CHECK(text_is("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float "
                  "y\nproperty float z\nelement face 1\nproperty list uchar int vertex_index\n"
                  "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
                  "3 0 1 2 3 0 1 2\n",
                  SF_MESH_FORMAT_AUTO, 3, 1));
    // A name that is a keyword, and a comment with numbers.
    CHECK(text_is("solid endsolid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendsolid\n",
                  SF_MESH_FORMAT_STL, 3, 1));
    CHECK(text_is("#v 1\nv 0 0 0\nv 1 0 0 # two\nv 0 1 0\nf 1 2 3 # f 4 5 6\n", SF_MESH_FORMAT_OBJ,
                  3, 1));
}

static void keeps_every_digit(void)
{
    // A number of 300 digits is one number, not two and not a shorter one.
    static char text[1024];
    strcpy(text, "v ");
    memset(text + 2, '0', 300);
    strcpy(text + 302, "7.25 0 0\nv 1 0.1 0\nv 0 1e-3 123456789.123456789\nf 1 2 3\n");
    sf_mesh *mesh = NULL;
    CHECK_EQ(read_bytes(text, strlen(text), SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, NULL), SF_OK);
    if (mesh != NULL) {
        const double *p = sf_mesh_get_view(mesh).vertices;
        CHECK(p[0] == 7.25 && p[4] == 0.1 && p[7] == 1e-3 && p[8] == 123456789.123456789);
    }
    sf_mesh_destroy(mesh);
}

static void names_formats_by_extension(void)
{
    CHECK_EQ(sf_mesh_format_from_name("a/b.c/part.StL"), SF_MESH_FORMAT_STL);
    CHECK_EQ(sf_mesh_format_from_name("x.obj"), SF_MESH_FORMAT_OBJ);
    CHECK_EQ(sf_mesh_format_from_name(".PLY"), SF_MESH_FORMAT_PLY);
    CHECK_EQ(sf_mesh_format_from_name("x.off"), SF_MESH_FORMAT_OFF);
    CHECK_EQ(sf_mesh_format_from_name("x.3MF"), SF_MESH_FORMAT_THREEMF);
    CHECK_EQ(sf_mesh_format_from_name("stl"), SF_MESH_FORMAT_AUTO);
    CHECK_EQ(sf_mesh_format_from_name("x.stl.gz"), SF_MESH_FORMAT_AUTO);
    CHECK_EQ(sf_mesh_format_from_name(""), SF_MESH_FORMAT_AUTO);
    CHECK_EQ(sf_mesh_format_from_name(NULL), SF_MESH_FORMAT_AUTO);
}

int main(void)
{
    TEST(reads_every_kind);
    TEST(reads_short_reads);
    TEST(reads_odd_but_valid_text);
    TEST(keeps_every_digit);
    TEST(names_formats_by_extension);
    return test_finish();
}
