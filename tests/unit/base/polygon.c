// SPDX-License-Identifier: MIT
// Why: what a thing stands on is the hull of its contacts, and those are often in one line,
// doubled, or a single one. Hulls are held against the definition: a corner is a point that lies in
// no triangle and on no segment of others. Coordinates go up to the limit.

#include "base/polygon.h"
#include "test.h"

enum { POINTS = 40 };

// Sign of the turn a, b, c by long doubles where that is exact: small coordinates only.
static long double area(const sfi_corner *a, const sfi_corner *b, const sfi_corner *c)
{
    return (long double)(b->x - a->x) * (c->y - a->y) - (long double)(b->y - a->y) * (c->x - a->x);
}

static int same_place(const sfi_corner *a, const sfi_corner *b)
{
    return a->x == b->x && a->y == b->y;
}

static int between(int64_t a, int64_t b, int64_t x)
{
    return (a <= x && x <= b) || (b <= x && x <= a);
}

// Whether p lies in the triangle abc, its border included, or on a segment when it is flat.
static int covered(const sfi_corner *a, const sfi_corner *b, const sfi_corner *c,
                   const sfi_corner *p)
{
    long double u = area(a, b, p), v = area(b, c, p), w = area(c, a, p);
    if (area(a, b, c) != 0) {
        return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
    }
    return (u == 0 && between(a->x, b->x, p->x) && between(a->y, b->y, p->y)) ||
           (v == 0 && between(b->x, c->x, p->x) && between(b->y, c->y, p->y));
}

// By definition; points in the place of p are not others.
static int is_corner(const sfi_corner *points, size_t count, const sfi_corner *p)
{
    for (size_t a = 0; a < count; a++) {
        for (size_t b = a; b < count; b++) {
            for (size_t c = b; c < count; c++) {
                if (!same_place(points + a, p) && !same_place(points + b, p) &&
                    !same_place(points + c, p) && covered(points + a, points + b, points + c, p)) {
                    return 0;
                }
            }
        }
    }
    return 1;
}

static void compare(const sfi_corner *points, size_t count)
{
    sfi_corner hull[POINTS], other[POINTS];
    memcpy(hull, points, count * sizeof *hull);
    size_t corners = sfi_polygon_hull(hull, count);
    for (size_t i = 0; i < count; i++) {
        size_t found = 0;
        for (size_t j = 0; j < corners; j++) {
            found += (size_t)same_place(points + i, hull + j);
        }
        CHECK_EQ(found, is_corner(points, count, points + i));
        other[count - 1 - i] = points[i];
    }
    for (size_t j = 0; j < corners; j++) {
        CHECK(corners < 3 ||
              area(hull + j, hull + (j + 1) % corners, hull + (j + 2) % corners) > 0);
        CHECK(hull[0].x < hull[j].x || (hull[0].x == hull[j].x && hull[0].y <= hull[j].y));
        CHECK(same_place(points + hull[j].name, hull + j));
    }
    // The order they come in does not matter.
    CHECK_EQ(sfi_polygon_hull(other, count), corners);
    for (size_t j = 0; j < corners; j++) {
        CHECK_EQ(other[j].name, hull[j].name);
    }
}

static void random_points(void)
{
    sfi_corner points[POINTS];
    for (int i = 0; i < 3000; i++) {
        size_t count = 1 + test_random_below(i % 50 == 0 ? POINTS : 12);
        uint32_t wide = i % 3 == 0 ? 3 : i % 3 == 1 ? 12 : 1u << 24, high = i % 7 == 0 ? 1 : wide;
        for (size_t j = 0; j < count; j++) {
            sfi_corner p = {test_random_below(wide), test_random_below(high), (uint32_t)j};
            points[j] = p;
        }
        compare(points, count);
    }
}

static void degenerate_points(void)
{
    sfi_corner points[POINTS];
    for (int64_t dx = -2; dx <= 2; dx++) {
        for (int64_t dy = -2; dy <= 2; dy++) {
            for (uint32_t j = 0; j < 9; j++) {
                sfi_corner p = {dx * (int64_t)(j * 5 % 9), dy * (int64_t)(j * 5 % 9), j};
                points[j] = p;
            }
            compare(points, 9);
            CHECK_EQ(sfi_polygon_hull(points, 9), dx == 0 && dy == 0 ? 1 : 2);
        }
    }
    CHECK_EQ(sfi_polygon_hull(points, 0), 0);
    CHECK_EQ(sfi_polygon_hull(points, 1), 1);
}

// At the limit, and as flat as can be: a product of 64 bits would see no turn, or the wrong one.
static void the_largest_points(void)
{
    int64_t m = SFI_CORNER_MAX;
    sfi_corner points[] = {{-m, -m, 0}, {m, m, 1},   {-1, 0, 2},    {0, 0, 3},
                           {1, 0, 4},   {-m, -m, 5}, {m, m - 1, 6}, {m / 2, m / 2, 7}};
    CHECK_EQ(sfi_polygon_hull(points, 8), 5);
    CHECK(points[0].x == -m && points[1].x == 1 && points[2].y == m - 1 && points[3].y == m &&
          points[4].x == -1);
}

static void distances(void)
{
    sfi_corner points[] = {{0, 0, 0}, {4, 0, 1}, {4, 2, 2}, {0, 2, 3}};
    size_t edge = 9;
    CHECK_NEAR(sfi_polygon_inside(points, 4, 1, 1, 10, 1, &edge), 1, 0);
    CHECK_EQ(edge, 0);
    CHECK_NEAR(sfi_polygon_inside(points, 4, 3.5, 1, 1, 1, &edge), 0.5, 0);
    CHECK_EQ(edge, 1);
    CHECK_NEAR(sfi_polygon_inside(points, 4, 2, 5, 1, 2, &edge), -6, 0);
    CHECK_EQ(edge, 2);
    CHECK_NEAR(sfi_polygon_inside(points, 4, -1, 5, 3, 0.5, &edge), -3, 0);
    CHECK_EQ(edge, 3);
}

int main(void)
{
    TEST(random_points);
    TEST(degenerate_points);
    TEST(the_largest_points);
    TEST(distances);
    return test_finish();
}
