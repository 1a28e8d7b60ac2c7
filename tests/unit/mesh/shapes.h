// SPDX-License-Identifier: MIT
// Small closed meshes for tests: a box, an icosphere, put together from triangles by hand.

#ifndef SF_TEST_SHAPES_H
#define SF_TEST_SHAPES_H

#include <sf/mesh.h>

#include <math.h>

// A mesh in fixed arrays.
typedef struct shape {
    double vertices[3 * 70000];
    uint32_t triangles[3 * 90000];
    size_t vertex_count, triangle_count;
} shape;

static inline sf_mesh_view shape_view(const shape *s)
{
    sf_mesh_view view = {s->vertices, s->vertex_count, s->triangles, s->triangle_count};
    return view;
}

static inline uint32_t shape_vertex(shape *s, double x, double y, double z)
{
    double *p = s->vertices + 3 * s->vertex_count;
    p[0] = x;
    p[1] = y;
    p[2] = z;
    return (uint32_t)s->vertex_count++;
}

static inline void shape_triangle(shape *s, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *t = s->triangles + 3 * s->triangle_count++;
    t[0] = a;
    t[1] = b;
    t[2] = c;
}

// Append a box, faces outwards, or inwards when `inside_out`.
static inline void shape_box(shape *s, const double low[3], const double high[3], int inside_out)
{
    static const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6},
                                     {0, 1, 4}, {1, 5, 4}, {2, 6, 3}, {3, 6, 7},
                                     {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    uint32_t base = (uint32_t)s->vertex_count;
    for (int i = 0; i < 8; i++) {
        shape_vertex(s, i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1],
                     i & 4 ? high[2] : low[2]);
    }
    for (int i = 0; i < 12; i++) {
        shape_triangle(s, base + (uint32_t)faces[i][0],
                       base + (uint32_t)faces[i][inside_out ? 2 : 1],
                       base + (uint32_t)faces[i][inside_out ? 1 : 2]);
    }
}

// Append a sphere of longitudes and latitudes: `n` bands, 2n around; faces outwards.
static inline void shape_sphere(shape *s, const double centre[3], double radius, int n)
{
    const double pi = 3.14159265358979323846;
    uint32_t south = shape_vertex(s, centre[0], centre[1], centre[2] - radius);
    uint32_t first = south + 1;
    for (int i = 1; i < n; i++) {
        double latitude = pi * (double)i / n - pi / 2;
        for (int j = 0; j < 2 * n; j++) {
            double longitude = pi * (double)j / n;
            shape_vertex(s, centre[0] + radius * cos(latitude) * cos(longitude),
                         centre[1] + radius * cos(latitude) * sin(longitude),
                         centre[2] + radius * sin(latitude));
        }
    }
    uint32_t north = shape_vertex(s, centre[0], centre[1], centre[2] + radius);
    uint32_t around = (uint32_t)(2 * n);
    for (uint32_t j = 0; j < around; j++) {
        uint32_t k = (j + 1) % around;
        shape_triangle(s, south, first + k, first + j);
        for (uint32_t i = 0; i + 2 < (uint32_t)n; i++) {
            uint32_t row = first + i * around, above = row + around;
            shape_triangle(s, row + j, row + k, above + k);
            shape_triangle(s, row + j, above + k, above + j);
        }
        uint32_t last = first + ((uint32_t)n - 2) * around;
        shape_triangle(s, last + j, last + k, north);
    }
}

#endif
