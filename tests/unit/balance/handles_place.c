// SPDX-License-Identifier: MIT
// Why: whoever has no handles of their own gets some that are worth moving. Depths are held against
// a look at every box outside, distances through the solid against rounds of relaxing; places
// against what the header says of them, and against a figure where anyone would put them.

#include "failing_allocator.h"
#include "solid.h"

#include "balance/handle/handles_depth.h"
#include "base/memory.h"

#include <sf/weights.h>

static const double heights[] = {1, 1.25, 0.75, 1, 1, 1.25, 1, 1};

// Distance of the middle of a cell to the closest box that is none, or out of the box around all.
static double naive_depth(const sfi_domain *d, size_t cell)
{
    double middle[3], least = INFINITY;
    sfi_domain_middle(d, cell, middle);
    for (int axis = 0; axis < 3; axis++) {
        double low = middle[axis] - d->planes[axis][0],
               high = d->planes[axis][d->cells[axis]] - middle[axis];
        least = low < least ? low : least;
        least = high < least ? high : least;
    }
    for (uint32_t n = 0; n < d->box_count; n++) {
        uint32_t at[3] = {n % d->cells[0], n / d->cells[0] % d->cells[1],
                          n / d->cells[0] / d->cells[1]};
        double square = 0;
        for (int axis = 0; axis < 3 && d->cell_at[n] == SFI_NO_CELL; axis++) {
            double low = d->planes[axis][at[axis]], high = d->planes[axis][at[axis] + 1];
            double by = middle[axis] < low    ? low - middle[axis]
                        : middle[axis] > high ? middle[axis] - high
                                              : 0;
            square += by * by;
        }
        least = d->cell_at[n] == SFI_NO_CELL && sqrt(square) < least ? sqrt(square) : least;
    }
    return least;
}

// No step makes any distance shorter, and each but those of the beginning is one step from another.
static void check_distances(const sfi_domain *d, const double *distance)
{
    for (size_t a = 0; a < d->cell_count; a++) {
        int has_step = distance[a] == 0 || distance[a] == INFINITY;
        for (size_t b = 0; b < d->cell_count; b++) {
            double p[3], q[3], square = 0;
            int near = a != b;
            sfi_domain_middle(d, a, p);
            sfi_domain_middle(d, b, q);
            for (size_t axis = 0; axis < 3; axis++) {
                near &= d->place[3 * a + axis] <= d->place[3 * b + axis] + 1 &&
                        d->place[3 * b + axis] <= d->place[3 * a + axis] + 1;
                square += (p[axis] - q[axis]) * (p[axis] - q[axis]);
            }
            if (near) {
                CHECK(distance[a] <= distance[b] + sqrt(square) + 1e-12);
                has_step |= fabs(distance[a] - distance[b] - sqrt(square)) < 1e-12;
            }
        }
        CHECK(has_step);
    }
}

static void depths_and_distances(void)
{
    sf_lattice lattice = {11, 9, 8, 1, 1.125, 1, heights, {30, -4, 5}};
    for (int round = 0; round < 5; round++) {
        sf_grid *grid = random_solid(&lattice, round == 0 ? 1 : 0.95);
        sf_allocator allocator = sfi_allocator_or_default(NULL);
        sfi_domain d;
        CHECK_EQ(sfi_domain_create(grid, 0, 100000, &allocator, &d), SF_OK);
        double *depth = malloc(2 * d.cell_count * sizeof *depth), *distance = depth + d.cell_count;
        CHECK_EQ(sfi_domain_depth(&d, &allocator, depth), SF_OK);
        for (size_t c = 0; c < d.cell_count; c++) {
            CHECK_NEAR(depth[c], naive_depth(&d, c), 1e-12);
            distance[c] = INFINITY;
        }
        uint32_t from[2] = {0, (uint32_t)d.cell_count / 2};
        sfi_spread spread = {malloc(4 * d.cell_count), malloc(4 * d.cell_count), 0};
        sfi_domain_spread(&d, from, 2, &spread, distance);
        check_distances(&d, distance);
        free(spread.heap);
        free(spread.where);
        free(depth);
        sfi_domain_destroy(&d);
        sf_grid_destroy(grid);
    }
}

// A trunk on two legs with two arms and a head, and its feet.
static sf_grid *figure(int finer, sf_grid **feet)
{
    uint32_t size = 32u * (uint32_t)finer;
    sf_lattice lattice = {size,        size / 2,    size, 1.0 / finer,
                          1.0 / finer, 1.0 / finer, NULL, {100, 0, 0}};
    sf_grid *grid = random_solid(&lattice, 0);
    for (uint32_t n = 0; n < size * size * size / 2; n++) {
        uint32_t i = n % size, j = n / size % (size / 2), k = n / size / (size / 2);
        double x = (i + 0.5) / finer - 16, y = (j + 0.5) / finer - 8, z = (k + 0.5) / finer;
        int trunk = x * x + y * y < 16 && z > 10 && z < 22;
        int arm = y * y + (z - 19) * (z - 19) < 4 && fabs(x) < 15;
        int leg = (fabs(x) - 3) * (fabs(x) - 3) + y * y < 5 && z <= 10;
        int head = x * x + y * y + (z - 26) * (z - 26) < 25;
        if (trunk || arm || leg || head) {
            CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), i, j, 1), SF_OK);
        }
    }
    double up[3] = {0, 0, 1};
    CHECK_EQ(sf_grid_foot(grid, up, 1, NULL, feet), SF_OK);
    return grid;
}

static void a_figure_is_held_by_hands_and_head(void)
{
    for (int finer = 1; finer <= 3; finer++) {
        sf_grid *feet, *grid = figure(finer, &feet);
        sf_place_options options = sf_place_options_default();
        sf_handle handles[8], again[8];
        size_t count = 0, more = 0;
        int hands = 0, head = 0;
        options.base = feet;
        options.count = 3;
        options.most_cells = 4000;
        CHECK_EQ(sf_handles_place(grid, &options, NULL, NULL, handles, 8, &count, NULL), SF_OK);
        CHECK_EQ(count, 3);
        for (size_t i = 0; i < count; i++) {
            double x = handles[i].at_mm[0] - 116, z = handles[i].at_mm[2];
            hands += fabs(x) > 11 && fabs(z - 19) < 2;
            head += fabs(x) < 2.5 && fabs(z - 26) < 2.5;
            CHECK(handles[i].kind == SF_HANDLE_POINT && handles[i].locked == 0);
        }
        CHECK_EQ(hands, 2);
        CHECK_EQ(head, 1);
        // With a fourth the first three stay.
        options.count = 4;
        CHECK_EQ(sf_handles_place(grid, &options, NULL, NULL, again, 8, &more, NULL), SF_OK);
        CHECK_EQ(more, 4);
        for (size_t i = 0; i < 3; i++) {
            CHECK(memcmp(handles[i].at_mm, again[i].at_mm, sizeof again[i].at_mm) == 0);
            CHECK(handles[i].kind == again[i].kind && handles[i].radius_mm == again[i].radius_mm);
        }
        // What was placed can be used.
        sf_weights *weights = NULL;
        sf_weights_options how = sf_weights_options_default();
        how.most_cells = options.most_cells;
        CHECK_EQ(sf_handle_base(feet, &again[4]), SF_OK);
        CHECK_EQ(sf_weights_create(grid, again, 5, &how, NULL, NULL, &weights, NULL), SF_OK);
        sf_weights_destroy(weights);
        sf_grid_destroy(feet);
        sf_grid_destroy(grid);
    }
}

static void without_a_base_the_deepest_comes_first(void)
{
    sf_grid *feet, *grid = figure(1, &feet);
    sf_handle handles[SF_HANDLE_MAX];
    sf_place_options options = sf_place_options_default();
    size_t count = 0;
    options.count = SF_HANDLE_MAX;
    CHECK_EQ(sf_handles_place(grid, &options, NULL, NULL, handles, SF_HANDLE_MAX, &count, NULL),
             SF_OK);
    printf("# %zu handles find room\n", count);
    CHECK(count > 5 && count < SF_HANDLE_MAX);
    CHECK(fabs(handles[0].at_mm[0] - 116) < 1 && fabs(handles[0].at_mm[2] - 26) < 2);
    for (size_t i = 0; i < count; i++) {
        for (size_t j = 0; j < i; j++) {
            double apart = 0;
            for (int d = 0; d < 3; d++) {
                double by = fabs(handles[i].at_mm[d] - handles[j].at_mm[d]);
                apart = by > apart ? by : apart;
            }
            CHECK(apart > 2.5);
        }
    }
    sf_grid_destroy(feet);
    sf_grid_destroy(grid);
}

// An egg has one place that is deeper than its surroundings; the others lie around it.
static void a_shape_without_limbs_is_held_all_around(void)
{
    sf_lattice lattice = {24, 24, 30, 1, 1, 1, NULL, {-12, -12, -15}};
    sf_grid *grid = random_solid(&lattice, 0);
    sf_handle handles[7];
    sf_place_options options = sf_place_options_default();
    size_t count = 0;
    for (uint32_t n = 0; n < 24 * 24 * 30; n++) {
        double x = n % 24 - 11.5, y = n / 24 % 24 - 11.5, z = n / 576 - 14.5;
        if (x * x + y * y + z * z * 0.64 < 144) {
            CHECK_EQ(sf_slice_set(sf_grid_slice(grid, n / 576), n % 24, n / 24 % 24, 1), SF_OK);
        }
    }
    options.count = 7;
    CHECK_EQ(sf_handles_place(grid, &options, NULL, NULL, handles, 7, &count, NULL), SF_OK);
    CHECK_EQ(count, 7);
    for (size_t i = 0; i < count; i++) {
        const double *p = handles[i].at_mm;
        double away = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        CHECK(i == 0 ? away < 2 : away > 2 && away < 10);
    }
    sf_grid_destroy(grid);
}

static void balls_leave_room(void)
{
    sf_grid *feet, *grid = figure(2, &feet);
    sf_handle handles[13];
    sf_place_options options = sf_place_options_default();
    size_t count = 0;
    options.count = 12;
    options.ball = 0.8;
    options.base = feet;
    CHECK_EQ(sf_handles_place(grid, &options, NULL, NULL, handles, 12, &count, NULL), SF_OK);
    CHECK(count >= 4);
    for (size_t i = 0; i < count; i++) {
        CHECK(handles[i].kind == SF_HANDLE_BALL && handles[i].radius_mm > 0.3);
        CHECK(handles[i].radius_mm < 4.1);
    }
    CHECK_EQ(sf_handle_base(feet, &handles[count]), SF_OK);
    sf_weights *weights = NULL;
    CHECK_EQ(sf_weights_create(grid, handles, count + 1, NULL, NULL, NULL, &weights, NULL), SF_OK);
    sf_weights_destroy(weights);
    sf_grid_destroy(feet);
    sf_grid_destroy(grid);
}

static void what_cannot_be_is_refused(void)
{
    sf_grid *feet, *grid = figure(1, &feet), *empty;
    sf_lattice lattice = sf_grid_lattice(grid), small = {3, 3, 3, 1, 1, 1, NULL, {0, 0, 0}};
    sf_handle handles[8];
    sf_place_options o = sf_place_options_default();
    sf_fault fault;
    size_t count = 7;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &empty), SF_OK);
    sf_grid *other = random_solid(&small, 1);
    CHECK_EQ(sf_handles_place(NULL, &o, NULL, NULL, handles, 8, &count, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handles_place(grid, &o, NULL, NULL, NULL, 8, &count, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handles_place(grid, &o, NULL, NULL, handles, 8, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_handles_place(empty, &o, NULL, NULL, handles, 8, &count, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "no voxels") != NULL);
    o.base = other;
    CHECK_EQ(sf_handles_place(grid, &o, NULL, NULL, handles, 8, &count, NULL), SF_ERR_SHAPE);
    o.base = grid;
    CHECK_EQ(sf_handles_place(grid, &o, NULL, NULL, handles, 8, &count, &fault), SF_ERR_INFEASIBLE);
    CHECK(strstr(fault.message, "three cells away") != NULL);
    o = sf_place_options_default();
    o.count = 0;
    CHECK_EQ(sf_handles_place(grid, &o, NULL, NULL, handles, 8, &count, NULL), SF_ERR_ARGUMENT);
    o.count = SF_HANDLE_MAX + 1;
    CHECK_EQ(sf_handles_place(grid, &o, NULL, NULL, handles, 8, &count, NULL), SF_ERR_ARGUMENT);
    o = sf_place_options_default();
    o.ball = 1.5;
    CHECK_EQ(sf_handles_place(grid, &o, NULL, NULL, handles, 8, &count, NULL), SF_ERR_ARGUMENT);
    o = sf_place_options_default();
    o.struct_size = 1;
    CHECK_EQ(sf_handles_place(grid, &o, NULL, NULL, handles, 8, &count, NULL), SF_ERR_ARGUMENT);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_handles_place(grid, NULL, NULL, &task, handles, 8, &count, NULL), SF_ERR_CANCELLED);
    CHECK_EQ(count, 7);
    CHECK_EQ(sf_handles_place(grid, NULL, NULL, NULL, handles, 4, &count, NULL), SF_ERR_CAPACITY);
    CHECK_EQ(count, 5);
    sf_status status = SF_ERR_MEMORY;
    failing_allocator failing;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        failing_begin(&failing, k);
        status = sf_handles_place(grid, NULL, &failing.allocator, NULL, handles, 8, &count, NULL);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    sf_grid_destroy(other);
    sf_grid_destroy(empty);
    sf_grid_destroy(feet);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(depths_and_distances);
    TEST(a_figure_is_held_by_hands_and_head);
    TEST(without_a_base_the_deepest_comes_first);
    TEST(a_shape_without_limbs_is_held_all_around);
    TEST(balls_leave_room);
    TEST(what_cannot_be_is_refused);
    return test_finish();
}
