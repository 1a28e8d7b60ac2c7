// SPDX-License-Identifier: MIT
// Why: SF_FILL_AUTO makes the meant solid out of the meshes that people have: inside out, some
// triangles turned, faces missing, corners not shared, shells that overlap or touch. Procedural
// twins of the broken files of the design notes' collection, which are tested where SF_DATA is set.

#include "solids.h"

static solid s, other;

static const double low[3] = {2, 2, 2}, high[3] = {18, 14, 10};

static uint64_t count_auto(const sf_lattice *lattice, sf_voxelize_report *report)
{
    sf_grid *grid = solid_voxelize(solid_view(&s), lattice, SF_FILL_AUTO, report);
    uint64_t count = sf_grid_popcount(grid);
    sf_grid_destroy(grid);
    return count;
}

static void make_box(void)
{
    s.vertex_count = s.triangle_count = 0;
    solid_box(&s, low, high);
}

static void inside_out_is_turned(void)
{
    sf_lattice lattice = solid_lattice(24, 24, 24);
    sf_voxelize_report report;
    for (int round = 0; round < 4; round++) { // closed, then open
        s.vertex_count = s.triangle_count = 0;
        double center[3] = {12, 12, 12};
        solid_sphere(&s, center, 9, 8, 10, 0.2);
        s.triangle_count -= round % 2 ? 9 : 0;
        sf_grid *plain = solid_voxelize(solid_view(&s), &lattice, SF_FILL_AUTO, &report);
        CHECK_EQ(report.flipped, 0);
        solid_flip(&s, 0);
        sf_grid *turned = solid_voxelize(solid_view(&s), &lattice, SF_FILL_AUTO, &report);
        CHECK_EQ(report.flipped, 1);
        CHECK(sf_grid_equal(plain, turned));
        CHECK(sf_grid_popcount(plain) > 1000);
        sf_grid_destroy(turned);
        sf_grid_destroy(plain);
    }
}

// Every choice of turned triangles of a box, by shared corners and by corners of their own.
static void any_triangles_turned(void)
{
    sf_lattice lattice = solid_lattice(20, 16, 12);
    for (uint32_t mask = 0; mask < 4096; mask++) {
        make_box();
        for (uint32_t t = 0; t < 12; t++) {
            if (mask >> t & 1) {
                uint32_t *v = s.triangles + 3 * t, swap = v[1];
                v[1] = v[2];
                v[2] = swap;
            }
        }
        if (mask % 2) { // as an STL file has it
            other = s;
            s.vertex_count = 0;
            for (uint32_t i = 0; i < 36; i++) {
                const double *p = other.vertices + 3 * other.triangles[i];
                s.triangles[i] = solid_vertex(&s, p[0], p[1], p[2]);
            }
        }
        sf_voxelize_report report;
        CHECK_EQ(count_auto(&lattice, &report), 16 * 12 * 8);
        CHECK_EQ(report.boundary_edges, 0);
    }
}

// One triangle of a box is missing, any of the twelve: the box within a fiftieth.
static void a_missing_triangle(void)
{
    sf_lattice lattice = solid_lattice(40, 32, 24);
    lattice.pitch_x_mm = lattice.pitch_y_mm = lattice.layer_mm = 0.5;
    for (uint32_t t = 0; t < 12; t++) {
        make_box();
        s.triangle_count = 11;
        memcpy(s.triangles + 3 * t, s.triangles + 33, 3 * sizeof(uint32_t));
        sf_voxelize_report report;
        double volume = (double)count_auto(&lattice, &report) / 8;
        CHECK_NEAR(volume, 16 * 12 * 8, 16 * 12 * 8 / 50.0);
        CHECK_EQ(report.boundary_edges, 3);
    }
}

// Shells that overlap count once, those that touch along an edge or a face are both there, and a
// cavity is a cavity.
static void shells(void)
{
    sf_lattice lattice = solid_lattice(24, 24, 24);
    sf_voxelize_report report;
    double a[3] = {10, 6, 4}, b[3] = {22, 20, 16}; // shares 8 x 8 x 6 with the box
    make_box();
    solid_box(&s, a, b);
    CHECK_EQ(count_auto(&lattice, &report), 16 * 12 * 8 + 12 * 14 * 12 - 8 * 8 * 6);
    double c[3] = {18, 14, 2}, d[3] = {22, 20, 10}; // touches along an edge
    make_box();
    solid_box(&s, c, d);
    CHECK_EQ(count_auto(&lattice, &report), 16 * 12 * 8 + 4 * 6 * 8);
    CHECK_EQ(report.boundary_edges, 0);
    double e[3] = {18, 2, 2}, f[3] = {22, 14, 10}; // touches along a face
    make_box();
    solid_box(&s, e, f);
    CHECK_EQ(count_auto(&lattice, &report), 20 * 12 * 8);
    double g[3] = {4, 4, 4}, h[3] = {8, 8, 8};
    make_box();
    solid_box(&s, g, h);
    solid_flip(&s, 12);
    CHECK_EQ(count_auto(&lattice, &report), 16 * 12 * 8 - 64);
    CHECK_EQ(report.flipped, 0);
}

// A ball whose triangles are all on their own and shrunken, so that no two of them meet.
static void a_ball_of_loose_triangles(void)
{
    sf_lattice lattice = solid_lattice(32, 32, 32);
    double center[3] = {16, 16, 16};
    other.vertex_count = other.triangle_count = 0;
    solid_sphere(&other, center, 12, 12, 16, 0);
    s.vertex_count = s.triangle_count = 0;
    for (size_t t = 0; t < other.triangle_count; t++) {
        const uint32_t *v = other.triangles + 3 * t;
        uint32_t corner[3];
        for (int i = 0; i < 3; i++) {
            double p[3];
            for (uint32_t c = 0; c < 3; c++) {
                double middle = (other.vertices[3 * v[0] + c] + other.vertices[3 * v[1] + c] +
                                 other.vertices[3 * v[2] + c]) /
                                3;
                p[c] = middle + 0.95 * (other.vertices[3 * v[i] + c] - middle);
            }
            corner[i] = solid_vertex(&s, p[0], p[1], p[2]);
        }
        solid_triangle(&s, corner[0], corner[1], corner[2]);
    }
    sf_voxelize_report report;
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(solid_view(&other), &mass), SF_OK);
    CHECK_NEAR((double)count_auto(&lattice, &report), mass.volume_mm3, 0.03 * mass.volume_mm3);
    CHECK_EQ(report.boundary_edges, 3 * s.triangle_count);
}

// Leftovers that enclose nothing: nothing is filled and nothing goes wrong.
static void what_has_no_inside(void)
{
    sf_lattice lattice = solid_lattice(12, 12, 12);
    sf_voxelize_report report;
    s.vertex_count = s.triangle_count = 0;
    for (int i = 0; i < 6; i++) {
        solid_vertex(&s, 2.0 + i, 3.0 + i * i % 5, 2.0 + i % 3 * 2);
    }
    solid_triangle(&s, 0, 0, 1); // collapsed
    solid_triangle(&s, 2, 2, 2);
    CHECK_EQ(count_auto(&lattice, &report), 0);
    solid_triangle(&s, 0, 1, 2); // a triangle and its back
    solid_triangle(&s, 0, 2, 1);
    CHECK_EQ(count_auto(&lattice, &report), 0);
    CHECK_EQ(report.boundary_edges, 0);
    for (int n = 0; n < 5; n++) { // five pages on one spine
        solid_triangle(&s, 3, 4, (uint32_t)n % 3);
    }
    count_auto(&lattice, &report);
}

int main(void)
{
    TEST(inside_out_is_turned);
    TEST(any_triangles_turned);
    TEST(a_missing_triangle);
    TEST(shells);
    TEST(a_ball_of_loose_triangles);
    TEST(what_has_no_inside);
    return test_finish();
}
