// SPDX-License-Identifier: MIT
// Why: "how steep is it?" must be answered in degrees that a person can check with a ruler (TRUST
// 73 over many layers in place of one). Wedges of known slope, on cubes and on oblong voxels; an
// island; a box; a cancel; memory that is refused.

#include "law/stack.h"

#include "failing_allocator.h"

#define DEGREES (180.0 / 3.14159265358979323846)

// A wall that leans: layer k spans y and is 6 voxels wide from k * slope on.
static sf_grid *leaning(double slope, const sf_lattice *lattice)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(lattice, stack_allocator(), &grid), SF_OK);
    for (uint32_t k = 0; k < lattice->nz; k++) {
        uint32_t x = (uint32_t)floor(k * lattice->layer_mm * slope / lattice->pitch_x_mm);
        sf_rect rect = {x, 0, x + 6, lattice->ny};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), rect, 1), SF_OK);
    }
    return grid;
}

static void wedges_of_known_slope(void)
{
    static const double pixels[2][3] = {{0.1, 0.1, 0.1}, {0.05, 0.1, 0.08}};
    for (int p = 0; p < 2; p++) {
        for (int degrees = 10; degrees <= 60; degrees += 10) {
            double slope = tan(degrees / DEGREES), height = 120 * pixels[p][2];
            sf_lattice lattice = {0, 3, 120, pixels[p][0], pixels[p][1], pixels[p][2], NULL, {0}};
            sf_steepest found;
            lattice.nx = (uint32_t)(height * slope / lattice.pitch_x_mm) + 8;
            sf_grid *grid = leaning(slope, &lattice);
            CHECK_EQ(sf_grid_steepest(grid, SF_BED_AUTO, stack_allocator(), NULL, &found), SF_OK);
            CHECK(found.is_bounded);
            double said = tan(found.angle_rad);
            CHECK(said <= slope + 0.01);
            CHECK(said >= slope - 3 * lattice.pitch_y_mm / height - 0.01);
            printf("# leaning by %d degrees: %.1f\n", degrees, found.angle_rad * DEGREES);
            sf_grid_destroy(grid);
        }
    }
}

static void islands_have_no_angle(void)
{
    sf_lattice lattice = {20, 20, 20, 0.1, 0.1, 0.1, NULL, {0, 0, 0}};
    sf_grid *grid = leaning(0, &lattice);
    sf_steepest found;
    CHECK_EQ(sf_grid_steepest(grid, SF_BED_AUTO, stack_allocator(), NULL, &found), SF_OK);
    CHECK(found.is_bounded && found.layer == SF_BED_AUTO && found.box.x1 == 0);
    CHECK_NEAR(found.angle_rad * DEGREES, 5, 1e-9);
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 11), 19, 19, 1), SF_OK);
    CHECK_EQ(sf_grid_steepest(grid, SF_BED_AUTO, stack_allocator(), NULL, &found), SF_OK);
    // Even 85 degrees step over twelve voxels at most, and here are fourteen.
    CHECK_EQ(found.layer, 11);
    CHECK(found.box.x0 == 19 && found.box.y0 == 19 && found.box.z0 == 11);
    CHECK(!found.is_bounded);
    sf_grid_destroy(grid);
}

static double last;
static sf_task task;

static void watch(void *user, double fraction)
{
    CHECK(fraction >= last && fraction <= 1);
    last = fraction;
    if (user != NULL && fraction > 0.3) {
        sf_task_cancel(&task);
    }
}

static void failing_calls_change_nothing(void)
{
    double heights[20];
    for (int k = 0; k < 20; k++) {
        heights[k] = 0.08 + 0.002 * k;
    }
    sf_lattice lattice = {20, 20, 20, 0.1, 0.1, 0.1, NULL, {0, 0, 0}};
    sf_grid *grid = leaning(0.5, &lattice);
    sf_steepest found, before;
    failing_allocator memory;
    memset(&before, 0x5a, sizeof before);
    found = before;
    CHECK_EQ(sf_grid_steepest(NULL, SF_BED_AUTO, stack_allocator(), NULL, &found), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_steepest(grid, 20, stack_allocator(), NULL, &found), SF_ERR_ARGUMENT);
    task = sf_task_default();
    task.progress = watch;
    task.user = &task;
    last = 0;
    CHECK_EQ(sf_grid_steepest(grid, SF_BED_AUTO, stack_allocator(), &task, &found),
             SF_ERR_CANCELLED);
    CHECK(last < 0.6);
    task = sf_task_default();
    task.progress = watch;
    last = 0;
    CHECK_EQ(sf_grid_steepest(grid, SF_BED_AUTO, stack_allocator(), &task, &before), SF_OK);
    CHECK_NEAR(last, 1, 0);
    memset(&before, 0x5a, sizeof before);
    sf_grid_destroy(grid);
    lattice.heights_mm = heights;
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &grid), SF_OK);
    for (long k = 0;; k++) {
        failing_begin(&memory, k);
        sf_status status = sf_grid_steepest(grid, SF_BED_AUTO, &memory.allocator, NULL, &found);
        CHECK_EQ(memory.live, 0);
        CHECK_EQ(memory.faults, 0);
        if (status == SF_OK) {
            CHECK(k > 1);
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
        CHECK(memcmp(&found, &before, sizeof found) == 0);
    }
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(wedges_of_known_slope);
    TEST(islands_have_no_angle);
    TEST(failing_calls_change_nothing);
    return test_finish();
}
