// SPDX-License-Identifier: MIT
// Marks of a plan. The centre of mass as it was is a ring, and as it is a dot that fits into the
// ring, so that both are seen where they lie at one place; a cross-hair, open in the middle, is the
// point that a thing hangs from, below which both may lie.

#include "plan_marks.h"

#include <math.h>
#include <stddef.h>

const double marks_paper[3] = {1, 1, 1};
const double marks_shadow[3] = {0.90, 0.905, 0.915}, marks_outline[3] = {0.62, 0.64, 0.67};
const double marks_support[3] = {0.62, 0.76, 0.93}, marks_rim[3] = {0.20, 0.38, 0.62};
const double marks_safe[3] = {0.56, 0.83, 0.58}, marks_safe_rim[3] = {0.20, 0.52, 0.25};
const double marks_before[3] = {0.90, 0.40, 0.10};
static const double after[3] = {0.10, 0.12, 0.16}, string[3] = {0.45, 0.18, 0.60};

#define THICK 3.0 // of the ring
#define HALO 1.2  // of paper around what must stand out
#define SQUARE 8.0

static const double *square(double x, double y, const double fill[3], const double edge[3])
{
    double far = fmax(fabs(x), fabs(y));
    return far < SQUARE - 1.6 ? fill : far < SQUARE ? edge : NULL;
}

static const double *cross_hair(double x, double y, double radius)
{
    double across = fmin(fabs(x), fabs(y)), along = fmax(fabs(x), fabs(y));
    if (fabs(radius - 12) < 1.1 || (across < 1.1 && along > 10 && along < 18)) {
        return string;
    }
    return fabs(radius - 12) < 2 || (across < 2 && along > 9 && along < 19) ? marks_paper : NULL;
}

const double *marks_colour(plan_mark mark, double x, double y)
{
    double radius = sqrt(x * x + y * y);
    switch (mark) {
    case MARK_SHADOW:
        return square(x, y, marks_shadow, marks_outline);
    case MARK_SUPPORT:
        return square(x, y, marks_support, marks_rim);
    case MARK_SAFE:
        return square(x, y, marks_safe, marks_safe_rim);
    case MARK_STRING:
        return cross_hair(x, y, radius);
    case MARK_BEFORE:
        return radius > MARKS_RING + HALO || radius < MARKS_RING - THICK - HALO ? NULL
               : radius > MARKS_RING || radius < MARKS_RING - THICK             ? marks_paper
                                                                                : marks_before;
    default:
        return radius < MARKS_DOT ? after : radius < MARKS_DOT + HALO ? marks_paper : NULL;
    }
}
