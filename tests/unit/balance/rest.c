// SPDX-License-Identifier: MIT
// Why: a toy that is said to roll upright must do so. Rest poses are held against brute force: the
// height of the centre of mass, looked up over all vertices, is walked down over the sphere of
// orientations in small steps, from the start and from starts around it; where those agree, rolling
// must end there too. And each rest is a minimum, whatever the way.

#include "failing_allocator.h"
#include "turn.h"

#include <sf/stance.h>

static sf_rest rest_of(soup *s, const double com[3], const double up[3])
{
    sf_rest rest = {{0, 0, 0}, 0, 0, 0, 0, 0};
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_mesh_rest(soup_view(s), com, up, 1, NULL, &rest, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    return rest;
}

// ---------------------------------------------------------------------------------------------
// Walking down
// ---------------------------------------------------------------------------------------------

static double height_of(const soup *s, const double com[3], const double up[3])
{
    double lowest = INFINITY;
    for (size_t i = 0; i < s->count; i++) {
        double h = dot3(up, s->vertices + 3 * i);
        lowest = h < lowest ? h : lowest;
    }
    return dot3(up, com) - lowest;
}

// A small circle of directions around one.
typedef struct circle {
    const soup *s;
    const double *com, *middle;
    double side[3], reach;
} circle;

static double height_at(const circle *c, double angle, double up[3])
{
    double axis[3];
    turn3(c->side, c->middle, angle, axis);
    turn3(c->middle, axis, c->reach, up);
    return height_of(c->s, c->com, up);
}

// The lowest place on the circle, which may lie in a gorge: every dip of 48 places is looked into
// more and more closely. Returns whether it is lower than the middle.
static int step_down(const soup *s, const double com[3], double up[3], double reach)
{
    const double apart = 6.283185307179586 / 48;
    circle c = {s, com, up, {up[1], -up[0], 0}, reach};
    double heights[48], best[3] = {0, 0, 1}, least = height_of(s, com, up), w[3];
    int found = 0;
    if (dot3(c.side, c.side) < 0.01) {
        c.side[0] = up[2];
        c.side[1] = 0;
        c.side[2] = -up[0];
    }
    double size = sqrt(dot3(c.side, c.side));
    for (int d = 0; d < 3; d++) {
        c.side[d] /= size;
    }
    for (int i = 0; i < 48; i++) {
        heights[i] = height_at(&c, i * apart, w);
    }
    for (int i = 0; i < 48; i++) {
        if (heights[i] > heights[(i + 1) % 48] || heights[i] > heights[(i + 47) % 48]) {
            continue;
        }
        double low = (i - 1) * apart, high = (i + 1) * apart;
        while (high - low > 1e-6) {
            double third = (high - low) / 3, u[3], v[3];
            if (height_at(&c, low + third, u) < height_at(&c, high - third, v)) {
                high -= third;
            } else {
                low += third;
            }
        }
        double h = height_at(&c, low, w);
        if (h < least) {
            least = h;
            found = 1;
            memcpy(best, w, sizeof w);
        }
    }
    if (found) {
        memcpy(up, best, sizeof best);
    }
    return found;
}

static void walk_down(const soup *s, const double com[3], const double start[3], double up[3])
{
    memcpy(up, start, 3 * sizeof *up);
    for (double reach = 5e-3; reach > 1e-4; reach *= 0.4) {
        for (int i = 0; i < 4000 && step_down(s, com, up, reach); i++) {
        }
    }
}

static void make_stone(soup *s, double com[3])
{
    size_t n = 5 + test_random_below(10);
    double sum = 0;
    s->count = 0;
    memset(com, 0, 3 * sizeof *com);
    for (size_t i = 0; i < n; i++) {
        double p[3], r = 0.5 + test_random_unit(), weight = 0.05 + test_random_unit();
        random_direction(p);
        soup_add(s, 10 * r * p[0], 10 * r * p[1], 10 * r * p[2]);
        for (int d = 0; d < 3; d++) {
            com[d] += weight * 10 * r * p[d];
        }
        sum += weight;
    }
    for (int d = 0; d < 3; d++) {
        com[d] /= sum;
    }
}

static void rolling_ends_where_walking_down_ends(void)
{
    static soup s;
    int agreed = 0, moved = 0;
    for (int i = 0; i < 100; i++) {
        double com[3], start[3], end[3], other[3], near[3], axis[3];
        make_stone(&s, com);
        random_direction(start);
        sf_rest rest = rest_of(&s, com, start);
        walk_down(&s, com, start, end);
        int together = rest.margin_rad > 0.02; // or a step might pass over it
        for (int k = 0; k < 4 && together; k++) {
            random_direction(axis);
            turn3(start, axis, 0.02, near);
            walk_down(&s, com, near, other);
            together = angle3(other, end) < 0.02;
        }
        if (together) {
            CHECK(angle3(end, rest.up) < 0.02);
            CHECK_NEAR(height_of(&s, com, end), rest.height_mm, 0.02);
            agreed++;
            moved += rest.turn_count >= 3;
        }
    }
    CHECK(agreed > 50);
    CHECK(moved > 10);
}

static void every_rest_is_a_minimum(void)
{
    static soup s;
    for (int i = 0; i < 3000; i++) {
        double com[3], start[3], axis[3], w[3];
        make_stone(&s, com);
        random_direction(start);
        sf_rest rest = rest_of(&s, com, start);
        double height = height_of(&s, com, rest.up);
        CHECK_NEAR(dot3(rest.up, rest.up), 1, 1e-14);
        CHECK_NEAR(height, rest.height_mm, 1e-12);
        CHECK_NEAR(rest.tilt_rad, angle3(start, rest.up), 1e-9);
        CHECK(height <= height_of(&s, com, start) + 1e-12);
        CHECK(rest.contact_count >= 3);
        CHECK(rest.margin_rad >= 0);
        for (int k = 0; k < 60; k++) {
            random_direction(axis);
            turn3(rest.up, axis, k % 2 ? 1e-3 : 1e-5, w);
            CHECK(rest.margin_rad < 2e-3 || height_of(&s, com, w) >= height - 1e-12);
        }
        // It stays where it is.
        sf_rest again = rest_of(&s, com, rest.up);
        CHECK(angle3(again.up, rest.up) < 1e-12);
        CHECK_EQ(again.turn_count, 0);
    }
}

// The margin: tilted by less it comes back, by more it does not.
static void the_margin_is_how_far_it_can_be_tilted(void)
{
    static soup s;
    int tried = 0;
    for (int i = 0; i < 150; i++) {
        double com[3], start[3], axis[3], tilted[3], least = INFINITY;
        make_stone(&s, com);
        random_direction(start);
        sf_rest rest = rest_of(&s, com, start);
        if (rest.margin_rad < 0.02) {
            continue;
        }
        // Leaning the ground is leaning `up`. The way over an edge is the nearest of many ways up.
        double side[3] = {rest.up[1], -rest.up[0], 0};
        if (dot3(side, side) < 0.01) {
            side[0] = rest.up[2];
            side[1] = 0;
            side[2] = -rest.up[0];
        }
        double size = sqrt(dot3(side, side));
        double best = 0, middle = 0;
        for (int k = -1800; k < 2200; k++) { // around, and then around the best
            double angle = k < 1800 ? k * 0.1 : middle + (k - 2000) * 0.002;
            for (int d = 0; d < 3; d++) {
                axis[d] = side[d] / size;
            }
            turn3(axis, rest.up, angle / DEGREES, axis);
            turn3(rest.up, axis, 1e-5, tilted);
            // To first order: the height rises by 1e-5 times the distance to the edge.
            double rise = (height_of(&s, com, tilted) - rest.height_mm) / 1e-5;
            double margin = atan(rise / rest.height_mm);
            best = margin < least ? angle : best;
            least = margin < least ? margin : least;
            middle = k < 1800 ? best : middle;
        }
        CHECK_NEAR(least, rest.margin_rad, 2e-3);
        tried++;
    }
    CHECK(tried > 50);
}

// ---------------------------------------------------------------------------------------------
// Known bodies
// ---------------------------------------------------------------------------------------------

static void box(soup *s, double x, double y, double z)
{
    s->count = 0;
    for (int i = 0; i < 8; i++) {
        soup_add(s, i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0);
    }
}

static void a_cube_falls_on_the_face_it_leans_to(void)
{
    static soup s;
    double com[3] = {5, 5, 5};
    for (int i = 0; i < 2000; i++) {
        double start[3], shift[3] = {100, -50, 20}, c[3];
        spin by = random_spin();
        random_direction(start);
        int axis = 0;
        for (int d = 1; d < 3; d++) {
            axis = fabs(start[d]) > fabs(start[axis]) ? d : axis;
        }
        double expected[3] = {0, 0, 0};
        expected[axis] = start[axis] > 0 ? 1 : -1;
        box(&s, 10, 10, 10);
        // Turned somehow: the faces are planes but for rounding.
        soup_turn(&s, &by, shift);
        turn3(com, by.axis, by.angle, c);
        for (int d = 0; d < 3; d++) {
            c[d] += shift[d];
        }
        turn3(start, by.axis, by.angle, start);
        turn3(expected, by.axis, by.angle, expected);
        sf_rest rest = rest_of(&s, c, start);
        CHECK(angle3(rest.up, expected) < 1e-12);
        CHECK_NEAR(rest.height_mm, 5, 1e-12);
        CHECK_NEAR(rest.margin_rad, 45 / DEGREES, 1e-12);
        CHECK_EQ(rest.contact_count, 4);
    }
}

// A loaded box whose centre of mass hangs out over a small end rolls on, and does not stay there.
static void a_face_without_the_centre_is_left(void)
{
    static soup s;
    double com[3] = {5, 2, 2}, up[3] = {1, 0, 0};
    s.count = 0; // a lamp shade, on a corner of whose small end the large end stands out
    for (int i = 0; i < 4; i++) {
        soup_add(&s, 0, i & 1, i & 2 ? 1 : 0);
        soup_add(&s, 8, 4 * (i & 1), i & 2 ? 4 : 0);
    }
    sf_rest rest = rest_of(&s, com, up);
    CHECK(rest.turn_count >= 1);
    CHECK(angle3(rest.up, up) > 0.5);
}

static void balanced_starts_fall(void)
{
    static soup s;
    double com[3] = {5, 5, 5};
    box(&s, 10, 10, 10);
    for (int x = -1; x <= 1; x++) {
        for (int y = -1; y <= 1; y++) {
            for (int z = -1; z <= 1; z++) {
                double up[3] = {x, y, z};
                if (x != 0 || y != 0 || z != 0) {
                    sf_rest rest = rest_of(&s, com, up);
                    CHECK_NEAR(fabs(rest.up[0]) + fabs(rest.up[1]) + fabs(rest.up[2]), 1, 1e-12);
                    CHECK((int)rest.turn_count <= (x != 0) + (y != 0) + (z != 0) - 1);
                    CHECK((rest.turn_count == 0) == ((x != 0) + (y != 0) + (z != 0) == 1));
                }
            }
        }
    }
}

static void bodies_without_width(void)
{
    static soup s;
    double com[3] = {5, 2, 0};
    for (int i = 0; i < 300; i++) { // a card falls on a side
        double start[3];
        random_direction(start);
        box(&s, 10, 4, 0);
        sf_rest rest = rest_of(&s, com, start);
        double expected[3] = {0, 0, start[2] > 0 ? 1 : -1};
        CHECK(angle3(rest.up, expected) < 1e-12);
        CHECK_NEAR(rest.height_mm, 0, 1e-12);
        CHECK_NEAR(rest.margin_rad, 90 / DEGREES, 1e-12);
    }
    for (int i = 0; i < 100; i++) { // a needle lies down, and may roll
        double start[3], along[3] = {1, 0, 0}, needle[3] = {5, 0, 0};
        random_direction(start);
        box(&s, 10, 0, 0);
        sf_rest rest = rest_of(&s, needle, start);
        CHECK_NEAR(dot3(rest.up, along), 0, 1e-12);
        CHECK_NEAR(rest.margin_rad, 0, 1e-12);
        CHECK_EQ(rest.contact_count, 2);
    }
    double point[3] = {0, 0, 0}, up[3] = {3, 0, 4};
    box(&s, 0, 0, 0);
    sf_rest rest = rest_of(&s, point, up);
    CHECK(rest.up[0] == 0.6 && rest.up[2] == 0.8 && rest.turn_count == 0);
}

// A sphere of many faces, weighted: it rolls until the weight is below, within a face of it.
static void a_roly_poly_stands_up(void)
{
    static soup s;
    const double pi = 3.14159265358979323846;
    double com[3] = {0, 0, -8};
    s.count = 0;
    for (int i = 1; i < 40; i++) {
        for (int j = 0; j < 80; j++) {
            double a = pi * i / 40, b = 2 * pi * j / 80;
            soup_add(&s, 10 * sin(a) * cos(b), 10 * sin(a) * sin(b), 10 * cos(a));
        }
    }
    for (int i = 0; i < 200; i++) {
        double start[3], up[3] = {0, 0, 1};
        random_direction(start);
        if (start[2] < -0.99) {
            continue; // upside down it has a flat to stand on
        }
        sf_rest rest = rest_of(&s, com, start);
        CHECK(angle3(rest.up, up) < 1e-9);
        CHECK(rest.turn_count <= 200);
    }
}

// ---------------------------------------------------------------------------------------------
// Promises
// ---------------------------------------------------------------------------------------------

static void many_starts_are_one_after_the_other(void)
{
    static soup s;
    double com[3], ups[3 * 20];
    sf_rest rests[20];
    make_stone(&s, com);
    for (int i = 0; i < 20; i++) {
        random_direction(ups + 3 * i);
    }
    CHECK_EQ(sf_mesh_rest(soup_view(&s), com, ups, 20, NULL, rests, NULL), SF_OK);
    for (int i = 0; i < 20; i++) {
        sf_rest rest = rest_of(&s, com, ups + 3 * i);
        CHECK(memcmp(&rest, &rests[i], sizeof rest) == 0);
    }
    CHECK_EQ(sf_mesh_rest(soup_view(&s), com, NULL, 0, NULL, NULL, NULL), SF_OK);
}

static void nonsense_is_refused(void)
{
    static soup s;
    double com[3] = {5, 5, 5}, up[3] = {0, 0, 1}, bad[3] = {5, 5, NAN};
    sf_rest rest, before;
    sf_fault fault = {SF_OK, 0, 0, ""};
    memset(&rest, 0x5a, sizeof rest);
    before = rest;
    box(&s, 10, 10, 10);
    sf_mesh_view view = soup_view(&s), none = {NULL, 0, NULL, 0};
    CHECK_EQ(sf_mesh_rest(view, NULL, up, 1, NULL, &rest, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_rest(view, com, NULL, 1, NULL, &rest, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_rest(view, com, up, 1, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_rest(view, bad, up, 1, NULL, &rest, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "1e12") != NULL);
    double ups[6] = {0, 0, 1, 0, 0, 0};
    CHECK_EQ(sf_mesh_rest(view, com, ups, 2, NULL, &rest, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "start 1") != NULL);
    CHECK_EQ(sf_mesh_rest(view, com, bad, 1, NULL, &rest, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_mesh_rest(none, com, up, 1, NULL, &rest, NULL), SF_ERR_ARGUMENT);
    com[0] = 10.1;
    CHECK_EQ(sf_mesh_rest(view, com, up, 1, NULL, &rest, &fault), SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "outside") != NULL);
    com[0] = 5;
    s.vertices[0] = 2e12;
    CHECK_EQ(sf_mesh_rest(view, com, up, 1, NULL, &rest, NULL), SF_ERR_OVERFLOW);
    s.vertices[0] = NAN;
    CHECK_EQ(sf_mesh_rest(view, com, up, 1, NULL, &rest, NULL), SF_ERR_ARGUMENT);
    // Outside of what is flat, or thin.
    double beside[3] = {5, 4.1, 0}, beyond[3] = {11, 0, 0};
    box(&s, 10, 4, 0);
    CHECK_EQ(sf_mesh_rest(view, beside, up, 1, NULL, &rest, NULL), SF_ERR_ARGUMENT);
    box(&s, 10, 0, 0);
    CHECK_EQ(sf_mesh_rest(view, beyond, up, 1, NULL, &rest, NULL), SF_ERR_ARGUMENT);
    CHECK(memcmp(&rest, &before, sizeof rest) == 0);
}

static void memory_that_ends(void)
{
    static soup s;
    double com[3], up[3] = {1, 2, 3};
    sf_status status = SF_ERR_MEMORY;
    failing_allocator f;
    sf_rest rest, before;
    memset(&rest, 0x5a, sizeof rest);
    before = rest;
    make_stone(&s, com);
    for (long k = 0; status == SF_ERR_MEMORY && k < 1000; k++) {
        CHECK(memcmp(&rest, &before, sizeof rest) == 0);
        failing_begin(&f, k);
        status = sf_mesh_rest(soup_view(&s), com, up, 1, &f.allocator, &rest, NULL);
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(f.requests > 10);
}

int main(void)
{
    TEST(rolling_ends_where_walking_down_ends);
    TEST(every_rest_is_a_minimum);
    TEST(the_margin_is_how_far_it_can_be_tilted);
    TEST(a_cube_falls_on_the_face_it_leans_to);
    TEST(a_face_without_the_centre_is_left);
    TEST(balanced_starts_fall);
    TEST(bodies_without_width);
    TEST(a_roly_poly_stands_up);
    TEST(many_starts_are_one_after_the_other);
    TEST(nonsense_is_refused);
    TEST(memory_that_ends);
    return test_finish();
}
