// SPDX-License-Identifier: MIT
// Why: what a part weighs is what people say of it: dense walls, a sparse inside, a magnet here.
// The densities are held against the same sentences said of one voxel at a time, the last region
// that holds a voxel's centre deciding.

#include "failing_allocator.h"
#include "law/stack.h"
#include "unit/mesh/shapes.h"

#include <sf/body.h>
#include <sf/density.h>

enum { NX = 70, NY = 9, NZ = 8, COUNT = NX * NY * NZ };
static const double heights[] = {1, 0.5, 0.75, 1.5, 0.5, 1, 1, 2};
static shape s;
static float density[COUNT];

static sf_lattice lattice_of(int with_heights)
{
    sf_lattice l = {NX, NY, NZ, 0.25, 1, 0.5, with_heights ? heights : NULL, {-2, 1, 3}};
    return l;
}

static sf_grid *noise(const sf_lattice *l)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(l, NULL, &grid), SF_OK);
    for (uint32_t i = 0; i < COUNT; i++) {
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, i / NX / NY), i % NX, i / NX % NY,
                              test_random_below(4) == 0),
                 SF_OK);
    }
    return grid;
}

static void centre_of(const sf_lattice *l, uint32_t i, double at[3])
{
    uint32_t k = i / NX / NY;
    at[0] = l->origin_mm[0] + (i % NX + 0.5) * l->pitch_x_mm;
    at[1] = l->origin_mm[1] + (i / NX % NY + 0.5) * l->pitch_y_mm;
    at[2] = 0.5 * (sf_lattice_layer_bottom(l, k) + sf_lattice_layer_bottom(l, k + 1));
}

static int in_box(const double at[3], const double low[3], const double high[3])
{
    int in = 1;
    for (int j = 0; j < 3; j++) {
        in = in && at[j] >= low[j] && at[j] < high[j];
    }
    return in;
}

static void sentences_about_one_voxel(void)
{
    for (int round = 0; round < 8; round++) {
        sf_lattice l = lattice_of(round % 2);
        sf_grid *wall = noise(&l), *mask = noise(&l);
        double low[3] = {1.1, 2.2, 4.3}, high[3] = {9.7, 8.1, 6.2};
        s.vertex_count = s.triangle_count = 0;
        shape_box(&s, low, high, 0);
        sf_density_region regions[3] = {{SF_DENSITY_BOX, 7.5, {0, 3, 3.5}, {4, 6, 5}, {0}, NULL},
                                        {SF_DENSITY_MESH, 0.25, {0}, {0}, {0}, NULL},
                                        {SF_DENSITY_MASK, 3, {0}, {0}, {0}, mask}};
        regions[1].mesh = shape_view(&s);
        sf_density_options o = sf_density_options_default();
        o.density = 1.25;
        o.infill = 0.2;
        o.wall = round & 2 ? wall : NULL;
        o.regions = regions;
        o.region_count = (size_t)(round % 4);
        CHECK_EQ(sf_lattice_density(&l, &o, NULL, NULL, density), SF_OK);
        for (uint32_t i = 0; i < COUNT; i++) {
            double at[3], want = 1.25;
            centre_of(&l, i, at);
            sf_slice dense = sf_grid_slice(wall, i / NX / NY);
            want *= o.wall == NULL || sf_slice_get(dense, i % NX, i / NX % NY) ? 1 : 0.2;
            want = o.region_count > 0 && in_box(at, regions[0].low_mm, regions[0].high_mm) ? 7.5
                                                                                           : want;
            want = o.region_count > 1 && in_box(at, low, high) ? 0.25 : want;
            sf_slice held = sf_grid_slice(mask, i / NX / NY);
            want = o.region_count > 2 && sf_slice_get(held, i % NX, i / NX % NY) ? 3 : want;
            CHECK(density[i] == (float)want);
        }
        sf_grid_destroy(wall);
        sf_grid_destroy(mask);
    }
}

// Printed with walls and a fifth inside, and a magnet: a body weighs what its parts weigh.
static void bodies_weigh_their_parts(void)
{
    sf_lattice l = lattice_of(0);
    sf_grid *solid = noise(&l);
    sf_body with = {0, {0}}, without = {0, {0}}, plain = {0, {0}};
    CHECK_EQ(sf_lattice_density(&l, NULL, NULL, NULL, density), SF_OK);
    CHECK_EQ(sf_grid_body(solid, NULL, NULL, &plain), SF_OK);
    CHECK_EQ(sf_grid_body(solid, density, NULL, &with), SF_OK);
    CHECK_NEAR(with.mass, plain.mass, 1e-12 * plain.mass);
    sf_density_options o = sf_density_options_default();
    o.density = 2;
    CHECK_EQ(sf_lattice_density(&l, &o, NULL, NULL, density), SF_OK);
    CHECK_EQ(sf_grid_body(solid, density, NULL, &without), SF_OK);
    CHECK_NEAR(without.mass, 2 * plain.mass, 1e-12 * plain.mass);
    sf_grid_destroy(solid);
}

static void failures_change_nothing(void)
{
    sf_lattice l = lattice_of(1);
    double low[3] = {1.1, 2.2, 4.3}, high[3] = {9.7, 8.1, 6.2};
    s.vertex_count = s.triangle_count = 0;
    shape_box(&s, low, high, 0);
    sf_density_region region = {SF_DENSITY_MESH, 2, {0}, {0}, {0}, NULL};
    region.mesh = shape_view(&s);
    sf_density_options o = sf_density_options_default();
    o.regions = &region;
    o.region_count = 1;
    sf_status status = SF_ERR_MEMORY;
    for (long at = 0; status != SF_OK && at < 50; at++) {
        failing_allocator f;
        failing_begin(&f, at);
        density[17] = -1;
        status = sf_lattice_density(&l, &o, &f.allocator, NULL, density);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && density[17] == -1));
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    density[17] = -1;
    CHECK_EQ(sf_lattice_density(&l, &o, NULL, &task, density), SF_ERR_CANCELLED);
    CHECK_EQ(sf_lattice_density(&l, NULL, NULL, &task, density), SF_ERR_CANCELLED);
    CHECK(density[17] == -1);
}

static void nonsense_is_refused(void)
{
    sf_lattice l = lattice_of(0), none = l, small = {3, 3, 3, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *other = NULL;
    sf_density_region region = {SF_DENSITY_BOX, 1, {0}, {0}, {0}, NULL};
    sf_density_options good = sf_density_options_default(), bad[9];
    CHECK_EQ(sf_grid_create(&small, NULL, &other), SF_OK);
    for (int i = 0; i < 9; i++) {
        bad[i] = good;
    }
    bad[0].struct_size = 0;
    bad[1].density = 0;
    bad[2].density = 1e-60;
    bad[3].density = 1e60;
    bad[4].infill = 0;
    bad[5].infill = 1.5;
    bad[6].infill = NAN;
    bad[7].region_count = 1;
    bad[8].density = NAN;
    for (int i = 0; i < 9; i++) {
        CHECK_EQ(sf_lattice_density(&l, &bad[i], NULL, NULL, density), SF_ERR_ARGUMENT);
    }
    good.regions = &region;
    good.region_count = 1;
    region.density = -1;
    CHECK_EQ(sf_lattice_density(&l, &good, NULL, NULL, density), SF_ERR_ARGUMENT);
    region.density = 1;
    region.high_mm[1] = INFINITY;
    CHECK_EQ(sf_lattice_density(&l, &good, NULL, NULL, density), SF_ERR_ARGUMENT);
    region.shape = SF_DENSITY_MASK;
    CHECK_EQ(sf_lattice_density(&l, &good, NULL, NULL, density), SF_ERR_ARGUMENT);
    region.mask = other;
    CHECK_EQ(sf_lattice_density(&l, &good, NULL, NULL, density), SF_ERR_SHAPE);
    region.shape = (sf_density_shape)3;
    CHECK_EQ(sf_lattice_density(&l, &good, NULL, NULL, density), SF_ERR_ARGUMENT);
    region.shape = SF_DENSITY_MESH;
    region.mesh.triangle_count = 1;
    CHECK_EQ(sf_lattice_density(&l, &good, NULL, NULL, density), SF_ERR_ARGUMENT);
    good.region_count = SF_DENSITY_REGIONS_MAX + 1;
    CHECK_EQ(sf_lattice_density(&l, &good, NULL, NULL, density), SF_ERR_OVERFLOW);
    good.region_count = 0;
    good.wall = other;
    CHECK_EQ(sf_lattice_density(&l, &good, NULL, NULL, density), SF_ERR_SHAPE);
    none.nx = 0;
    CHECK_EQ(sf_lattice_density(&none, NULL, NULL, NULL, density), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_lattice_density(NULL, NULL, NULL, NULL, density), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_lattice_density(&l, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_grid_destroy(other);
}

int main(void)
{
    TEST(sentences_about_one_voxel);
    TEST(bodies_weigh_their_parts);
    TEST(failures_change_nothing);
    TEST(nonsense_is_refused);
    return test_finish();
}
