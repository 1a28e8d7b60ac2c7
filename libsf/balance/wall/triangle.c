// SPDX-License-Identifier: MIT
// How near a triangle comes to a box.
//
// The distance between two convex bodies is that of two of their points; which features these lie
// on tells how to find them. With p on the triangle and q in the box:
//
//   p on an edge     a segment against the box. The squared distance of p(t) to the box is convex
//                    in t, and its slope is linear between the (at most six) places where a
//                    coordinate enters or leaves the box: the bracket around the slope's zero is
//                    narrowed by each of them, and then the zero is that of a straight line.
//   p inside         then p - q is along the triangle's normal, so q is the corner of the box that
//                    is farthest towards the plane; where several tie, moving q along them either
//                    leaves p inside or brings it to an edge.
//   they meet        but no edge comes near: then what the plane cuts out of the box lies inside
//                    the triangle, and so does the point where the box's diagonal crosses the
//                    plane.
//
// Every distance comes from a point of the triangle, whose distance to the box is a matter of a few
// roundings; thin triangles, whose normal is little more than rounding, are found by their edges.
// What is too far off is found cheaply by the normal: any direction that parts all corners from the
// box by so much proves it, whatever it is the normal of.

#include "balance/wall/near.h"

#include <float.h>
#include <math.h>

#include "mesh/vector.h"

// How far a coordinate sticks out of the box, with its sign.
static double excess(double p, double half)
{
    return p > half ? p - half : p < -half ? p + half : 0;
}

static double squared_gap(const double p[3], const double half[3])
{
    double x = excess(p[0], half[0]), y = excess(p[1], half[1]), z = excess(p[2], half[2]);
    return x * x + y * y + z * z;
}

// Half the slope of the squared gap along p + t e.
static double slope(const double p[3], const double e[3], const double half[3], double t)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += e[i] * excess(p[i] + t * e[i], half[i]);
    }
    return sum;
}

// Squared distance of a segment, from p along e, to the box.
static double segment_gap(const double p[3], const double e[3], const double half[3])
{
    double low = 0, high = 1, at_low = slope(p, e, half, 0), at_high = slope(p, e, half, 1);
    double on[3], t;
    if (at_low >= 0) {
        return squared_gap(p, half);
    }
    for (int i = 0; i < 6 && at_high > 0; i++) {
        double border = (i < 3 ? half[i] : -half[i - 3]), step = e[i % 3];
        t = step != 0 ? (border - p[i % 3]) / step : 0;
        if (t > low && t < high) {
            double here = slope(p, e, half, t);
            *(here > 0 ? &high : &low) = t;
            *(here > 0 ? &at_high : &at_low) = here;
        }
    }
    t = at_high > 0 ? low - at_low * (high - low) / (at_high - at_low) : 1;
    for (int i = 0; i < 3; i++) {
        on[i] = p[i] + t * e[i];
    }
    return squared_gap(on, half);
}

// The plane of a triangle beside a box.
typedef struct plane {
    double normal[3], squared; // and its squared length
    double reach;              // of the box along the normal
    double least, most;        // of the corners along the normal
} plane;

static plane lay_plane(const double corners[3][3], double e[2][3], const double half[3])
{
    plane p;
    sfi_cross(e[0], e[1], p.normal);
    p.squared = sfi_dot(p.normal, p.normal);
    p.reach =
        half[0] * fabs(p.normal[0]) + half[1] * fabs(p.normal[1]) + half[2] * fabs(p.normal[2]);
    p.least = p.most = sfi_dot(p.normal, corners[0]);
    for (int i = 1; i < 3; i++) {
        double along = sfi_dot(p.normal, corners[i]);
        p.least = along < p.least ? along : p.least;
        p.most = along > p.most ? along : p.most;
    }
    return p;
}

// Whether the plane alone keeps the triangle away from the box.
static int is_parted(const plane *p, double limit)
{
    double gap = p->least > 0 ? p->least - p->reach : -p->most - p->reach;
    return gap > 0 && gap * gap >= limit * limit * p->squared;
}

// Squared distance of a point inside of the triangle, which is the nearest where no edge is nearer;
// else a large number.
static double inside_gap(const double corners[3][3], double e[2][3], const plane *p,
                         const double half[3])
{
    double at[3], d00 = sfi_dot(e[0], e[0]), d01 = sfi_dot(e[0], e[1]), d11 = sfi_dot(e[1], e[1]);
    double offset = 0.5 * (p->least + p->most), determinant = d00 * d11 - d01 * d01;
    if (!(determinant > 0) || !(p->reach > 0)) {
        return DBL_MAX;
    }
    // The corner of the box that is farthest along the normal has `reach` along it.
    int meets = fabs(offset) <= p->reach;
    double beyond = offset > 0 ? offset - p->reach : offset + p->reach;
    for (int i = 0; i < 3; i++) {
        double corner = p->normal[i] < 0 ? -half[i] : half[i];
        at[i] = meets ? corner * (offset / p->reach)
                      : (offset > 0 ? corner : -corner) + p->normal[i] * (beyond / p->squared);
        at[i] -= corners[0][i];
    }
    double b0 = sfi_dot(e[0], at), b1 = sfi_dot(e[1], at);
    double u = (d11 * b0 - d01 * b1) / determinant, v = (d00 * b1 - d01 * b0) / determinant;
    if (!(u >= 0 && v >= 0 && u + v <= 1)) {
        return DBL_MAX;
    }
    for (int i = 0; i < 3; i++) {
        at[i] = corners[0][i] + u * e[0][i] + v * e[1][i];
    }
    return squared_gap(at, half);
}

static double lesser(double a, double b)
{
    return a < b ? a : b;
}

double sfi_triangle_gap(const double corners[3][3], const double half[3], double limit,
                        double enough)
{
    double e[2][3], last[3], squared = enough * enough;
    sfi_subtract(corners[1], corners[0], e[0]);
    sfi_subtract(corners[2], corners[0], e[1]);
    plane p = lay_plane(corners, e, half);
    if (is_parted(&p, limit)) {
        return DBL_MAX;
    }
    double gap = squared_gap(corners[0], half);
    if (gap < squared) {
        return gap;
    }
    gap = lesser(gap, segment_gap(corners[0], e[0], half));
    if (gap < squared) {
        return gap;
    }
    sfi_subtract(corners[2], corners[1], last);
    gap = lesser(gap, segment_gap(corners[0], e[1], half));
    gap = lesser(gap, segment_gap(corners[1], last, half));
    return gap < squared ? gap : lesser(gap, inside_gap(corners, e, &p, half));
}
