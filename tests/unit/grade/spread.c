// SPDX-License-Identifier: MIT
// Why: a property that is painted on a surface has to be something inside. What is linear where it
// is fixed must be linear everywhere; nothing may leave what is fixed; and a shell between two
// spheres must have what a formula says, better on finer voxels. Tetrahedra of voxels must fill
// them and conform. Guards: issue 8 part 6, the strong guarantee.

#include "failing_allocator.h"
#include "test.h"

#include <sf/tetra.h>

static sf_property shade(void)
{
    sf_property p;
    CHECK_EQ(sf_property_named("shade", &p), SF_OK);
    return p;
}

static sf_tets *cut(const sf_grid *grid)
{
    sf_property p = shade();
    sf_tets *tets = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_tets_of_grid(grid, &p, NULL, &tets, &fault), SF_OK);
    return tets;
}

static sf_grid *random_grid(double part)
{
    static const double heights[6] = {1, 0.5, 0.7, 1, 2, 1};
    sf_lattice l = {7, 5, 6, 1, 0.8, 1, heights, {10, -20, 3}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < 6; k++) {
        for (uint32_t i = 0; i < 35; i++) {
            sf_rect one = {i % 7, i / 7, i % 7 + 1, i / 7 + 1};
            CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), one, test_random_unit() < part), SF_OK);
        }
    }
    return grid;
}

static void voxels_are_filled(void)
{
    for (int i = 0; i < 20; i++) {
        sf_grid *grid = random_grid(i == 0 ? 1 : 0.5);
        sf_tets *tets = cut(grid);
        sf_tets_report report;
        double volume = 0;
        for (uint32_t k = 0; k < 6; k++) {
            sf_lattice l = sf_grid_lattice(grid);
            sf_slice s = sf_grid_slice(grid, k);
            for (uint32_t y = 0; y < 5; y++) {
                for (uint32_t x = 0; x < 7; x++) {
                    volume += (double)(s.words[y * s.stride] >> x & 1) * 0.8 *
                              sf_lattice_layer_height(&l, k);
                }
            }
        }
        CHECK_EQ(sf_tets_check(tets, NULL, &report), SF_OK);
        CHECK_NEAR(report.volume_mm3, volume, 1e-9);
        CHECK(report.inverted == 0 && report.crowded_faces == 0);
        sf_tets_destroy(tets);
        sf_grid_destroy(grid);
    }
}

// Whether a point lies in the lattice's box's border.
static int is_outer(const double p[3])
{
    return p[0] < 10.1 || p[0] > 16.9 || p[1] < -19.9 || p[1] > -16.1 || p[2] < 3.1 || p[2] > 9.1;
}

static void what_is_linear_stays_so(void)
{
    sf_grid *grid = random_grid(1);
    sf_tets *tets = cut(grid);
    sf_tets_view v = sf_tets_get_view(tets);
    uint8_t *fixed = calloc(v.point_count, 1);
    double *values = calloc(v.point_count, sizeof *values);
    sf_spread_report report;
    for (size_t i = 0; i < v.point_count; i++) {
        const double *p = v.positions + 3 * i;
        fixed[i] = is_outer(p) != 0;
        values[i] = fixed[i] ? 2 * p[0] - 3 * p[1] + 0.5 * p[2] - 7 : 50;
    }
    CHECK_EQ(sf_tets_set_values(tets, 0, 0, v.point_count, values), SF_OK);
    CHECK_EQ(sf_tets_spread(tets, 0, fixed, NULL, NULL, &report), SF_OK);
    v = sf_tets_get_view(tets);
    size_t free_points = 0;
    for (size_t i = 0; i < v.point_count; i++) {
        const double *p = v.positions + 3 * i;
        CHECK_NEAR(v.channels[0].values[i], 2 * p[0] - 3 * p[1] + 0.5 * p[2] - 7, 1e-8);
        free_points += !fixed[i];
    }
    CHECK(free_points == 6 * 4 * 5 && report.fixed == v.point_count - free_points);
    CHECK(report.iterations > 3 && report.residual <= 1e-11);
    free(fixed);
    free(values);
    sf_tets_destroy(tets);
    sf_grid_destroy(grid);
}

// Between spheres of radii 1 and 2 at 0 and 1 the property is 2 - 2 / r.
static double shell_error(uint32_t cells)
{
    sf_lattice l = {cells,       cells,       cells, 4.2 / cells,
                    4.2 / cells, 4.2 / cells, NULL,  {-2.1, -2.1, -2.1}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < cells; k++) {
        for (uint32_t i = 0; i < cells * cells; i++) {
            sf_rect one = {i % cells, i / cells, i % cells + 1, i / cells + 1};
            double x = -2.1 + (i % cells + 0.5) * l.layer_mm,
                   y = -2.1 + (i / cells + 0.5) * l.layer_mm;
            double z = -2.1 + (k + 0.5) * l.layer_mm, r = sqrt(x * x + y * y + z * z);
            CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), one, r > 0.7 && r < 2.09), SF_OK);
        }
    }
    sf_tets *tets = cut(grid);
    sf_tets_view v = sf_tets_get_view(tets);
    uint8_t *fixed = calloc(v.point_count, 1);
    double *values = calloc(v.point_count, sizeof *values), worst = 0;
    for (size_t i = 0; i < v.point_count; i++) {
        const double *p = v.positions + 3 * i;
        double r = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        fixed[i] = r < 1 || r > 1.9;
        values[i] = fixed[i] ? 2 - 2 / r : 0; // as it is there, so that steps do no harm
    }
    CHECK_EQ(sf_tets_set_values(tets, 0, 0, v.point_count, values), SF_OK);
    CHECK_EQ(sf_tets_spread(tets, 0, fixed, NULL, NULL, NULL), SF_OK);
    v = sf_tets_get_view(tets);
    for (size_t i = 0; i < v.point_count; i++) {
        const double *p = v.positions + 3 * i;
        double r = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        worst = fmax(worst, fixed[i] ? 0 : fabs(v.channels[0].values[i] - (2 - 2 / r)));
    }
    free(fixed);
    free(values);
    sf_tets_destroy(tets);
    sf_grid_destroy(grid);
    return worst;
}

static void a_shell_is_what_the_formula_says(void)
{
    double coarse = shell_error(20), fine = shell_error(40);
    printf("# largest error %g, on voxels of half the size %g\n", coarse, fine);
    CHECK(coarse < 0.02 && fine < 0.4 * coarse);
}

// Random voxels hang together or not: nothing leaves the range of what is fixed, which is kept.
static void nothing_leaves_the_range(void)
{
    for (int i = 0; i < 20; i++) {
        sf_grid *grid = random_grid(0.4);
        sf_tets *tets = cut(grid);
        sf_tets_view v = sf_tets_get_view(tets);
        uint8_t *fixed = calloc(v.point_count, 1);
        double *values = calloc(v.point_count, sizeof *values);
        for (size_t p = 0; p < v.point_count; p++) {
            fixed[p] = p == 0 || test_random_unit() < 0.1;
            values[p] = fixed[p] ? test_random_unit() : 100 * test_random_unit();
        }
        CHECK_EQ(sf_tets_set_values(tets, 0, 0, v.point_count, values), SF_OK);
        CHECK_EQ(sf_tets_spread(tets, 0, fixed, NULL, NULL, NULL), SF_OK);
        v = sf_tets_get_view(tets);
        for (size_t p = 0; p < v.point_count; p++) {
            double is = v.channels[0].values[p];
            CHECK(is >= 0 && is <= 1 && (!fixed[p] || is == values[p]));
        }
        free(fixed);
        free(values);
        sf_tets_destroy(tets);
        sf_grid_destroy(grid);
    }
}

static void refuses_and_leaves_nothing_behind(void)
{
    sf_grid *grid = random_grid(1), *empty = random_grid(0);
    sf_property p = shade();
    sf_tets *tets = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_tets_of_grid(empty, &p, NULL, &tets, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "no solid") != NULL);
    CHECK_EQ(sf_tets_of_grid(NULL, &p, NULL, &tets, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_tets_of_grid(grid, NULL, NULL, &tets, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_tets_of_grid(grid, &p, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_status status = SF_ERR_MEMORY;
    failing_allocator memory;
    for (long k = 0; status != SF_OK && k < 100; k++) {
        failing_begin(&memory, k);
        status = sf_tets_of_grid(grid, &p, &memory.allocator, &tets, NULL);
        CHECK((status == SF_OK) == (tets != NULL) && (status == SF_OK || memory.live == 0));
    }
    sf_tets_destroy(tets);
    CHECK(status == SF_OK && memory.live == 0 && memory.faults == 0);
    tets = cut(grid);
    size_t count = sf_tets_get_view(tets).point_count;
    uint8_t *fixed = calloc(count, 1);
    CHECK_EQ(sf_tets_spread(tets, 0, fixed, NULL, NULL, NULL), SF_ERR_ARGUMENT); // nothing is fixed
    fixed[0] = 1;
    CHECK_EQ(sf_tets_spread(tets, 1, fixed, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_tets_spread(tets, 0, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_tets_spread(NULL, 0, fixed, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    double five = 5;
    sf_task task = sf_task_default();
    CHECK_EQ(sf_tets_set_values(tets, 0, 0, 1, &five), SF_OK);
    fixed[count - 1] = 1;
    sf_task_cancel(&task);
    CHECK_EQ(sf_tets_spread(tets, 0, fixed, NULL, &task, NULL), SF_ERR_CANCELLED);
    for (long k = 0; k < 2; k++) {
        failing_begin(&memory, k);
        CHECK_EQ(sf_tets_spread(tets, 0, fixed, &memory.allocator, NULL, NULL), SF_ERR_MEMORY);
        CHECK(memory.live == 0 && sf_tets_get_view(tets).channels[0].values[1] == 0);
    }
    free(fixed);
    sf_tets_destroy(tets);
    sf_grid_destroy(grid);
    sf_grid_destroy(empty);
}

int main(void)
{
    TEST(voxels_are_filled);
    TEST(what_is_linear_stays_so);
    TEST(a_shell_is_what_the_formula_says);
    TEST(nothing_leaves_the_range);
    TEST(refuses_and_leaves_nothing_behind);
    return test_finish();
}
