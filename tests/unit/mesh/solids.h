// SPDX-License-Identifier: MIT
// Meshes made by rule, and a slow judge of what lies inside them, for the tests of the voxeliser.
//
// The judge knows nothing of rows or of edges: it adds up solid angles (A. van Oosterom, J.
// Strackee, "The solid angle of a plane triangle", 1983) seen from a voxel's centre. Where the
// centre may lie exactly on the surface it is moved by a little in x, less in y, still less in z;
// that is what the voxeliser promises: a centre on the surface counts as lying just beyond it.

#ifndef SF_TEST_SOLIDS_H
#define SF_TEST_SOLIDS_H

#include <sf/mesh.h>

#include "test.h"

#define SOLID_VERTICES 4096
#define SOLID_TRIANGLES 8192

// Coordinates in voxels of the lattice (0..n); mesh coordinates are the same where pitch is 1.
typedef struct solid {
    double vertices[3 * SOLID_VERTICES];
    uint32_t triangles[3 * SOLID_TRIANGLES];
    size_t vertex_count, triangle_count;
} solid;

static inline sf_mesh_view solid_view(const solid *s)
{
    sf_mesh_view view = {s->vertices, s->vertex_count, s->triangles, s->triangle_count};
    return view;
}

static inline uint32_t solid_vertex(solid *s, double x, double y, double z)
{
    double *p = s->vertices + 3 * s->vertex_count;
    p[0] = x;
    p[1] = y;
    p[2] = z;
    return (uint32_t)s->vertex_count++;
}

static inline void solid_triangle(solid *s, uint32_t a, uint32_t b, uint32_t c)
{
    uint32_t *t = s->triangles + 3 * s->triangle_count++;
    t[0] = a;
    t[1] = b;
    t[2] = c;
}

// Twelve triangles, normals outward; each face split along one or the other diagonal at random.
static inline void solid_box(solid *s, const double low[3], const double high[3])
{
    uint32_t v = (uint32_t)s->vertex_count;
    for (int i = 0; i < 8; i++) {
        solid_vertex(s, i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1],
                     i & 4 ? high[2] : low[2]);
    }
    static const uint32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                         {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (int f = 0; f < 6; f++) {
        const uint32_t *q = faces[f];
        uint32_t r = test_random_below(2);
        solid_triangle(s, v + q[r], v + q[r + 1], v + q[r + 2]);
        solid_triangle(s, v + q[r], v + q[r + 2], v + q[(r + 3) % 4]);
    }
}

static inline void solid_tetra(solid *s, double p[4][3])
{
    double u[3][3];
    for (int i = 0; i < 9; i++) {
        u[i / 3][i % 3] = p[i / 3 + 1][i % 3] - p[0][i % 3];
    }
    double det = u[0][0] * (u[1][1] * u[2][2] - u[1][2] * u[2][1]) -
                 u[0][1] * (u[1][0] * u[2][2] - u[1][2] * u[2][0]) +
                 u[0][2] * (u[1][0] * u[2][1] - u[1][1] * u[2][0]);
    uint32_t v[4];
    for (int i = 0; i < 4; i++) {
        v[i] = solid_vertex(s, p[i][0], p[i][1], p[i][2]);
    }
    if (det < 0) {
        uint32_t swap = v[2];
        v[2] = v[3];
        v[3] = swap;
    }
    solid_triangle(s, v[0], v[2], v[1]);
    solid_triangle(s, v[0], v[1], v[3]);
    solid_triangle(s, v[0], v[3], v[2]);
    solid_triangle(s, v[1], v[2], v[3]);
}

// A sphere of rings and sectors, bumpy when `noise` > 0; normals outward.
static inline void solid_sphere(solid *s, const double center[3], double radius, uint32_t rings,
                                uint32_t sectors, double noise)
{
    const double pi = 3.14159265358979323846;
    uint32_t south = solid_vertex(s, center[0], center[1], center[2] - radius);
    for (uint32_t i = 1; i < rings; i++) {
        for (uint32_t j = 0; j < sectors; j++) {
            double polar = pi * i / rings, round = 2 * pi * j / sectors;
            double r = radius * (1 + noise * (test_random_unit() - 0.5));
            solid_vertex(s, center[0] + r * sin(polar) * cos(round),
                         center[1] + r * sin(polar) * sin(round), center[2] - r * cos(polar));
        }
    }
    uint32_t north = solid_vertex(s, center[0], center[1], center[2] + radius);
    for (uint32_t j = 0; j < sectors; j++) {
        uint32_t next = (j + 1) % sectors;
        solid_triangle(s, south, south + 1 + next, south + 1 + j);
        for (uint32_t i = 0; i + 2 < rings; i++) {
            uint32_t a = south + 1 + i * sectors, b = a + sectors;
            solid_triangle(s, a + j, a + next, b + next);
            solid_triangle(s, a + j, b + next, b + j);
        }
        uint32_t top = south + 1 + (rings - 2) * sectors;
        solid_triangle(s, top + j, top + next, north);
    }
}

// Round every coordinate to 1/256: the voxeliser then sees exactly this mesh.
static inline void solid_snap(solid *s)
{
    for (size_t i = 0; i < 3 * s->vertex_count; i++) {
        s->vertices[i] = floor(s->vertices[i] * 256 + 0.5) / 256;
    }
}

// Turn every triangle from `first` on inside out.
static inline void solid_flip(solid *s, size_t first)
{
    for (size_t t = first; t < s->triangle_count; t++) {
        uint32_t swap = s->triangles[3 * t + 1];
        s->triangles[3 * t + 1] = s->triangles[3 * t + 2];
        s->triangles[3 * t + 2] = swap;
    }
}

static inline double solid_angle(const double *a, const double *b, const double *c,
                                 const double q[3])
{
    double u[3], v[3], w[3];
    for (int i = 0; i < 3; i++) {
        u[i] = a[i] - q[i];
        v[i] = b[i] - q[i];
        w[i] = c[i] - q[i];
    }
    double det = u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
                 u[2] * (v[0] * w[1] - v[1] * w[0]);
    double lu = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    double lv = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    double lw = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    double uv = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
    double vw = v[0] * w[0] + v[1] * w[1] + v[2] * w[2];
    double wu = w[0] * u[0] + w[1] * u[1] + w[2] * u[2];
    return 2 * atan2(det, lu * lv * lw + uv * lw + vw * lu + wu * lv);
}

// The winding number of the mesh around q.
static inline double solid_winding(const solid *s, const double q[3])
{
    double sum = 0;
    for (size_t t = 0; t < s->triangle_count; t++) {
        const uint32_t *v = s->triangles + 3 * t;
        sum +=
            solid_angle(s->vertices + 3 * v[0], s->vertices + 3 * v[1], s->vertices + 3 * v[2], q);
    }
    return sum / (4 * 3.14159265358979323846);
}

// A lattice of n cubes of size 1 with its corner at 0.
static inline sf_lattice solid_lattice(uint32_t nx, uint32_t ny, uint32_t nz)
{
    sf_lattice lattice = {nx, ny, nz, 1.0, 1.0, 1.0, NULL, {0, 0, 0}};
    return lattice;
}

// Voxelise into a new grid.
static inline sf_grid *solid_voxelize(sf_mesh_view mesh, const sf_lattice *lattice, sf_fill fill,
                                      sf_voxelize_report *report)
{
    sf_grid *grid = NULL;
    sf_voxelize_options options = sf_voxelize_options_default();
    options.fill = fill;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    CHECK_EQ(sf_grid_voxelize(grid, mesh, &options, NULL, NULL, report), SF_OK);
    return grid;
}

// How many voxels of a unit lattice differ from the judge's word. `parity`: odd winding is solid.
// `nudge` is how far centres move in x; it must be less than what separates a centre from the
// surfaces that it does not lie on.
static inline int solid_disagreements(const solid *s, const sf_grid *grid, int parity, double nudge)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    int wrong = 0;
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        for (uint32_t y = 0; y < lattice.ny; y++) {
            for (uint32_t x = 0; x < lattice.nx; x++) {
                double q[3] = {x + 0.5 + nudge, y + 0.5 + nudge * 0x1p-8,
                               k + 0.5 + nudge * 0x1p-16};
                double w = solid_winding(s, q);
                int inside = parity ? (long long)floor(w + 0.5) % 2 != 0 : w >= 0.5;
                wrong += inside != sf_slice_get(slice, x, y);
            }
        }
    }
    return wrong;
}

#endif
