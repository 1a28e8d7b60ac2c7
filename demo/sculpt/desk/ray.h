// SPDX-License-Identifier: MIT
// The pointer's ray: what it passes, and what it meets.

#ifndef SCULPT_DESK_RAY_H
#define SCULPT_DESK_RAY_H

#include "desk.h"

static inline double ray_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Pixels from the pointer to a place in the picture; infinite where it is behind the eye.
double ray_away_px(const desk_pointer *p, const double at_mm[3]);

// Where the ray comes as deep into the picture as a place; 0 where that is behind the eye.
int ray_at_depth(const desk_pointer *p, const double at_mm[3], double found_mm[3]);

// What was met first: begin with ray_none().
typedef struct ray_hit {
    double t; // mm along the ray; infinite where nothing was met
    double at_mm[3], normal[3];
    size_t triangle;
} ray_hit;

ray_hit ray_none(void);

// Try a triangle, number `triangle`, that is seen from its outside.
void ray_meet(const desk_pointer *p, const double *a, const double *b, const double *c,
              size_t triangle, ray_hit *best);

#endif
