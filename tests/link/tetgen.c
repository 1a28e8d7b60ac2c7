// SPDX-License-Identifier: MIT
// Why: TetGen's tetrahedra are to fill the surface that they were asked for, conform, and carry
// inside what is painted outside. What is linear on the surface must be linear inside, a known
// solution near what it is, and what TetGen cannot do must end in a sentence. Guards: issue 8
// part 6.

#include <sf/io.h>
#include <sf/link/tetgen.h>

#include "../failing_allocator.h"
#include "../test.h"

static const double box_points[24] = {0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0,
                                      0, 0, 5, 2, 0, 5, 2, 3, 5, 0, 3, 5};
static const uint32_t box_corners[36] = {0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                         1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
static const sf_mesh_view box = {box_points, 8, box_corners, 12};

static sf_tets *fill(sf_mesh_view mesh, const sf_tetgen_options *options)
{
    sf_tets *tets = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_tetgen_fill(mesh, options, NULL, NULL, &tets, &fault), SF_OK);
    if (tets == NULL) {
        printf("# %s\n", fault.message);
    }
    return tets;
}

static void check_filled(const sf_tets *tets, double volume, double tolerance)
{
    sf_tets_report report = {0};
    CHECK_EQ(sf_tets_check(tets, NULL, &report), SF_OK);
    printf("# %zu tetrahedra, volume %.9g of %.9g\n", sf_tets_get_view(tets).tet_count,
           report.volume_mm3, volume);
    CHECK_NEAR(report.volume_mm3, volume, tolerance);
    CHECK(report.inverted == 0 && report.crowded_faces == 0);
}

static void a_box_is_filled_and_stays_linear(void)
{
    double values[8];
    sf_property shade;
    sf_tetgen_options options = sf_tetgen_options_default();
    CHECK_EQ(sf_property_named("shade", &shade), SF_OK);
    for (int i = 0; i < 8; i++) {
        const double *p = box_points + 3 * i;
        values[i] = 2 * p[0] - 3 * p[1] + 0.5 * p[2] - 7;
    }
    options.values = values;
    options.property = &shade;
    options.most_mm3 = 0.05;
    sf_tets *tets = fill(box, &options);
    check_filled(tets, 30, 1e-9);
    sf_tets_view v = sf_tets_get_view(tets);
    CHECK(v.channel_count == 1 && strcmp(v.channels[0].property.name, "shade") == 0);
    double worst = 0;
    for (size_t i = 0; i < v.point_count && v.channel_count == 1; i++) {
        const double *p = v.positions + 3 * i;
        double is = v.channels[0].values[i];
        worst = fmax(worst, fabs(is - (2 * p[0] - 3 * p[1] + 0.5 * p[2] - 7)));
    }
    printf("# %zu points, linear within %g\n", v.point_count, worst);
    CHECK(v.point_count > 300 && worst < 1e-8);
    sf_tets_destroy(tets);
    tets = fill(box, NULL);
    CHECK_EQ(sf_tets_get_view(tets).channel_count, 0);
    sf_tets_destroy(tets);
}

// A ball of voxels' surface, smoothed, painted with x^2 - y^2 + 2 z, which is harmonic.
static void a_ball_is_harmonic_inside(void)
{
    sf_lattice l = {24, 24, 24, 1, 1, 1, NULL, {-12, -12, -12}};
    sf_surface_options how = sf_surface_options_default();
    sf_grid *grid = NULL;
    sf_mesh *mesh = NULL;
    sf_mass mass;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < 24; k++) {
        for (uint32_t i = 0; i < 576; i++) {
            double x = i % 24 - 11.5, y = i / 24 - 11.5, z = k - 11.5;
            sf_rect one = {i % 24, i / 24, i % 24 + 1, i / 24 + 1};
            CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), one, x * x + y * y + z * z < 81), SF_OK);
        }
    }
    how.smooth_passes = 10;
    CHECK_EQ(sf_grid_surface(grid, &how, NULL, NULL, &mesh), SF_OK);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    double *values = calloc(view.vertex_count, sizeof *values);
    sf_property shade;
    sf_tetgen_options options = sf_tetgen_options_default();
    CHECK_EQ(sf_property_named("shade", &shade), SF_OK);
    for (size_t i = 0; i < view.vertex_count; i++) {
        const double *p = view.vertices + 3 * i;
        values[i] = p[0] * p[0] - p[1] * p[1] + 2 * p[2];
    }
    options.values = values;
    options.property = &shade;
    sf_tets *tets = fill(view, &options);
    CHECK_EQ(sf_mesh_measure(view, &mass), SF_OK);
    check_filled(tets, mass.volume_mm3, 1e-6);
    sf_tets_view v = sf_tets_get_view(tets);
    double worst = 0;
    for (size_t i = 0; i < v.point_count; i++) {
        const double *p = v.positions + 3 * i;
        worst = fmax(worst, fabs(v.channels[0].values[i] - (p[0] * p[0] - p[1] * p[1] + 2 * p[2])));
    }
    printf("# of a range of 160, at most %g off\n", worst);
    CHECK(worst < 2);
    free(values);
    sf_tets_destroy(tets);
    sf_mesh_destroy(mesh);
    sf_grid_destroy(grid);
}

static void models_are_filled(void)
{
    static const char *const paths[] = {"characters/spot_low_resolution.obj",
                                        "parts/cube_with_concave_hole_enlarged_standing.obj"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA names no folder");
    }
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        char path[1024];
        sf_file *file = NULL;
        sf_mesh *mesh = NULL;
        sf_mass mass;
        snprintf(path, sizeof path, "%s/%s", getenv("SF_DATA"), paths[i]);
        CHECK_EQ(sf_file_open(path, NULL, &file, NULL), SF_OK);
        CHECK_EQ(sf_mesh_read(sf_file_source(file), SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, NULL),
                 SF_OK);
        sf_file_close(file);
        CHECK_EQ(sf_mesh_measure(sf_mesh_get_view(mesh), &mass), SF_OK);
        sf_tets *tets = fill(sf_mesh_get_view(mesh), NULL);
        check_filled(tets, fabs(mass.volume_mm3), 1e-6 * fabs(mass.volume_mm3));
        sf_tets_destroy(tets);
        sf_mesh_destroy(mesh);
    }
}

static sf_status refused(sf_mesh_view mesh, const sf_tetgen_options *options, const char *words)
{
    sf_tets *tets = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_tetgen_fill(mesh, options, NULL, NULL, &tets, &fault);
    CHECK(tets == NULL && strstr(fault.message, words) != NULL);
    if (strstr(fault.message, words) == NULL) {
        printf("# %s: %s\n", sf_status_name(status), fault.message);
    }
    return status;
}

static void refuses(void)
{
    sf_mesh_view open = {box_points, 8, box_corners, 11};
    sf_tetgen_options options = sf_tetgen_options_default();
    sf_property density = sf_property_density();
    double values[8] = {1, 1, 1, 1, -1, 1, 1, 1}, through[48];
    uint32_t both[72];
    CHECK_EQ(refused(open, NULL, "not closed"), SF_ERR_UNSUPPORTED);
    for (int i = 0; i < 24; i++) { // a second box that sticks out of the first
        through[i] = box_points[i];
        through[24 + i] = box_points[i] + (i % 3 == 0 ? 1.1 : 0.6);
    }
    for (int i = 0; i < 36; i++) {
        both[i] = box_corners[i];
        both[36 + i] = box_corners[i] + 8;
    }
    sf_mesh_view crossing = {through, 16, both, 24};
    CHECK_EQ(refused(crossing, NULL, "through itself"), SF_ERR_UNSUPPORTED);
    options.values = values;
    CHECK_EQ(refused(box, &options, "property"), SF_ERR_ARGUMENT);
    options.property = &density;
    CHECK_EQ(refused(box, &options, "vertex 4"), SF_ERR_ARGUMENT);
    for (int i = 0; i < 8; i++) {
        values[i] = NAN;
    }
    CHECK_EQ(refused(box, &options, "no vertex"), SF_ERR_ARGUMENT);
    options = sf_tetgen_options_default();
    options.quality = 1;
    CHECK_EQ(refused(box, &options, "quality"), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_tetgen_fill(box, NULL, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
}

static void survives_every_refused_allocation(void)
{
    sf_status status = SF_ERR_MEMORY;
    sf_tetgen_options options = sf_tetgen_options_default();
    double values[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    sf_property density = sf_property_density();
    options.values = values;
    options.property = &density;
    options.most_mm3 = 5;
    for (long k = 0; status != SF_OK && k < 200; k++) {
        sf_tets *tets = NULL;
        failing_allocator memory;
        failing_begin(&memory, k);
        status = sf_tetgen_fill(box, &options, &memory.allocator, NULL, &tets, NULL);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && tets == NULL));
        sf_tets_destroy(tets);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
}

static void stops(void)
{
    sf_tets *tets = NULL;
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_tetgen_fill(box, NULL, NULL, &task, &tets, NULL), SF_ERR_CANCELLED);
    CHECK(tets == NULL);
}

int main(void)
{
    TEST(a_box_is_filled_and_stays_linear);
    TEST(a_ball_is_harmonic_inside);
    TEST(models_are_filled);
    TEST(refuses);
    TEST(survives_every_refused_allocation);
    TEST(stops);
    return test_finish();
}
