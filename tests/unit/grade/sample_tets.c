// SPDX-License-Identifier: MIT
// Why: tetrahedra are the other way to print a cage, and the one for shapes that others cut: their
// slices must be nearly those of the limit, their volumes come to it, and what a voxel has must be
// the first tetrahedron's that holds it, interpolated, with nothing left out. Guards: issue 5
// (sample, tetra), the exchange of other programs.

#include "failing_allocator.h"
#include "slices.h"

// A kind of cage by its tetrahedra and straight from its limit: nearly the same voxels, and where
// both have one nearly the same property.
static void tetrahedra_come_to_the_same(void)
{
    uint64_t solid = 0, differ = 0, filled = 0;
    double worst = 0;
    for (int kind = 0; kind < 5; kind += 4) {
        test_cage c = kind_of(kind);
        if (kind > 0) {
            test_cage straight = test_cage_wheel(8, 3, 0);
            memcpy(c.positions, straight.positions, 3 * c.points * sizeof *c.positions);
            test_cage_free(&straight);
        }
        sf_cage *cage = test_cage_make(&c);
        sf_refine_options options = sf_refine_options_default();
        options.steps = 4;
        sf_refinement *r = NULL;
        sf_tets *tets = NULL;
        sf_sampler *a = NULL, *b = NULL;
        sf_grid *grid = NULL, *other = NULL;
        size_t zero = 0;
        sf_lattice l = lattice_around(&c, 0.08);
        sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
        CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_OK);
        CHECK_EQ(sf_tets_of_refinement(r, 4, NULL, &tets), SF_OK);
        a = sampler_of(limit, &l, 1);
        CHECK_EQ(sf_sampler_of_tets(tets, &l, 1, &zero, NULL, &b, NULL), SF_OK);
        CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
        CHECK_EQ(sf_grid_create(&l, NULL, &other), SF_OK);
        double *p = calloc((size_t)l.nx * l.ny, sizeof *p), *q = calloc((size_t)l.nx * l.ny, 8);
        for (uint32_t k = l.nz; k-- > 0;) {
            sf_slice s = sf_grid_slice(grid, k), t = sf_grid_slice(other, k);
            CHECK_EQ(sf_sampler_slice(a, k, s, &p), SF_OK);
            CHECK_EQ(sf_sampler_slice(b, k, t, &q), SF_OK);
            for (uint32_t i = 0; i < l.nx * l.ny; i++) {
                int x = bit(s, i % l.nx, i / l.nx), y = bit(t, i % l.nx, i / l.nx);
                differ += x != y;
                worst = x && y ? fmax(worst, fabs(p[i] - q[i])) : worst;
            }
        }
        sf_sample_report report;
        CHECK_EQ(sf_sampler_report(b, &report), SF_OK);
        solid += report.solid;
        filled += report.filled;
        free(p);
        free(q);
        sf_grid_destroy(grid);
        sf_grid_destroy(other);
        sf_sampler_destroy(a);
        sf_sampler_destroy(b);
        sf_tets_destroy(tets);
        sf_refinement_destroy(r);
        sf_limit_destroy(limit);
        sf_cage_destroy(cage);
        test_cage_free(&c);
    }
    printf("# of %llu voxels %llu differ, properties of 0 to 1 at most %.2g apart; %llu filled\n",
           (unsigned long long)solid, (unsigned long long)differ, worst,
           (unsigned long long)filled);
    CHECK(solid > 10000 && differ < solid / 200 && worst < 0.01 && filled < solid / 1000);
}

// The volume of a limit: its voxels are counted.
static double counted_volume(const test_cage *c, double pitch)
{
    sf_lattice l = lattice_around(c, pitch), one = l;
    sf_limit *limit = limit_of(c, SF_REFINE_STANDARD);
    sf_sampler *sampler = sampler_of(limit, &l, 0);
    sf_sample_report report;
    sf_grid *grid = NULL;
    one.nz = 1;
    CHECK_EQ(sf_grid_create(&one, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < l.nz; k++) {
        CHECK_EQ(sf_sampler_slice(sampler, k, sf_grid_slice(grid, 0), NULL), SF_OK);
    }
    CHECK_EQ(sf_sampler_report(sampler, &report), SF_OK);
    sf_grid_destroy(grid);
    sf_sampler_destroy(sampler);
    sf_limit_destroy(limit);
    return (double)report.solid * l.pitch_x_mm * l.pitch_y_mm * l.layer_mm;
}

// A step makes cells half as long, and what a straight side leaves out a quarter.
static void volumes_of_tetrahedra_come_to_the_counted_one(void)
{
    for (int kind = 0; kind < 5; kind += 4) {
        test_cage c = kind_of(kind);
        sf_cage *cage = test_cage_make(&c);
        sf_refine_options options = sf_refine_options_default();
        sf_refinement *r = NULL;
        options.steps = 4;
        double counted = counted_volume(&c, 0.02), apart[5] = {0};
        CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_OK);
        for (uint32_t step = 1; step <= options.steps; step++) {
            sf_tets *tets = NULL;
            sf_tets_report report;
            CHECK_EQ(sf_tets_of_refinement(r, step, NULL, &tets), SF_OK);
            CHECK_EQ(sf_tets_check(tets, NULL, &report), SF_OK);
            apart[step] = fabs(report.volume_mm3 / counted - 1);
            sf_tets_destroy(tets);
        }
        printf("# %.6g mm3 counted; by tetrahedra %.3g, %.3g, %.3g, %.3g of that from it\n",
               counted, apart[1], apart[2], apart[3], apart[4]);
        CHECK(apart[1] < 0.03 && apart[2] < 0.3 * apart[1] && apart[3] < 0.3 * apart[2]);
        CHECK(apart[4] < 0.4 * apart[3] && apart[4] < 1e-3); // counting is good to some 1e-4
        sf_refinement_destroy(r);
        sf_cage_destroy(cage);
        test_cage_free(&c);
    }
}

// One tetrahedron whose property is linear: what is interpolated is known everywhere.
static void a_tetrahedron_is_interpolated_and_flat_ones_are_nothing(void)
{
    static const double points[15] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 4, 2, 2, 0};
    static const uint32_t corners[8] = {0, 1, 2, 3, 0, 1, 4, 2}; // the second is flat
    double values[5];
    for (int i = 0; i < 5; i++) {
        values[i] = 1 + points[3 * i] + 2 * points[3 * i + 1] + 3 * points[3 * i + 2];
    }
    sf_channel density = {sf_property_density(), 5, values, NULL};
    sf_tets_view view = {5, points, 2, corners, 1, &density};
    sf_tets *tets = NULL;
    sf_sampler *sampler = NULL;
    sf_grid *grid = NULL;
    size_t zero = 0, one = 1;
    sf_lattice l = {41, 41, 41, 0.1, 0.1, 0.1, NULL, {0.003, 0.004, 0.005}};
    CHECK_EQ(sf_tets_create(&view, NULL, &tets, NULL), SF_OK);
    CHECK_EQ(sf_sampler_of_tets(tets, &l, 1, &one, NULL, &sampler, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_sampler_of_tets(tets, &l, 1, &zero, NULL, &sampler, NULL), SF_OK);
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    double *p = calloc(41 * 41, sizeof *p);
    for (uint32_t k = 0; k < 41; k += 4) {
        sf_slice s = sf_grid_slice(grid, k);
        CHECK_EQ(sf_sampler_slice(sampler, k, s, &p), SF_OK);
        for (uint32_t i = 0; i < 41 * 41; i++) {
            double x = 0.003 + 0.1 * (i % 41 + 0.5), y = 0.004 + 0.1 * (i / 41 + 0.5);
            double z = 0.005 + 0.1 * (k + 0.5);
            if (x + y + z < 3.99) {
                CHECK(bit(s, i % 41, i / 41));
                CHECK_NEAR(p[i], 1 + x + 2 * y + 3 * z, 1e-12);
            } else if (x + y + z > 4.01) {
                CHECK(!bit(s, i % 41, i / 41) && p[i] == 0);
            }
        }
    }
    free(p);
    sf_grid_destroy(grid);
    sf_sampler_destroy(sampler);
    sampler = NULL;
    for (long k = 0;; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_status status =
            sf_sampler_of_tets(tets, &l, 1, &zero, &memory.allocator, &sampler, NULL);
        sf_sampler_destroy(sampler);
        sampler = NULL;
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
    }
    sf_tets_destroy(tets);
}

// Where tetrahedra overlap the first by number is meant, be it tall or low, above or below.
static void the_first_of_those_that_overlap_is_told(void)
{
    for (uint32_t order = 0; order < 2; order++) {
        double points[24];
        uint32_t corners[8] = {0, 1, 2, 3, 4, 5, 6, 7}, tall = order == 0 ? 0 : 4;
        for (uint32_t i = 0; i < 8; i++) {
            uint32_t corner = i % 4;
            int is_tall = i - tall < 4;
            points[3 * i] = corner == 1 ? 8 : 0;
            points[3 * i + 1] = corner == 2 ? 8 : 0;
            points[3 * i + 2] = (is_tall ? 0 : 2) + (corner == 3 ? is_tall ? 8 : 1 : 0);
        }
        double values[8] = {1, 1, 1, 1, 2, 2, 2, 2};
        sf_channel density = {sf_property_density(), 8, values, NULL};
        sf_tets_view view = {8, points, 2, corners, 1, &density};
        sf_lattice l = {8, 8, 40, 0.25, 0.25, 0.2, NULL, {0, 0, 0}};
        sf_tets *tets = NULL;
        sf_sampler *sampler = NULL;
        sf_grid *grid = NULL;
        size_t zero = 0;
        double plane[64], *p = plane;
        CHECK_EQ(sf_tets_create(&view, NULL, &tets, NULL), SF_OK);
        CHECK_EQ(sf_sampler_of_tets(tets, &l, 1, &zero, NULL, &sampler, NULL), SF_OK);
        CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
        for (uint32_t k = 0; k < 40; k++) {
            sf_slice s = sf_grid_slice(grid, k);
            CHECK_EQ(sf_sampler_slice(sampler, k, s, &p), SF_OK);
            double z = 0.2 * (k + 0.5), expected = order == 1 && z > 2 && z < 2.95 ? 1 : 1 + order;
            CHECK(!bit(s, 0, 0) || plane[0] == expected);
        }
        sf_sampler_destroy(sampler);
        sf_grid_destroy(grid);
        sf_tets_destroy(tets);
    }
}

// At tips a row has one voxel, which rounding may take out of the tetrahedron: it is no less dense.
static void no_solid_voxel_is_left_out(void)
{
    uint64_t solid = 0, filled = 0, empty = 0;
    for (int round = 0; round < 300; round++) {
        double points[12], values[4] = {1000, 1001, 1000, 1001}, plane[64 * 64], *p = plane;
        uint32_t corners[4] = {0, 1, 2, 3};
        for (int i = 0; i < 12; i++) {
            points[i] = 4 * test_random_unit();
        }
        sf_channel density = {sf_property_density(), 4, values, NULL};
        sf_tets_view view = {4, points, 1, corners, 1, &density};
        sf_lattice l = {64, 64, 64, 1.0 / 16, 1.0 / 16, 1.0 / 16, NULL, {0, 0, 0}};
        sf_tets *tets = NULL;
        sf_sampler *sampler = NULL;
        sf_grid *grid = NULL;
        sf_sample_report report;
        size_t zero = 0;
        CHECK_EQ(sf_tets_create(&view, NULL, &tets, NULL), SF_OK);
        CHECK_EQ(sf_sampler_of_tets(tets, &l, 1, &zero, NULL, &sampler, NULL), SF_OK);
        CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
        for (uint32_t k = 0; k < 64; k++) {
            sf_slice s = sf_grid_slice(grid, k);
            CHECK_EQ(sf_sampler_slice(sampler, k, s, &p), SF_OK);
            for (uint32_t i = 0; i < 64 * 64; i++) {
                empty += bit(s, i % 64, i / 64) && !(plane[i] > 999.99 && plane[i] < 1001.01);
            }
        }
        CHECK_EQ(sf_sampler_report(sampler, &report), SF_OK);
        solid += report.solid;
        filled += report.filled;
        sf_grid_destroy(grid);
        sf_sampler_destroy(sampler);
        sf_tets_destroy(tets);
    }
    printf("# of %llu voxels %llu are in no tetrahedron\n", (unsigned long long)solid,
           (unsigned long long)filled);
    CHECK(filled > 0 && filled < solid / 1000);
    CHECK_EQ(empty, 0);
}

int main(void)
{
    TEST(tetrahedra_come_to_the_same);
    TEST(volumes_of_tetrahedra_come_to_the_counted_one);
    TEST(a_tetrahedron_is_interpolated_and_flat_ones_are_nothing);
    TEST(the_first_of_those_that_overlap_is_told);
    TEST(no_solid_voxel_is_left_out);
    return test_finish();
}
