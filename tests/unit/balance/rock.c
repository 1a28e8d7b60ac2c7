// SPDX-License-Identifier: MIT
// Why: a rocking toy that is called safe must roll back from wherever it is let go within the
// range, and come to rest within the tolerance. Half-spaces, which are worked out place by place
// around the pose, are held against rolling the body from many starts, and against what is known of
// rockers and bowls.

#include "failing_allocator.h"
#include "verdict.h"

#define RADIUS 50.0

// The hull's points of a rocker: an arc of `half` degrees to either side, with so many facets, and
// a post on top; the middle of the arc's circle is at (0, 0, RADIUS).
static void make_rocker(soup *s, double half, int facets)
{
    s->count = 0;
    for (int i = 0; i <= facets; i++) {
        double a = half * (2.0 * i / facets - 1) / DEGREES;
        for (int side = -1; side <= 1; side += 2) {
            soup_add(s, RADIUS * sin(a), 30 * side, RADIUS * (1 - cos(a)));
        }
    }
    soup_add(s, 3, 2, 90);
    soup_add(s, -4, 1, 90);
    soup_add(s, 1, -5, 88);
}

// The lower part of an ellipsoid, of random points or of rings, and something on top.
static void make_bowl(soup *s, const double axes[3], int is_random)
{
    const double pi = 3.14159265358979323846;
    s->count = 0;
    for (int i = 0; i < 20; i++) {
        for (int j = 0; j < 36; j++) {
            double a = is_random ? acos(1 - 0.8 * test_random_unit()) : 1.3 * (i + 0.25) / 20;
            double b = 2 * pi * (is_random ? test_random_unit() : (double)j / 36);
            soup_add(s, axes[0] * sin(a) * cos(b), axes[1] * sin(a) * sin(b),
                     axes[2] * (1 - cos(a)));
        }
    }
    soup_add(s, 3, 2, 1.5 * axes[2]);
    soup_add(s, -4, 1, 1.5 * axes[2]);
}

static sf_stance *rocking(soup *s, const sf_stance_options *given)
{
    sf_stance_options options = *given;
    options.kind = SF_STANCE_ROCK;
    return stance_of(s, &options);
}

// The largest tilt that it comes to rest in, from starts all over the range.
static double worst_tilt(soup *s, const double com[3], const double up[3], double range, int starts)
{
    static double ups[3 * 100];
    static sf_rest rests[100];
    double worst = 0;
    for (int i = 0; i < starts; i++) {
        double axis[3], side[3];
        random_direction(axis);
        for (int d = 0; d < 3; d++) {
            side[d] = axis[d] - dot3(axis, up) * up[d];
        }
        double size = sqrt(dot3(side, side));
        for (int d = 0; d < 3; d++) {
            side[d] /= size;
        }
        turn3(up, side, range * (i % 2 ? 1 : test_random_unit()), ups + 3 * i);
    }
    CHECK_EQ(sf_mesh_rest(soup_view(s), com, ups, (size_t)starts, NULL, rests, NULL), SF_OK);
    for (int i = 0; i < starts; i++) {
        double tilt = angle3(rests[i].up, up);
        worst = tilt > worst ? tilt : worst;
    }
    return worst;
}

// ---------------------------------------------------------------------------------------------
// Rockers
// ---------------------------------------------------------------------------------------------

// How high on the axis the centre may lie: each facet beyond the tolerance must be left over its
// inner edge, also on a floor that leans by a tenth of a degree.
static double highest_centre(double half, int facets, double tolerance)
{
    double least = INFINITY;
    for (int i = 0; i < facets; i++) {
        double inner = fabs(half * (2.0 * i / facets - 1)) / DEGREES;
        double outer = fabs(half * (2.0 * (i + 1) / facets - 1)) / DEGREES;
        double tilt = 0.5 * (inner + outer), edge = inner < outer ? inner : outer;
        double high = RADIUS * (1 - cos(edge)) + RADIUS * sin(edge) / tan(tilt + 0.1 / DEGREES);
        if (tilt > tolerance && tilt <= 20 / DEGREES) {
            least = high < least ? high : least;
        }
    }
    return least;
}

// An arc of 30 degrees to either side: it comes to rest within a degree.
static void a_rocker_comes_to_rest_upright(void)
{
    static soup s;
    sf_stance_options options = sf_stance_options_default();
    for (int facets = 60; facets <= 300; facets += 61) {
        make_rocker(&s, 30, facets);
        sf_stance *stance = rocking(&s, &options);
        double up[3] = {0, 0, 1}, high = highest_centre(30, facets, 1 / DEGREES);
        size_t count = 0;
        for (int h = 1; h < 60; h++) {
            double com[3] = {0, 0, h};
            sf_stance_verdict v = verdict_of(stance, com);
            CHECK_EQ(v.safe, h < high);
            CHECK(!v.safe || v.stands);
            CHECK(h <= RADIUS || !v.stands);
            CHECK(v.margin_rad <= 0);
            if (v.safe) {
                CHECK(-v.margin_rad <= 1 / DEGREES);
                CHECK(worst_tilt(&s, com, up, options.range_rad, 60) <= 1 / DEGREES + 1e-12);
            }
        }
        CHECK(high > 0.6 * RADIUS);
        CHECK_EQ(sf_stance_halfspaces(stance, NULL, 0, &count), SF_ERR_CAPACITY);
        CHECK(count < 100);
        sf_stance_destroy(stance);
    }
}

// ---------------------------------------------------------------------------------------------
// Bodies of all kinds
// ---------------------------------------------------------------------------------------------

static void safe_bodies_roll_back(void)
{
    static soup s;
    int safe = 0, unsafe = 0, fell = 0;
    for (int i = 0; i < 45; i++) {
        double axes[3] = {30 + 40 * test_random_unit(), 30 + 40 * test_random_unit(),
                          30 + 20 * test_random_unit()};
        double up[3] = {0, 0, 1}, shift[3] = {10, -20, 30};
        spin by = random_spin();
        sf_stance_options options = sf_stance_options_default();
        if (i % 3 == 0) {
            make_rocker(&s, 10 + 40 * test_random_unit(), 20 + (int)test_random_below(100));
        } else {
            make_bowl(&s, axes, i % 3 == 1);
        }
        soup_turn(&s, &by, shift);
        turn3(up, by.axis, by.angle, options.up);
        memcpy(up, options.up, sizeof up);
        options.tolerance_rad = (1 + 5 * test_random_unit()) / DEGREES;
        options.range_rad = options.tolerance_rad + (5 + 20 * test_random_unit()) / DEGREES;
        sf_stance *stance = rocking(&s, &options);
        for (int k = 0; k < 30; k++) {
            double com[3], size = k % 2 ? 2 : 8;
            for (int d = 0; d < 3; d++) {
                com[d] = d == 2 ? 1 + 40 * test_random_unit() : size * (test_random_unit() - 0.5);
            }
            turn3(com, by.axis, by.angle, com);
            for (int d = 0; d < 3; d++) {
                com[d] += shift[d];
            }
            sf_stance_verdict v = verdict_of(stance, com);
            if (v.safe) {
                CHECK(v.stands);
                CHECK(worst_tilt(&s, com, up, options.range_rad, 30) <=
                      options.tolerance_rad + 1e-9);
                safe++;
            } else {
                unsafe++;
                fell += !v.stands;
            }
        }
        sf_stance_destroy(stance);
    }
    CHECK(safe > 200);
    CHECK(fell > unsafe / 2);
    printf("# %d safe, %d not, of which %d do not come back\n", safe, unsafe, fell);
}

// Who aims at less than the tolerance ends up within it: what is safe for less is safe for more.
static void less_tolerance_is_stricter(void)
{
    static soup s;
    int both = 0, only = 0;
    for (int i = 0; i < 60; i++) {
        sf_stance_options options = sf_stance_options_default(), less;
        make_rocker(&s, 10 + 30 * test_random_unit(), 20 + (int)test_random_below(200));
        options.tolerance_rad = (0.3 + 2 * test_random_unit()) / DEGREES;
        less = options;
        less.tolerance_rad -= (i % 2 ? 0.1 : 0.2 * test_random_unit()) / DEGREES;
        sf_stance *wide = rocking(&s, &options), *narrow = rocking(&s, &less);
        for (int k = 0; k < 30; k++) {
            double com[3] = {3 * test_random_unit() - 1.5, 0, 1 + 45 * test_random_unit()};
            int is_narrow = verdict_of(narrow, com).safe, is_wide = verdict_of(wide, com).safe;
            CHECK(!is_narrow || is_wide);
            both += is_narrow && is_wide;
            only += is_wide && !is_narrow;
        }
        sf_stance_destroy(wide);
        sf_stance_destroy(narrow);
    }
    CHECK(both > 200 && only > 20);
    printf("# %d safe for both, %d for the wider\n", both, only);
}

// As low as it gets is always good: just above the contact, whatever the body.
static void low_enough_is_always_good(void)
{
    static soup s;
    for (int i = 0; i < 60; i++) {
        double axes[3] = {30 + 40 * test_random_unit(), 30 + 40 * test_random_unit(), 40};
        double com[3] = {0, 0, 0}, polygon[3 * 64];
        size_t count = 0;
        sf_stance_options options = sf_stance_options_default();
        if (i % 2 == 0) {
            make_rocker(&s, 40, 81);
        } else {
            make_bowl(&s, axes, 0);
        }
        sf_stance *stance = rocking(&s, &options);
        CHECK_EQ(sf_stance_polygon(stance, polygon, 64, &count), SF_OK);
        for (size_t c = 0; c < 3 * count; c++) {
            com[c % 3] += polygon[c] / (double)count;
        }
        com[2] += 0.1;
        CHECK_EQ(verdict_of(stance, com).safe, 1);
        sf_stance_destroy(stance);
    }
}

// A box that is asked to come back as a rocker must stand like one: the region is that of standing.
static void a_box_rocks_like_it_stands(void)
{
    static soup s;
    sf_stance_options options = sf_stance_options_default();
    s.count = 0;
    for (int i = 0; i < 8; i++) {
        soup_add(&s, i & 1 ? 20 : 0, i & 2 ? 30 : 0, i & 4 ? 40 : 0);
    }
    sf_stance *rock = rocking(&s, &options);
    for (int i = 0; i < 2000; i++) {
        double com[3] = {20 * test_random_unit(), 30 * test_random_unit(), 40 * test_random_unit()};
        double least = fmin(fmin(com[0], 20 - com[0]), fmin(com[1], 30 - com[1]));
        double margin = atan(least / com[2]) * DEGREES;
        sf_stance_verdict v = verdict_of(rock, com);
        // The polygon around the outer circle may ask for half a percent more.
        CHECK(margin < 20.3 || v.safe);
        CHECK(margin > 20.099 || !v.safe);
        CHECK_EQ(v.stands, margin > 20);
    }
    sf_stance_destroy(rock);
}

// A plate's faces look away from each other: its edges are looked at in halves.
static void a_plate_rocks_like_it_stands(void)
{
    static soup s;
    sf_stance_options options = sf_stance_options_default();
    s.count = 0;
    for (int i = 0; i < 8; i++) {
        soup_add(&s, i & 1 ? 20 : 0, i & 2 ? 30 : 0, 0);
    }
    sf_stance *rock = rocking(&s, &options);
    double com[3] = {10, 15, 0};
    sf_stance_verdict v = verdict_of(rock, com);
    CHECK(v.safe && v.stands && v.margin_rad == 0);
    // On its edge it falls to a side.
    options.up[0] = 1;
    options.up[2] = 0;
    sf_stance *edge = rocking(&s, &options);
    v = verdict_of(edge, com);
    CHECK(!v.safe && !v.stands);
    CHECK_NEAR(v.margin_rad, -90 / DEGREES, 1e-9);
    sf_stance_destroy(edge);
    sf_stance_destroy(rock);
}

static void what_has_no_width_does_not_rock(void)
{
    static soup s;
    sf_stance *stance = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_stance_options options = sf_stance_options_default();
    options.kind = SF_STANCE_ROCK;
    s.count = 0;
    for (int i = 0; i < 5; i++) {
        soup_add(&s, i, 2 * i, 0);
    }
    CHECK_EQ(sf_stance_create(soup_view(&s), &options, NULL, &stance, &fault), SF_ERR_ARGUMENT);
    CHECK(stance == NULL && strstr(fault.message, "no width") != NULL);
}

static void memory_that_ends(void)
{
    static soup s;
    sf_stance_options options = sf_stance_options_default();
    sf_status status = SF_ERR_MEMORY;
    sf_stance *stance = NULL;
    failing_allocator f;
    options.kind = SF_STANCE_ROCK;
    make_rocker(&s, 30, 40);
    for (long k = 0; status == SF_ERR_MEMORY && k < 1000; k++) {
        failing_begin(&f, k);
        status = sf_stance_create(soup_view(&s), &options, &f.allocator, &stance, NULL);
        CHECK(status == SF_OK || (stance == NULL && f.live == 0 && f.faults == 0));
    }
    CHECK_EQ(status, SF_OK);
    CHECK(f.requests > 20);
    double com[3] = {0, 0, 20};
    sf_stance_verdict v, before;
    memset(&v, 0x5a, sizeof v);
    before = v;
    for (long k = 0; k < 2; k++) {
        f.fail_at = f.requests + k;
        CHECK_EQ(sf_stance_judge(stance, com, &v), SF_ERR_MEMORY);
        CHECK(memcmp(&v, &before, sizeof v) == 0);
    }
    f.fail_at = -1;
    CHECK_EQ(sf_stance_judge(stance, com, &v), SF_OK);
    sf_stance_destroy(stance);
    CHECK_EQ(f.live, 0);
    CHECK_EQ(f.faults, 0);
}

int main(void)
{
    TEST(a_rocker_comes_to_rest_upright);
    TEST(safe_bodies_roll_back);
    TEST(less_tolerance_is_stricter);
    TEST(low_enough_is_always_good);
    TEST(a_box_rocks_like_it_stands);
    TEST(a_plate_rocks_like_it_stands);
    TEST(what_has_no_width_does_not_rock);
    TEST(memory_that_ends);
    return test_finish();
}
