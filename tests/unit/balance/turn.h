// SPDX-License-Identifier: MIT
// Rotations, random directions and random soups of triangles for tests of balance.

#ifndef SF_TEST_TURN_H
#define SF_TEST_TURN_H

#include "test.h"

#include <sf/mesh.h>

#define DEGREES (180 / 3.14159265358979323846)

static inline double dot3(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Rodrigues' formula: v turned about an axis of length 1.
static inline void turn3(const double v[3], const double axis[3], double angle, double out[3])
{
    double cross[3] = {axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2],
                       axis[0] * v[1] - axis[1] * v[0]};
    double along = dot3(axis, v), c = cos(angle), s = sin(angle), result[3];
    for (int i = 0; i < 3; i++) {
        result[i] = c * v[i] + s * cross[i] + (1 - c) * along * axis[i];
    }
    memcpy(out, result, sizeof result);
}

static inline double angle3(const double a[3], const double b[3])
{
    double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                       a[0] * b[1] - a[1] * b[0]};
    return atan2(sqrt(dot3(cross, cross)), dot3(a, b));
}

// Evenly over the sphere.
static inline void random_direction(double out[3])
{
    double z = 2 * test_random_unit() - 1, t = 6.283185307179586 * test_random_unit();
    double r = sqrt(1 - z * z);
    out[0] = r * cos(t);
    out[1] = r * sin(t);
    out[2] = z;
}

// A rotation: an axis and an angle.
typedef struct spin {
    double axis[3], angle;
} spin;

static inline spin random_spin(void)
{
    spin s;
    random_direction(s.axis);
    s.angle = 6.283185307179586 * test_random_unit();
    return s;
}

enum { SOUP_MAX = 4096 };

// Points, and triangles that use each of them.
typedef struct soup {
    double vertices[3 * SOUP_MAX];
    uint32_t triangles[3 * SOUP_MAX];
    size_t count;
} soup;

static inline void soup_add(soup *s, double x, double y, double z)
{
    double *p = s->vertices + 3 * s->count++;
    p[0] = x;
    p[1] = y;
    p[2] = z;
}

static inline void soup_turn(soup *s, const spin *by, const double shift[3])
{
    for (size_t i = 0; i < s->count; i++) {
        turn3(s->vertices + 3 * i, by->axis, by->angle, s->vertices + 3 * i);
        for (int d = 0; d < 3; d++) {
            s->vertices[3 * i + (size_t)d] += shift[d];
        }
    }
}

// A triangle from each vertex over its two followers.
static inline sf_mesh_view soup_view(soup *s)
{
    for (size_t i = 0; i < 3 * s->count; i++) {
        s->triangles[i] = (uint32_t)((i / 3 + i % 3) % s->count);
    }
    sf_mesh_view view = {s->vertices, s->count, s->triangles, s->count};
    return view;
}

#endif
