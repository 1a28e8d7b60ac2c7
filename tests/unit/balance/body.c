// SPDX-License-Identifier: MIT
// Why: whether a thing stands is decided by its mass and first moments. Voxels with densities and
// layers of any height are held against a sum over single boxes, mesh against voxels of the same
// solid, and a body less a part of it against the rest.

#include "law/stack.h"

#include <sf/body.h>

static const double heights[] = {0.5, 1, 2, 0.25, 1.5, 1, 1, 3};

static sf_grid *random_grid(uint32_t nx, uint32_t ny, uint32_t nz, int with_heights)
{
    sf_lattice lattice = {nx, ny, nz, 0.5, 2, 1.25, with_heights ? heights : NULL, {3, -7, 11}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < nz; k++) {
        for (uint32_t y = 0; y < ny; y++) {
            for (uint32_t x = 0; x < nx; x++) {
                CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), x, y, test_random_below(3) == 0),
                         SF_OK);
            }
        }
    }
    return grid;
}

// The same sum, box by box.
static sf_body naive(const sf_grid *grid, const float *density)
{
    sf_lattice l = sf_grid_lattice(grid);
    sf_body sum = {0, {0, 0, 0}};
    double bottom = l.origin_mm[2];
    for (uint32_t k = 0; k < l.nz; k++) {
        double height = l.heights_mm != NULL ? l.heights_mm[k] : l.layer_mm;
        for (uint32_t i = 0; i < l.nx * l.ny; i++) {
            uint32_t x = i % l.nx, y = i / l.nx;
            double d = density == NULL ? 1 : density[(size_t)k * l.nx * l.ny + i];
            double m = sf_slice_get(sf_grid_slice(grid, k), x, y) * d * l.pitch_x_mm *
                       l.pitch_y_mm * height;
            sum.mass += m;
            sum.moment[0] += m * (l.origin_mm[0] + (x + 0.5) * l.pitch_x_mm);
            sum.moment[1] += m * (l.origin_mm[1] + (y + 0.5) * l.pitch_y_mm);
            sum.moment[2] += m * (bottom + 0.5 * height);
        }
        bottom += height;
    }
    return sum;
}

static void check_near(sf_body a, sf_body b, double tolerance)
{
    CHECK_NEAR(a.mass, b.mass, tolerance * (1 + fabs(b.mass)));
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(a.moment[i], b.moment[i], tolerance * (1 + fabs(b.moment[i])));
    }
}

static void voxels_are_summed_as_boxes(void)
{
    for (uint32_t nx = 1; nx < 140; nx += 23) {
        sf_grid *grid = random_grid(nx, 5, 8, nx % 2 == 0);
        float *density = malloc(sizeof *density * nx * 5 * 8);
        sf_body body = {0, {0, 0, 0}};
        for (uint32_t i = 0; i < nx * 5 * 8; i++) {
            density[i] = (float)test_random_unit();
        }
        CHECK_EQ(sf_grid_body(grid, NULL, NULL, &body), SF_OK);
        check_near(body, naive(grid, NULL), 1e-13);
        CHECK_EQ(sf_grid_body(grid, density, NULL, &body), SF_OK);
        check_near(body, naive(grid, density), 1e-13);
        free(density);
        sf_grid_destroy(grid);
    }
}

static void meshes_weigh_what_their_voxels_weigh(void)
{
    // A corner of stairs: its voxels touch in faces, so that no vertex of the surface is moved.
    sf_grid *grid = random_grid(20, 6, 8, 0);
    for (uint32_t i = 0; i < 20 * 6 * 8; i++) {
        uint32_t x = i % 20, y = i / 20 % 6, k = i / 120;
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), x, y, x + 2 * y + k < 15), SF_OK);
    }
    sf_mesh *mesh = NULL;
    sf_body of_mesh = {0, {0, 0, 0}}, of_grid = {0, {0, 0, 0}};
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &mesh), SF_OK);
    CHECK_EQ(sf_mesh_body(sf_mesh_get_view(mesh), 2, &of_mesh), SF_OK);
    CHECK_EQ(sf_grid_body(grid, NULL, NULL, &of_grid), SF_OK);
    check_near(of_mesh, sf_body_add(of_grid, 1, of_grid), 1e-12);
    sf_mesh_destroy(mesh);
    sf_grid_destroy(grid);
}

static void bodies_add_up(void)
{
    sf_ballast ballast[] = {{2, {1, 0, 0}}, {1, {4, 3, 0}}, {3, {0, 0, -1}}};
    sf_body all = sf_ballast_body(ballast, 3), some = sf_ballast_body(ballast, 2);
    sf_body rest = sf_body_add(all, -1, some);
    double com[3] = {9, 9, 9};
    CHECK_EQ(sf_body_com(all, com), SF_OK);
    CHECK(com[0] == 1 && com[1] == 0.5 && com[2] == -0.5);
    CHECK_EQ(sf_body_com(rest, com), SF_OK);
    CHECK(com[0] == 0 && com[1] == 0 && com[2] == -1);
    CHECK_EQ(sf_body_com(sf_body_add(some, -1, some), com), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_body_com(sf_body_add(some, -1, all), com), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_body_com(all, NULL), SF_ERR_ARGUMENT);
    CHECK(com[2] == -1);
}

static void nonsense_is_refused(void)
{
    sf_grid *grid = random_grid(3, 3, 8, 0);
    sf_body body = {7, {7, 7, 7}};
    float density[72];
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 0), 0, 0, 1), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 0), 1, 0, 0), SF_OK);
    for (int i = 0; i < 72; i++) {
        density[i] = i == 1 ? NAN : 1;
    }
    CHECK_EQ(sf_grid_body(grid, density, NULL, &body), SF_OK); // nobody looks at what is empty
    body.mass = 7;
    density[0] = NAN;
    CHECK_EQ(sf_grid_body(grid, density, NULL, &body), SF_ERR_ARGUMENT);
    density[0] = INFINITY;
    CHECK_EQ(sf_grid_body(grid, density, NULL, &body), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_body(NULL, NULL, NULL, &body), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_body(grid, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_grid_body(grid, NULL, &task, &body), SF_ERR_CANCELLED);
    sf_mesh_view none = {NULL, 0, NULL, 0};
    CHECK_EQ(sf_mesh_body(none, 1, &body), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_body(none, NAN, &body), SF_ERR_ARGUMENT);
    CHECK(body.mass == 7);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(voxels_are_summed_as_boxes);
    TEST(meshes_weigh_what_their_voxels_weigh);
    TEST(bodies_add_up);
    TEST(nonsense_is_refused);
    return test_finish();
}
