// SPDX-License-Identifier: MIT
// A bottle that leans: rings of vertices along an axis that is not upright, a flat foot and a lid.

#ifndef SF_TEST_BALANCE_BOTTLE_H
#define SF_TEST_BALANCE_BOTTLE_H

#include "test.h"

#include <sf/mesh.h>

enum { BOTTLE_RINGS = 25, BOTTLE_AROUND = 32, BOTTLE_HEIGHT = 48 };

// How wide it is at a height, from 0 to 1: a narrow foot, a body, a neck.
static inline double bottle_radius(double at)
{
    return 5 + 5 * sin(3.14159265358979 * at) - 2 * at;
}

static inline void bottle_triangle(sf_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t t[3] = {a, b, c};
    CHECK_EQ(sf_mesh_add_triangles(mesh, t, 1), SF_OK);
}

// Closed, looking outwards, its foot on z = 0; the axis goes `lean` to the side for each step up.
static inline sf_mesh *bottle(double lean)
{
    sf_mesh *mesh = NULL;
    CHECK_EQ(sf_mesh_create(NULL, &mesh), SF_OK);
    for (int r = 0; r < BOTTLE_RINGS; r++) {
        double at = r / (BOTTLE_RINGS - 1.0), z = at * BOTTLE_HEIGHT;
        for (int i = 0; i < BOTTLE_AROUND; i++) {
            double angle = i * 6.283185307179586 / BOTTLE_AROUND;
            const double p[3] = {lean * z + bottle_radius(at) * cos(angle),
                                 bottle_radius(at) * sin(angle), z};
            CHECK_EQ(sf_mesh_add_vertices(mesh, p, 1), SF_OK);
        }
    }
    const double ends[6] = {0, 0, 0, lean * BOTTLE_HEIGHT, 0, BOTTLE_HEIGHT};
    CHECK_EQ(sf_mesh_add_vertices(mesh, ends, 2), SF_OK);
    uint32_t foot = BOTTLE_RINGS * BOTTLE_AROUND, lid = foot + 1;
    for (uint32_t i = 0; i < BOTTLE_AROUND; i++) {
        uint32_t next = (i + 1) % BOTTLE_AROUND, top = (BOTTLE_RINGS - 1) * BOTTLE_AROUND;
        bottle_triangle(mesh, foot, next, i);
        bottle_triangle(mesh, lid, top + i, top + next);
        for (uint32_t r = 0; r + 1 < BOTTLE_RINGS; r++) {
            uint32_t row = r * BOTTLE_AROUND, above = row + BOTTLE_AROUND;
            bottle_triangle(mesh, row + i, row + next, above + next);
            bottle_triangle(mesh, row + i, above + next, above + i);
        }
    }
    return mesh;
}

#endif
