// SPDX-License-Identifier: MIT
// Solid angles of triangles, added up without arc tangents.
//
// Half the solid angle of a triangle with corners a, b, c (seen from q) is the argument of the
// complex number den + i num, with num = det(a, b, c) and den = |a||b||c| + (a.b)|c| + (b.c)|a| +
// (c.a)|b|. Angles are added by multiplying these numbers and counting turns, so that a whole
// number of turns is known exactly, and one arc tangent does for all triangles.
//
// num is computed in integers where it is small. Where it is 0, q lies in the triangle's plane, and
// the sign of what follows depends on the side to which q is taken to lie: the side of the
// crossings' rule, beyond in x, then in y, then in z. So triangles and crossings agree, and a hole
// that lies in a plane of voxel centres is filled or not as one, instead of being sprinkled.
//
// Source: A. van Oosterom, J. Strackee, "The solid angle of a plane triangle", 1983.

#include "mesh/angle.h"

#include "base/math.h"
#include "mesh/vector.h"

#include <math.h>

#define PI 0x1.921fb54442d18p+1

static void add_angle(sfi_angle *sum, double re, double im)
{
    int up = sum->im > 0.0 || (sum->im == 0.0 && sum->re < 0.0), down = sum->im < 0.0;
    int step_up = im > 0.0 || (im == 0.0 && re < 0.0), step_down = im < 0.0;
    double x = sum->re * re - sum->im * im, y = sum->re * im + sum->im * re;
    int now_up = y > 0.0 || (y == 0.0 && x < 0.0);
    sum->turns += up && step_up && !now_up;
    sum->turns -= down && step_down && now_up;
    double size = fabs(x) > fabs(y) ? fabs(x) : fabs(y);
    double unit = size > 0x1p200 ? 0x1p-200 : size < 0x1p-200 ? 0x1p200 : 1.0;
    sum->re = x * unit;
    sum->im = y * unit;
}

// An angle of exactly half a turn, up or down.
static void add_half_turn(sfi_angle *sum, int up)
{
    add_angle(sum, -1.0, 0.0);
    sum->turns -= !up;
}

double sfi_angle_turns(const sfi_angle *a)
{
    double part;
    if (a->re > 0.0) {
        part = sfi_atan(a->im / a->re);
    } else if (a->re < 0.0) {
        part = sfi_atan(a->im / a->re) + (a->im < 0.0 ? -PI : PI);
    } else {
        part = a->im < 0.0 ? -PI / 2 : PI / 2;
    }
    return (double)a->turns + part / (2 * PI);
}

static double denominator_of(const double *u, const double *v, const double *w, double a, double b,
                             double c)
{
    return a * b * c + sfi_dot(u, v) * c + sfi_dot(v, w) * a + sfi_dot(w, u) * b;
}

static double denominator(const double v[3][3])
{
    double a = sqrt(sfi_dot(v[0], v[0])), b = sqrt(sfi_dot(v[1], v[1])),
           c = sqrt(sfi_dot(v[2], v[2]));
    return denominator_of(v[0], v[1], v[2], a, b, c);
}

// Normal of an integer triangle. Exact while its edges stay below 2^30.
static void normal(const sfi_point *const p[3], int64_t n[3])
{
    int64_t ux = (int64_t)p[1]->x - p[0]->x, vx = (int64_t)p[2]->x - p[0]->x;
    int64_t uy = (int64_t)p[1]->y - p[0]->y, vy = (int64_t)p[2]->y - p[0]->y;
    int64_t uz = (int64_t)p[1]->z - p[0]->z, vz = (int64_t)p[2]->z - p[0]->z;
    n[0] = uy * vz - uz * vy;
    n[1] = uz * vx - ux * vz;
    n[2] = ux * vy - uy * vx;
}

#define NARROW ((int64_t)1 << 20) // products of three numbers below it, six of them, fit 63 bits

// Six times the volume between q and the triangle: exact within 2^20 units (4096 voxels) of q.
static double height(const sfi_point *const p[3], const int64_t n[3], sfi_point q)
{
    int64_t x = (int64_t)p[0]->x - q.x, y = (int64_t)p[0]->y - q.y, z = (int64_t)p[0]->z - q.z;
    const int64_t most = NARROW * NARROW;
    if (x > -NARROW && x < NARROW && y > -NARROW && y < NARROW && z > -NARROW && z < NARROW &&
        n[0] > -most && n[0] < most && n[1] > -most && n[1] < most && n[2] > -most && n[2] < most) {
        return (double)(x * n[0] + y * n[1] + z * n[2]);
    }
    return (double)x * (double)n[0] + (double)y * (double)n[1] + (double)z * (double)n[2];
}

// q lies in the triangle's plane, up to nothing: it is taken to lie just beyond, first in x.
static void add_flat(sfi_angle *sum, double v[3][3], const int64_t n[3], const double scale[3])
{
    int64_t first = n[0] != 0 ? n[0] : n[1] != 0 ? n[1] : n[2];
    if (first == 0) {
        return; // no area
    }
    double a = sqrt(sfi_dot(v[0], v[0])), b = sqrt(sfi_dot(v[1], v[1])),
           c = sqrt(sfi_dot(v[2], v[2]));
    double den = denominator((const double(*)[3])v), little = 1e-12 * a * b * c;
    if (den > little) {
        return; // beside the triangle
    }
    if (den < -little) {
        add_half_turn(sum, first < 0);
        return;
    }
    // On an edge or a corner, where it matters from which side the angle is seen.
    static const double aside[3] = {0x1p-2, 0x1p-4, 0x1p-6};
    double num = 0.0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            v[j][i] -= aside[i] * scale[i];
        }
        num += aside[i] * (double)n[i];
    }
    num = fabs(num) * scale[0] * scale[1] * scale[2];
    add_angle(sum, denominator((const double(*)[3])v), first < 0 ? num : -num);
}

// Where rounding may have changed its sign, what is tiny is made out in integers.
static void add_level(sfi_angle *sum, const sfi_point *const p[3], sfi_point q, double v[3][3],
                      const double scale[3])
{
    int64_t n[3];
    normal(p, n);
    double num = height(p, n, q);
    if (num == 0.0) {
        add_flat(sum, v, n, scale);
    } else {
        add_angle(sum, denominator((const double(*)[3])v), num * scale[0] * scale[1] * scale[2]);
    }
}

void sfi_angle_add(sfi_angle *sum, const sfi_point *const p[3], sfi_point q, const double scale[3])
{
    double v[3][3], across[3], length[3];
    for (int i = 0; i < 3; i++) {
        v[i][0] = (double)(p[i]->x - q.x) * scale[0];
        v[i][1] = (double)(p[i]->y - q.y) * scale[1];
        v[i][2] = (double)(p[i]->z - q.z) * scale[2];
        length[i] = sqrt(sfi_dot(v[i], v[i]));
    }
    sfi_cross(v[1], v[2], across);
    double num = sfi_dot(v[0], across), most = length[0] * length[1] * length[2];
    if (fabs(num) < 0x1p-46 * most) { // six products, each wrong by few parts in 2^53
        add_level(sum, p, q, v, scale);
        return;
    }
    add_angle(sum, denominator_of(v[0], v[1], v[2], length[0], length[1], length[2]), num);
}

void sfi_angle_add_beside(sfi_angle *sum, const double *const v[3], const double length[3])
{
    double across[3];
    sfi_cross(v[1], v[2], across);
    add_angle(sum, denominator_of(v[0], v[1], v[2], length[0], length[1], length[2]),
              sfi_dot(v[0], across));
}
