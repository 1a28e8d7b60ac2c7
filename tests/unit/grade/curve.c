// SPDX-License-Identifier: MIT
// Why: a curve turns measured properties into tones, so it must be monotone whatever was measured,
// go through what agrees, and be read backwards exactly. The pooled values are held against the
// max-min formula for isotonic means, which pools nothing; the rest against what a monotone smooth
// function is. Promises: the same curve for samples in any order; ends and plateaus answered with
// the nearest.

#include <sf/mixture.h>

#include "test.h"

enum { COUNT = 24 };

// Fraction of a stiff material, and a modulus in MPa: made up for this test, an example.
static const sf_curve_sample example[] = {{0.00, 1.1, 1},    {0.10, 1.9, 1},   {0.20, 3.4, 1},
                                          {0.30, 6.6, 1},    {0.40, 13.0, 1},  {0.50, 31.0, 1},
                                          {0.60, 82.0, 1},   {0.70, 210.0, 1}, {0.80, 520.0, 1},
                                          {0.90, 1150.0, 1}, {1.00, 2000.0, 1}};

static sf_curve *make(const sf_curve_sample *samples, size_t count, sf_trend trend)
{
    sf_curve *curve = NULL;
    CHECK_EQ(sf_curve_create(samples, count, trend, NULL, &curve), SF_OK);
    return curve;
}

static double at(const sf_curve *curve, double x)
{
    double y = NAN;
    CHECK_EQ(sf_curve_value(curve, x, &y, NULL), SF_OK);
    return y;
}

// max over j <= i of min over k >= i of the mean of j..k.
static double isotonic(const sf_curve_sample *s, int count, int i, double sign)
{
    double best = -INFINITY;
    for (int j = 0; j <= i; j++) {
        double least = INFINITY;
        for (int k = i; k < count; k++) {
            double sum = 0, weight = 0;
            for (int n = j; n <= k; n++) {
                sum += s[n].weight * sign * s[n].y;
                weight += s[n].weight;
            }
            least = fmin(least, sum / weight);
        }
        best = fmax(best, least);
    }
    return sign * best;
}

static void knots_are_isotonic_means(void)
{
    for (int round = 0; round < 200; round++) {
        sf_curve_sample s[COUNT];
        int count = 2 + (int)test_random_below(COUNT - 1);
        double change = 0;
        for (int i = 0; i < count; i++) {
            s[i].x = i + 0.5 * test_random_unit();
            s[i].y = (round % 2 ? -0.1 : 0.1) * i + test_random_unit();
            s[i].weight = 0.2 + test_random_unit();
        }
        double sign = round % 2 ? -1 : 1;
        sf_curve *curve = make(s, (size_t)count, round % 2 ? SF_TREND_FALLING : SF_TREND_RISING);
        for (int i = 0; i < count; i++) {
            double want = isotonic(s, count, i, sign);
            CHECK_NEAR(at(curve, s[i].x), want, 1e-12);
            change = fmax(change, fabs(want - s[i].y));
        }
        CHECK_NEAR(sf_curve_change(curve), change, 1e-12);
        sf_curve_destroy(curve);
    }
}

static void it_is_monotone_and_smooth(void)
{
    for (int round = 0; round < 60; round++) {
        sf_curve_sample s[COUNT];
        for (int i = 0; i < COUNT; i++) {
            s[i].x = i + 0.9 * test_random_unit();
            s[i].y = pow(test_random_unit(), 4) * 10 + (round % 3) * i;
            s[i].weight = 1;
        }
        sf_curve *curve = make(s, COUNT, SF_TREND_RISING);
        double before = at(curve, s[0].x);
        for (int i = 0; i <= 20000; i++) {
            double x = s[0].x + (s[COUNT - 1].x - s[0].x) * i / 20000, y, slope;
            CHECK_EQ(sf_curve_value(curve, x, &y, &slope), SF_OK);
            CHECK(y >= before - 1e-12 && slope >= -1e-9);
            before = y;
        }
        for (int i = 1; i + 1 < COUNT; i++) { // across a knot
            double y, left, right, h = 1e-7;
            CHECK_EQ(sf_curve_value(curve, s[i].x - h, &y, &left), SF_OK);
            CHECK_EQ(sf_curve_value(curve, s[i].x + h, &y, &right), SF_OK);
            CHECK_NEAR(left, right, 1e-3);
            CHECK_NEAR((at(curve, s[i].x + h) - at(curve, s[i].x - h)) / (2 * h), left, 1e-3);
        }
        sf_curve_destroy(curve);
    }
}

static void lines_stay_lines(void)
{
    const sf_curve_sample s[4] = {{0, 1, 1}, {0.3, 1.6, 2}, {0.5, 2, 1}, {1, 3, 5}};
    sf_curve *curve = make(s, 4, SF_TREND_AUTO);
    for (int i = 0; i <= 100; i++) {
        double y, slope, x;
        CHECK_EQ(sf_curve_value(curve, i / 100.0, &y, &slope), SF_OK);
        CHECK_NEAR(y, 1 + i / 50.0, 1e-14);
        CHECK_NEAR(slope, 2, 1e-13);
        CHECK_EQ(sf_curve_inverse(curve, 1 + i / 50.0, &x, NULL), SF_OK);
        CHECK_NEAR(x, i / 100.0, 1e-14);
    }
    sf_curve_destroy(curve);
}

static void backwards_is_the_inverse(void)
{
    sf_curve *curve = make(example, sizeof example / sizeof *example, SF_TREND_AUTO);
    for (int i = 0; i <= 10000; i++) {
        double y = 1.1 * pow(2000 / 1.1, i / 10000.0), x, miss;
        CHECK_EQ(sf_curve_inverse(curve, y, &x, &miss), SF_OK);
        CHECK_NEAR(at(curve, x), y, 1e-12 * y);
        CHECK_NEAR(miss, 0, 1e-12 * y);
    }
    sf_curve_destroy(curve);
    for (int round = 0; round < 100; round++) {
        sf_curve_sample s[COUNT];
        for (int i = 0; i < COUNT; i++) {
            s[i].x = test_random_unit();
            s[i].y = -pow(s[i].x, 3) + 0.2 * test_random_unit();
            s[i].weight = 1;
        }
        curve = make(s, COUNT, SF_TREND_AUTO);
        for (int i = 0; i <= 200; i++) {
            double x = i / 200.0, y = at(curve, x), back;
            CHECK_EQ(sf_curve_inverse(curve, y, &back, NULL), SF_OK);
            CHECK_NEAR(at(curve, back), y, 1e-13);
            CHECK(back <= x + 1e-6 || x < s[0].x);
        }
        sf_curve_destroy(curve);
    }
}

static void what_is_not_there_is_answered_with_the_nearest(void)
{
    const sf_curve_sample s[5] = {{0, 5, 1}, {1, 3, 1}, {2, 3, 1}, {3, 1, 1}, {4, 1, 1}};
    sf_curve *curve = make(s, 5, SF_TREND_AUTO);
    double x, miss;
    CHECK_EQ(sf_curve_inverse(curve, 7, &x, &miss), SF_OK);
    CHECK(x == 0 && miss == -2);
    CHECK_EQ(sf_curve_inverse(curve, -1, &x, &miss), SF_OK);
    CHECK(x == 3 && miss == 2);
    CHECK_EQ(sf_curve_inverse(curve, 3, &x, &miss), SF_OK);
    CHECK(x == 1 && miss == 0);
    CHECK(at(curve, -9) == 5 && at(curve, 9) == 1);
    sf_curve_destroy(curve);
}

static void order_and_copies_do_not_matter(void)
{
    sf_curve_sample s[40];
    for (int i = 0; i < 40; i++) {
        s[i].x = test_random_below(12);
        s[i].y = test_random_unit();
        s[i].weight = 1 + test_random_below(3);
    }
    sf_curve *first = make(s, 40, SF_TREND_AUTO);
    for (int round = 0; round < 20; round++) {
        for (int i = 39; i > 0; i--) {
            uint32_t k = test_random_below((uint32_t)i + 1);
            sf_curve_sample kept = s[i];
            s[i] = s[k];
            s[k] = kept;
        }
        sf_curve *other = make(s, 40, SF_TREND_AUTO);
        for (int i = -2; i < 140; i++) {
            CHECK(at(first, i * 0.1) == at(other, i * 0.1));
        }
        sf_curve_destroy(other);
    }
    sf_curve_destroy(first);
}

int main(void)
{
    TEST(knots_are_isotonic_means);
    TEST(it_is_monotone_and_smooth);
    TEST(lines_stay_lines);
    TEST(backwards_is_the_inverse);
    TEST(what_is_not_there_is_answered_with_the_nearest);
    TEST(order_and_copies_do_not_matter);
    return test_finish();
}
