// SPDX-License-Identifier: MIT
// Convex hulls of points in the plane: the stack of Graham and Andrew, in place.
//
// The line from the least to the greatest point (by x, then y) parts the others into those below or
// on it and those above. The lower ones by rising x and then the upper ones by falling x make a
// polygon that goes around once; one pass over it with a stack, which drops every corner that does
// not turn left, leaves the hull. The stack never outgrows what was read, so it lies in the array
// itself. Points are sorted by heap, which takes no memory, by position and then by name, so that
// the result does not depend on the order they came in.
//
// Turns are exact: differences fit in 63 bits, their products in 128.
//
// Source: A. M. Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions", 1979;
// J. W. J. Williams, "Algorithm 232: Heapsort", 1964.

#include "base/polygon.h"

#include "base/exact.h"

#include <math.h>

static int comes_before(const sfi_corner *a, const sfi_corner *b)
{
    return a->x != b->x ? a->x < b->x : a->y != b->y ? a->y < b->y : a->name < b->name;
}

static void swap(sfi_corner *a, sfi_corner *b)
{
    sfi_corner kept = *a;
    *a = *b;
    *b = kept;
}

// Left turn (1), none (0) or right turn (-1) on the way over a and b to c.
static int turn(const sfi_corner *a, const sfi_corner *b, const sfi_corner *c)
{
    return sfi_exact_turn(b->x - a->x, b->y - a->y, c->x - a->x, c->y - a->y);
}

// Let the item at `root` sink; `falling`: the least comes to the top.
static void sift(sfi_corner *items, size_t root, size_t count, int falling)
{
    for (size_t child; (child = 2 * root + 1) < count; root = child) {
        child += child + 1 < count && comes_before(items + child + falling,   // the larger one, or
                                                   items + child + !falling); // the lesser one
        if (!(falling ? comes_before(items + child, items + root)
                      : comes_before(items + root, items + child))) {
            return;
        }
        swap(items + root, items + child);
    }
}

static void sort(sfi_corner *items, size_t count, int falling)
{
    for (size_t root = count / 2; root > 0; root--) {
        sift(items, root - 1, count, falling);
    }
    for (size_t end = count; end > 1; end--) {
        swap(items, items + end - 1);
        sift(items, 0, end - 1, falling);
    }
}

// The points in the order of a polygon around their hull, the least of them first.
static void arrange(sfi_corner *points, size_t count)
{
    sfi_corner greatest = points[0];
    size_t lower = 1;
    for (size_t i = 1; i < count; i++) {
        if (comes_before(points + i, points)) {
            swap(points, points + i);
        }
        if (comes_before(&greatest, points + i)) {
            greatest = points[i];
        }
    }
    for (size_t i = 1; i < count; i++) {
        if (turn(points, &greatest, points + i) <= 0) {
            swap(points + lower++, points + i);
        }
    }
    sort(points + 1, lower - 1, 0);
    sort(points + lower, count - lower, 1);
}

size_t sfi_polygon_hull(sfi_corner *points, size_t count)
{
    size_t top = 1;
    if (count < 2) {
        return count;
    }
    arrange(points, count);
    for (size_t i = 1; i < count; i++) {
        while (top >= 2 && turn(points + top - 2, points + top - 1, points + i) <= 0) {
            top--;
        }
        points[top++] = points[i];
    }
    while (top > 2 && turn(points + top - 2, points + top - 1, points) <= 0) {
        top--;
    }
    return top == 2 && points[0].x == points[1].x && points[0].y == points[1].y ? 1 : top;
}

double sfi_polygon_inside(const sfi_corner *corners, size_t count, double x, double y,
                          double pitch_x, double pitch_y, size_t *edge)
{
    double least = INFINITY;
    for (size_t i = 0; i < count; i++) {
        const sfi_corner *a = corners + i, *b = corners + (i + 1) % count;
        double dx = (double)(b->x - a->x) * pitch_x, dy = (double)(b->y - a->y) * pitch_y;
        double px = (x - (double)a->x) * pitch_x, py = (y - (double)a->y) * pitch_y;
        double inside = (dx * py - dy * px) / sqrt(dx * dx + dy * dy);
        if (inside < least) {
            least = inside;
            *edge = i;
        }
    }
    return least;
}
