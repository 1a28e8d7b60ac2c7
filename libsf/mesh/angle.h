// SPDX-License-Identifier: MIT
// Solid angles of triangles, added up without arc tangents.

#ifndef SF_MESH_ANGLE_H
#define SF_MESH_ANGLE_H

#include "mesh/frame.h"

// Half a solid angle: a direction, of any length, with its argument in (-pi, pi], and whole turns
// beyond it. Nothing is {1, 0, 0}.
typedef struct sfi_angle {
    double re, im;
    int64_t turns;
} sfi_angle;

// Add what a triangle fills of the view from q, positive when it turns its back to q. `scale` gives
// the length of a unit along x, y and z.
void sfi_angle_add(sfi_angle *sum, const sfi_point *const p[3], sfi_point q, const double scale[3]);

// The same for a point beside the triangle, 0, from its corners and how far they are.
void sfi_angle_add_beside(sfi_angle *sum, const double *const v[3], const double length[3]);

// The sum in turns: a closed surface around q gives 1.
double sfi_angle_turns(const sfi_angle *a);

#endif
