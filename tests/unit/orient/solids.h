// SPDX-License-Identifier: MIT
// Parts that know which way up they print: built from boxes, and prisms of any outline.

#ifndef SF_TEST_ORIENT_SOLIDS_H
#define SF_TEST_ORIENT_SOLIDS_H

#include "unit/mesh/shapes.h"

static inline void solid_clear(shape *s)
{
    s->vertex_count = s->triangle_count = 0;
}

static inline void solid_box(shape *s, double x0, double y0, double z0, double x1, double y1,
                             double z1)
{
    double low[3] = {x0, y0, z0}, high[3] = {x1, y1, z1};
    shape_box(s, low, high, 0);
}

// A convex outline in x and z, counter-clockwise as seen from -y, `count` corners; from y0 to y1.
static inline void solid_prism(shape *s, const double (*xz)[2], uint32_t count, double y0,
                               double y1)
{
    uint32_t base = (uint32_t)s->vertex_count;
    for (uint32_t i = 0; i < 2 * count; i++) {
        shape_vertex(s, xz[i % count][0], i < count ? y0 : y1, xz[i % count][1]);
    }
    for (uint32_t i = 1; i + 1 < count; i++) {
        shape_triangle(s, base, base + i, base + i + 1);
        shape_triangle(s, base + count, base + count + i + 1, base + count + i);
    }
    for (uint32_t i = 0; i < count; i++) {
        uint32_t a = base + i, b = base + (i + 1) % count;
        shape_triangle(s, a, b + count, b);
        shape_triangle(s, a, a + count, b + count);
    }
}

// A plate on a post: a T all around.
static inline void solid_t(shape *s)
{
    solid_clear(s);
    solid_box(s, 8, 8, 0, 12, 12, 20);
    solid_box(s, 0, 0, 20, 20, 20, 24);
}

static inline void solid_table(shape *s)
{
    solid_clear(s);
    solid_box(s, 0, 0, 14, 30, 20, 17);
    for (int i = 0; i < 4; i++) {
        double x = i % 2 ? 27 : 0, y = i / 2 ? 17 : 0;
        solid_box(s, x, y, 0, x + 3, y + 3, 14);
    }
}

// A wedge that stands on its sharp edge.
static inline void solid_wedge(shape *s)
{
    static const double outline[3][2] = {{10, 0}, {14, 24}, {2, 20}};
    solid_clear(s);
    solid_prism(s, outline, 3, 0, 15);
}

// Two arms and the beam that joins them at the top, arms reaching down: U_overhang's twin.
static inline void solid_u(shape *s)
{
    solid_clear(s);
    solid_box(s, 0, 0, 0, 5, 10, 20);
    solid_box(s, 20, 0, 0, 25, 10, 20);
    solid_box(s, 0, 0, 20, 25, 10, 25);
}

// Legs that meet at the bottom and a bar between them: A_upsidedown's twin.
static inline void solid_a(shape *s)
{
    static const double left[4][2] = {{14, 0}, {16, 0}, {4, 30}, {0, 30}};
    static const double right[4][2] = {{14, 0}, {16, 0}, {30, 30}, {26, 30}};
    solid_clear(s);
    solid_prism(s, left, 4, 0, 12);
    solid_prism(s, right, 4, 0, 12);
    solid_box(s, 6, 0, 19, 24, 12, 22);
}

#endif
