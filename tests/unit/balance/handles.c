// SPDX-License-Identifier: MIT
// Why: handles are where somebody points, or where nobody has to. Feet are held against a look at
// every voxel, covers against the definition, the middle behind a point against a ray followed in
// tiny steps. Promise: what cannot be is refused with a sentence, and nothing changes.

#include "failing_allocator.h"
#include "solid.h"

#include <sf/handles.h>

static const double heights[] = {1, 1.25, 0.75, 1, 1, 1.25, 1, 1};

static void feet_are_what_lies_lowest(void)
{
    sf_lattice lattice = {70, 5, 8, 1, 1.125, 1, heights, {3, -40, 5}};
    for (int round = 0; round < 20; round++) {
        sf_grid *grid = random_solid(&lattice, 0.1), *foot = NULL;
        double up[3], height = 4 * test_random_unit(), length = 0, least = INFINITY;
        for (int d = 0; d < 3; d++) {
            up[d] = round == 0 ? d == 2 : 2 * test_random_unit() - 1;
            length += up[d] * up[d];
        }
        CHECK_EQ(sf_grid_foot(grid, up, height, NULL, &foot), SF_OK);
        for (int pass = 0; pass < 2; pass++) {
            for (uint32_t n = 0; n < 70 * 5 * 8; n++) {
                uint32_t x = n % 70, y = n / 70 % 5, z = n / 350;
                double at[3] = {x + 0.5, (y + 0.5) * 1.125,
                                sf_lattice_layer_bottom(&lattice, z) + 0.5 * heights[z] - 5};
                double h = (at[0] * up[0] + at[1] * up[1] + at[2] * up[2]) / sqrt(length);
                int solid_here = sf_slice_get(sf_grid_slice(grid, z), x, y);
                least = pass == 0 && solid_here && h < least ? h : least;
                if (pass == 1 && fabs(h - least - height) > 1e-9) {
                    CHECK_EQ(sf_slice_get(sf_grid_slice(foot, z), x, y),
                             solid_here && h < least + height);
                }
            }
        }
        sf_handle handle;
        CHECK_EQ(sf_handle_base(foot, &handle), SF_OK);
        CHECK(handle.kind == SF_HANDLE_BASE && handle.locked == 1 && handle.region == foot);
        sf_grid_destroy(foot);
        sf_grid_destroy(grid);
    }
}

static void a_base_has_the_middle_of_its_voxels(void)
{
    sf_lattice lattice = {5, 5, 5, 1, 1, 2, NULL, {10, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 0);
    sf_handle handle;
    CHECK_EQ(sf_handle_base(grid, &handle), SF_ERR_ARGUMENT);
    sf_rect rect = {1, 0, 3, 1};
    CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, 2), rect, 1), SF_OK);
    CHECK_EQ(sf_handle_base(grid, &handle), SF_OK);
    CHECK(handle.at_mm[0] == 12 && handle.at_mm[1] == 0.5 && handle.at_mm[2] == 5);
    CHECK_EQ(sf_handle_base(NULL, &handle), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_base(grid, NULL), SF_ERR_ARGUMENT);
    sf_grid_destroy(grid);
}

static void covers_hold_the_surface(void)
{
    sf_lattice lattice = {12, 12, 12, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 0), *touched = random_solid(&lattice, 0), *cover = NULL;
    double p[12] = {2.1, 2.2, 2.3, 9.3, 3.1, 2.7, 4.4, 9.2, 3.3, 5.5, 5.4, 9.8};
    const uint32_t t[12] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
    sf_mesh_view mesh = {p, 4, t, 4};
    sf_voxelize_options options = sf_voxelize_options_default();
    CHECK_EQ(sf_grid_voxelize(grid, mesh, &options, NULL, NULL, NULL), SF_OK);
    options.fill = SF_FILL_SURFACE;
    CHECK_EQ(sf_grid_voxelize(touched, mesh, &options, NULL, NULL, NULL), SF_OK);
    CHECK_EQ(sf_grid_cover(grid, mesh, NULL, NULL, &cover), SF_OK);
    for (uint32_t n = 0; n < 1728; n++) {
        uint32_t x = n % 12, y = n / 12 % 12, z = n / 144;
        CHECK_EQ(sf_slice_get(sf_grid_slice(cover, z), x, y),
                 sf_slice_get(sf_grid_slice(grid, z), x, y) ||
                     sf_slice_get(sf_grid_slice(touched, z), x, y));
    }
    for (int i = 0; i < 4; i++) {
        CHECK(sf_slice_get(sf_grid_slice(cover, (uint32_t)p[3 * i + 2]), (uint32_t)p[3 * i],
                           (uint32_t)p[3 * i + 1]));
    }
    CHECK_EQ(sf_grid_cover(NULL, mesh, NULL, NULL, &cover), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_cover(grid, mesh, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_grid_destroy(cover);
    sf_grid_destroy(touched);
    sf_grid_destroy(grid);
}

static int solid_at(const sf_grid *grid, const double p[3])
{
    sf_lattice l = sf_grid_lattice(grid);
    double x = floor((p[0] - l.origin_mm[0]) / l.pitch_x_mm),
           y = floor((p[1] - l.origin_mm[1]) / l.pitch_y_mm);
    for (uint32_t z = 0; z < l.nz; z++) {
        if (p[2] >= sf_lattice_layer_bottom(&l, z) && p[2] < sf_lattice_layer_bottom(&l, z + 1)) {
            return x >= 0 && y >= 0 && x < l.nx && y < l.ny &&
                   sf_slice_get(sf_grid_slice(grid, z), (uint32_t)x, (uint32_t)y);
        }
    }
    return 0;
}

// The first stretch at least half a voxel long, else the first of all, in steps of 1/500.
static int follow(const sf_grid *grid, const double from[3], const double unit[3], double middle[3])
{
    double step = 0.002, enter = 0, found[2] = {0, 0};
    int was = 0, any = 0;
    for (int i = 0; i < 40000; i++) {
        double length = i * step, p[3];
        for (int d = 0; d < 3; d++) {
            p[d] = from[d] + length * unit[d];
        }
        int is = solid_at(grid, p);
        enter = is && !was ? length : enter;
        if (was && !is && (!any || length - enter >= 0.5)) {
            found[0] = enter;
            found[1] = length;
            any = 1;
            if (length - enter >= 0.5) {
                break;
            }
        }
        was = is;
    }
    for (int d = 0; d < 3; d++) {
        middle[d] = from[d] + 0.5 * (found[0] + found[1]) * unit[d];
    }
    return any;
}

static void centers_are_the_middle_of_what_a_ray_enters(void)
{
    sf_lattice lattice = {9, 8, 8, 1, 1.125, 1, heights, {30, -4, 5}};
    sf_grid *grid = random_solid(&lattice, 0.2);
    int hits = 0, misses = 0;
    for (int i = 0; i < 400; i++) {
        double from[3], to[3], unit[3], length = 0, middle[3], found[3] = {7, 7, 7};
        sf_fault fault;
        for (int d = 0; d < 3; d++) {
            from[d] = lattice.origin_mm[d] - 5 + 19 * test_random_unit();
            to[d] = lattice.origin_mm[d] + 9 * test_random_unit();
            unit[d] = to[d] - from[d];
            unit[d] = i % 7 == d ? 0 : unit[d];
            length += unit[d] * unit[d];
        }
        for (int d = 0; d < 3; d++) {
            unit[d] /= sqrt(length);
        }
        int hit = follow(grid, from, unit, middle);
        double direction[3] = {3 * unit[0], 3 * unit[1], 3 * unit[2]};
        sf_status status = sf_handle_center(grid, from, direction, found, &fault);
        int near = fabs(found[0] - middle[0]) < 0.004 && fabs(found[1] - middle[1]) < 0.004 &&
                   fabs(found[2] - middle[2]) < 0.004;
        hits += hit && near;
        misses += !hit && status == SF_ERR_INFEASIBLE;
        CHECK(status == SF_OK ||
              (found[0] == 7 && strstr(fault.message, "no solid voxel") != NULL));
    }
    printf("# %d rays of 400 end in the same middle, %d miss\n", hits, misses);
    // Tiny steps pass over corners, and take half a voxel for a little less.
    CHECK(hits + misses >= 390 && hits > 100 && misses > 20);
    sf_grid_destroy(grid);
}

static void rays_that_are_none_are_refused(void)
{
    sf_lattice lattice = {9, 8, 8, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 1);
    double from[3] = {4, 4, 20}, down[3] = {0, 0, -2}, none[3] = {0, 0, 0}, nan[3] = {0, NAN, 1};
    double out[3] = {7, 7, 7};
    CHECK_EQ(sf_handle_center(grid, from, none, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center(grid, from, nan, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center(grid, nan, down, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center(NULL, from, down, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center(grid, NULL, down, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center(grid, from, NULL, out, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center(grid, from, down, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK(out[0] == 7);
    CHECK_EQ(sf_handle_center(grid, from, down, from, NULL), SF_OK);
    CHECK(from[0] == 4 && from[1] == 4 && from[2] == 4);
    sf_grid_destroy(grid);
}

static void feet_refuse_nonsense_and_free_what_they_took(void)
{
    sf_lattice lattice = {9, 8, 8, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 1), *empty = random_solid(&lattice, 0), *foot = NULL;
    double up[3] = {0, 0, 1}, none[3] = {0, 0, 0}, nan[3] = {NAN, 0, 0};
    CHECK_EQ(sf_grid_foot(NULL, up, 1, NULL, &foot), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_foot(grid, NULL, 1, NULL, &foot), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_foot(grid, up, 1, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_foot(grid, none, 1, NULL, &foot), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_foot(grid, nan, 1, NULL, &foot), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_foot(grid, up, -1, NULL, &foot), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_foot(grid, up, NAN, NULL, &foot), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_foot(empty, up, 1, NULL, &foot), SF_ERR_ARGUMENT);
    double p[9] = {1, 1, 1, 5, 1, 1, 1, 5, 1};
    const uint32_t t[3] = {0, 1, 2};
    sf_mesh_view mesh = {p, 3, t, 1};
    sf_status status = SF_ERR_MEMORY;
    failing_allocator failing;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        failing_begin(&failing, k);
        status = sf_grid_cover(grid, mesh, &failing.allocator, NULL, &foot);
        CHECK(status == SF_OK || (foot == NULL && failing.live == 0));
    }
    CHECK_EQ(status, SF_OK);
    sf_grid_destroy(foot);
    CHECK(failing.live == 0 && failing.faults == 0);
    foot = NULL;
    failing_begin(&failing, 0);
    CHECK_EQ(sf_grid_foot(grid, up, 1, &failing.allocator, &foot), SF_ERR_MEMORY);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_grid_cover(grid, mesh, NULL, &task, &foot), SF_ERR_CANCELLED);
    CHECK(foot == NULL);
    sf_grid_destroy(empty);
    sf_grid_destroy(grid);
}

// From as far as a place can be, and by a direction however long, the middle is the middle; what is
// no place is refused, and never answered with what is no number.
static void rays_come_from_afar(void)
{
    sf_lattice lattice = {8, 8, 8, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 2);
    const double lengths[] = {1, 1e-300, 1e-160, 1e160, 1e308};
    for (int i = 0; i < 5; i++) {
        const double starts[] = {-1, -1e6, -1e12};
        const double along[3] = {lengths[i], 0, 0}, aslant[3] = {lengths[i], lengths[i], 0};
        for (int j = 0; j < 3; j++) {
            const double from[3] = {starts[j], 3.5, 4.5}, corner[3] = {starts[j], starts[j], 4.5};
            double at[3] = {-9, -9, -9};
            CHECK_EQ(sf_handle_center(grid, from, along, at, NULL), SF_OK);
            CHECK_NEAR(at[0], 4, 1e-3);
            CHECK(at[1] == 3.5 && at[2] == 4.5);
            CHECK_EQ(sf_handle_center(grid, corner, aslant, at, NULL), SF_OK);
            CHECK_NEAR(at[0], 4, 1e-3);
            CHECK_NEAR(at[1], 4, 1e-3);
        }
    }
    const double beyond[][3] = {{-2e12, 4, 4}, {1e300, 4, 4}, {1e308, 1e308, 1e308}, {4, NAN, 4}};
    const double down[3] = {-1, -1, -1}, zero[3] = {0, 0, 0}, no[3] = {1, INFINITY, 0};
    double at[3] = {-9, -9, -9};
    for (int i = 0; i < 4; i++) {
        CHECK_EQ(sf_handle_center(grid, beyond[i], down, at, NULL), SF_ERR_ARGUMENT);
    }
    CHECK_EQ(sf_handle_center(grid, at, zero, at, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handle_center(grid, at, no, at, NULL), SF_ERR_ARGUMENT);
    CHECK(at[0] == -9 && at[1] == -9 && at[2] == -9);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(feet_are_what_lies_lowest);
    TEST(a_base_has_the_middle_of_its_voxels);
    TEST(covers_hold_the_surface);
    TEST(centers_are_the_middle_of_what_a_ray_enters);
    TEST(rays_that_are_none_are_refused);
    TEST(feet_refuse_nonsense_and_free_what_they_took);
    TEST(rays_come_from_afar);
    return test_finish();
}
