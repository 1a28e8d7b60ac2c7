// SPDX-License-Identifier: MIT
// The pointer's ray.

#include "ray.h"

#include <math.h>

double ray_away_px(const desk_pointer *p, const double at_mm[3])
{
    double to[3], off[3];
    for (int i = 0; i < 3; i++) {
        to[i] = at_mm[i] - p->eye_mm[i];
    }
    double depth = ray_dot(to, p->forward), along = depth / ray_dot(p->along, p->forward);
    if (!(depth > 0)) {
        return INFINITY;
    }
    for (int i = 0; i < 3; i++) {
        off[i] = to[i] - along * p->along[i];
    }
    return hypot(ray_dot(off, p->right), ray_dot(off, p->up)) / (p->spread * depth);
}

int ray_at_depth(const desk_pointer *p, const double at_mm[3], double found_mm[3])
{
    double to[3];
    for (int i = 0; i < 3; i++) {
        to[i] = at_mm[i] - p->eye_mm[i];
    }
    double t = ray_dot(to, p->forward) / ray_dot(p->along, p->forward);
    for (int i = 0; i < 3; i++) {
        found_mm[i] = p->eye_mm[i] + t * p->along[i];
    }
    return t > 0 && isfinite(t);
}

ray_hit ray_none(void)
{
    const ray_hit none = {INFINITY, {0, 0, 0}, {0, 0, 1}, 0};
    return none;
}

// T. Möller, B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997.
void ray_meet(const desk_pointer *p, const double *a, const double *b, const double *c,
              size_t triangle, ray_hit *best)
{
    double e[3], f[3], n[3], to[3], q[3];
    for (int i = 0; i < 3; i++) {
        e[i] = b[i] - a[i];
        f[i] = c[i] - a[i];
        to[i] = p->eye_mm[i] - a[i];
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        n[i] = e[j] * f[k] - e[k] * f[j];
        q[i] = to[j] * p->along[k] - to[k] * p->along[j];
    }
    double det = -ray_dot(p->along, n);
    if (!(det > 0)) {
        return;
    }
    double u = ray_dot(f, q) / det, v = -ray_dot(e, q) / det, t = ray_dot(to, n) / det;
    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < best->t) {
        double length = sqrt(ray_dot(n, n));
        best->t = t;
        best->triangle = triangle;
        for (int i = 0; i < 3; i++) {
            best->at_mm[i] = p->eye_mm[i] + t * p->along[i];
            best->normal[i] = n[i] / length;
        }
    }
}
