// SPDX-License-Identifier: MIT
// Why: a call that drains must leave the part, the array of holes and the report as they were when
// it fails (TRUST 84-86): memory is refused at each request, the task is cancelled, and arguments
// make no sense.

#include "drain_parts.h"
#include "failing_allocator.h"

#include <sf/carve.h>

static sf_grid *simple_part(void)
{
    sf_grid *grid = empty_grid(14, 14, 16, 1);
    fill(grid, 1, 1, 0, 13, 13, 16, 1);
    fill(grid, 3, 3, 3, 11, 11, 5, 0);
    fill(grid, 4, 4, 8, 10, 10, 10, 0);
    return grid;
}

static void failures_change_nothing(void)
{
    sf_status status = SF_ERR_MEMORY;
    sf_terms terms = sf_terms_default();
    sf_drain drains[4];
    sf_drain_options o = sf_drain_options_default();
    o.diameter_mm = 1;
    o.count = 2;
    o.void_min = 100;
    o.fill = 1;
    o.drains = drains;
    o.drain_capacity = 4;
    sf_grid *was = simple_part();
    for (long at = 0; status != SF_OK && at < 300; at++) {
        failing_allocator f;
        sf_drain_report r;
        memset(&r, 7, sizeof r);
        memset(drains, 7, sizeof drains);
        sf_grid *grid = simple_part();
        failing_begin(&f, at);
        status = sf_grid_drain(grid, &terms, &o, &f.allocator, NULL, &r);
        CHECK(status == SF_OK ||
              (status == SF_ERR_MEMORY && sf_grid_equal(grid, was) &&
               r.drain_count == 0x0707070707070707u && drains[0].voxels == 0x0707070707070707u));
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
        sf_grid_destroy(grid);
    }
    CHECK_EQ(status, SF_OK);
    sf_grid *grid = simple_part();
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_grid_drain(grid, &terms, &o, NULL, &task, NULL), SF_ERR_CANCELLED);
    CHECK(sf_grid_equal(grid, was));
    sf_grid_destroy(grid);
    sf_grid_destroy(was);
}

static void nonsense_is_refused(void)
{
    sf_grid *grid = simple_part(), *was = simple_part(), *other = empty_grid(3, 3, 3, 1);
    const sf_stance *none[1] = {NULL};
    sf_drain_options good = sf_drain_options_default(), bad[9];
    float density[14 * 14 * 16];
    for (int i = 0; i < 14 * 14 * 16; i++) {
        density[i] = NAN;
    }
    good.diameter_mm = 1;
    for (int i = 0; i < 9; i++) {
        bad[i] = good;
    }
    bad[0].struct_size = 1;
    bad[1].diameter_mm = 0;
    bad[2].diameter_mm = NAN;
    bad[3].diameter_mm = INFINITY;
    bad[4].count = 0;
    bad[5].drain_capacity = 1;
    bad[6].stance_count = 1; // of a body without mass
    bad[7].stance_count = 1;
    bad[7].body.mass = 1;
    bad[7].stances = none;
    bad[8].density = density;
    for (int i = 0; i < 9; i++) {
        CHECK_EQ(sf_grid_drain(grid, NULL, &bad[i], NULL, NULL, NULL), SF_ERR_ARGUMENT);
    }
    bad[0] = good;
    bad[0].diameter_mm = 600;
    CHECK_EQ(sf_grid_drain(grid, NULL, &bad[0], NULL, NULL, NULL), SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_grid_drain(NULL, NULL, &good, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_drain(grid, NULL, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_terms terms = sf_terms_default();
    terms.keep = grid;
    CHECK_EQ(sf_grid_drain(grid, &terms, &good, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    terms.keep = other;
    CHECK_EQ(sf_grid_drain(grid, &terms, &good, NULL, NULL, NULL), SF_ERR_SHAPE);
    CHECK(sf_grid_equal(grid, was));
    sf_grid_destroy(grid);
    sf_grid_destroy(was);
    sf_grid_destroy(other);
}

int main(void)
{
    TEST(failures_change_nothing);
    TEST(nonsense_is_refused);
    return test_finish();
}
