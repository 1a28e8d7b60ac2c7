// SPDX-License-Identifier: MIT
// Why: on a mesh whose corners lie on the voxeliser's units the result is exact, ties included: a
// voxel is solid where the winding number around its centre is at least one, a centre on the
// surface counting as just beyond it. Boxes through voxel centres hit every edge and corner rule.
// Guards TRUST B9, 78 (centre sampling) and the fill rule of the design notes, 7.1.

#include "solids.h"

// Corners on halves of a voxel leave much room beside a centre, corners on 1/256 very little.
#define COARSE 0x1p-14
#define FINE 0x1p-33

static solid s;

static double half_step(uint32_t bound)
{
    return test_random_below(2 * bound + 1) / 2.0;
}

static void check_exact(uint32_t nx, uint32_t ny, uint32_t nz, sf_fill fill, double nudge)
{
    sf_lattice lattice = solid_lattice(nx, ny, nz);
    sf_voxelize_report report;
    sf_grid *grid = solid_voxelize(solid_view(&s), &lattice, fill, &report);
    CHECK_EQ(solid_disagreements(&s, grid, fill == SF_FILL_PARITY, nudge), 0);
    CHECK_EQ(report.odd_rows, 0);
    CHECK_EQ(report.solid_voxels, sf_grid_popcount(grid));
    sf_grid_destroy(grid);
}

static void boxes_through_centres(void)
{
    for (int round = 0; round < 60; round++) {
        s.vertex_count = s.triangle_count = 0;
        for (int n = 0; n < 2; n++) {
            double low[3], high[3];
            for (int i = 0; i < 3; i++) {
                low[i] = half_step(6) - 1;
                high[i] = low[i] + 0.5 + half_step(5);
            }
            solid_box(&s, low, high);
        }
        check_exact(9, 8, 7, SF_FILL_WINDING, COARSE);
        check_exact(9, 8, 7, SF_FILL_PARITY, COARSE);
    }
}

static void tetrahedra_through_centres(void)
{
    for (int round = 0; round < 200; round++) {
        s.vertex_count = s.triangle_count = 0;
        for (int n = 0; n < 3; n++) {
            double p[4][3];
            for (int i = 0; i < 12; i++) {
                p[i / 3][i % 3] = half_step(10) - 1;
            }
            solid_tetra(&s, p);
        }
        check_exact(8, 9, 8, SF_FILL_WINDING, COARSE);
        check_exact(8, 9, 8, SF_FILL_PARITY, COARSE);
    }
}

static void tetrahedra_in_general_position(void)
{
    for (int round = 0; round < 200; round++) {
        s.vertex_count = s.triangle_count = 0;
        for (int n = 0; n < 3; n++) {
            double p[4][3];
            for (int i = 0; i < 12; i++) {
                p[i / 3][i % 3] = 12 * test_random_unit() - 2;
            }
            solid_tetra(&s, p);
        }
        solid_snap(&s);
        check_exact(8, 8, 8, SF_FILL_WINDING, FINE);
    }
}

static void bumpy_spheres(void)
{
    for (int round = 0; round < 10; round++) {
        s.vertex_count = s.triangle_count = 0;
        double center[3] = {6 + test_random_unit(), 6 + test_random_unit(), 6 + test_random_unit()};
        solid_sphere(&s, center, 5, 8, 12, 0.3);
        solid_snap(&s);
        check_exact(13, 12, 13, SF_FILL_AUTO, FINE);
        CHECK_EQ(s.triangle_count, 168);
    }
}

// More rows than the voxeliser steps through one by one, and wide enough for several words.
static void large_triangles(void)
{
    for (int round = 0; round < 6; round++) {
        s.vertex_count = s.triangle_count = 0;
        double p[4][3];
        for (int i = 0; i < 12; i++) {
            p[i / 3][i % 3] = (i % 3 == 2 ? 8 : 200) * test_random_unit() - 2;
        }
        solid_tetra(&s, p);
        solid_snap(&s);
        check_exact(190, 70, 4, SF_FILL_AUTO, FINE);
    }
}

int main(void)
{
    TEST(boxes_through_centres);
    TEST(tetrahedra_through_centres);
    TEST(tetrahedra_in_general_position);
    TEST(bumpy_spheres);
    TEST(large_triangles);
    return test_finish();
}
