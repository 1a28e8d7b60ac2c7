// SPDX-License-Identifier: MIT
// Why: densities and what hangs are figures that a person builds on. Both are counted again here,
// voxel by voxel; and asking for densities costs a pass over the voxels, not a search for each.

#include "failing_allocator.h"
#include "standing.h"
#include "unit/mesh/shapes.h"

static shape s; // too large for the stack

static double denser_above(void *user, const double p[3])
{
    size_t *calls = user;
    *calls += 1;
    return p[2] > 20 ? 1.75 : 0.5;
}

static double nonsense(void *user, const double p[3])
{
    const double *values = user;
    return p[2] > 20 ? values[0] : 1;
}

static sf_stand *make_with(const sf_stand_options *o, const sf_allocator *allocator)
{
    sf_handle handles[3];
    sf_stand *stand = NULL;
    sf_stance_options stance = sf_stance_options_default();
    sf_mesh *mesh = bottle(0.3);
    CHECK_EQ(sf_stand_create(sf_mesh_get_view(mesh), &stance, 1, handles, handles_of(0.3, handles),
                             o, allocator, NULL, &stand, NULL),
             SF_OK);
    sf_mesh_destroy(mesh);
    return stand;
}

// Requests for memory of one round, and of those how many a density makes.
static void densities_come_in_one_pass(void)
{
    long requests[2];
    size_t calls = 0;
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    o.pitch_mm = 2;
    for (int i = 0; i < 2; i++) {
        failing_allocator counting;
        failing_begin(&counting, -1);
        o.density = i == 1 ? denser_above : NULL;
        o.density_user = &calls;
        sf_stand *stand = make_with(&o, &counting.allocator);
        requests[i] = counting.requests;
        CHECK_EQ(sf_stand_round(stand, NULL, NULL), SF_OK);
        requests[i] = counting.requests - requests[i];
        sf_stand_destroy(stand);
        CHECK(counting.live == 0 && counting.faults == 0);
    }
    CHECK(calls > 500);
    CHECK(requests[1] < requests[0] + 40);
}

// Mass and centre of the meshes, and of each voxel that is left what it weighs beside 1. Before the
// first round that bends, every place is where it was.
static void what_weighs_is_counted_again(void)
{
    for (int deform = 0; deform < 2; deform++) {
        size_t calls = 0;
        sf_stand_options o = options_of(deform, SF_CARVE_PLANE);
        sf_body sum, cavity;
        double com[3];
        o.density = denser_above;
        o.density_user = &calls;
        sf_stand *stand = make_with(&o, NULL);
        CHECK_EQ(sf_stand_round(stand, NULL, NULL), SF_OK);
        const sf_grid *left = sf_stand_grid(stand);
        sf_lattice l = sf_grid_lattice(left);
        CHECK_EQ(sf_mesh_body(sf_stand_outer(stand), 1, &sum), SF_OK);
        CHECK_EQ(sf_mesh_body(sf_stand_cavity(stand), 1, &cavity), SF_OK);
        sum = sf_body_add(sum, 1, cavity);
        for (uint32_t i = 0; i < l.nx * l.ny * l.nz; i++) {
            uint32_t x = i % l.nx, y = i / l.nx % l.ny, k = i / l.nx / l.ny;
            const double p[3] = {l.origin_mm[0] + x + 0.5, l.origin_mm[1] + y + 0.5,
                                 l.origin_mm[2] + k + 0.5};
            sf_ballast more = {(p[2] > 20 ? 1.75 : 0.5) - 1, {p[0], p[1], p[2]}};
            if (sf_slice_get(sf_grid_slice(left, k), x, y)) {
                sum = sf_body_add(sum, 1, sf_ballast_body(&more, 1));
            }
        }
        sf_stand_report r = sf_stand_describe(stand);
        CHECK_EQ(sf_body_com(sum, com), SF_OK);
        CHECK_NEAR(r.mass, sum.mass, 1e-6 * sum.mass);
        for (int d = 0; d < 3; d++) {
            CHECK_NEAR(r.com_mm[d], com[d], 1e-6);
        }
        sf_stand_destroy(stand);
    }
}

static void nonsense_is_refused(void)
{
    const double values[] = {0, -1, NAN, INFINITY, 1e-300, 1e300};
    sf_stance_options stance = sf_stance_options_default();
    for (int carve = 0; carve < 2; carve++) {
        for (int i = 0; i < 6; i++) {
            double value = values[i];
            sf_stand_options o = options_of(1, SF_CARVE_PLANE);
            sf_mesh *mesh = bottle(0.3);
            sf_stand *stand = NULL;
            o.pitch_mm = 3;
            o.carve = carve;
            o.density = nonsense;
            o.density_user = &value;
            CHECK_EQ(sf_stand_create(sf_mesh_get_view(mesh), &stance, 1, NULL, 0, &o, NULL, NULL,
                                     &stand, NULL),
                     SF_ERR_ARGUMENT);
            CHECK(stand == NULL);
            sf_mesh_destroy(mesh);
            value = 1;
            stand = make_with(&o, NULL);
            value = values[i]; // what was sane once may be no more
            CHECK_EQ(sf_stand_round(stand, NULL, NULL), SF_ERR_ARGUMENT);
            CHECK(sf_stand_describe(stand).rounds == 0 && sf_stand_grid(stand) == NULL);
            CHECK(sf_stand_density(stand) == NULL);
            value = 2;
            CHECK_EQ(sf_stand_round(stand, NULL, NULL), SF_OK);
            CHECK(sf_stand_density(stand) != NULL);
            sf_stand_destroy(stand);
        }
    }
}

static double heavy_top(void *user, const double p[3])
{
    const double *density = user;
    return p[2] > 10 ? density[1] : density[0];
}

// The balance before anything is done is that of the densities: a column of 10 x 10 x 20 mm whose
// upper half stands 3 mm aside.
static void the_start_is_weighed_as_it_is(void)
{
    static const double boxes[2][2][3] = {{{0, 0, 0}, {10, 10, 10}}, {{3, 0, 10}, {13, 10, 20}}};
    const double densities[3][2] = {{1, 1}, {1, 4}, {0.5, 8}};
    sf_stance_options stance = sf_stance_options_default();
    for (int i = 0; i < 3; i++) {
        sf_stand_options o = options_of(0, SF_CARVE_PLANE);
        sf_stand *stand = NULL;
        double at[2] = {densities[i][0], densities[i][1]}, whole = at[0] + at[1];
        s.vertex_count = s.triangle_count = 0;
        shape_box(&s, boxes[0][0], boxes[0][1], 0);
        shape_box(&s, boxes[1][0], boxes[1][1], 0);
        o.density = i > 0 ? heavy_top : NULL;
        o.density_user = at;
        CHECK_EQ(sf_stand_create(shape_view(&s), &stance, 1, NULL, 0, &o, NULL, NULL, &stand, NULL),
                 SF_OK);
        sf_stand_report r = sf_stand_describe(stand);
        double x = (5 * at[0] + 8 * at[1]) / whole, z = (5 * at[0] + 15 * at[1]) / whole;
        CHECK_NEAR(r.mass, 1000 * whole, 1e-6 * whole);
        CHECK_NEAR(r.com_before_mm[0], x, 1e-6);
        CHECK_NEAR(r.com_before_mm[2], z, 1e-6);
        CHECK_NEAR(r.margin_before_rad, atan2(10 - x, z), 1e-6); // over the edge at x = 10
        sf_stand_destroy(stand);
    }
}

static int is_carried(const sf_grid *grid, uint32_t x, uint32_t y, uint32_t k)
{
    for (int n = 0; n < 9; n++) { // the border of the lattice is empty
        if (sf_slice_get(sf_grid_slice(grid, k - 1), x + (uint32_t)(n % 3) - 1,
                         y + (uint32_t)(n / 3) - 1)) {
            return 1;
        }
    }
    return 0;
}

// A table with one foot, the underside of its top a little below a layer's border: the voxels above
// hang, and no part of them is as near to the surface as the thin wall. The paper's carving takes
// some of them away, and leaves others hanging: only these count.
static void what_hangs_is_counted_again(void)
{
    static const double table[2][2][3] = {{{0, 0, 0}, {10, 10, 8}}, {{-4, 0, 7.6}, {40, 10, 13}}};
    sf_stand_options o = options_of(0, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_voxelize_options how = sf_voxelize_options_default();
    sf_stand *stand = NULL;
    sf_grid *solid = NULL;
    uint64_t gone = 0, hanging = 0;
    s.vertex_count = s.triangle_count = 0;
    for (int i = 0; i < 2; i++) {
        shape_box(&s, table[i][0], table[i][1], 0);
    }
    o.wall_mm = 0.01;
    o.rule = SF_RULE_BOX3;
    CHECK_EQ(sf_stand_create(shape_view(&s), &stance, 1, NULL, 0, &o, NULL, NULL, &stand, NULL),
             SF_OK);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    const sf_grid *left = sf_stand_grid(stand);
    sf_lattice l = sf_grid_lattice(left);
    how.fill = SF_FILL_WINDING;
    CHECK_EQ(sf_grid_create(&l, NULL, &solid), SF_OK);
    CHECK_EQ(sf_grid_voxelize(solid, sf_stand_outer(stand), &how, NULL, NULL, NULL), SF_OK);
    for (uint32_t k = 2; k < l.nz; k++) { // layer 1 lies on the bed
        for (uint32_t i = 0; i < l.nx * l.ny; i++) {
            uint32_t x = i % l.nx, y = i / l.nx;
            int was = sf_slice_get(sf_grid_slice(solid, k), x, y);
            int is = sf_slice_get(sf_grid_slice(left, k), x, y);
            gone += was && !is && !is_carried(solid, x, y, k);
            hanging += is && !is_carried(left, x, y, k) && is_carried(solid, x, y, k);
        }
    }
    CHECK(gone > 0 && hanging > 0);
    CHECK_EQ(sf_stand_describe(stand).hanging_voxels, hanging);
    sf_grid_destroy(solid);
    sf_stand_destroy(stand);
}

int main(void)
{
    TEST(densities_come_in_one_pass);
    TEST(what_weighs_is_counted_again);
    TEST(nonsense_is_refused);
    TEST(the_start_is_weighed_as_it_is);
    TEST(what_hangs_is_counted_again);
    return test_finish();
}
