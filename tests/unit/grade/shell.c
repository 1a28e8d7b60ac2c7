// SPDX-License-Identifier: MIT
// Why: where a material must not come near the surface, no voxel of it may, wherever within its
// voxels the surface runs. Held against random triangles: points of them are sampled, and each
// voxel with a point nearer than the distance must be in the shell; and each voxel of the shell
// must have a touched voxel that near, by a loop over all pairs. Promises: layers in any order are
// the same bytes; surface outside the lattice counts.

#include <sf/halftone.h>

#include "test.h"

enum { TRIANGLES = 3 };

typedef struct thing {
    double vertices[9 * TRIANGLES];
    uint32_t triangles[3 * TRIANGLES];
    sf_mesh_view mesh;
    sf_lattice lattice;
    double heights[16], bottom[17];
} thing;

static thing it;

static void make(int with_heights)
{
    sf_lattice l = {9 + test_random_below(8), 5 + test_random_below(9), 12, 0.5, 0.8, 0.3, NULL,
                    {-1.25, 3.5, 0.75}};
    it.lattice = l;
    it.bottom[0] = l.origin_mm[2];
    for (uint32_t k = 0; k < l.nz; k++) {
        it.heights[k] = with_heights ? 0.2 + 0.05 * test_random_below(8) : 0.3;
        it.bottom[k + 1] = it.bottom[k] + it.heights[k];
    }
    it.lattice.heights_mm = with_heights ? it.heights : NULL;
    double size[3] = {l.nx * 0.5, l.ny * 0.8, it.bottom[l.nz] - it.bottom[0]};
    for (int i = 0; i < 3 * TRIANGLES; i++) {
        for (int n = 0; n < 3; n++) {
            // A fifth of them outside.
            it.vertices[3 * i + n] = l.origin_mm[n] + (1.2 * test_random_unit() - 0.1) * size[n];
        }
        it.triangles[i] = (uint32_t)i;
    }
    it.mesh.vertices = it.vertices;
    it.mesh.vertex_count = 3 * TRIANGLES;
    it.mesh.triangles = it.triangles;
    it.mesh.triangle_count = TRIANGLES;
}

static double outside(double at, double low, double high)
{
    return at < low ? low - at : at > high ? at - high : 0;
}

static double distance_to_voxel(const double p[3], uint32_t x, uint32_t y, uint32_t z)
{
    const sf_lattice *l = &it.lattice;
    double a = l->origin_mm[0] + x * 0.5, b = l->origin_mm[1] + y * 0.8;
    double d[3] = {outside(p[0], a, a + 0.5), outside(p[1], b, b + 0.8),
                   outside(p[2], it.bottom[z], it.bottom[z + 1])};
    return sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
}

static sf_grid *shell_grid(double distance, int downward)
{
    sf_grid *grid = NULL;
    sf_shell *shell = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_grid_create(&it.lattice, NULL, &grid), SF_OK);
    sf_status status = sf_shell_create(it.mesh, &it.lattice, distance, NULL, &shell, &fault);
    CHECK_EQ(status, SF_OK);
    for (uint32_t i = 0; status == SF_OK && i < it.lattice.nz; i++) {
        uint32_t k = downward ? it.lattice.nz - 1 - i : i;
        k = downward == 2 ? (i * 7) % it.lattice.nz : k;
        CHECK_EQ(sf_shell_slice(shell, k, sf_grid_slice(grid, k)), SF_OK);
    }
    sf_shell_destroy(shell);
    return grid;
}

// Points of the triangles: voxels nearer than the distance, less what corners are rounded by.
static void nothing_near_is_left_out(void)
{
    for (int round = 0; round < 40; round++) {
        double distance = 0.1 + 1.2 * test_random_unit();
        make(round % 2);
        sf_grid *grid = shell_grid(distance, 0);
        int missing = 0;
        for (int i = 0; i < 60 * TRIANGLES; i++) {
            double a = test_random_unit(), b = test_random_unit(), p[3];
            if (a + b > 1) {
                a = 1 - a;
                b = 1 - b;
            }
            const double *v = it.vertices + i % TRIANGLES * 9;
            for (int n = 0; n < 3; n++) {
                p[n] = v[n] + a * (v[3 + n] - v[n]) + b * (v[6 + n] - v[n]);
            }
            for (uint32_t z = 0; z < it.lattice.nz; z++) {
                for (uint32_t y = 0; y < it.lattice.ny; y++) {
                    for (uint32_t x = 0; x < it.lattice.nx; x++) {
                        missing += distance_to_voxel(p, x, y, z) < distance - 0.006 &&
                                   !sf_slice_get(sf_grid_slice(grid, z), x, y);
                    }
                }
            }
        }
        CHECK_EQ(missing, 0);
        sf_grid_destroy(grid);
    }
}

static double gap_of(uint32_t a, uint32_t b, double pitch)
{
    uint32_t apart = a < b ? b - a : a - b;
    return apart > 1 ? (apart - 1) * pitch : 0;
}

// On meshes inside the lattice: the shell is what its description says, by all pairs. Layers are
// equally high here; else the surface of a lattice that is wider is rounded to another grid.
static void nothing_far_is_taken(void)
{
    for (int round = 0; round < 30; round++) {
        double distance = round % 5 == 0 ? 0 : 1.2 * test_random_unit();
        make(0);
        for (int i = 0; i < 3 * TRIANGLES; i++) {
            double *v = &it.vertices[3 * i];
            v[0] = it.lattice.origin_mm[0] + 0.1 + test_random_unit() * (it.lattice.nx * 0.5 - 0.2);
            v[1] = it.lattice.origin_mm[1] + 0.1 + test_random_unit() * (it.lattice.ny * 0.8 - 0.2);
            v[2] = it.bottom[0] + 0.1 +
                   test_random_unit() * (it.bottom[it.lattice.nz] - it.bottom[0] - 0.2);
        }
        sf_grid *grid = shell_grid(distance, 0), *surface = shell_grid(0, 0);
        int wrong = 0;
        for (uint32_t v = 0; v < it.lattice.nx * it.lattice.ny * it.lattice.nz; v++) {
            uint32_t x = v % it.lattice.nx, y = v / it.lattice.nx % it.lattice.ny;
            uint32_t z = v / it.lattice.nx / it.lattice.ny;
            int near = 0;
            for (uint32_t k = 0; k < it.lattice.nz; k++) {
                double c = k > z   ? it.bottom[k] - it.bottom[z + 1]
                           : k < z ? it.bottom[z] - it.bottom[k + 1]
                                   : 0;
                for (uint32_t j = 0; j < it.lattice.ny; j++) {
                    for (uint32_t i = 0; i < it.lattice.nx; i++) {
                        double a = gap_of(x, i, 0.5), b = gap_of(y, j, 0.8);
                        int same = x == i && y == j && z == k;
                        near = near || (sf_slice_get(sf_grid_slice(surface, k), i, j) &&
                                        (same || sqrt(a * a + b * b + c * c) < distance - 1e-9));
                    }
                }
            }
            wrong += near != sf_slice_get(sf_grid_slice(grid, z), x, y);
        }
        CHECK_EQ(wrong, 0);
        sf_grid_destroy(grid);
        sf_grid_destroy(surface);
    }
}

static void without_distance_it_is_the_surface(void)
{
    for (int round = 0; round < 10; round++) {
        sf_voxelize_options options = sf_voxelize_options_default();
        sf_grid *want = NULL;
        make(round % 2);
        options.fill = SF_FILL_SURFACE;
        sf_grid *grid = shell_grid(0, 0);
        CHECK_EQ(sf_grid_create(&it.lattice, NULL, &want), SF_OK);
        CHECK_EQ(sf_grid_voxelize(want, it.mesh, &options, NULL, NULL, NULL), SF_OK);
        CHECK(sf_grid_equal(grid, want));
        sf_grid_destroy(grid);
        sf_grid_destroy(want);
    }
}

static void layers_come_in_any_order(void)
{
    for (int round = 0; round < 10; round++) {
        make(round % 2);
        sf_grid *up = shell_grid(0.9, 0), *down = shell_grid(0.9, 1), *mixed = shell_grid(0.9, 2);
        CHECK(sf_grid_equal(up, down));
        CHECK(sf_grid_equal(up, mixed));
        sf_grid_destroy(up);
        sf_grid_destroy(down);
        sf_grid_destroy(mixed);
    }
}

int main(void)
{
    TEST(nothing_near_is_left_out);
    TEST(nothing_far_is_taken);
    TEST(without_distance_it_is_the_surface);
    TEST(layers_come_in_any_order);
    return test_finish();
}
