// SPDX-License-Identifier: MIT
// Slices of 3MF files become contours in their places: heights, units, transforms, stacks that are
// made of others; and what are no layers is refused. Guards: issue 8 part 1, TRUTH.md (the sliced
// torus has 797.9223 mm3 in 50 slices).

#include "stored_zip.h"

#define RING                                                                                       \
    "<s:vertices><s:vertex x=\"0\" y=\"0\"/><s:vertex x=\"4\" y=\"0\"/>"                           \
    "<s:vertex x=\"4\" y=\"4\"/><s:vertex x=\"0\" y=\"4\"/><s:vertex x=\"1\" y=\"1\"/>"            \
    "<s:vertex x=\"1\" y=\"2\"/><s:vertex x=\"3\" y=\"1\"/></s:vertices>"                          \
    "<s:polygon startv=\"0\"><s:segment v2=\"1\"/><s:segment v2=\"2\"/><s:segment v2=\"3\"/>"      \
    "<s:segment v2=\"0\"/></s:polygon>"                                                            \
    "<s:polygon startv=\"4\"><s:segment v2=\"5\"/><s:segment v2=\"6\"/><s:segment v2=\"4\"/>"      \
    "</s:polygon>"
#define RING_AREA 15.0 // a square of 16 without a triangle of 1
#define STACK(id, attributes, inside)                                                              \
    "<s:slicestack id=\"" id "\" " attributes ">" inside "</s:slicestack>"
#define SLICE(top, inside) "<s:slice ztop=\"" top "\">" inside "</s:slice>"
#define SLICED(id, stack, more)                                                                    \
    "<object id=\"" id "\" s:slicestackid=\"" stack "\" " more ">" CORNER "</object>"
#define TWO STACK("3", "zbottom=\"1\"", SLICE("1.5", RING) SLICE("2", ""))

static sf_threemf *read_archive(archive *a)
{
    sf_threemf *document = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(archive_read(a, NULL, NULL, &document, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    return document;
}

static sf_contour_stack *stack_of(const char *model)
{
    static archive a;
    sf_contour_stack *stack = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    archive_model(&a, model);
    sf_threemf *document = read_archive(&a);
    CHECK(sf_threemf_is_sliced(document));
    CHECK_EQ(sf_threemf_contours(document, NULL, &stack, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    sf_threemf_destroy(document);
    return stack;
}

static int layer_is(const sf_contour_stack *stack, uint32_t k, double bottom, double top,
                    double area, const double first[2])
{
    sf_contours contours;
    double low = 0, high = 0;
    if (sf_contour_stack_layer(stack, k, &contours, &low, &high) != SF_OK) {
        return 0;
    }
    double found = sf_contours_area_mm2(&contours);
    int good = fabs(low - bottom) < 1e-12 && fabs(high - top) < 1e-12 && fabs(found - area) < 1e-9;
    if (first != NULL) {
        good = good && fabs(contours.points_mm[0] - first[0]) < 1e-9 &&
               fabs(contours.points_mm[1] - first[1]) < 1e-9;
    }
    if (!good) {
        printf("# layer %u: %g to %g, %g mm2\n", (unsigned)k, low, high, found);
    }
    return good;
}

static void reads_slices(void)
{
    sf_contour_stack *stack = stack_of(MODEL("", TWO SLICED("1", "3", ""), ITEM("1")));
    const double first[2] = {0, 0};
    CHECK_EQ(sf_contour_stack_count(stack), 2);
    CHECK(layer_is(stack, 0, 1, 1.5, RING_AREA, first));
    CHECK(layer_is(stack, 1, 1.5, 2, 0, NULL));
    sf_contour_stack_destroy(stack);
}

// In inches, turned by a quarter, moved by (1, 2, 3) inches; and mirrored, which must not turn the
// inside out.
static void reads_units_and_transforms(void)
{
    double in = 25.4;
    sf_contour_stack *stack =
        stack_of(MODEL("unit=\"inch\"", TWO SLICED("1", "3", ""),
                       "<item objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 1 2 3\"/>"));
    const double first[2] = {in, 2 * in};
    CHECK(layer_is(stack, 0, 4 * in, 4.5 * in, RING_AREA * in * in, first));
    sf_contour_stack_destroy(stack);
    stack = stack_of(MODEL("", TWO SLICED("1", "3", ""),
                           "<item objectid=\"1\" transform=\"-2 0 0 0 1 0 0 0 1 0 0 0\"/>"));
    CHECK(layer_is(stack, 0, 1, 1.5, 2 * RING_AREA, NULL));
    sf_contour_stack_destroy(stack);
}

// Two parts of the archive, one above the other: the bottom that the second claims does not count.
static void reads_references(void)
{
    static archive a;
    sf_contour_stack *stack = NULL;
    memset(&a, 0, sizeof a);
    archive_add(&a, "_rels/.rels", RELS("/3D/3dmodel.model"));
    archive_add(&a, "3D/3dmodel.model",
                MODEL("",
                      STACK("8", "",
                            "<s:sliceref slicestackid=\"3\" slicepath=\"/2D/a.model\"/>"
                            "<s:sliceref slicestackid=\"3\" slicepath=\"/2D/b.model\"/>")
                          SLICED("1", "8", ""),
                      ITEM("1")));
    archive_add(&a, "2D/a.model", MODEL("", TWO, ""));
    archive_add(&a, "2D/b.model", MODEL("", STACK("3", "zbottom=\"2.2\"", SLICE("2.5", RING)), ""));
    archive_end(&a);
    sf_threemf *document = read_archive(&a);
    CHECK_EQ(sf_threemf_contours(document, NULL, &stack, NULL), SF_OK);
    CHECK_EQ(sf_contour_stack_count(stack), 3);
    CHECK(layer_is(stack, 0, 1, 1.5, RING_AREA, NULL));
    CHECK(layer_is(stack, 2, 2, 2.5, RING_AREA, NULL));
    sf_contour_stack_destroy(stack);
    sf_threemf_destroy(document);
}

static void joins_items(void)
{
    sf_contour_stack *stack = stack_of(
        MODEL("", TWO SLICED("1", "3", "") SLICED("2", "3", "type=\"support\""),
              ITEM("1") "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 9 0 0\"/>" ITEM("2")));
    CHECK_EQ(sf_contour_stack_count(stack), 2);
    CHECK(layer_is(stack, 0, 1, 1.5, 2 * RING_AREA, NULL));
    sf_contour_stack_destroy(stack);
}

static void refuses_what_are_no_layers(void)
{
    static const struct {
        const char *model;
        sf_status status;
        const char *words;
    } wrong[] = {
        {MODEL("", OBJECT("1", CORNER), ITEM("1")), SF_ERR_FORMAT, "no slices"},
        {MODEL("", TWO SLICED("1", "3", "") OBJECT("2", CORNER), ITEM("1") ITEM("2")),
         SF_ERR_FORMAT, "no slices"},
        {MODEL("", TWO SLICED("1", "3", "type=\"support\""), ITEM("1")), SF_ERR_FORMAT,
         "has slices"},
        {MODEL("", TWO SLICED("1", "3", ""),
               "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 2 0 0 0\"/>"),
         SF_ERR_FORMAT, "tilted"},
        {MODEL("", TWO SLICED("1", "3", ""),
               "<item objectid=\"1\" transform=\"1 0 0.1 0 1 0 0 0 1 0 0 0\"/>"),
         SF_ERR_FORMAT, "tilted"},
        {MODEL("", TWO SLICED("1", "3", ""),
               ITEM("1") "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 1\"/>"),
         SF_ERR_UNSUPPORTED, "different heights"},
        {MODEL("",
               TWO STACK("4", "zbottom=\"1\"", SLICE("1.5", "")) SLICED("1", "3", "")
                   SLICED("2", "4", ""),
               ITEM("1") ITEM("2")),
         SF_ERR_UNSUPPORTED, "different heights"},
        {MODEL("", STACK("3", "zbottom=\"1e13\"", SLICE("2e13", "")) SLICED("1", "3", ""),
               ITEM("1")),
         SF_ERR_ARGUMENT, "1e12"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        static archive a;
        sf_contour_stack *stack = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        archive_model(&a, wrong[i].model);
        sf_threemf *document = read_archive(&a);
        CHECK_EQ(sf_threemf_contours(document, NULL, &stack, &fault), wrong[i].status);
        CHECK(stack == NULL && strstr(fault.message, wrong[i].words) != NULL);
        printf("# %s\n", fault.message);
        sf_threemf_destroy(document);
    }
    sf_contour_stack *stack = NULL;
    CHECK_EQ(sf_threemf_contours(NULL, NULL, &stack, NULL), SF_ERR_ARGUMENT);
    CHECK(!sf_threemf_is_sliced(NULL));
}

// A mesh that only stands for slices is no mesh.
static void takes_no_rough_mesh(void)
{
    static archive a;
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    archive_model(&a, MODEL("requiredextensions=\"s\"",
                            TWO SLICED("1", "3", "s:meshresolution=\"lowres\""), ITEM("1")));
    sf_threemf *document = read_archive(&a);
    CHECK(sf_threemf_get_view(document).objects[0].is_rough);
    CHECK_EQ(sf_threemf_merge(document, NULL, NULL, &mesh, &fault), SF_ERR_UNSUPPORTED);
    CHECK(mesh == NULL && strstr(fault.message, "stand for its slices") != NULL);
    sf_threemf_destroy(document);
}

static void survives_failing_memory(void)
{
    static archive a;
    failing_allocator memory;
    archive_model(&a, MODEL("", TWO SLICED("1", "3", ""), ITEM("1") ITEM("1")));
    sf_threemf *document = read_archive(&a);
    long k = 0;
    for (sf_status status = SF_ERR_MEMORY; status == SF_ERR_MEMORY && k < 100; k++) {
        sf_contour_stack *stack = NULL;
        failing_begin(&memory, k);
        status = sf_threemf_contours(document, &memory.allocator, &stack, NULL);
        CHECK((status == SF_OK) == (stack != NULL));
        sf_contour_stack_destroy(stack);
        CHECK_EQ(memory.live, 0);
        CHECK_EQ(memory.faults, 0);
    }
    CHECK(k > 4 && k < 100);
    sf_threemf_destroy(document);
}

// By their areas, and as voxels of 0.02 mm.
static void measures_the_torus(void)
{
    char name[1024];
    sf_file *file = NULL;
    sf_threemf *document = NULL;
    sf_contour_stack *stack = NULL;
    double volume = 0, widest = 0;
    if (getenv("SF_DATA") == NULL || !sf_threemf_is_served()) {
        SKIP("SF_DATA names no folder, or this build reads no 3MF");
    }
    snprintf(name, sizeof name, "%s/3mf/torus_sliced.3mf", getenv("SF_DATA"));
    CHECK_EQ(sf_file_open(name, NULL, &file, NULL), SF_OK);
    CHECK_EQ(sf_threemf_read(sf_file_source(file), NULL, NULL, &document, NULL), SF_OK);
    sf_file_close(file);
    CHECK_EQ(sf_threemf_contours(document, NULL, &stack, NULL), SF_OK);
    CHECK_EQ(sf_contour_stack_count(stack), 50);
    for (uint32_t k = 0; k < sf_contour_stack_count(stack); k++) {
        sf_contours contours;
        double bottom = 0, top = 0;
        CHECK_EQ(sf_contour_stack_layer(stack, k, &contours, &bottom, &top), SF_OK);
        double area = sf_contours_area_mm2(&contours);
        CHECK_NEAR(top - bottom, 0.08, 1e-9);
        volume += area * (top - bottom);
        widest = fmax(widest, area);
    }
    printf("# %.6f mm3, widest %.4f mm2\n", volume, widest);
    CHECK_NEAR(volume, 797.9223, 1e-4);
    CHECK_NEAR(widest, 255.7412, 1e-4);
    static double heights[50];
    sf_lattice lattice;
    sf_grid *grid = NULL;
    CHECK_EQ(sf_contour_stack_lattice(stack, 0.02, 0.02, heights, 50, &lattice), SF_OK);
    CHECK_EQ(sf_grid_from_contours(stack, &lattice, SF_CONTOUR_NONZERO, NULL, NULL, &grid), SF_OK);
    double voxels = (double)sf_grid_popcount(grid) * 0.02 * 0.02 * 0.08;
    printf("# as voxels %.6f mm3\n", voxels);
    CHECK_NEAR(voxels, 797.9223, 0.05);
    sf_grid_destroy(grid);
    sf_contour_stack_destroy(stack);
    sf_threemf_destroy(document);
}

// A slice in many places is as many points as in many slices: the reading's bound holds for them.
static void bounds_what_is_placed(void)
{
    static archive a;
    archive_model(&a, MODEL("", TWO SLICED("1", "3", ""),
                            ITEM("1") ITEM("1") ITEM("1") ITEM("1") ITEM("1") ITEM("1")));
    for (size_t most = 40; most < 60; most++) { // 6 times 7 points and 2 slices
        sf_read_limits limits = sf_read_limits_default();
        sf_threemf *document = NULL;
        sf_contour_stack *stack = NULL;
        sf_fault fault = {SF_OK, 0, 0, ""};
        limits.vertices_max = most;
        CHECK_EQ(archive_read(&a, &limits, NULL, &document, NULL), SF_OK);
        sf_status status = sf_threemf_contours(document, NULL, &stack, &fault);
        CHECK_EQ(status, most < 6 * 9 ? SF_ERR_OVERFLOW : SF_OK);
        CHECK((stack == NULL) == (status != SF_OK));
        CHECK(status == SF_OK || strstr(fault.message, "vertices_max") != NULL);
        sf_contour_stack_destroy(stack);
        sf_threemf_destroy(document);
    }
}

// References to nothing, which a walk would pass again and again for every place.
static void refuses_references_to_nothing(void)
{
    static archive a;
    memset(&a, 0, sizeof a);
    archive_add(&a, "_rels/.rels", RELS("/3D/3dmodel.model"));
    archive_add(&a, "3D/3dmodel.model",
                MODEL("",
                      STACK("8", "", "<s:sliceref slicestackid=\"3\" slicepath=\"/2D/a.model\"/>")
                          SLICED("1", "8", ""),
                      ITEM("1")));
    archive_add(&a, "2D/a.model", MODEL("", STACK("3", "", ""), ""));
    archive_end(&a);
    CHECK(refused(&a, NULL, SF_ERR_FORMAT, "leads to none"));
}

int main(void)
{
    TEST(measures_the_torus);
    if (!sf_threemf_is_served()) {
        return test_finish();
    }
    TEST(reads_slices);
    TEST(reads_units_and_transforms);
    TEST(reads_references);
    TEST(joins_items);
    TEST(refuses_what_are_no_layers);
    TEST(bounds_what_is_placed);
    TEST(refuses_references_to_nothing);
    TEST(takes_no_rough_mesh);
    TEST(survives_failing_memory);
    return test_finish();
}
