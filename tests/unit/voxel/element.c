// SPDX-License-Identifier: MIT
// Why: an element that is one lattice point too wide accepts what does not print. Ellipses are
// compared with their definition in exact arithmetic done another way, sums with the sum of all
// pairs of offsets, and elements that break their promises are refused.

#include "voxel/element.h"
#include "test.h"

static int holds(const sf_element *e, int dx, int dy)
{
    int x = abs(dx), y = abs(dy);
    return y <= e->reach_y && x <= e->half_width[y];
}

static void the_small_ones_are_what_they_are_called(void)
{
    sf_element box = sf_element_box3(), plus = sf_element_plus3();
    for (int dy = -3; dy <= 3; dy++) {
        for (int dx = -3; dx <= 3; dx++) {
            CHECK_EQ(holds(&box, dx, dy), abs(dx) <= 1 && abs(dy) <= 1);
            CHECK_EQ(holds(&plus, dx, dy), abs(dx) + abs(dy) <= 1);
        }
    }
}

// With radii of whole sixteenths of a voxel below 16 voxels, (16 dx ry)^2 + (16 dy rx)^2 <=
// (rx ry)^2 is a comparison of numbers below 2^33.
static void ellipses_hold_the_points_within(void)
{
    for (int round = 0; round < 600; round++) {
        uint64_t rx = test_random_below(256), ry = round % 3 == 0 ? rx : test_random_below(256);
        sf_element e;
        CHECK_EQ(sf_element_ellipse(rx << 12, ry << 12, &e), SF_OK);
        CHECK(sfi_element_is_valid(&e));
        for (int dy = -17; dy <= 17; dy++) {
            for (int dx = -17; dx <= 17; dx++) {
                uint64_t a = 16 * (uint64_t)abs(dx), b = 16 * (uint64_t)abs(dy);
                int within = (a == 0 || a <= rx) && (b == 0 || b <= ry) &&
                             a * ry * a * ry + b * rx * b * rx <= rx * ry * rx * ry;
                within |= (dx == 0 && b <= ry) || (dy == 0 && a <= rx); // a radius of 0 too
                CHECK_EQ(holds(&e, dx, dy), within);
            }
        }
    }
}

// 3-4-5, scaled: points that lie on the circle belong to it, and not on one a 65536th smaller.
static void points_on_the_rim_belong_to_it(void)
{
    for (unsigned k = 1; 5 * k <= SF_REACH_MAX; k++) {
        uint64_t radius = (uint64_t)(5 * k) << 16;
        sf_element e;
        CHECK_EQ(sf_element_ellipse(radius, radius, &e), SF_OK);
        CHECK(e.reach_y == 5 * k && e.half_width[3 * k] == 4 * k && e.half_width[4 * k] == 3 * k);
        CHECK_EQ(sf_element_ellipse(radius - 1, radius - 1, &e), SF_OK);
        CHECK(e.reach_y == 5 * k - 1 && e.half_width[3 * k] == 4 * k - 1);
    }
}

static void radii_beyond_the_limit_are_refused(void)
{
    sf_element e = sf_element_plus3(), kept = e;
    const uint64_t limit = (uint64_t)(SF_REACH_MAX + 1) << 16;
    CHECK_EQ(sf_element_ellipse(limit, 1, &e), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_element_ellipse(1, limit, &e), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_element_ellipse(UINT64_MAX, UINT64_MAX, &e), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_element_ellipse(1, 1, NULL), SF_ERR_ARGUMENT);
    CHECK(memcmp(&e, &kept, sizeof e) == 0);
    CHECK_EQ(sf_element_ellipse(limit - 1, limit - 1, &e), SF_OK);
    CHECK(e.reach_y == SF_REACH_MAX && e.half_width[0] == SF_REACH_MAX);
}

static sf_element random_element(unsigned most)
{
    sf_element e = {(uint16_t)test_random_below(most + 1), {(uint16_t)test_random_below(most + 1)}};
    for (unsigned dy = 1; dy <= e.reach_y; dy++) {
        e.half_width[dy] = (uint16_t)test_random_below(e.half_width[dy - 1] + 1u);
    }
    return e;
}

// Whether some offset of a and some of b add up to (dx, dy).
static int reaches(const sf_element *a, const sf_element *b, int dx, int dy)
{
    for (int y = -a->reach_y; y <= a->reach_y; y++) {
        for (int x = -a->half_width[abs(y)]; x <= a->half_width[abs(y)]; x++) {
            if (holds(b, dx - x, dy - y)) {
                return 1;
            }
        }
    }
    return 0;
}

static void sums_hold_the_sums_of_all_pairs(void)
{
    for (int round = 0; round < 300; round++) {
        sf_element a = random_element(4), b = random_element(4), sum;
        CHECK_EQ(sf_element_sum(&a, &b, &sum), SF_OK);
        CHECK(sfi_element_is_valid(&sum));
        for (int dy = -9; dy <= 9; dy++) {
            for (int dx = -9; dx <= 9; dx++) {
                CHECK_EQ(holds(&sum, dx, dy), reaches(&a, &b, dx, dy));
            }
        }
        sf_element in_place = a;
        CHECK_EQ(sf_element_sum(&in_place, &b, &in_place), SF_OK);
        CHECK(memcmp(&in_place, &sum, sizeof sum) == 0);
    }
}

static void broken_promises_are_refused(void)
{
    sf_element good = sf_element_box3(), sum = sf_element_plus3(), kept = sum;
    sf_element widens = {2, {1, 2, 0}}, far = {SF_REACH_MAX + 1, {0}}, wide = {0, {300}};
    sf_element tall = {SF_REACH_MAX, {0}}, broad = {0, {SF_REACH_MAX}};
    const sf_element *bad[] = {NULL, &widens, &far, &wide};
    for (size_t i = 0; i < 4; i++) {
        CHECK_EQ(sf_element_sum(bad[i], &good, &sum), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_element_sum(&good, bad[i], &sum), SF_ERR_ARGUMENT);
    }
    CHECK_EQ(sf_element_sum(&good, &good, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_element_sum(&tall, &good, &sum), SF_ERR_OVERFLOW);
    CHECK_EQ(sf_element_sum(&good, &broad, &sum), SF_ERR_OVERFLOW);
    CHECK(memcmp(&sum, &kept, sizeof sum) == 0);
    CHECK_EQ(sf_element_sum(&tall, &broad, &sum), SF_OK);
    CHECK(sum.reach_y == SF_REACH_MAX && sum.half_width[SF_REACH_MAX] == SF_REACH_MAX);
}

int main(void)
{
    TEST(the_small_ones_are_what_they_are_called);
    TEST(ellipses_hold_the_points_within);
    TEST(points_on_the_rim_belong_to_it);
    TEST(radii_beyond_the_limit_are_refused);
    TEST(sums_hold_the_sums_of_all_pairs);
    TEST(broken_promises_are_refused);
    return test_finish();
}
