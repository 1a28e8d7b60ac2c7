// SPDX-License-Identifier: MIT
// The slow judge of distances: from a box to a triangle by all pairs of their features, and from a
// voxel to a mesh by all of its triangles.
//
// The least distance of two convex bodies that do not meet is that of a corner of one and a face of
// the other, or of two edges; they meet when an edge of one pierces the other. All of these are
// looked at, so nothing needs to be known about which one it is.

#ifndef SF_TEST_DISTANCES_H
#define SF_TEST_DISTANCES_H

#include "test.h"

#include <sf/mesh.h>

typedef struct vec {
    double v[3];
} vec;

static inline vec vec_of(const double p[3])
{
    vec a = {{p[0], p[1], p[2]}};
    return a;
}

static inline vec vec_add(vec a, double f, vec b)
{
    vec c = {{a.v[0] + f * b.v[0], a.v[1] + f * b.v[1], a.v[2] + f * b.v[2]}};
    return c;
}

static inline double vec_dot(vec a, vec b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

static inline vec vec_cross(vec a, vec b)
{
    vec c = {{a.v[1] * b.v[2] - a.v[2] * b.v[1], a.v[2] * b.v[0] - a.v[0] * b.v[2],
              a.v[0] * b.v[1] - a.v[1] * b.v[0]}};
    return c;
}

static inline double vec_far(vec a, vec b)
{
    vec d = vec_add(a, -1, b);
    return sqrt(vec_dot(d, d));
}

static inline double clamp01(double t)
{
    return t < 0 ? 0 : t > 1 ? 1 : t;
}

static inline double point_segment(vec p, vec a, vec b)
{
    vec d = vec_add(b, -1, a);
    double length = vec_dot(d, d);
    double t = length > 0 ? clamp01(vec_dot(vec_add(p, -1, a), d) / length) : 0;
    return vec_far(p, vec_add(a, t, d));
}

// Least of: the ends against the other segment, and the feet of the common perpendicular.
static inline double segment_segment(vec a, vec b, vec c, vec d)
{
    double least = fmin(fmin(point_segment(a, c, d), point_segment(b, c, d)),
                        fmin(point_segment(c, a, b), point_segment(d, a, b)));
    vec u = vec_add(b, -1, a), v = vec_add(d, -1, c), w = vec_add(a, -1, c);
    double uu = vec_dot(u, u), uv = vec_dot(u, v), vv = vec_dot(v, v);
    double uw = vec_dot(u, w), vw = vec_dot(v, w), det = uu * vv - uv * uv;
    if (det > 1e-12 * uu * vv) {
        double s = (uv * vw - vv * uw) / det, t = (uu * vw - uv * uw) / det;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
            least = fmin(least, vec_far(vec_add(a, s, u), vec_add(c, t, v)));
        }
    }
    return least;
}

// Where p lies over a triangle: distance to its plane where the foot is inside, else a large one.
// So thin a triangle that its normal is rounding has edges that say as much.
static inline double point_face(vec p, const vec t[3])
{
    vec e = vec_add(t[1], -1, t[0]), f = vec_add(t[2], -1, t[0]), n = vec_cross(e, f);
    double nn = vec_dot(n, n);
    if (!(nn > 1e-16 * vec_dot(e, e) * vec_dot(f, f))) {
        return 1e300;
    }
    for (int i = 0; i < 3; i++) {
        vec along = vec_add(t[(i + 1) % 3], -1, t[i]);
        if (vec_dot(vec_cross(along, vec_add(p, -1, t[i])), n) < 0) {
            return 1e300;
        }
    }
    return fabs(vec_dot(n, vec_add(p, -1, t[0]))) / sqrt(nn);
}

static inline double box_gap(vec p, const double low[3], const double high[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        double gap = fmax(0, fmax(low[i] - p.v[i], p.v[i] - high[i]));
        sum += gap * gap;
    }
    return sqrt(sum);
}

// Whether a segment goes through a triangle, or an edge of the triangle through the box.
static inline int pierces(vec a, vec b, const vec t[3])
{
    vec n = vec_cross(vec_add(t[1], -1, t[0]), vec_add(t[2], -1, t[0]));
    double da = vec_dot(n, vec_add(a, -1, t[0])), db = vec_dot(n, vec_add(b, -1, t[0]));
    if (da * db > 0 || da == db) {
        return 0;
    }
    return point_face(vec_add(a, da / (da - db), vec_add(b, -1, a)), t) < 1e300;
}

static inline int segment_meets_box(vec a, vec b, const double low[3], const double high[3])
{
    double t0 = 0, t1 = 1;
    for (int i = 0; i < 3; i++) {
        double step = b.v[i] - a.v[i], in = (low[i] - a.v[i]) / step,
               out = (high[i] - a.v[i]) / step;
        if (step == 0) {
            t1 = a.v[i] < low[i] || a.v[i] > high[i] ? -1 : t1;
        } else {
            t0 = fmax(t0, fmin(in, out));
            t1 = fmin(t1, fmax(in, out));
        }
    }
    return t0 <= t1;
}

static inline double box_triangle(const double low[3], const double high[3], const vec t[3])
{
    vec corners[8];
    double least = 1e300;
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 3; j++) {
            corners[i].v[j] = i >> j & 1 ? high[j] : low[j];
        }
        least = fmin(least, point_face(corners[i], t));
    }
    for (int e = 0; e < 3; e++) {
        vec a = t[e], b = t[(e + 1) % 3];
        least = fmin(least, box_gap(a, low, high));
        if (segment_meets_box(a, b, low, high)) {
            return 0;
        }
        for (int i = 0; i < 8; i++) {
            for (int j = 0; j < 3; j++) {
                if ((i >> j & 1) == 0) {
                    least = fmin(least, segment_segment(a, b, corners[i], corners[i | 1 << j]));
                }
            }
        }
    }
    for (int i = 0; i < 8; i++) {
        for (int j = 0; j < 3; j++) {
            if ((i >> j & 1) == 0 && pierces(corners[i], corners[i | 1 << j], t)) {
                return 0;
            }
        }
    }
    return least;
}

static inline double box_mesh(const double low[3], const double high[3], sf_mesh_view mesh)
{
    double least = 1e300;
    for (size_t i = 0; i < mesh.triangle_count; i++) {
        vec t[3];
        for (size_t j = 0; j < 3; j++) {
            t[j] = vec_of(mesh.vertices + 3 * (size_t)mesh.triangles[3 * i + j]);
        }
        least = fmin(least, box_triangle(low, high, t));
    }
    return least;
}

// Corners of a voxel.
static inline void voxel_box(const sf_lattice *l, uint32_t x, uint32_t y, uint32_t k, double low[3],
                             double high[3])
{
    low[0] = l->origin_mm[0] + x * l->pitch_x_mm;
    low[1] = l->origin_mm[1] + y * l->pitch_y_mm;
    low[2] = sf_lattice_layer_bottom(l, k);
    high[0] = l->origin_mm[0] + (x + 1) * l->pitch_x_mm;
    high[1] = l->origin_mm[1] + (y + 1) * l->pitch_y_mm;
    high[2] = sf_lattice_layer_bottom(l, k + 1);
}

#endif
