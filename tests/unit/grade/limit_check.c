// SPDX-License-Identifier: MIT
// Why: a shape that lies inside out somewhere gives tetrahedra and voxels that are nonsense, and
// must be named. Bounds of the determinant are held against the determinant at many places, on
// random splines and on linear ones, where it is known; whole shapes against their cells: sane ones
// have no inverted piece and many that are proved, and one whose inner point is pulled through has.

#include "failing_allocator.h"
#include "limits.h"

#include "grade/limit/jacobian.h"

static double determinant(const double *j)
{
    return j[0] * (j[4] * j[8] - j[5] * j[7]) - j[1] * (j[3] * j[8] - j[5] * j[6]) +
           j[2] * (j[3] * j[7] - j[4] * j[6]);
}

static sfi_spline random_spline(double jitter)
{
    sfi_spline s;
    memset(&s, 0, sizeof s);
    s.dimension = s.width = 3;
    for (uint32_t i = 0; i < 64; i++) {
        for (uint32_t axis = 0; axis < 3; axis++) {
            s.rest[3 * i + axis] = (i >> 2 * axis & 3) + jitter * (test_random_unit() - 0.5);
        }
    }
    return s;
}

static void bounds_hold_everywhere(void)
{
    double narrowest = INFINITY;
    for (int round = 0; round < 200; round++) {
        sfi_spline s = random_spline(0.1 * (round % 20));
        double least, greatest, low = INFINITY, high = -INFINITY;
        sfi_jacobian_bounds(&s, &least, &greatest);
        for (int i = 0; i < 300; i++) {
            double u[3], x[3], j[9];
            for (int axis = 0; axis < 3; axis++) {
                u[axis] = i < 8 ? i >> axis & 1 : test_random_unit();
            }
            sfi_spline_at(&s, u, x, j);
            low = fmin(low, determinant(j));
            high = fmax(high, determinant(j));
        }
        CHECK(least <= low + 1e-12 && greatest >= high - 1e-12);
        narrowest = fmin(narrowest, (high - low + 1e-9) / (greatest - least + 1e-9));
        if (round % 20 == 0) { // a lattice
            CHECK_NEAR(least, 1, 1e-12);
            CHECK_NEAR(greatest, 1, 1e-12);
        }
    }
    printf("# what was found is at least %.2f of the bounds\n", narrowest);
    CHECK(narrowest > 0.05);
}

static sf_limit_report report_of(const test_cage *c)
{
    sf_limit *limit = limit_of(c, SF_REFINE_STANDARD);
    sf_limit_report report = {0};
    CHECK_EQ(sf_limit_check(limit, NULL, NULL, &report), SF_OK);
    CHECK_EQ(report.positive + report.inverted + report.open, sf_limit_piece_count(limit));
    sf_limit_destroy(limit);
    return report;
}

static void sane_shapes_are_right_and_others_are_not(void)
{
    test_cage c = test_cage_block(4, 4, 4);
    sf_limit_report r = report_of(&c);
    CHECK(r.inverted == 0 && r.first_inverted == 512);
    // Pieces along the twelve edges stay open, and no others.
    CHECK_EQ(r.open, 12 * 8 - 2 * 8);
    test_cage_place(&c, 31, 3.2, 3.2, 3.2); // a point inside, from (1, 1, 1) beyond its neighbours
    r = report_of(&c);
    CHECK(r.inverted > 0 && r.first_inverted < 512);
    test_cage_free(&c);
    static const uint32_t around[3] = {3, 5, 6};
    for (int i = 0; i < 3; i++) {
        c = test_cage_wheel(around[i], 4, 0);
        r = report_of(&c);
        CHECK(r.inverted == 0 && r.positive > 0);
        test_cage_free(&c);
    }
}

static void what_cannot_be_asked_is_refused(void)
{
    test_cage c = test_cage_block(2, 2, 2);
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    sf_limit_report report = {7, 7, 7, 7};
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_limit_check(limit, NULL, &task, &report), SF_ERR_CANCELLED);
    CHECK_EQ(sf_limit_check(NULL, NULL, NULL, &report), SF_ERR_ARGUMENT);
    for (long k = 0; k < 2; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        CHECK_EQ(sf_limit_check(limit, &memory.allocator, NULL, &report), SF_ERR_MEMORY);
        CHECK(memory.live == 0 && memory.faults == 0);
    }
    CHECK(report.open == 7);
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

int main(void)
{
    TEST(bounds_hold_everywhere);
    TEST(sane_shapes_are_right_and_others_are_not);
    TEST(what_cannot_be_asked_is_refused);
    return test_finish();
}
