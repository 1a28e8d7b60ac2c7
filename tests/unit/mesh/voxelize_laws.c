// SPDX-License-Identifier: MIT
// Why: laws that hold whatever the mesh is. Moving lattice and voxels together by whole voxels
// moves the voxels; cutting a solid by a shared face cuts its voxels into two sets that are
// disjoint and whole; scaling everything by a power of two changes nothing, even along one axis;
// layers of different heights are slices at their own centres. Guards TRUST B9 and the design
// notes, 7.1: a row that meets a shared edge or face is counted once.

#include "solids.h"

static solid s;

static void random_ball(double size)
{
    s.vertex_count = s.triangle_count = 0;
    double center[3] = {size / 2 + test_random_unit(), size / 2 + test_random_unit(),
                        size / 2 + test_random_unit()};
    solid_sphere(&s, center, size * 0.4, 8, 10, 0.3);
}

static void moving_the_lattice_moves_the_voxels(void)
{
    for (int round = 0; round < 12; round++) {
        random_ball(20);
        solid_snap(&s);
        if (round % 3 == 1) {
            s.triangle_count -= 9;
        }
        sf_lattice near = solid_lattice(24, 24, 24), moved = solid_lattice(32, 32, 32);
        moved.origin_mm[0] = -3;
        moved.origin_mm[1] = -5;
        moved.origin_mm[2] = -7;
        sf_fill fill = round % 3 == 2 ? SF_FILL_SURFACE : SF_FILL_AUTO;
        sf_grid *a = solid_voxelize(solid_view(&s), &near, fill, NULL);
        sf_grid *b = solid_voxelize(solid_view(&s), &moved, fill, NULL);
        int wrong = 0;
        for (uint32_t v = 0; v < 24 * 24 * 24; v++) {
            uint32_t x = v % 24, y = v / 24 % 24, k = v / 576;
            wrong += sf_slice_get(sf_grid_slice(a, k), x, y) !=
                     sf_slice_get(sf_grid_slice(b, k + 7), x + 3, y + 5);
        }
        CHECK_EQ(wrong, 0);
        CHECK_EQ(sf_grid_popcount(a), sf_grid_popcount(b));
        sf_grid_destroy(b);
        sf_grid_destroy(a);
    }
}

// Each tetrahedron of a cube's six around a diagonal is closed; together they are the cube. The
// corners are random, so faces, edges and the diagonal lie anywhere, or exactly on centres.
static void parts_that_share_faces_make_the_whole(void)
{
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                    {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int round = 0; round < 40; round++) {
        double corner[8][3];
        for (int i = 0; i < 24; i++) { // a bent cube, on halves of a voxel every other round
            double v = ((i / 3) >> (i % 3) & 1) * 7 + 2 + 3 * test_random_unit();
            corner[i / 3][i % 3] = round % 2 ? floor(v * 2) / 2 : floor(v * 256) / 256;
        }
        sf_lattice lattice = solid_lattice(14, 14, 14);
        sf_grid *parts[6];
        uint64_t sum = 0;
        for (int n = 0; n < 6; n++) {
            int a = 1 << order[n][0], b = a | 1 << order[n][1];
            double p[4][3];
            memcpy(p[0], corner[0], sizeof p[0]);
            memcpy(p[1], corner[a], sizeof p[1]);
            memcpy(p[2], corner[b], sizeof p[2]);
            memcpy(p[3], corner[7], sizeof p[3]);
            s.vertex_count = s.triangle_count = 0;
            solid_tetra(&s, p);
            parts[n] = solid_voxelize(solid_view(&s), &lattice, SF_FILL_AUTO, NULL);
            sum += sf_grid_popcount(parts[n]);
        }
        // The whole: its twelve faces, split as the parts are.
        s.vertex_count = s.triangle_count = 0;
        for (int i = 0; i < 8; i++) {
            solid_vertex(&s, corner[i][0], corner[i][1], corner[i][2]);
        }
        for (int n = 0; n < 6; n++) {
            uint32_t a = 1u << order[n][0], b = a | 1u << order[n][1];
            int even = n < 3;
            solid_triangle(&s, 0, even ? b : a, even ? a : b);
            solid_triangle(&s, 7, even ? a : b, even ? b : a);
        }
        sf_grid *whole = solid_voxelize(solid_view(&s), &lattice, SF_FILL_AUTO, NULL);
        CHECK_EQ(sum, sf_grid_popcount(whole));
        int wrong = 0;
        for (uint32_t v = 0; v < 14 * 14 * 14; v++) {
            int count = 0;
            for (int n = 0; n < 6; n++) {
                count += sf_slice_get(sf_grid_slice(parts[n], v / 196), v % 14, v / 14 % 14);
            }
            wrong += count != sf_slice_get(sf_grid_slice(whole, v / 196), v % 14, v / 14 % 14);
        }
        CHECK_EQ(wrong, 0);
        for (int n = 0; n < 6; n++) {
            sf_grid_destroy(parts[n]);
        }
        sf_grid_destroy(whole);
    }
}

static void scaling_an_axis_changes_nothing(void)
{
    for (int round = 0; round < 10; round++) {
        random_ball(20);
        sf_lattice plain = solid_lattice(24, 24, 24), scaled = plain;
        scaled.pitch_x_mm = 0.5;
        scaled.pitch_y_mm = 4;
        scaled.layer_mm = 0.125;
        sf_fill fill = round % 2 ? SF_FILL_SURFACE : SF_FILL_AUTO;
        sf_grid *a = solid_voxelize(solid_view(&s), &plain, fill, NULL);
        for (size_t i = 0; i < s.vertex_count; i++) {
            s.vertices[3 * i] *= 0.5;
            s.vertices[3 * i + 1] *= 4;
            s.vertices[3 * i + 2] *= 0.125;
        }
        sf_grid *b = solid_voxelize(solid_view(&s), &scaled, fill, NULL);
        CHECK(sf_grid_equal(a, b));
        CHECK(sf_grid_popcount(a) > 500);
        sf_grid_destroy(b);
        sf_grid_destroy(a);
    }
}

// Layer k of uneven heights has its centre where layer 2k or so of a fine lattice has its own.
static void layers_are_slices_at_their_centres(void)
{
    static const double heights[8] = {1, 3, 2, 1, 1, 3, 2, 3}; // of 16: each mean of 2
    static const uint32_t centre_eighths[8] = {4, 20, 40, 52, 60, 76, 96, 116}; // in 1/8
    for (int round = 0; round < 6; round++) {
        random_ball(16);
        solid_snap(&s);
        if (round % 2) {
            s.triangle_count -= 9;
        }
        sf_lattice uneven = {20, 20, 8, 1, 1, 0, heights, {0, 0, 0}};
        sf_grid *a = solid_voxelize(solid_view(&s), &uneven, SF_FILL_AUTO, NULL);
        for (uint32_t k = 0; k < 8; k++) {
            sf_lattice one = {20, 20, 1, 1, 1, 2, NULL, {0, 0, centre_eighths[k] / 8.0 - 1}};
            sf_grid *b = solid_voxelize(solid_view(&s), &one, SF_FILL_AUTO, NULL);
            for (uint32_t y = 0; y < 20; y++) {
                sf_slice left = sf_grid_slice(a, k), right = sf_grid_slice(b, 0);
                CHECK_EQ(left.words[y * left.stride], right.words[y * right.stride]);
            }
            sf_grid_destroy(b);
        }
        sf_grid_destroy(a);
    }
}

// A mesh that leaves the lattice on any side is no leak, and fills what lies inside.
static void a_mesh_may_leave_the_lattice(void)
{
    s.vertex_count = s.triangle_count = 0;
    double low[3] = {-100, -3, -9}, high[3] = {100, 5, 90};
    solid_box(&s, low, high);
    sf_lattice lattice = solid_lattice(70, 9, 9);
    sf_voxelize_report report;
    for (int fill = SF_FILL_AUTO; fill < SF_FILL_SURFACE; fill++) {
        sf_grid *grid = solid_voxelize(solid_view(&s), &lattice, (sf_fill)fill, &report);
        CHECK_EQ(report.odd_rows, 0);
        CHECK_EQ(report.solid_voxels, 70 * 5 * 9);
        sf_grid_destroy(grid);
    }
}

int main(void)
{
    TEST(moving_the_lattice_moves_the_voxels);
    TEST(parts_that_share_faces_make_the_whole);
    TEST(scaling_an_axis_changes_nothing);
    TEST(layers_are_slices_at_their_centres);
    TEST(a_mesh_may_leave_the_lattice);
    return test_finish();
}
