// SPDX-License-Identifier: MIT
// Why: painting is how people say what goes where, many times a minute, and what they see must be
// what the documentation's formulas say. Weights of balls and capsules are held against distances
// to points sampled along the line; operations against their formulas, point by point; smoothing
// against means over edges found from the cells by comparing all with all. Promises: bounds hold,
// the other side of a jump is not touched, what fails has changed nothing.

#include "cages.h"
#include "failing_allocator.h"

#include <sf/paint.h>

enum { MOST = 400 };

static test_cage block(void)
{
    test_cage c = test_cage_block(4, 3, 3);
    c.values = calloc(c.points, sizeof *c.values);
    for (size_t i = 0; i < c.points; i++) {
        c.values[i] = test_random_unit();
    }
    return c;
}

static double distance(const double *p, const double *from, const double *to)
{
    double best = INFINITY;
    for (int i = 0; i <= 4000; i++) {
        double sum = 0;
        for (int axis = 0; axis < 3; axis++) {
            double d = p[axis] - (from[axis] + i / 4000.0 * (to[axis] - from[axis]));
            sum += d * d;
        }
        best = fmin(best, sqrt(sum));
    }
    return best;
}

static void brushes_weigh_by_distance(void)
{
    test_cage c = block();
    sf_cage *cage = test_cage_make(&c);
    for (int round = 0; round < 60; round++) {
        sf_paint_brush b = sf_paint_brush_default();
        double weights[MOST] = {0};
        size_t touched = 0, expected = 0;
        for (int axis = 0; axis < 3; axis++) {
            b.from_mm[axis] = 4 * test_random_unit();
            b.to_mm[axis] = round % 3 == 0 ? b.from_mm[axis] : 4 * test_random_unit();
        }
        b.radius_mm = 0.3 + 2 * test_random_unit();
        b.strength = round % 2 ? 1 : 0.5;
        b.falloff = (sf_falloff)(round % 4);
        b.where = (sf_paint_where)(round / 3 % 3);
        CHECK_EQ(sf_paint_select(cage, &b, weights, &touched), SF_OK);
        for (size_t i = 0; i < c.points; i++) {
            const double *p = c.positions + 3 * i;
            double t = distance(p, b.from_mm, b.to_mm) / b.radius_mm;
            int outside =
                p[0] == 0 || p[0] == 4 || p[1] == 0 || p[1] == 3 || p[2] == 0 || p[2] == 3;
            double w = b.falloff == SF_FALLOFF_CONSTANT ? 1
                       : b.falloff == SF_FALLOFF_LINEAR ? 1 - t
                       : b.falloff == SF_FALLOFF_SMOOTH
                           ? 1 - 3 * t * t + 2 * t * t * t
                           : (exp(-9 * t * t / 2) - exp(-4.5)) / (1 - exp(-4.5));
            w = t > 1 || (b.where == SF_PAINT_OUTSIDE && !outside) ||
                        (b.where == SF_PAINT_INSIDE && outside)
                    ? 0
                    : b.strength * w;
            if (fabs(t - 1) > 1e-3) { // not at the rim, where samples decide otherwise
                CHECK_NEAR(weights[i], w, 1e-3);
            }
            expected += weights[i] > 0;
        }
        CHECK_EQ(touched, expected);
        double twice[MOST];
        memcpy(twice, weights, sizeof twice);
        CHECK_EQ(sf_paint_select(cage, &b, twice, NULL), SF_OK); // the greater of both: the same
        CHECK(memcmp(twice, weights, c.points * sizeof *twice) == 0);
    }
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

// The mean over points that share an edge: those one step away in a block.
static double mean_of_neighbours(const test_cage *c, const double *values, size_t i, int outside,
                                 size_t stride)
{
    double sum = 0;
    int count = 0;
    for (size_t j = 0; j < c->points; j++) {
        const double *p = c->positions + 3 * i, *q = c->positions + 3 * j;
        double steps = fabs(p[0] - q[0]) + fabs(p[1] - q[1]) + fabs(p[2] - q[2]);
        int on = q[0] == 0 || q[0] == 4 || q[1] == 0 || q[1] == 3 || q[2] == 0 || q[2] == 3;
        if (steps == 1 && (!outside || on)) {
            sum += values[stride * j];
            count++;
        }
    }
    return sum / count;
}

static void values_change_by_their_formulas(void)
{
    test_cage c = block();
    double weights[MOST];
    for (size_t i = 0; i < c.points; i++) {
        weights[i] = i % 5 == 0 ? 0 : i % 5 == 1 ? 1 : test_random_unit();
    }
    for (int operation = 0; operation < 3; operation++) {
        sf_cage *cage = test_cage_make(&c);
        double amount = operation == SF_PAINT_ADD ? -0.4 : 0.6;
        size_t changed = 0, expected = 0;
        CHECK_EQ(sf_paint_values(cage, 0, weights, (sf_paint_operation)operation, amount, NULL,
                                 &changed),
                 SF_OK);
        const double *found = sf_cage_get_view(cage).channels[0].values;
        for (size_t i = 0; i < c.points; i++) {
            double v = c.values[i], w = weights[i];
            double now = operation == SF_PAINT_SET ? v + w * (amount - v)
                         : operation == SF_PAINT_ADD
                             ? v + w * amount
                             : v + w * amount * (mean_of_neighbours(&c, c.values, i, 0, 1) - v);
            CHECK_NEAR(found[i], fmax(now, 0), 1e-14); // a density is 0 at the least
            expected += found[i] != v;
        }
        CHECK_EQ(changed, expected);
        sf_cage_destroy(cage);
    }
    test_cage_free(&c);
}

static void positions_move_and_smooth(void)
{
    test_cage c = block();
    double weights[MOST], vector[3] = {0.1, -2, 3};
    for (size_t i = 0; i < c.points; i++) {
        weights[i] = i % 4 == 0 ? 0 : test_random_unit();
    }
    sf_cage *cage = test_cage_make(&c);
    size_t changed = 0;
    CHECK_EQ(sf_paint_move(cage, weights, vector, NULL, &changed), SF_OK);
    CHECK_EQ(changed, c.points - (c.points + 3) / 4);
    const double *at = sf_cage_get_view(cage).positions;
    for (size_t i = 0; i < 3 * c.points; i++) {
        CHECK_NEAR(at[i], c.positions[i] + weights[i / 3] * vector[i % 3], 1e-15);
    }
    sf_cage_destroy(cage);
    cage = test_cage_make(&c);
    CHECK_EQ(sf_paint_smooth(cage, weights, 0.5, NULL, NULL), SF_OK);
    at = sf_cage_get_view(cage).positions;
    for (size_t i = 0; i < c.points; i++) {
        const double *p = c.positions + 3 * i;
        int outside = p[0] == 0 || p[0] == 4 || p[1] == 0 || p[1] == 3 || p[2] == 0 || p[2] == 3;
        for (size_t axis = 0; axis < 3; axis++) {
            double mean = mean_of_neighbours(&c, c.positions + axis, i, outside, 3);
            CHECK_NEAR(at[3 * i + axis], p[axis] + weights[i] * 0.5 * (mean - p[axis]), 1e-14);
        }
    }
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

static void the_other_side_of_a_jump_is_not_touched(void)
{
    test_cage c = test_cage_block(4, 1, 1);
    double weights[20] = {0};
    c.value_count = 2;
    c.values = calloc(2, sizeof *c.values);
    c.values[1] = 1;
    c.indices = calloc(8 * c.cells, sizeof *c.indices);
    for (size_t i = 0; i < 8 * c.cells; i++) {
        c.indices[i] = i / 8 >= 2;
    }
    sf_cage *cage = test_cage_make(&c);
    for (size_t i = 0; i < c.points; i++) {
        weights[i] = c.positions[3 * i] == 4; // the far end, which only the second value has
    }
    CHECK_EQ(sf_paint_values(cage, 0, weights, SF_PAINT_SMOOTH, 1, NULL, NULL), SF_OK);
    const double *found = sf_cage_get_view(cage).channels[0].values;
    CHECK(found[0] == 0 && found[1] == 1); // all neighbours there are itself
    CHECK_EQ(sf_paint_values(cage, 0, weights, SF_PAINT_SET, 5, NULL, NULL), SF_OK);
    CHECK(found[0] == 0 && found[1] == 5);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

static void what_cannot_be_is_refused_and_changes_nothing(void)
{
    test_cage c = block();
    sf_cage *cage = test_cage_make(&c);
    double weights[MOST], far[3] = {2e12, 0, 0};
    for (size_t i = 0; i < c.points; i++) {
        weights[i] = 1;
    }
    sf_paint_brush b = sf_paint_brush_default();
    b.radius_mm = 0;
    CHECK_EQ(sf_paint_select(cage, &b, weights, NULL), SF_ERR_ARGUMENT);
    b.radius_mm = INFINITY; // all of it
    b.strength = 1.5;
    CHECK_EQ(sf_paint_select(cage, &b, weights, NULL), SF_ERR_ARGUMENT);
    b.strength = 0.25;
    b.falloff = (sf_falloff)4;
    CHECK_EQ(sf_paint_select(cage, &b, weights, NULL), SF_ERR_ARGUMENT);
    b.falloff = SF_FALLOFF_GAUSSIAN;
    b.to_mm[0] = 1e200; // what is that long has no place for its points
    CHECK_EQ(sf_paint_select(cage, &b, weights, NULL), SF_ERR_ARGUMENT);
    b.to_mm[0] = -1e12;
    size_t touched = 0;
    double none[MOST] = {0};
    CHECK_EQ(sf_paint_select(cage, &b, none, &touched), SF_OK);
    CHECK(touched == c.points && none[7] == 0.25);
    weights[3] = 1.1;
    CHECK_EQ(sf_paint_values(cage, 0, weights, SF_PAINT_SET, 1, NULL, NULL), SF_ERR_ARGUMENT);
    weights[3] = 1;
    CHECK_EQ(sf_paint_values(cage, 1, weights, SF_PAINT_SET, 1, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_paint_values(cage, 0, weights, SF_PAINT_SMOOTH, 2, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_paint_values(cage, 0, weights, SF_PAINT_SET, NAN, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_paint_move(cage, weights, far, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_paint_smooth(cage, weights, -1, NULL, NULL), SF_ERR_ARGUMENT);
    sf_cage_view v = sf_cage_get_view(cage);
    CHECK(memcmp(v.positions, c.positions, 3 * c.points * sizeof(double)) == 0);
    CHECK(memcmp(v.channels[0].values, c.values, c.points * sizeof(double)) == 0);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

// A point of weight 0 stays as it is, to the sign of its zeros.
static void what_is_not_meant_stays(void)
{
    test_cage c = test_cage_block(1, 1, 1);
    for (size_t i = 0; i < 3 * c.points; i++) {
        c.positions[i] = c.positions[i] == 0 ? -0.0 : c.positions[i];
    }
    sf_cage *cage = test_cage_make(&c);
    double weights[8] = {0}, vector[3] = {1, 0, 0};
    size_t changed = 9;
    CHECK_EQ(sf_paint_move(cage, weights, vector, NULL, &changed), SF_OK);
    CHECK_EQ(changed, 0);
    weights[2] = 1;
    CHECK_EQ(sf_paint_move(cage, weights, vector, NULL, &changed), SF_OK);
    CHECK_EQ(changed, 1);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

static sf_status paint(int way, sf_cage *cage, const double *weights, const sf_allocator *allocator)
{
    const double vector[3] = {0, 0.1, 0};
    switch (way) {
    case 0:
        return sf_paint_values(cage, 0, weights, SF_PAINT_SMOOTH, 1, allocator, NULL);
    case 1:
        return sf_paint_values(cage, 0, weights, SF_PAINT_SET, 1, allocator, NULL);
    case 2:
        return sf_paint_smooth(cage, weights, 1, allocator, NULL);
    default:
        return sf_paint_move(cage, weights, vector, allocator, NULL);
    }
}

// With a property that jumps and one that does not.
static void without_memory_nothing_is_changed(void)
{
    for (int way = 0; way < 8; way++) {
        test_cage c = block();
        double weights[MOST];
        for (size_t i = 0; i < c.points; i++) {
            weights[i] = test_random_unit();
        }
        if (way >= 4) {
            c.value_count = 2;
            c.indices = calloc(8 * c.cells, sizeof *c.indices);
            for (size_t i = 0; i < 8 * c.cells; i++) {
                c.indices[i] = i / 8 % 4 >= 2;
            }
        }
        sf_cage *cage = test_cage_make(&c);
        size_t values = c.indices != NULL ? c.value_count : c.points;
        sf_status status = SF_ERR_MEMORY;
        for (long k = 0; status == SF_ERR_MEMORY; k++) {
            failing_allocator memory;
            sf_cage_view v = sf_cage_get_view(cage);
            CHECK(memcmp(v.positions, c.positions, 3 * c.points * sizeof(double)) == 0);
            CHECK(memcmp(v.channels[0].values, c.values, values * sizeof(double)) == 0);
            failing_begin(&memory, k);
            status = paint(way % 4, cage, weights, &memory.allocator);
            CHECK(status == SF_OK || status == SF_ERR_MEMORY);
            CHECK(memory.live == 0 && memory.faults == 0);
        }
        sf_cage_destroy(cage);
        test_cage_free(&c);
    }
}

int main(void)
{
    TEST(what_is_not_meant_stays);
    TEST(without_memory_nothing_is_changed);
    TEST(brushes_weigh_by_distance);
    TEST(values_change_by_their_formulas);
    TEST(positions_move_and_smooth);
    TEST(the_other_side_of_a_jump_is_not_touched);
    TEST(what_cannot_be_is_refused_and_changes_nothing);
    return test_finish();
}
