// SPDX-License-Identifier: MIT
// The slow judge of what carving and bending give: weight and wall, from the meshes alone.

#ifndef SF_TEST_BALANCE_JUDGE_H
#define SF_TEST_BALANCE_JUDGE_H

#include "unit/balance/distances.h"

// Adds mass and moments of the tetrahedra between the origin and the triangles.
static inline void judge_weight(sf_mesh_view mesh, double sums[4])
{
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        const double *a = mesh.vertices + 3 * (size_t)mesh.triangles[3 * t];
        const double *b = mesh.vertices + 3 * (size_t)mesh.triangles[3 * t + 1];
        const double *c = mesh.vertices + 3 * (size_t)mesh.triangles[3 * t + 2];
        double six = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]);
        sums[0] += six / 6;
        for (int d = 0; d < 3; d++) {
            sums[1 + d] += six / 24 * (a[d] + b[d] + c[d]);
        }
    }
}

// Centre of mass of an outside together with its cavity, whose triangles look into the hollow.
static inline void judge_com(sf_mesh_view outer, sf_mesh_view cavity, double com[3])
{
    double sums[4] = {0, 0, 0, 0};
    judge_weight(outer, sums);
    judge_weight(cavity, sums);
    for (int d = 0; d < 3; d++) {
        com[d] = sums[1 + d] / sums[0];
    }
}

static inline double judge_point_triangle(vec p, const vec t[3])
{
    double least = point_face(p, t);
    for (int e = 0; e < 3; e++) {
        least = fmin(least, point_segment(p, t[e], t[(e + 1) % 3]));
    }
    return least;
}

// The least distance of every `step`-th vertex of the cavity to the outside.
static inline double judge_wall(sf_mesh_view outer, sf_mesh_view cavity, size_t step)
{
    double least = INFINITY;
    for (size_t v = 0; v < cavity.vertex_count; v += step) {
        vec p = vec_of(cavity.vertices + 3 * v);
        for (size_t t = 0; t < outer.triangle_count; t++) {
            vec corners[3];
            for (size_t i = 0; i < 3; i++) {
                corners[i] = vec_of(outer.vertices + 3 * (size_t)outer.triangles[3 * t + i]);
            }
            least = fmin(least, judge_point_triangle(p, corners));
        }
    }
    return least;
}

#endif
