// SPDX-License-Identifier: MIT
// The 3MF files of other programs: counts, bounds and volumes that were measured by another reader,
// and of those that require what is not read, each is refused with a sentence. Guards: issue 8
// (TRUTH.md). The procedural twins are in threemf_read and threemf_refuse.

#include <sf/threemf.h>

#include "test.h"

static const struct known {
    const char *path;
    size_t triangles; // 0: must be refused
    size_t colours;
    double volume; // 0: not measured
    double low[3], high[3];
} files[] = {
    {"3mf/dodeca_chain_loop_color.3mf",
     7680,
     9,
     32583.87867,
     {1.58698, 3.96245, 1.59398},
     {221.461, 144.637, 17.594}},
    {"3mf/heartgears.3mf",
     30636,
     0,
     0,
     {0.00118637, 0.00637054, 0.00279617},
     {79.5723, 47.6736, 76.435}},
    {"3mf/pyramid_vertexcolor.3mf", 4, 4, 333.3333333, {0, 0, 0}, {10, 10, 10}},
    {"3mf/seam_test_object.3mf",
     225154,
     0,
     15550.531,
     {94.9995, 89.498, 0},
     {155.0005, 120.502, 48}},
    {"3mf/torus_sliced.3mf",
     12,
     0,
     2347.303392,
     {33.0327, 31.5338, 14.967},
     {57.2807, 55.7348, 18.967}},
    {"3mf/SphereInACage.3mf", 0, 0, 0, {0, 0, 0}, {0, 0, 0}},
    {"3mf/SphereInACage_small.imagestack.3mf", 0, 0, 0, {0, 0, 0}, {0, 0, 0}},
    {"3mf/variable_voronoi.3mf", 0, 0, 0, {0, 0, 0}, {0, 0, 0}},
    {"parts/3DBenchy.3mf", 225154, 0, 0, {-29.176, -15.502, 0}, {30.825, 15.502, 48}},
};

static sf_status read_file(const char *path, sf_threemf **document, sf_fault *fault)
{
    char name[1024];
    sf_file *file = NULL;
    snprintf(name, sizeof name, "%s/%s", getenv("SF_DATA"), path);
    sf_status status = sf_file_open(name, NULL, &file, fault);
    if (status == SF_OK) {
        status = sf_threemf_read(sf_file_source(file), NULL, NULL, document, fault);
        sf_file_close(file);
    }
    return status;
}

static void check_file(const struct known *k, const sf_threemf *document)
{
    sf_mesh *mesh = NULL;
    sf_mass mass;
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    CHECK_EQ(sf_threemf_get_view(document).colour_count, k->colours);
    CHECK_EQ(sf_threemf_merge(document, NULL, NULL, &mesh, NULL), SF_OK);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    CHECK_EQ(view.triangle_count, k->triangles);
    if (k->volume > 0) {
        CHECK_EQ(sf_mesh_measure(view, &mass), SF_OK);
        CHECK_NEAR(mass.volume_mm3, k->volume, 1e-8 * k->volume);
    }
    CHECK_EQ(sf_mesh_bounds(view, low, high), SF_OK);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(low[i], k->low[i], 1e-3);
        CHECK_NEAR(high[i], k->high[i], 1e-3);
    }
    sf_mesh_destroy(mesh);
}

static void reads_what_others_wrote(void)
{
    if (getenv("SF_DATA") == NULL || !sf_threemf_is_served()) {
        SKIP("SF_DATA names no folder, or this build reads no 3MF");
    }
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        const struct known *k = &files[i];
        sf_threemf *document = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        sf_status status = read_file(k->path, &document, &fault);
        printf("# %s: %s\n", k->path, fault.message);
        CHECK_EQ(status, k->triangles > 0 ? SF_OK : SF_ERR_UNSUPPORTED);
        if (status == SF_OK) {
            check_file(k, document);
        } else {
            CHECK(strstr(fault.message, "requires") != NULL && fault.line > 0);
        }
        sf_threemf_destroy(document);
    }
}

// The corners of the pyramid have the colours that its file gives them, triangle by triangle.
static void reads_a_colour_for_each_corner(void)
{
    static const uint32_t expected[12] = {0, 1, 2, 2, 1, 3, 0, 2, 3, 0, 3, 1};
    sf_threemf *document = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    if (getenv("SF_DATA") == NULL || !sf_threemf_is_served()) {
        SKIP("SF_DATA names no folder, or this build reads no 3MF");
    }
    CHECK_EQ(read_file("3mf/pyramid_vertexcolor.3mf", &document, &fault), SF_OK);
    sf_threemf_view view = sf_threemf_get_view(document);
    CHECK_EQ(view.object_count, 1);
    CHECK(view.object_count == 1 && view.objects[0].colours != NULL &&
          memcmp(view.objects[0].colours, expected, sizeof expected) == 0);
    sf_threemf_destroy(document);
}

int main(void)
{
    TEST(reads_what_others_wrote);
    TEST(reads_a_colour_for_each_corner);
    return test_finish();
}
