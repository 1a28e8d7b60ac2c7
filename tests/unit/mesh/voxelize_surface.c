// SPDX-License-Identifier: MIT
// Why: SF_FILL_SURFACE promises every voxel that the surface touches and nothing else, voxels being
// closed boxes. The judge clips each triangle to each voxel in rational steps that stay exact for
// corners on eighths of a voxel, and asks whether anything is left. Guards the design notes, 7.3.

#include "solids.h"

static solid s;

typedef struct shape {
    double at[16][3];
    int count;
} shape;

static void cut(shape *p, int c, double limit, double side)
{
    shape out;
    out.count = 0;
    for (int i = 0; i < p->count; i++) {
        const double *a = p->at[i], *b = p->at[(i + 1) % p->count];
        double da = side * (a[c] - limit), db = side * (b[c] - limit);
        if (da <= 0) {
            memcpy(out.at[out.count++], a, sizeof out.at[0]);
        }
        if (da * db < 0) {
            for (int n = 0; n < 3; n++) {
                out.at[out.count][n] = n == c ? limit : a[n] + da / (da - db) * (b[n] - a[n]);
            }
            out.count++;
        }
    }
    *p = out;
}

// How much of the triangle is left in the box made larger by `slack` on all sides.
static int left_in_box(const uint32_t *v, const double low[3], const double high[3], double slack)
{
    shape p;
    p.count = 3;
    for (int i = 0; i < 3; i++) {
        memcpy(p.at[i], s.vertices + 3 * v[i], sizeof p.at[i]);
    }
    for (int c = 0; c < 3; c++) {
        cut(&p, c, low[c] - slack, -1);
        cut(&p, c, high[c] + slack, 1);
    }
    return p.count > 0;
}

// A voxel is wrong when it is solid though nothing comes within 1e-9 of it, or empty though
// something reaches into it by more than 1e-9. Exact contact is tested separately, below.
static int wrong_voxels(const sf_grid *grid)
{
    sf_lattice l = sf_grid_lattice(grid);
    int wrong = 0;
    for (uint32_t k = 0; k < l.nz; k++) {
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t x = 0; x < l.nx; x++) {
                double low[3] = {x * l.pitch_x_mm, y * l.pitch_y_mm,
                                 sf_lattice_layer_bottom(&l, k)};
                double high[3] = {low[0] + l.pitch_x_mm, low[1] + l.pitch_y_mm,
                                  sf_lattice_layer_bottom(&l, k + 1)};
                int loosely = 0, strictly = 0;
                for (size_t t = 0; t < s.triangle_count; t++) {
                    loosely |= left_in_box(s.triangles + 3 * t, low, high, 1e-9);
                    strictly |= left_in_box(s.triangles + 3 * t, low, high, -1e-9);
                }
                int is = sf_slice_get(sf_grid_slice(grid, k), x, y);
                wrong += (is && !loosely) || (!is && strictly);
            }
        }
    }
    return wrong;
}

static void check_surface(const sf_lattice *lattice)
{
    sf_voxelize_report report;
    sf_grid *grid = solid_voxelize(solid_view(&s), lattice, SF_FILL_SURFACE, &report);
    CHECK_EQ(wrong_voxels(grid), 0);
    CHECK_EQ(report.solid_voxels, sf_grid_popcount(grid));
    CHECK_EQ(report.fill, SF_FILL_SURFACE);
    sf_grid_destroy(grid);
}

static void add_triangle(double extent, double step)
{
    uint32_t v[3];
    for (int i = 0; i < 3; i++) {
        double p[3];
        for (int c = 0; c < 3; c++) {
            p[c] = floor((extent * test_random_unit() - 2) / step + 0.5) * step;
        }
        v[i] = solid_vertex(&s, p[0], p[1], p[2]);
    }
    solid_triangle(&s, v[0], v[1], v[2]);
}

static void random_triangles(void)
{
    for (int round = 0; round < 150; round++) {
        s.vertex_count = s.triangle_count = 0;
        for (int n = 0; n < 2; n++) {
            add_triangle(12, round % 2 ? 0x1p-8 : 0x1p-3);
        }
        sf_lattice lattice = solid_lattice(8, 8, 8);
        check_surface(&lattice);
    }
}

static void layers_of_different_heights(void)
{
    for (int round = 0; round < 60; round++) {
        s.vertex_count = s.triangle_count = 0;
        add_triangle(12, 0x1p-8);
        static const double heights[6] = {1, 0.5, 2, 0.5, 1, 1}; // mean 1
        sf_lattice lattice = {16, 8, 6, 0.5, 1.0, 0, heights, {0, 0, 0}};
        check_surface(&lattice);
    }
}

// Points, segments and triangles that only touch a face, an edge or a corner of voxels.
static void contact_counts(void)
{
    static const struct {
        double p[3][3];
        uint64_t count;
    } cases[] = {
        {{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}, 8},                   // a lattice point
        {{{2, 2, 2.5}, {2, 2, 2.5}, {2, 2, 2.5}}, 4},             // on an edge
        {{{2.5, 2.5, 2}, {2.5, 2.5, 2}, {2.5, 2.5, 2}}, 2},       // on a face
        {{{2.5, 2.5, 2.5}, {2.5, 2.5, 2.5}, {2.5, 2.5, 2.5}}, 1}, // inside
        {{{1, 1.5, 1.5}, {3, 1.5, 1.5}, {3, 1.5, 1.5}}, 4},       // a segment: x from 0 to 4
        {{{1, 1, 2}, {3, 1, 2}, {1, 3, 2}}, 30},                  // see below
        {{{3, 1, 1}, {1, 3, 1}, {1, 1, 3}}, 25},                  // x + y + z = 5
        {{{-9, -9, -9}, {-9, 9, -9}, {-9, -9, -1}}, 0},           // outside
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        s.vertex_count = s.triangle_count = 0;
        for (int c = 0; c < 3; c++) {
            solid_vertex(&s, cases[i].p[c][0], cases[i].p[c][1], cases[i].p[c][2]);
        }
        solid_triangle(&s, 0, 1, 2);
        sf_lattice lattice = solid_lattice(6, 6, 6);
        sf_grid *grid = solid_voxelize(solid_view(&s), &lattice, SF_FILL_SURFACE, NULL);
        uint64_t touched = 0; // exact for these numbers: all cuts are at dyadic fractions
        for (uint32_t v = 0; v < 216; v++) {
            double low[3] = {v % 6, v / 6 % 6, v / 36},
                   high[3] = {low[0] + 1, low[1] + 1, low[2] + 1};
            int is = sf_slice_get(sf_grid_slice(grid, v / 36), v % 6, v / 6 % 6);
            int should = left_in_box(s.triangles, low, high, 0);
            touched += (uint64_t)should;
            CHECK_EQ(is, should);
        }
        CHECK_EQ(sf_grid_popcount(grid), touched);
        if (i < 5) {
            CHECK_EQ(touched, cases[i].count);
        }
        sf_grid_destroy(grid);
    }
}

// The surface's voxels hold every voxel that changes when the solid rule looks at one side or the
// other of the mesh: solid voxels without them are strictly inside.
static void it_separates_inside_from_outside(void)
{
    s.vertex_count = s.triangle_count = 0;
    double center[3] = {16, 16, 16};
    solid_sphere(&s, center, 13, 12, 16, 0.2);
    sf_lattice lattice = solid_lattice(32, 32, 32);
    sf_grid *solid_grid = solid_voxelize(solid_view(&s), &lattice, SF_FILL_AUTO, NULL);
    sf_grid *shell = solid_voxelize(solid_view(&s), &lattice, SF_FILL_SURFACE, NULL);
    int leaks = 0;
    for (uint32_t k = 0; k < 32; k++) {
        sf_slice in = sf_grid_slice(solid_grid, k), on = sf_grid_slice(shell, k);
        for (uint32_t y = 0; y < 32; y++) {
            for (uint32_t x = 0; x + 1 < 32; x++) {
                int changes = sf_slice_get(in, x, y) != sf_slice_get(in, x + 1, y);
                leaks += changes && !sf_slice_get(on, x, y) && !sf_slice_get(on, x + 1, y);
            }
        }
    }
    CHECK_EQ(leaks, 0);
    sf_grid_destroy(shell);
    sf_grid_destroy(solid_grid);
}

int main(void)
{
    TEST(random_triangles);
    TEST(layers_of_different_heights);
    TEST(contact_counts);
    TEST(it_separates_inside_from_outside);
    return test_finish();
}
