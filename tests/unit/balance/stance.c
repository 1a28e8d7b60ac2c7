// SPDX-License-Identifier: MIT
// Why: a body that is called safe must stand when it is tilted, and hang as it was meant to. Safe
// regions are held against tilting: the body is turned about horizontal axes, and it is looked up,
// contact by contact, whether the vertical through its centre of mass still meets what it stands
// on. Hanging is held against the least energy over all orientations.

#include "verdict.h"

enum { CONTACTS = 8, CORNERS_MAX = 64 };

// ---------------------------------------------------------------------------------------------
// Tilting
// ---------------------------------------------------------------------------------------------

// A body with z up: feet on z = 0, matter above, a centre of mass; then turned somehow.
typedef struct body {
    soup shape;
    size_t feet;
    double com[3], up[3];
} body;

static void make_body(body *b)
{
    double shift[3], unit[3] = {0, 0, 1};
    spin by = random_spin();
    b->shape.count = 0;
    b->feet = 1 + test_random_below(CONTACTS);
    double near = test_random_below(2) ? 4 : 24; // how far from the middle the centre may lie
    for (size_t i = 0; i < b->feet; i++) {
        double x = 20 * test_random_unit(), y = 20 * test_random_unit();
        soup_add(&b->shape, floor(x), floor(y), 0);
    }
    for (int i = 0; i < 6; i++) {
        soup_add(&b->shape, 30 * test_random_unit() - 5, 30 * test_random_unit() - 5,
                 1 + 30 * test_random_unit());
    }
    for (int d = 0; d < 3; d++) {
        b->com[d] = d == 2 ? 0.5 + 20 * test_random_unit() : 10 + near * (test_random_unit() - 0.5);
        shift[d] = 100 * test_random_unit() - 50;
    }
    soup_turn(&b->shape, &by, shift);
    turn3(b->com, by.axis, by.angle, b->com);
    turn3(unit, by.axis, by.angle, b->up);
    for (int d = 0; d < 3; d++) {
        b->com[d] += shift[d];
    }
}

static double cross2(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Whether q lies in a triangle of three of the points.
static int is_carried(double (*p)[2], size_t count, const double q[2])
{
    for (size_t a = 0; a < count; a++) {
        for (size_t b = a + 1; b < count; b++) {
            for (size_t c = b + 1; c < count; c++) {
                double u = cross2(p[a], p[b], q), v = cross2(p[b], p[c], q),
                       w = cross2(p[c], p[a], q);
                if (fabs(cross2(p[a], p[b], p[c])) > 1e-9 &&
                    ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) {
                    return 1;
                }
            }
        }
    }
    return 0;
}

// Turn the body by `angle` about a horizontal axis and look along the vertical: feet and centre of
// mass as an observer from above sees them, with the feet's plane carried along it.
static int stays(const body *b, const double axis[3], double angle)
{
    double seen[CONTACTS][2], q[2], com[3], foot[3];
    double first[3] = {b->up[1], -b->up[0], 0}, second[3];
    if (dot3(first, first) < 0.01) {
        first[0] = b->up[2];
        first[1] = 0;
        first[2] = -b->up[0];
    }
    double size = sqrt(dot3(first, first));
    for (int d = 0; d < 3; d++) {
        first[d] /= size;
    }
    turn3(first, b->up, 1.5707963267948966, second);
    for (size_t i = 0; i < b->feet; i++) {
        turn3(b->shape.vertices + 3 * i, axis, angle, foot);
        seen[i][0] = dot3(first, foot);
        seen[i][1] = dot3(second, foot);
    }
    turn3(b->com, axis, angle, com);
    q[0] = dot3(first, com);
    q[1] = dot3(second, com);
    return is_carried(seen, b->feet, q);
}

// In all of 720 directions of tilt.
static int survives(const body *b, double angle)
{
    double axis[3] = {b->up[1], -b->up[0], 0};
    if (dot3(axis, axis) < 0.01) {
        axis[0] = b->up[2];
        axis[1] = 0;
        axis[2] = -b->up[0];
    }
    double size = sqrt(dot3(axis, axis));
    for (int d = 0; d < 3; d++) {
        axis[d] /= size;
    }
    for (int i = 0; i < 720; i++) {
        double turned[3];
        turn3(axis, b->up, i * 0.5 / DEGREES, turned);
        if (!stays(b, turned, angle)) {
            return 0;
        }
    }
    return 1;
}

static void safe_bodies_survive_tilting(void)
{
    static body b;
    int safe = 0, unsafe = 0;
    for (int i = 0; i < 5000; i++) {
        make_body(&b);
        sf_stance_options options = sf_stance_options_default();
        memcpy(options.up, b.up, sizeof b.up);
        options.gamma_rad = i % 5 == 0 ? 0 : 30 * test_random_unit() / DEGREES;
        options.contact_mm = 1e-6;
        sf_stance *stance = stance_of(&b.shape, &options);
        sf_stance_verdict v = verdict_of(stance, b.com);
        // Half a degree between directions hides what is closer than this.
        if (fabs(v.slack_mm) > 1e-3) {
            CHECK_EQ(v.safe, survives(&b, options.gamma_rad));
            CHECK_EQ(v.safe, v.margin_rad >= options.gamma_rad);
            CHECK_EQ(v.stands, v.margin_rad >= 0);
            *(v.safe ? &safe : &unsafe) += 1;
        }
        if (v.margin_rad > 0.01) {
            CHECK(survives(&b, v.margin_rad - 0.001));
            CHECK(!survives(&b, v.margin_rad + 0.001));
        }
        sf_stance_destroy(stance);
    }
    CHECK(safe > 500);
    CHECK(unsafe > 2500);
}

// The edge that is named is the one over which the centre goes first.
static void the_edge_is_the_nearest_to_falling(void)
{
    static body b;
    for (int i = 0; i < 2000; i++) {
        make_body(&b);
        sf_stance_options options = sf_stance_options_default();
        memcpy(options.up, b.up, sizeof b.up);
        sf_stance *stance = stance_of(&b.shape, &options);
        sf_stance_verdict v = verdict_of(stance, b.com);
        double along[3], from[3];
        for (int d = 0; d < 3; d++) {
            along[d] = v.edge_mm[1][d] - v.edge_mm[0][d];
            from[d] = b.com[d] - v.edge_mm[0][d];
        }
        double length = sqrt(dot3(along, along)), height = dot3(b.up, from);
        CHECK_NEAR(dot3(b.up, v.edge_mm[0]), sf_stance_ground(stance), 1e-9);
        if (length > 0) {
            // Turned about the edge by the margin, the centre stands above it: no moment is left.
            double turned[3], moment;
            for (int d = 0; d < 3; d++) {
                along[d] /= length;
            }
            turn3(from, along, v.margin_rad, turned);
            moment = (along[1] * turned[2] - along[2] * turned[1]) * b.up[0] +
                     (along[2] * turned[0] - along[0] * turned[2]) * b.up[1] +
                     (along[0] * turned[1] - along[1] * turned[0]) * b.up[2];
            CHECK_NEAR(moment, 0, 1e-9);
            CHECK(height > 0);
        }
        sf_stance_destroy(stance);
    }
}

// ---------------------------------------------------------------------------------------------
// What touches
// ---------------------------------------------------------------------------------------------

// A table with a round top and a square of feet, each side with many vertices along it, turned.
static void a_square_has_four_corners(void)
{
    static soup s;
    for (int i = 0; i < 200; i++) {
        spin by = random_spin();
        double up[3] = {0, 0, 1}, shift[3] = {5, 6, 7}, polygon[3 * CORNERS_MAX];
        sf_stance_options options = sf_stance_options_default();
        size_t corners = 0, contacts = 0;
        s.count = 0;
        for (int j = 0; j <= 40; j++) {
            soup_add(&s, j, 0, 0);
            soup_add(&s, 40 - j, 40, 0);
            soup_add(&s, 0, j, 0);
            soup_add(&s, 40, 40 - j, 0);
            soup_add(&s, 20 + 30 * cos(j), 20 + 30 * sin(j), 50);
        }
        soup_turn(&s, &by, shift);
        turn3(up, by.axis, by.angle, options.up);
        sf_stance *stance = stance_of(&s, &options);
        CHECK_EQ(sf_stance_polygon(stance, polygon, CORNERS_MAX, &corners), SF_OK);
        CHECK_EQ(corners, 4);
        CHECK_EQ(sf_stance_contacts(stance, NULL, 0, &contacts), SF_ERR_CAPACITY);
        CHECK_EQ(contacts, 164);
        double middle[3] = {20, 20, 20}, area = 0;
        turn3(middle, by.axis, by.angle, middle);
        for (int d = 0; d < 3; d++) {
            middle[d] += shift[d];
        }
        CHECK_NEAR(verdict_of(stance, middle).margin_rad, 45 / DEGREES, 1e-9);
        for (size_t c = 0; c < corners; c++) {
            const double *p = polygon + 3 * c, *q = polygon + 3 * ((c + 1) % corners);
            area += 0.5 * (options.up[0] * (p[1] * q[2] - p[2] * q[1]) +
                           options.up[1] * (p[2] * q[0] - p[0] * q[2]) +
                           options.up[2] * (p[0] * q[1] - p[1] * q[0]));
        }
        CHECK_NEAR(area, 1600, 1e-6); // counter-clockwise
        sf_stance_destroy(stance);
    }
}

static void contacts_lie_within_tolerance_and_region(void)
{
    static soup s;
    uint32_t contacts[16];
    size_t count = 0;
    sf_stance_options options = sf_stance_options_default();
    s.count = 0;
    for (int i = 0; i < 10; i++) {
        soup_add(&s, i, i % 2, 0.125 * i);
    }
    s.vertices[3 * s.count] = 0; // a vertex that nobody uses, far below
    s.vertices[3 * s.count + 1] = 0;
    s.vertices[3 * s.count + 2] = -100;
    sf_mesh_view view = soup_view(&s);
    view.vertex_count++;
    options.contact_mm = 0.375;
    sf_stance *stance = NULL;
    CHECK_EQ(sf_stance_create(view, &options, NULL, &stance, NULL), SF_OK);
    CHECK_EQ(sf_stance_contacts(stance, contacts, 16, &count), SF_OK);
    CHECK_EQ(count, 4);
    for (uint32_t i = 0; i < count; i++) {
        CHECK_EQ(contacts[i], i);
    }
    double flat[33];
    memcpy(flat, s.vertices, sizeof flat);
    CHECK_EQ(sf_stance_flatten(stance, flat, 10), SF_ERR_SHAPE);
    CHECK_EQ(sf_stance_flatten(stance, flat, 11), SF_OK);
    for (int i = 0; i < 11; i++) {
        CHECK(flat[3 * i] == s.vertices[3 * i] && flat[3 * i + 1] == s.vertices[3 * i + 1]);
        CHECK_NEAR(flat[3 * i + 2], i < 4 ? 0 : s.vertices[3 * i + 2], 0);
    }
    sf_stance_destroy(stance);

    // In a region the lowest of its own vertices decides.
    options.region_low_mm[0] = 2.5;
    options.region_high_mm[0] = 6;
    CHECK_EQ(sf_stance_create(view, &options, NULL, &stance, NULL), SF_OK);
    CHECK_EQ(sf_stance_contacts(stance, contacts, 16, &count), SF_OK);
    CHECK_EQ(count, 4);
    CHECK(contacts[0] == 3 && contacts[3] == 6);
    CHECK_NEAR(sf_stance_ground(stance), 0.375, 0);
    // The body goes on below: a centre of mass down there is not safe, whatever the slopes say.
    sf_halfspace halfspaces[16];
    CHECK_EQ(sf_stance_halfspaces(stance, halfspaces, 16, &count), SF_OK);
    double inside[3] = {4.5, 0.5, -3};
    CHECK_EQ(verdict_of(stance, inside).safe, 0);
    CHECK_NEAR(verdict_of(stance, inside).margin_rad, 90 / DEGREES, 1e-12);
    inside[0] = 9;
    CHECK_NEAR(verdict_of(stance, inside).margin_rad, -90 / DEGREES, 1e-12);
    sf_stance_destroy(stance);

    options.region_low_mm[0] = 100;
    options.region_high_mm[0] = 200;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_stance_create(view, &options, NULL, &stance, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "region") != NULL);
}

// A point, a segment, a body without height.
static void degenerate_contacts(void)
{
    static soup s;
    double polygon[3 * CORNERS_MAX];
    size_t count = 0;
    sf_stance_options options = sf_stance_options_default();
    for (int feet = 1; feet <= 3; feet++) {
        s.count = 0;
        for (int i = 0; i < 8 * feet; i++) {
            // All in one place; along a line; the line with a body on top.
            soup_add(&s, feet == 1 ? 2 : i % 7, feet == 1 ? 2 : 2 * (i % 7), 0);
        }
        soup_add(&s, 0, 5, feet == 1 ? 0 : 5);
        if (feet == 1) {
            s.vertices[3 * s.count - 2] = 2;
            s.vertices[3 * s.count - 3] = 2;
        }
        sf_stance *stance = stance_of(&s, &options);
        CHECK_EQ(sf_stance_polygon(stance, polygon, CORNERS_MAX, &count), SF_OK);
        CHECK_EQ(count, feet == 1 ? 1 : 2);
        double above[3] = {2, feet == 1 ? 2 : 4, 3};
        sf_stance_verdict v = verdict_of(stance, above);
        CHECK_NEAR(v.margin_rad, 0, 1e-12); // balanced on a knife's edge
        CHECK_EQ(v.safe, 0);
        double beside[3] = {4, feet == 1 ? 2 : 3, 3};
        v = verdict_of(stance, beside);
        CHECK_NEAR(v.margin_rad, -atan(feet == 1 ? 2.0 / 3 : sqrt(5) / 3), 1e-12);
        CHECK_EQ(v.stands, 0);
        double beyond[3] = {8, feet == 1 ? 2 : 16, 3};
        v = verdict_of(stance, beyond);
        CHECK_NEAR(v.margin_rad, -atan((feet == 1 ? 6 : sqrt(20)) / 3), 1e-12);
        CHECK(memcmp(v.edge_mm[0], v.edge_mm[1], sizeof v.edge_mm[0]) == 0);
        CHECK_EQ(sf_stance_halfspaces(stance, NULL, 0, &count), SF_ERR_CAPACITY);
        CHECK_EQ(count, 4);
        sf_stance_destroy(stance);
    }
    // A plate without thickness touches with all of itself.
    s.count = 0;
    for (int i = 0; i < 25; i++) {
        soup_add(&s, i % 5, i / 5, 7);
    }
    sf_stance *stance = stance_of(&s, &options);
    CHECK_EQ(sf_stance_polygon(stance, polygon, CORNERS_MAX, &count), SF_OK);
    CHECK_EQ(count, 4);
    double com[3] = {2, 2, 7};
    CHECK_NEAR(verdict_of(stance, com).margin_rad, 90 / DEGREES, 1e-12);
    CHECK_EQ(verdict_of(stance, com).safe, 1);
    sf_stance_destroy(stance);
}

// ---------------------------------------------------------------------------------------------
// Hanging
// ---------------------------------------------------------------------------------------------

// The direction w, as up of the body, in which the centre of mass lies lowest below the point: by
// looking at many directions, then closer and closer around the best.
static void least_energy(const double arm[3], double best[3])
{
    double least = INFINITY;
    for (int i = 0; i < 400; i++) {
        double w[3];
        random_direction(w);
        if (dot3(arm, w) < least) {
            least = dot3(arm, w);
            memcpy(best, w, sizeof w);
        }
    }
    for (double reach = 0.3; reach > 1e-9; reach *= 0.7) {
        for (int i = 0; i < 20; i++) {
            double w[3], axis[3];
            random_direction(axis);
            turn3(best, axis, reach, w);
            if (dot3(arm, w) < least) {
                least = dot3(arm, w);
                memcpy(best, w, sizeof w);
            }
        }
    }
}

static void hanging_finds_the_least_energy(void)
{
    static body b;
    int safe = 0;
    for (int i = 0; i < 2000; i++) {
        make_body(&b);
        sf_stance_options options = sf_stance_options_default();
        double arm[3], best[3] = {0, 0, 1}, tilt, inside;
        options.kind = SF_STANCE_HANG;
        options.tolerance_rad = (i % 4 == 0 ? 40 : 3) / DEGREES;
        options.lever_mm = 0.5;
        for (int d = 0; d < 3; d++) {
            options.up[d] = 3 * b.up[d];
            options.point_mm[d] = b.shape.vertices[d];
            // Half of them nearly below the point.
            if (i % 2 == 0) {
                b.com[d] = options.point_mm[d] - (0.3 + 5 * test_random_unit()) * b.up[d] +
                           0.3 * test_random_unit();
            }
            arm[d] = b.com[d] - options.point_mm[d];
        }
        sf_stance *stance = stance_of(&b.shape, &options);
        sf_stance_verdict v = verdict_of(stance, b.com);
        least_energy(arm, best);
        tilt = angle3(best, b.up);
        CHECK_NEAR(v.margin_rad, -tilt, 1e-6);
        if (fabs(tilt - options.tolerance_rad) > 1e-6) {
            CHECK_EQ(v.stands, tilt <= options.tolerance_rad);
        }
        CHECK(!v.safe || v.stands);
        inside = 0.98 * tan(options.tolerance_rad);
        if (tilt < 1.5 && tan(tilt) <= inside && -dot3(arm, b.up) > 0.501) {
            CHECK(v.safe);
            safe++;
        }
        CHECK(memcmp(v.edge_mm[1], options.point_mm, sizeof options.point_mm) == 0);
        sf_stance_destroy(stance);
    }
    CHECK(safe > 100);
}

static void hanging_from_the_centre_is_no_stance(void)
{
    static soup s;
    sf_stance_options options = sf_stance_options_default();
    double polygon[3], com[3] = {1, 2, 3};
    size_t count = 9;
    s.count = 0;
    soup_add(&s, 0, 0, 0);
    soup_add(&s, 3, 4, 12);
    options.kind = SF_STANCE_HANG;
    memcpy(options.point_mm, com, sizeof com);
    sf_stance *stance = stance_of(&s, &options);
    CHECK_NEAR(sf_stance_get_options(stance).lever_mm, 0.13, 1e-15);
    CHECK_EQ(verdict_of(stance, com).stands, 0);
    CHECK_EQ(verdict_of(stance, com).safe, 0);
    CHECK_EQ(sf_stance_polygon(stance, polygon, 1, &count), SF_OK);
    CHECK(count == 1 && memcmp(polygon, com, sizeof com) == 0);
    CHECK_EQ(sf_stance_contacts(stance, NULL, 0, &count), SF_OK);
    CHECK_EQ(count, 0);
    CHECK_NEAR(sf_stance_ground(stance), 3, 0);
    com[2] = 3.5; // above the point it would turn over
    CHECK_NEAR(verdict_of(stance, com).margin_rad, -180 / DEGREES, 1e-12);
    sf_stance_destroy(stance);
}

int main(void)
{
    TEST(safe_bodies_survive_tilting);
    TEST(the_edge_is_the_nearest_to_falling);
    TEST(a_square_has_four_corners);
    TEST(contacts_lie_within_tolerance_and_region);
    TEST(degenerate_contacts);
    TEST(hanging_finds_the_least_energy);
    TEST(hanging_from_the_centre_is_no_stance);
    return test_finish();
}
