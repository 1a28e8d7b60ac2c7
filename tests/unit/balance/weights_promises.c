// SPDX-License-Identifier: MIT
// Why: weights have to hold whatever they are asked for. Promises: the same bytes for any number of
// threads; the same weights for a shape that is moved, scaled or mirrored; blocks of voxels that
// are as few as asked; pieces without a handle that follow the closest; sentences for what cannot
// be; nothing kept and nothing changed when memory runs out or a task is cancelled.

#include "backwards.h"
#include "failing_allocator.h"
#include "solid.h"

#include <sf/weights.h>

enum { COUNT = 6 };

// A lump with six points, of which four make a group of their own.
static sf_grid *lump(uint32_t size, double pitch, const double origin[3])
{
    sf_lattice lattice = {size,  size,  size, pitch,
                          pitch, pitch, NULL, {origin[0], origin[1], origin[2]}};
    sf_grid *grid = random_solid(&lattice, 0);
    for (uint32_t n = 0; n < size * size * size; n++) {
        double x = n % size + 0.5 - 0.5 * size, y = n / size % size + 0.5 - 0.5 * size,
               z = n / size / size + 0.5 - 0.5 * size;
        int inside = x * x + y * y + z * z < 0.25 * size * size || fabs(x) < 2;
        CHECK_EQ(
            sf_slice_set(sf_grid_slice(grid, n / size / size), n % size, n / size % size, inside),
            SF_OK);
    }
    return grid;
}

static void place(const sf_grid *grid, sf_handle handles[COUNT])
{
    const double at[COUNT][3] = {{0.5, 0.1, 0.1}, {0.5, 0.9, 0.9}, {0.5, 0.1, 0.9},
                                 {0.2, 0.5, 0.5}, {0.8, 0.5, 0.5}, {0.5, 0.9, 0.1}};
    sf_lattice l = sf_grid_lattice(grid);
    for (int j = 0; j < COUNT; j++) {
        sf_handle h = {SF_HANDLE_POINT, {0, 0, 0}, 0, NULL, 0};
        for (int d = 0; d < 3; d++) {
            h.at_mm[d] = l.origin_mm[d] + at[j][d] * l.nx * l.pitch_x_mm;
        }
        handles[j] = h;
    }
}

static sf_weights *make(const sf_grid *grid, const sf_handle *handles, size_t count,
                        const sf_weights_options *options, sf_task *task)
{
    sf_weights *weights = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status =
        sf_weights_create(grid, handles, count, options, NULL, task, &weights, &fault);
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
    }
    CHECK_EQ(status, SF_OK);
    return weights;
}

// A point of the cube around a grid, at random.
static void random_point(const sf_grid *grid, double p[3])
{
    sf_lattice l = sf_grid_lattice(grid);
    for (int d = 0; d < 3; d++) {
        p[d] = l.origin_mm[d] + (1.2 * test_random_unit() - 0.1) * l.nx * l.pitch_x_mm;
    }
}

static void rising(void *user, double fraction)
{
    double *last = user;
    CHECK(fraction >= *last && fraction <= 1);
    *last = fraction;
}

static void the_same_bytes_and_progress(void)
{
    const double origin[3] = {0, 0, 0};
    sf_grid *grid = lump(14, 1, origin);
    sf_handle handles[COUNT];
    place(grid, handles);
    for (int method = 0; method < 2; method++) {
        sf_weights_options options = sf_weights_options_default();
        options.method = (sf_weights_method)method;
        sf_task task = sf_task_default(), plain = sf_task_default();
        double last = 0;
        task.parallel_for = backwards;
        plain.progress = rising;
        plain.user = &last;
        sf_weights *a = make(grid, handles, COUNT, &options, &plain),
                   *b = make(grid, handles, COUNT, &options, &task);
        CHECK(last == 1);
        for (int i = 0; i < 1000; i++) {
            double p[3], one[COUNT], two[COUNT];
            random_point(grid, p);
            CHECK_EQ(sf_weights_at(a, p, one, NULL), SF_OK);
            CHECK_EQ(sf_weights_at(b, p, two, NULL), SF_OK);
            CHECK(memcmp(one, two, sizeof one) == 0);
        }
        sf_weights_destroy(a);
        sf_weights_destroy(b);
    }
    sf_grid_destroy(grid);
}

static void moved_scaled_and_mirrored(void)
{
    const double origin[3] = {0, 0, 0}, away[3] = {-700, 90, 3};
    sf_grid *here = lump(12, 1, origin), *there = lump(12, 25, away);
    sf_handle a[COUNT], b[COUNT];
    place(here, a);
    place(there, b);
    sf_weights *one = make(here, a, COUNT, NULL, NULL), *two = make(there, b, COUNT, NULL, NULL);
    for (int i = 0; i < 1000; i++) {
        double p[3], q[3], w[COUNT], v[COUNT];
        random_point(here, p);
        for (int d = 0; d < 3; d++) {
            q[d] = away[d] + 25 * p[d];
        }
        CHECK_EQ(sf_weights_at(one, p, w, NULL), SF_OK);
        CHECK_EQ(sf_weights_at(two, q, v, NULL), SF_OK);
        for (int j = 0; j < COUNT; j++) {
            CHECK_NEAR(w[j], v[j], 1e-6);
        }
    }
    sf_weights_destroy(one);
    sf_weights_destroy(two);
    // Mirrored: the two handles beside the middle alone.
    one = make(here, a + 3, 2, NULL, NULL);
    for (int i = 0; i < 1000; i++) {
        double p[3], w[2], v[2];
        random_point(here, p);
        CHECK_EQ(sf_weights_at(one, p, w, NULL), SF_OK);
        p[0] = 12 - p[0];
        CHECK_EQ(sf_weights_at(one, p, v, NULL), SF_OK);
        CHECK_NEAR(w[0], v[1], 1e-4);
    }
    sf_weights_destroy(one);
    sf_grid_destroy(here);
    sf_grid_destroy(there);
}

static void blocks_are_few_and_nearly_cubes(void)
{
    // Flat voxels: 0.4 by 0.2 by 0.05.
    sf_lattice lattice = {20, 40, 160, 0.4, 0.2, 0.05, NULL, {1, 2, 3}};
    sf_grid *grid = random_solid(&lattice, 1);
    sf_handle handles[2] = {{SF_HANDLE_POINT, {1.3, 2.3, 3.3}, 0, NULL, 0},
                            {SF_HANDLE_POINT, {8.7, 9.7, 10.7}, 0, NULL, 0}};
    sf_weights_options options = sf_weights_options_default();
    sf_weights *weights = make(grid, handles, 2, &options, NULL);
    sf_weights_facts facts = sf_weights_describe(weights);
    CHECK(facts.block[0] == 1 && facts.block[1] == 2 && facts.block[2] == 8);
    CHECK_EQ(facts.cell_count, 8000);
    CHECK_EQ(facts.node_count, 21 * 21 * 21);
    CHECK_NEAR(facts.cell_mm[2], 0.4, 1e-12);
    sf_weights_destroy(weights);
    options.most_cells = 1000;
    weights = make(grid, handles, 2, &options, NULL);
    facts = sf_weights_describe(weights);
    CHECK(facts.cell_count == 1000 && facts.block[0] == 2 && facts.block[2] == 16);
    sf_weights_destroy(weights);
    options.cell_mm = 1.2;
    weights = make(grid, handles, 2, &options, NULL);
    facts = sf_weights_describe(weights);
    CHECK(facts.block[0] == 3 && facts.block[1] == 6 && facts.block[2] == 24);
    CHECK_EQ(facts.cell_count, 7 * 7 * 7);
    double w[2], top[3] = {9, 10, 11};
    CHECK_EQ(sf_weights_at(weights, top, w, NULL), SF_OK);
    CHECK(w[1] == 1 && w[0] == 0);
    sf_weights_destroy(weights);
    sf_grid_destroy(grid);
}

static void one_handle_has_it_all(void)
{
    const double origin[3] = {0, 0, 0};
    sf_grid *grid = lump(8, 1, origin);
    sf_handle handles[COUNT];
    place(grid, handles);
    sf_weights *weights = make(grid, handles, 1, NULL, NULL);
    for (int i = 0; i < 100; i++) {
        double p[3], w[1];
        random_point(grid, p);
        CHECK_EQ(sf_weights_at(weights, p, w, NULL), SF_OK);
        CHECK_NEAR(w[0], 1, 1e-14);
    }
    sf_weights_destroy(weights);
    sf_grid_destroy(grid);
}

static void loose_pieces_follow_the_closest(void)
{
    sf_lattice lattice = {30, 4, 4, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 1);
    // Cut at x = 18..20 and at 24: two pieces more. The long one has a handle at each end.
    for (uint32_t n = 0; n < 16; n++) {
        sf_rect cut = {18, n % 4, 21, n % 4 + 1}, second = {24, n % 4, 25, n % 4 + 1};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, n / 4), cut, 0), SF_OK);
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, n / 4), second, 0), SF_OK);
    }
    sf_handle handles[2] = {{SF_HANDLE_POINT, {0.5, 0.5, 0.5}, 0, NULL, 0},
                            {SF_HANDLE_POINT, {10.5, 2.5, 2.5}, 0, NULL, 0}};
    sf_weights *weights = make(grid, handles, 2, NULL, NULL);
    CHECK_EQ(sf_weights_describe(weights).loose_count, 2);
    double ends[2][3] = {{17.99999, 0.5, 0.5}, {21.5, 2.5, 3.5}}, w[2][2], v[2];
    CHECK_EQ(sf_weights_at(weights, ends[0], w[0], NULL), SF_OK);
    CHECK_EQ(sf_weights_at(weights, ends[1], w[1], NULL), SF_OK);
    CHECK_NEAR(w[0][0], w[1][0], 1e-4);
    for (int i = 0; i < 100; i++) {
        double p[3] = {21 + 9 * test_random_unit(), 4 * test_random_unit(), 4 * test_random_unit()};
        CHECK_EQ(sf_weights_at(weights, p, v, NULL), SF_OK);
        CHECK_NEAR(v[0], w[1][0], 1e-15);
    }
    sf_weights_destroy(weights);
    sf_grid_destroy(grid);
}

// What a handle in another piece does is nothing: weights of a piece are those that it has alone.
static void pieces_do_not_know_of_each_other(void)
{
    sf_lattice lattice = {24, 6, 6, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *both = random_solid(&lattice, 1), *alone = NULL;
    for (uint32_t k = 0; k < 6; k++) {
        sf_rect gap = {12, 0, 13, 6};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(both, k), gap, 0), SF_OK);
    }
    CHECK_EQ(sf_grid_clone(both, NULL, &alone), SF_OK);
    for (uint32_t k = 0; k < 6; k++) {
        sf_rect rest = {13, 0, 24, 6};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(alone, k), rest, 0), SF_OK);
    }
    sf_handle handles[4] = {{SF_HANDLE_POINT, {0.5, 0.5, 0.5}, 0, NULL, 0},
                            {SF_HANDLE_POINT, {8.5, 3.5, 3.5}, 0, NULL, 0},
                            {SF_HANDLE_POINT, {14.5, 0.5, 3.5}, 0, NULL, 0},
                            {SF_HANDLE_POINT, {20.5, 5.5, 3.5}, 0, NULL, 0}};
    for (int method = 0; method < 2; method++) {
        sf_weights_options options = sf_weights_options_default();
        options.method = (sf_weights_method)method;
        options.tolerance = 1e-8;
        sf_weights *all = make(both, handles, 4, &options, NULL),
                   *two = make(alone, handles, 2, &options, NULL);
        for (int i = 0; i < 1000; i++) {
            double p[3] = {24 * test_random_unit(), 6 * test_random_unit(), 6 * test_random_unit()};
            double w[4], v[2];
            CHECK_EQ(sf_weights_at(all, p, w, NULL), SF_OK);
            CHECK_EQ(sf_weights_at(two, p, v, NULL), SF_OK);
            for (int j = 0; p[0] < 12 && j < 4; j++) {
                CHECK_NEAR(w[j], j < 2 ? v[j] : 0, 1e-7);
            }
            CHECK(p[0] < 13 || (w[0] < 1e-7 && w[1] < 1e-7));
        }
        sf_weights_destroy(all);
        sf_weights_destroy(two);
    }
    sf_grid_destroy(both);
    sf_grid_destroy(alone);
}

static void refuse(const sf_grid *grid, const sf_handle *handles, size_t count, sf_status status,
                   const char *words)
{
    sf_weights *weights = (sf_weights *)(void *)&status;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_weights_create(grid, handles, count, NULL, NULL, NULL, &weights, &fault), status);
    CHECK_EQ(fault.status, status);
    CHECK(weights == (sf_weights *)(void *)&status);
    if (strstr(fault.message, words) == NULL) {
        printf("# \"%s\" lacks \"%s\"\n", fault.message, words);
        CHECK(0);
    }
}

static void what_cannot_be_is_refused(void)
{
    const double origin[3] = {0, 0, 0};
    sf_grid *grid = lump(12, 1, origin), *other = lump(8, 1, origin), *empty, *corner;
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_handle h[COUNT];
    CHECK_EQ(sf_grid_create(&lattice, NULL, &empty), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &corner), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(corner, 0), 0, 0, 1), SF_OK);
    place(grid, h);
    refuse(grid, h, 0, SF_ERR_ARGUMENT, "1 to 64");
    refuse(grid, h, 65, SF_ERR_ARGUMENT, "1 to 64");
    refuse(empty, h, 1, SF_ERR_ARGUMENT, "no voxels");
    h[2].at_mm[0] = 0.5;
    h[2].at_mm[1] = 0.5;
    refuse(grid, h, 4, SF_ERR_INFEASIBLE, "handle 3 lies outside the solid");
    h[2].at_mm[1] = NAN;
    refuse(grid, h, 4, SF_ERR_ARGUMENT, "handle 3 is no");
    place(grid, h);
    h[5] = h[1];
    h[5].at_mm[0] -= 0.7;
    refuse(grid, h, 6, SF_ERR_INFEASIBLE, "handles 2 and 6 touch");
    place(grid, h);
    h[1].kind = SF_HANDLE_BALL;
    refuse(grid, h, 2, SF_ERR_ARGUMENT, "handle 2 is no");
    h[1].radius_mm = 100;
    refuse(grid, h, 2, SF_ERR_INFEASIBLE, "handles 1 and 2 touch");
    h[1].kind = SF_HANDLE_BASE;
    refuse(grid, h, 2, SF_ERR_ARGUMENT, "handle 2 is no");
    h[1].region = other;
    refuse(grid, h, 2, SF_ERR_SHAPE, "region of handle 2");
    h[1].region = empty;
    refuse(grid, h, 2, SF_ERR_ARGUMENT, "without a single voxel");
    h[1].region = corner;
    refuse(grid, h, 2, SF_ERR_INFEASIBLE, "base that lies outside");
    h[1].kind = (sf_handle_kind)7;
    refuse(grid, h, 2, SF_ERR_ARGUMENT, "no point, ball or base");
    sf_grid_destroy(grid);
    sf_grid_destroy(other);
    sf_grid_destroy(empty);
    sf_grid_destroy(corner);
}

static void options_out_of_range_are_refused(void)
{
    const double origin[3] = {0, 0, 0};
    sf_grid *grid = lump(12, 1, origin);
    sf_handle h[COUNT];
    sf_weights_options o = sf_weights_options_default();
    sf_weights *weights = NULL;
    place(grid, h);
    o.struct_size = 0;
    CHECK_EQ(sf_weights_create(grid, h, 2, &o, NULL, NULL, &weights, NULL), SF_ERR_ARGUMENT);
    o = sf_weights_options_default();
    o.tolerance = 0;
    CHECK_EQ(sf_weights_create(grid, h, 2, &o, NULL, NULL, &weights, NULL), SF_ERR_ARGUMENT);
    o = sf_weights_options_default();
    o.cell_mm = NAN;
    CHECK_EQ(sf_weights_create(grid, h, 2, &o, NULL, NULL, &weights, NULL), SF_ERR_ARGUMENT);
    o = sf_weights_options_default();
    o.method = (sf_weights_method)2;
    CHECK_EQ(sf_weights_create(grid, h, 2, &o, NULL, NULL, &weights, NULL), SF_ERR_ARGUMENT);
    o = sf_weights_options_default();
    o.most_cells = 7;
    CHECK_EQ(sf_weights_create(grid, h, 2, &o, NULL, NULL, &weights, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_create(NULL, h, 2, NULL, NULL, NULL, &weights, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_create(grid, NULL, 2, NULL, NULL, NULL, &weights, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_weights_create(grid, h, 2, NULL, NULL, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK(weights == NULL);
    sf_weights_destroy(NULL);
    sf_grid_destroy(grid);
}

static void memory_runs_out(void)
{
    // Two pieces, so that every path takes memory.
    sf_lattice lattice = {12, 5, 5, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 1);
    for (uint32_t k = 0; k < 5; k++) {
        sf_rect cut = {9, 0, 10, 5};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), cut, 0), SF_OK);
    }
    sf_handle handles[2] = {{SF_HANDLE_POINT, {0.5, 0.5, 0.5}, 0, NULL, 0},
                            {SF_HANDLE_POINT, {7.5, 2.5, 2.5}, 0, NULL, 0}};
    for (int method = 0; method < 2; method++) {
        sf_weights_options options = sf_weights_options_default();
        failing_allocator failing;
        sf_weights *weights = NULL;
        sf_fault fault;
        options.method = (sf_weights_method)method;
        sf_status status = SF_ERR_MEMORY;
        long k = 0;
        for (; status == SF_ERR_MEMORY && k < 1000; k++) {
            failing_begin(&failing, k);
            status = sf_weights_create(grid, handles, 2, &options, &failing.allocator, NULL,
                                       &weights, &fault);
            CHECK(status == SF_OK || (weights == NULL && failing.live == 0));
            CHECK(failing.faults == 0);
        }
        CHECK_EQ(status, SF_OK);
        CHECK(k > 20);
        sf_weights_destroy(weights);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    sf_grid_destroy(grid);
}

static void stop_midway(void *user, size_t count, sf_task_body body, void *context)
{
    sf_task_cancel(user);
    backwards(NULL, count, body, context);
}

static void cancels_are_heeded(void)
{
    const double origin[3] = {0, 0, 0};
    sf_grid *grid = lump(12, 1, origin);
    sf_handle handles[COUNT];
    place(grid, handles);
    for (int method = 0; method < 2; method++) {
        sf_weights_options options = sf_weights_options_default();
        failing_allocator failing;
        sf_weights *weights = NULL;
        sf_task task = sf_task_default();
        options.method = (sf_weights_method)method;
        failing_begin(&failing, -1);
        task.parallel_for = stop_midway;
        task.user = &task;
        CHECK_EQ(sf_weights_create(grid, handles, COUNT, &options, &failing.allocator, &task,
                                   &weights, NULL),
                 SF_ERR_CANCELLED);
        CHECK_EQ(sf_weights_create(grid, handles, COUNT, &options, &failing.allocator, &task,
                                   &weights, NULL),
                 SF_ERR_CANCELLED);
        CHECK(weights == NULL && failing.live == 0 && failing.faults == 0);
    }
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(the_same_bytes_and_progress);
    TEST(moved_scaled_and_mirrored);
    TEST(blocks_are_few_and_nearly_cubes);
    TEST(one_handle_has_it_all);
    TEST(loose_pieces_follow_the_closest);
    TEST(pieces_do_not_know_of_each_other);
    TEST(what_cannot_be_is_refused);
    TEST(options_out_of_range_are_refused);
    TEST(memory_runs_out);
    TEST(cancels_are_heeded);
    return test_finish();
}
