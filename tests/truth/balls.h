// SPDX-License-Identifier: MIT
// Three balls on a leaning axis, each with ridges around it, cut flat where the lowest stands: what
// figure 14 of "Make It Stand" shows, made anew from nothing but these numbers. It falls when it is
// solid, and carving alone cannot hold it.

#ifndef TESTS_TRUTH_BALLS_H
#define TESTS_TRUTH_BALLS_H

#include "standing.h"

enum { BALLS = 3, BALLS_RINGS = 180, BALLS_AROUND = 96 };

#define BALLS_LEAN 0.6    // radians from the vertical
#define BALLS_FOOT 6.6    // height of the lowest ball's middle, of a radius of 8
#define BALLS_NECK 2.6    // no part of the axis is thinner
#define BALLS_RIDGE 0.035 // height of a ridge, of the radius

static const double balls_radius[BALLS] = {8, 9, 7};
static const double balls_along[BALLS] = {0, 16, 31}; // middles along the axis

static inline void balls_middle(int ball, double at[3])
{
    at[0] = balls_along[ball] * sin(BALLS_LEAN);
    at[1] = 0;
    at[2] = BALLS_FOOT + balls_along[ball] * cos(BALLS_LEAN);
}

// How far the surface lies from the axis, and whether in a ball.
static inline double balls_away(double along)
{
    double away = 0;
    for (int b = 0; b < BALLS; b++) {
        double off = (along - balls_along[b]) / balls_radius[b];
        if (fabs(off) < 1) {
            double ridge = 1 + BALLS_RIDGE * cos(10 * asin(off)) * sqrt(1 - off * off);
            away = fmax(away, balls_radius[b] * ridge * sqrt(1 - off * off));
        }
    }
    int between = along > balls_along[0] && along < balls_along[BALLS - 1];
    return between ? fmax(away, BALLS_NECK) : away;
}

static inline void balls_add(sf_mesh *mesh, double along, double away, double angle)
{
    double out = away * cos(angle);
    double p[3] = {along * sin(BALLS_LEAN) + out * cos(BALLS_LEAN), away * sin(angle),
                   BALLS_FOOT + along * cos(BALLS_LEAN) - out * sin(BALLS_LEAN)};
    p[2] = fmax(p[2], 0);
    CHECK_EQ(sf_mesh_add_vertices(mesh, p, 1), SF_OK);
}

static inline void balls_triangle(sf_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t t[3] = {a, b, c};
    CHECK_EQ(sf_mesh_add_triangles(mesh, t, 1), SF_OK);
}

// Closed, looking outwards: rings across the axis between two ends.
static inline standing_model balls_make(void)
{
    standing_model m = {NULL, {0, 0, 0}, {0, 0, 0}, 0};
    double first = -balls_radius[0], last = balls_along[BALLS - 1] + balls_radius[BALLS - 1];
    CHECK_EQ(sf_mesh_create(NULL, &m.mesh), SF_OK);
    for (int r = 1; r <= BALLS_RINGS; r++) {
        double along = first + (last - first) * r / (BALLS_RINGS + 1);
        for (int i = 0; i < BALLS_AROUND; i++) {
            balls_add(m.mesh, along, balls_away(along), i * 6.283185307179586 / BALLS_AROUND);
        }
    }
    balls_add(m.mesh, first, 0, 0);
    balls_add(m.mesh, last, 0, 0);
    uint32_t low = BALLS_RINGS * BALLS_AROUND, high = low + 1;
    for (uint32_t i = 0; i < BALLS_AROUND; i++) {
        uint32_t next = (i + 1) % BALLS_AROUND, top = (BALLS_RINGS - 1) * BALLS_AROUND;
        balls_triangle(m.mesh, low, next, i);
        balls_triangle(m.mesh, high, top + i, top + next);
        for (uint32_t r = 0; r + 1 < BALLS_RINGS; r++) {
            uint32_t row = r * BALLS_AROUND, above = row + BALLS_AROUND;
            balls_triangle(m.mesh, row + i, row + next, above + next);
            balls_triangle(m.mesh, row + i, above + next, above + i);
        }
    }
    CHECK_EQ(sf_mesh_bounds(sf_mesh_get_view(m.mesh), m.low, m.high), SF_OK);
    for (int d = 0; d < 3; d++) {
        m.size = fmax(m.size, m.high[d] - m.low[d]);
    }
    return m;
}

// Three degrees, on the flat that was cut.
static inline sf_stance_options balls_stance(void)
{
    sf_stance_options o = sf_stance_options_default();
    o.gamma_rad = 3 * STANDING_DEGREE;
    return o;
}

// A point in the middle of each ball.
static inline size_t balls_handles(sf_handle handles[BALLS])
{
    for (int b = 0; b < BALLS; b++) {
        sf_handle h = {.kind = SF_HANDLE_POINT};
        balls_middle(b, h.at_mm);
        handles[b] = h;
    }
    return BALLS;
}

#endif
