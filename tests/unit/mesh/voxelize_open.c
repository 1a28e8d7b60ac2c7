// SPDX-License-Identifier: MIT
// Why: an open mesh is solid where its winding number, added up over all triangles by a slow judge,
// is at least one half: boxes without a face, spheres with holes, loose triangles, anisotropic
// voxels. The voxeliser patches holes and looks at few voxels; the judge does neither.
// Guards the design notes, 7.2, and that closed parts stay exact.

#include "solids.h"

static solid s;

// Voxels that differ from the judge, but for those whose winding number is within 1e-9 of a half.
static int wrong_voxels(const sf_grid *grid)
{
    sf_lattice l = sf_grid_lattice(grid);
    int wrong = 0;
    for (uint32_t k = 0; k < l.nz; k++) {
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t x = 0; x < l.nx; x++) {
                double q[3] = {(x + 0.5 + 0x1p-33) * l.pitch_x_mm,
                               (y + 0.5 + 0x1p-41) * l.pitch_y_mm,
                               (k + 0.5 + 0x1p-49) * l.layer_mm};
                double w = solid_winding(&s, q);
                int is = sf_slice_get(sf_grid_slice(grid, k), x, y);
                wrong += fabs(w - 0.5) > 1e-9 && is != (w > 0.5);
            }
        }
    }
    return wrong;
}

static void check_open(const sf_lattice *lattice, sf_fill fill, size_t boundary_edges)
{
    sf_voxelize_report report;
    sf_grid *grid = solid_voxelize(solid_view(&s), lattice, fill, &report);
    CHECK_EQ(wrong_voxels(grid), 0);
    CHECK_EQ(report.boundary_edges, boundary_edges);
    CHECK_EQ(report.solid_voxels, sf_grid_popcount(grid));
    CHECK_EQ(report.fill, SF_FILL_WINDING);
    sf_grid_destroy(grid);
}

static void spheres_with_holes(void)
{
    for (int round = 0; round < 10; round++) {
        s.vertex_count = s.triangle_count = 0;
        double center[3] = {7 + test_random_unit(), 7 + test_random_unit(), 7 + test_random_unit()};
        solid_sphere(&s, center, 6, 6, 8, 0.2);
        solid_snap(&s);
        for (int n = 0; n < 1 + round; n++) { // may touch: loops of any shape
            uint32_t t = test_random_below((uint32_t)s.triangle_count);
            s.triangle_count--;
            memcpy(s.triangles + 3 * t, s.triangles + 3 * s.triangle_count, 3 * sizeof(uint32_t));
        }
        sf_lattice lattice = solid_lattice(15, 14, 15);
        sf_voxelize_report report;
        sf_grid *grid = solid_voxelize(solid_view(&s), &lattice, SF_FILL_AUTO, &report);
        CHECK_EQ(wrong_voxels(grid), 0);
        CHECK(report.boundary_edges >= 3);
        sf_grid_destroy(grid);
    }
}

// Corners on voxel centres: rows run through rims and patches, centres lie on both.
static void boxes_without_a_face(void)
{
    for (uint32_t face = 0; face < 6; face++) {
        s.vertex_count = s.triangle_count = 0;
        double low[3] = {1.5, 2, 1.5}, high[3] = {8.5, 8.5, 8};
        solid_box(&s, low, high);
        s.triangle_count -= 2;
        for (int i = 0; i < 6; i++) {
            s.triangles[6 * face + (uint32_t)i] = s.triangles[30 + i];
        }
        sf_lattice lattice = solid_lattice(10, 11, 10);
        check_open(&lattice, SF_FILL_AUTO, 4);
        check_open(&lattice, SF_FILL_WINDING, 4);
    }
}

static void loose_triangles(void)
{
    for (int round = 0; round < 5; round++) {
        s.vertex_count = s.triangle_count = 0;
        for (int n = 0; n < 30; n++) {
            uint32_t v[3];
            for (int i = 0; i < 3; i++) {
                v[i] = solid_vertex(&s, 12 * test_random_unit(), 12 * test_random_unit(),
                                    12 * test_random_unit());
            }
            solid_triangle(&s, v[0], v[1], v[2]);
        }
        solid_snap(&s);
        sf_lattice lattice = solid_lattice(12, 12, 12);
        check_open(&lattice, SF_FILL_WINDING, 90);
    }
}

// Large enough for boxes within boxes, and for voxels that only just are on one side of a half.
static void a_soup_of_many_boxes(void)
{
    s.vertex_count = s.triangle_count = 0;
    for (int n = 0; n < 100; n++) {
        uint32_t v[3];
        for (int i = 0; i < 3; i++) {
            v[i] = solid_vertex(&s, 70 * test_random_unit(), 36 * test_random_unit(),
                                36 * test_random_unit());
        }
        solid_triangle(&s, v[0], v[1], v[2]);
    }
    solid_snap(&s);
    sf_lattice lattice = solid_lattice(67, 35, 37);
    check_open(&lattice, SF_FILL_WINDING, 300);
}

// Solid angles are measured in millimetres, not in voxels.
static void voxels_that_are_no_cubes(void)
{
    s.vertex_count = s.triangle_count = 0;
    double center[3] = {6, 6.25, 5.5};
    solid_sphere(&s, center, 5, 6, 8, 0.2);
    s.triangle_count -= 8; // most of a sector
    for (size_t i = 0; i < 3 * s.vertex_count; i++) {
        s.vertices[i] = floor(s.vertices[i] * 128 + 0.5) / 128;
    }
    sf_lattice lattice = {24, 12, 40, 0.5, 1.0, 0.25, NULL, {0, 0, 0}};
    check_open(&lattice, SF_FILL_AUTO, 10);
}

// A closed part beside an open one is voxelised as if it were alone.
static void closed_parts_stay_exact(void)
{
    s.vertex_count = s.triangle_count = 0;
    double low[3] = {0.5, 0.5, 0.5}, high[3] = {3.5, 6, 7};
    double center[3] = {9, 5, 5};
    solid_box(&s, low, high);
    solid_sphere(&s, center, 4, 5, 6, 0.1);
    s.triangle_count -= 6;
    solid_snap(&s);
    sf_lattice lattice = solid_lattice(14, 10, 10);
    sf_grid *grid = solid_voxelize(solid_view(&s), &lattice, SF_FILL_AUTO, NULL);
    for (uint32_t k = 0; k < 10; k++) {
        for (uint32_t y = 0; y < 10; y++) {
            for (uint32_t x = 0; x < 4; x++) {
                CHECK_EQ(sf_slice_get(sf_grid_slice(grid, k), x, y), x < 3 && y < 6 && k < 7);
            }
        }
    }
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(spheres_with_holes);
    TEST(boxes_without_a_face);
    TEST(loose_triangles);
    TEST(a_soup_of_many_boxes);
    TEST(voxels_that_are_no_cubes);
    TEST(closed_parts_stay_exact);
    return test_finish();
}
