// SPDX-License-Identifier: MIT
// Why: what slicers hand over as polygons must become just the voxels whose centres they enclose,
// under both fills; polygons that share an edge must neither share a voxel nor leave one out; and
// voxels traced into contours must come back as they were. The oracle asks each centre on its own
// how often it is wound around, by signs of products. (TRUST 31, 79, 85, 87.)

#include "random_slice.h"

#include "failing_allocator.h"

#include <sf/support.h>

#define POINTS 64

static uint64_t memory[3][4096];
static double points[2 * POINTS];
static size_t starts[9];

// Whole numbers of 1/8192 voxel, on a lattice of pitch 1 / 2 and 1 / 4 with its corner at (-3, 5).
static const sf_lattice lattice = {70, 23, 1, 0.5, 0.25, 1.0, NULL, {-3, 5, 0}};

static int winding(const sf_contours *c, double x, double y, int *parity)
{
    int turns = 0;
    for (size_t k = 0; k < c->contour_count; k++) {
        size_t begin = c->starts[k], count = c->starts[k + 1] - begin;
        for (size_t i = 0; i < count; i++) {
            const double *a = c->points_mm + 2 * (begin + i);
            const double *b = c->points_mm + 2 * (begin + (i + 1) % count);
            int up = a[1] <= y && b[1] > y, down = b[1] <= y && a[1] > y;
            double side = (b[0] - a[0]) * (y - a[1]) - (x - a[0]) * (b[1] - a[1]);
            // Left of the centre or through it: exact, as all are small multiples of 2^-15.
            turns += up && side <= 0 ? 1 : down && side >= 0 ? -1 : 0;
            *parity ^= (up && side <= 0) || (down && side >= 0);
        }
    }
    return turns;
}

static void compare(const sf_contours *c, uint64_t *words)
{
    for (int fill = 0; fill < 2; fill++) {
        sf_slice slice = {words, lattice.nx, lattice.ny, 3};
        memset(words, 0xa5, sizeof memory[0]);
        CHECK_EQ(sf_slice_from_contours(slice, &lattice, c, (sf_contour_fill)fill, NULL, NULL),
                 SF_OK);
        for (uint32_t y = 0; y < lattice.ny; y++) {
            for (uint32_t x = 0; x < lattice.nx; x++) {
                int parity = 0;
                int turns = winding(c, -3 + 0.5 * (x + 0.5), 5 + 0.25 * (y + 0.5), &parity);
                CHECK_EQ(sf_slice_get(slice, x, y), fill == 0 ? turns != 0 : parity);
            }
        }
    }
}

static void random_polygons(void)
{
    for (int round = 0; round < 400; round++) {
        size_t contours = 1 + test_random_below(8), at = 0;
        int coarse = round % 3 == 0; // points on centres and borders of voxels
        for (size_t c = 0; c < contours; c++) {
            starts[c] = at;
            at += test_random_below(POINTS / 8);
        }
        starts[contours] = at;
        for (size_t i = 0; i < at; i++) {
            double step = coarse ? 0.5 : 1.0 / 8192;
            double x = floor((-10 + 90 * test_random_unit()) / step) * step;
            double y = floor((-10 + 40 * test_random_unit()) / step) * step;
            points[2 * i] = -3 + 0.5 * x;
            points[2 * i + 1] = 5 + 0.25 * y;
        }
        sf_contours c = {points, starts, contours};
        compare(&c, memory[0]);
    }
}

// The plane cut into triangles that share edges: each voxel belongs to exactly one.
static void neighbours_share_nothing(void)
{
    double corner[4][2] = {{-4, 4}, {33, 4}, {33, 12}, {-4, 12}};
    for (int round = 0; round < 100; round++) {
        double middle[2] = {-3 + floor(70 * test_random_unit()) * 0.25,
                            5 + floor(46 * test_random_unit()) * 0.125};
        sf_slice sum = {memory[0], lattice.nx, lattice.ny, 2}, one = sum;
        uint64_t solid = 0;
        one.words = memory[1];
        memset(memory[0], 0, sizeof memory[0]);
        for (int i = 0; i < 4; i++) {
            double triangle[6] = {corner[i][0],           corner[i][1], corner[(i + 1) % 4][0],
                                  corner[(i + 1) % 4][1], middle[0],    middle[1]};
            size_t bounds[2] = {0, 3};
            sf_contours c = {triangle, bounds, 1};
            CHECK_EQ(sf_slice_from_contours(one, &lattice, &c, SF_CONTOUR_NONZERO, NULL, NULL),
                     SF_OK);
            solid += sf_slice_popcount(one);
            CHECK_EQ(sf_slice_or(sum, sum, one), SF_OK);
        }
        CHECK_EQ(sf_slice_popcount(sum), 70 * 23);
        CHECK_EQ(solid, 70 * 23);
    }
}

static void traced_and_drawn_again(void)
{
    for (uint32_t round = 0; round < 200; round++) {
        sf_lattice l = {1 + round, 1 + test_random_below(20), 1, 0.1, 0.3, 1.0, NULL, {0.7, -2, 0}};
        sf_slice slice = {memory[0], l.nx, l.ny, 4 + round % 3}, back = slice;
        sf_contour_stack *stack = NULL;
        sf_contours c;
        back.words = memory[1];
        random_slice(slice, round % 9);
        CHECK_EQ(sf_contour_stack_create(0, NULL, &stack), SF_OK);
        CHECK_EQ(sf_contour_stack_trace(stack, 0.5, slice, &l), SF_OK);
        CHECK_EQ(sf_contour_stack_layer(stack, 0, &c, NULL, NULL), SF_OK);
        for (int fill = 0; fill < 2; fill++) {
            memset(memory[1], 0xff, sizeof memory[1]);
            CHECK_EQ(sf_slice_from_contours(back, &l, &c, (sf_contour_fill)fill, NULL, NULL),
                     SF_OK);
            CHECK(sf_slice_equal(back, slice));
        }
        CHECK_NEAR(sf_contours_area_mm2(&c), 0.1 * 0.3 * (double)sf_slice_popcount(slice), 1e-9);
        sf_contour_stack_destroy(stack);
    }
}

// A ring: the hole turns right, points are where it turns, and nothing else is said.
static void trace_of_a_ring(void)
{
    sf_lattice l = {8, 8, 1, 1, 1, 1.0, NULL, {0, 0, 0}};
    sf_slice slice = {memory[0], 8, 8, 1};
    sf_contour_stack *stack = NULL;
    sf_contours c;
    double bottom, top;
    static const double expected[16] = {6, 1, 6, 6, 1, 6, 1, 1, 2, 2, 2, 5, 5, 5, 5, 2};
    memset(memory[0], 0, sizeof memory[0]);
    sf_rect outer = {1, 1, 6, 6}, inner = {2, 2, 5, 5};
    CHECK_EQ(sf_slice_fill(slice, outer, 1), SF_OK);
    CHECK_EQ(sf_slice_fill(slice, inner, 0), SF_OK);
    CHECK_EQ(sf_contour_stack_create(-1, NULL, &stack), SF_OK);
    CHECK_EQ(sf_contour_stack_trace(stack, 0.5, slice, &l), SF_OK);
    CHECK_EQ(sf_contour_stack_layer(stack, 0, &c, &bottom, &top), SF_OK);
    CHECK(bottom == -1 && top == 0.5 && c.contour_count == 2 && c.starts[1] == 4);
    int good = c.starts[2] == 8;
    for (int i = 0; good && i < 8; i++) {
        // Any corner may be the first of its contour.
        int found = 0;
        for (int j = i / 4 * 4; j < i / 4 * 4 + 4; j++) {
            found |= c.points_mm[2 * i] == expected[2 * j] &&
                     c.points_mm[2 * i + 1] == expected[2 * j + 1];
        }
        good = found;
    }
    CHECK(good);
    CHECK_EQ(sf_contours_area_mm2(&c), 25 - 9);
    sf_contour_stack_destroy(stack);
}

static void stacks_become_grids(void)
{
    static const double squares[16] = {0, 0, 4, 0, 4, 4, 0, 4, 1, 1, 3, 1, 3, 3, 1, 3};
    static const size_t two[3] = {0, 4, 8};
    sf_contours nested = {squares, two, 2}, none = {NULL, NULL, 0};
    sf_contour_stack *stack = NULL;
    sf_grid *grid = NULL;
    sf_lattice l;
    double heights[3];
    CHECK_EQ(sf_contour_stack_create(1, NULL, &stack), SF_OK);
    CHECK_EQ(sf_contour_stack_lattice(stack, 0.5, 0.5, heights, 3, &l), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_contour_stack_add(stack, 1.25, &nested, NULL), SF_OK);
    CHECK_EQ(sf_contour_stack_add(stack, 1.5, &none, NULL), SF_OK);
    CHECK_EQ(sf_contour_stack_add(stack, 2.5, &nested, NULL), SF_OK);
    CHECK_EQ(sf_contour_stack_count(stack), 3);
    CHECK_EQ(sf_contour_stack_lattice(stack, 0.5, 0.5, heights, 2, &l), SF_ERR_CAPACITY);
    CHECK_EQ(sf_contour_stack_lattice(stack, 0.5, 0.5, heights, 3, &l), SF_OK);
    CHECK(l.nx == 9 && l.ny == 9 && l.nz == 3 && heights[0] == 0.25 && heights[2] == 1.0 &&
          l.origin_mm[2] == 1);
    CHECK_EQ(sf_grid_from_contours(stack, &l, SF_CONTOUR_EVEN_ODD, NULL, NULL, &grid), SF_OK);
    CHECK_EQ(sf_grid_popcount(grid), 2 * (64 - 16));
    sf_grid_destroy(grid);
    CHECK_EQ(sf_grid_from_contours(stack, &l, SF_CONTOUR_NONZERO, NULL, NULL, &grid), SF_OK);
    CHECK_EQ(sf_grid_popcount(grid), 2 * 64); // both squares turn one way
    sf_grid_destroy(grid);
    sf_task task = sf_task_default();
    sf_grid *same = NULL;
    sf_task_cancel(&task);
    CHECK_EQ(sf_grid_from_contours(stack, &l, SF_CONTOUR_NONZERO, NULL, &task, &same),
             SF_ERR_CANCELLED);
    l.nz = 2;
    CHECK_EQ(sf_grid_from_contours(stack, &l, SF_CONTOUR_NONZERO, NULL, NULL, &same), SF_ERR_SHAPE);
    CHECK(same == NULL);
    sf_contour_stack_destroy(stack);
    sf_contour_stack_destroy(NULL);
}

// A check that is fed contours says what a check that is fed their slices says.
static void checks_take_contours(void)
{
    static uint64_t room[2][65536];
    sf_check_report report[2];
    sf_checker *checker[2];
    sf_check_options o = sf_check_options_default();
    uint64_t *aligned[2];
    o.width = lattice.nx;
    o.height = lattice.ny;
    for (int i = 0; i < 2; i++) {
        aligned[i] = (uint64_t *)(((uintptr_t)room[i] + 63) & ~(uintptr_t)63);
        CHECK_EQ(sf_checker_place(&o, aligned[i], sizeof room[i] - 64, &checker[i]), SF_OK);
    }
    for (int k = 0; k < 12; k++) {
        static const size_t one[2] = {0, 3};
        double triangle[6];
        for (int i = 0; i < 6; i++) {
            triangle[i] = i % 2 == 0 ? 35 * test_random_unit() - 3 : 5 + 6 * test_random_unit();
        }
        sf_contours c = {triangle, one, 1};
        sf_slice slice = {memory[0], lattice.nx, lattice.ny, 2};
        CHECK_EQ(sf_slice_from_contours(slice, &lattice, &c, SF_CONTOUR_NONZERO, NULL, NULL),
                 SF_OK);
        CHECK_EQ(sf_checker_push(checker[0], slice), SF_OK);
        CHECK_EQ(sf_checker_push_contours(checker[1], &lattice, &c, SF_CONTOUR_NONZERO, NULL, NULL),
                 SF_OK);
    }
    for (int i = 0; i < 2; i++) {
        CHECK_EQ(sf_checker_report(checker[i], &report[i], NULL), SF_OK);
    }
    CHECK(report[0].unsupported_voxels > 0);
    CHECK(memcmp(&report[0], &report[1], sizeof report[0]) == 0);
    sf_lattice other = lattice;
    sf_contours none = {NULL, NULL, 0};
    other.nx++;
    CHECK_EQ(sf_checker_push_contours(checker[1], &other, &none, SF_CONTOUR_NONZERO, NULL, NULL),
             SF_ERR_SHAPE);
    CHECK_EQ(sf_checker_push_contours(NULL, &lattice, &none, SF_CONTOUR_NONZERO, NULL, NULL),
             SF_ERR_ARGUMENT);
}

static void nonsense_is_refused(void)
{
    static const size_t good[2] = {0, 3}, falls[3] = {0, 3, 2}, late[2] = {1, 3};
    double p[6] = {0, 6, 1, 6, 1, 7};
    sf_slice slice = {memory[0], lattice.nx, lattice.ny, 2}, small = {memory[0], 3, 3, 1};
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_contours c = {p, good, 1}, wrong = {p, falls, 2}, shifted = {p, late, 1};
    sf_contours no_points = {NULL, good, 1}, no_starts = {p, NULL, 1};
    sf_contour_stack *stack = NULL;
    memset(memory[0], 0x11, sizeof memory[0]);
    memcpy(memory[1], memory[0], sizeof memory[0]);
    const sf_contours *bad[] = {&wrong, &shifted, &no_points, &no_starts, NULL};
    for (int i = 0; i < 5; i++) {
        CHECK_EQ(sf_slice_from_contours(slice, &lattice, bad[i], SF_CONTOUR_NONZERO, NULL, NULL),
                 SF_ERR_ARGUMENT);
    }
    CHECK_EQ(sf_slice_from_contours(slice, &lattice, &c, (sf_contour_fill)2, NULL, NULL),
             SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_from_contours(small, &lattice, &c, SF_CONTOUR_NONZERO, NULL, NULL),
             SF_ERR_SHAPE);
    static const double far[] = {NAN, INFINITY, -INFINITY, 1e300, 131080 * 0.5};
    for (int i = 0; i < 5; i++) {
        p[2] = far[i];
        sf_status status =
            sf_slice_from_contours(slice, &lattice, &c, SF_CONTOUR_NONZERO, NULL, &fault);
        CHECK_EQ(status, i < 3 ? SF_ERR_ARGUMENT : SF_ERR_OVERFLOW);
        CHECK(fault.status == status && strstr(fault.message, "point 1 ") != NULL);
    }
    CHECK(memcmp(memory[0], memory[1], sizeof memory[0]) == 0);
    CHECK(isnan(sf_contours_area_mm2(&wrong)) && sf_contours_area_mm2(NULL) == 0);
    CHECK_EQ(sf_contour_stack_create(NAN, NULL, &stack), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_contour_stack_create(2, NULL, &stack), SF_OK);
    p[2] = 1e13;
    CHECK_EQ(sf_contour_stack_add(stack, 3, &c, &fault), SF_ERR_ARGUMENT);
    p[2] = 1;
    CHECK_EQ(sf_contour_stack_add(stack, 2, &c, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_contour_stack_add(stack, NAN, &c, &fault), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_contour_stack_trace(stack, 1, slice, &lattice), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_contour_stack_trace(stack, 3, small, &lattice), SF_ERR_SHAPE);
    CHECK_EQ(sf_contour_stack_count(stack), 0);
    CHECK_EQ(sf_contour_stack_layer(stack, 0, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_contour_stack_destroy(stack);
}

static void memory_runs_out(void)
{
    static const size_t good[2] = {0, 3};
    static const double p[6] = {0, 6, 9, 6, 1, 9};
    sf_contours c = {p, good, 1};
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status != SF_OK && k < 40; k++) {
        failing_allocator f;
        sf_contour_stack *stack = NULL;
        sf_grid *grid = NULL;
        sf_slice slice = {memory[0], lattice.nx, lattice.ny, 2};
        failing_begin(&f, k);
        memset(memory[0], 0x3c, sizeof memory[0]);
        status = sf_contour_stack_create(0, &f.allocator, &stack);
        if (status == SF_OK) {
            status = sf_contour_stack_trace(stack, 1, slice, &lattice);
            CHECK_EQ(sf_contour_stack_count(stack), status == SF_OK);
        }
        if (status == SF_OK) {
            status = sf_contour_stack_add(stack, 2, &c, NULL);
            CHECK_EQ(sf_contour_stack_count(stack), status == SF_OK ? 2 : 1);
        }
        if (status == SF_OK) {
            sf_lattice two = lattice;
            two.nz = 2;
            status =
                sf_grid_from_contours(stack, &two, SF_CONTOUR_NONZERO, &f.allocator, NULL, &grid);
            CHECK((status == SF_OK) == (grid != NULL));
        }
        CHECK(status == SF_OK || status == SF_ERR_MEMORY);
        CHECK(k > 0 || status == SF_ERR_MEMORY);
        sf_grid_destroy(grid);
        sf_contour_stack_destroy(stack);
        CHECK(f.live == 0 && f.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
}

int main(void)
{
    TEST(random_polygons);
    TEST(neighbours_share_nothing);
    TEST(traced_and_drawn_again);
    TEST(trace_of_a_ring);
    TEST(stacks_become_grids);
    TEST(checks_take_contours);
    TEST(nonsense_is_refused);
    TEST(memory_runs_out);
    return test_finish();
}
