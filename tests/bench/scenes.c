// SPDX-License-Identifier: MIT
// Shapes to time on: balls and noise as the two ends of what a grid can hold, a printer's plate,
// and a sphere whose bumps keep its triangles from lying in any special direction.

#include "scenes.h"

#include "bench.h"

#include <math.h>
#include <string.h>

static uint64_t state;

// splitmix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators", 2014).
static uint64_t random_word(void)
{
    uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static double random_unit(void)
{
    return (double)(random_word() >> 11) * 0x1p-53;
}

static sf_grid *cube(uint32_t n)
{
    sf_lattice lattice = {n, n, n, 1.0, 1.0, 1.0, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    bench_must(sf_grid_create(&lattice, NULL, &grid));
    state = 1;
    return grid;
}

// Add the voxels of a slice whose centres lie in a disk.
static void add_disk(sf_slice slice, double x, double y, double radius)
{
    for (uint32_t row = 0; row < slice.height; row++) {
        double dy = row + 0.5 - y, half = radius * radius - dy * dy;
        if (half <= 0) {
            continue;
        }
        double x0 = ceil(x - sqrt(half) - 0.5), x1 = floor(x + sqrt(half) - 0.5) + 1;
        x0 = x0 < 0 ? 0 : x0;
        x1 = x1 > slice.width ? slice.width : x1;
        if (x0 < x1) {
            sf_rect rect = {(uint32_t)x0, row, (uint32_t)x1, row + 1};
            bench_must(sf_slice_fill(slice, rect, 1));
        }
    }
}

void scene_add_ball(sf_grid *grid, double x, double y, double z, double radius)
{
    for (uint32_t k = 0; k < sf_grid_lattice(grid).nz; k++) {
        double dz = k + 0.5 - z, rest = radius * radius - dz * dz;
        if (rest > 0) {
            add_disk(sf_grid_slice(grid, k), x, y, sqrt(rest));
        }
    }
}

static sf_grid *scene_of_balls(uint32_t n, int balls)
{
    sf_grid *grid = cube(n);
    for (int ball = 0; ball < balls; ball++) {
        double at[3], radius = n * (0.06 + 0.12 * random_unit());
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = n * random_unit();
        }
        scene_add_ball(grid, at[0], at[1], at[2], radius);
    }
    return grid;
}

sf_grid *scene_four_balls(uint32_t n)
{
    static const double balls[4][4] = {{0.29, 0.29, 0.21, 0.22},
                                       {0.68, 0.33, 0.39, 0.215},
                                       {0.33, 0.7, 0.64, 0.22},
                                       {0.7, 0.7, 0.78, 0.215}};
    sf_grid *grid = cube(n);
    for (int i = 0; i < 4; i++) {
        scene_add_ball(grid, n * balls[i][0], n * balls[i][1], n * balls[i][2], n * balls[i][3]);
    }
    sf_rect plate = {n / 16, n / 16, n - n / 16, n - n / 16};
    bench_must(sf_slice_fill(sf_grid_slice(grid, 0), plate, 1));
    return grid;
}

sf_grid *scene_slab(uint32_t n, uint32_t nz, uint32_t z, uint32_t margin)
{
    sf_lattice lattice = {n, n, nz, 1.0, 1.0, 1.0, NULL, {0, 0, 0}};
    sf_rect slab = {margin, margin, n - margin, n - margin};
    sf_grid *grid = NULL;
    bench_must(sf_grid_create(&lattice, NULL, &grid));
    for (uint32_t k = z; k < z + 4; k++) {
        bench_must(sf_slice_fill(sf_grid_slice(grid, k), slab, 1));
    }
    return grid;
}

sf_grid *scene_balls(uint32_t n)
{
    return scene_of_balls(n, 60);
}

sf_grid *scene_far_balls(uint32_t n)
{
    return scene_of_balls(n, 12);
}

static void fill_with_noise(sf_slice slice)
{
    for (uint32_t y = 0; y < slice.height; y++) {
        uint64_t *row = slice.words + (size_t)y * slice.stride;
        for (uint32_t x = 0; x < slice.width; x += 64) {
            uint32_t padding = slice.width - x < 64 ? 64 - (slice.width - x) : 0;
            row[x / 64] = random_word() >> padding;
        }
    }
}

sf_grid *scene_noise(uint32_t n)
{
    sf_grid *grid = cube(n);
    for (uint32_t k = 0; k < n; k++) {
        fill_with_noise(sf_grid_slice(grid, k));
    }
    return grid;
}

static sf_slice empty_slice(uint32_t width, uint32_t height)
{
    sf_slice slice = {NULL, width, height, sf_slice_stride(width)};
    size_t size = slice.stride * height * sizeof(uint64_t);
    slice.words = bench_memory(size);
    memset(slice.words, 0, size);
    state = 2;
    return slice;
}

sf_slice scene_plate(uint32_t width, uint32_t height)
{
    sf_slice slice = empty_slice(width, height);
    for (int part = 0; part < 60; part++) {
        add_disk(slice, width * random_unit(), height * random_unit(),
                 height * (0.01 + 0.05 * random_unit()));
    }
    for (int support = 0; support < 2500; support++) {
        add_disk(slice, width * random_unit(), height * random_unit(), 2 + 4 * random_unit());
    }
    return slice;
}

sf_slice scene_noise_slice(uint32_t width, uint32_t height)
{
    sf_slice slice = empty_slice(width, height);
    fill_with_noise(slice);
    return slice;
}

// --- the sphere ----------------------------------------------------------------------------------

// The twelve vertices and twenty faces of an icosahedron; g is the golden ratio.
#define G 1.6180339887498949
static const double corners[12][3] = {{-1, G, 0}, {1, G, 0}, {-1, -G, 0}, {1, -G, 0},
                                      {0, -1, G}, {0, 1, G}, {0, -1, -G}, {0, 1, -G},
                                      {G, 0, -1}, {G, 0, 1}, {-G, 0, -1}, {-G, 0, 1}};
static const uint32_t faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

// A point of a face at whole barycentric weights, moved onto the bumpy sphere. A point on the edge
// of two faces comes out the same from both: two products are added, and a zero.
static void bumpy_point(const uint32_t *face, const uint32_t *weights, double size, double *point)
{
    double p[3], length = 0;
    for (int axis = 0; axis < 3; axis++) {
        p[axis] = 0;
        for (int i = 0; i < 3; i++) {
            p[axis] += weights[i] * corners[face[i]][axis];
        }
        length += p[axis] * p[axis];
    }
    for (int axis = 0; axis < 3; axis++) {
        p[axis] /= sqrt(length);
    }
    double bumps = 0.05 * sin(7 * p[0] + 1) * sin(9 * p[1] + 2) * sin(8 * p[2] + 3) +
                   0.003 * sin(97 * p[0]) * sin(89 * p[1]) * sin(101 * p[2]);
    for (int axis = 0; axis < 3; axis++) {
        point[axis] = size * (0.5 + 0.45 * (1 + bumps) * p[axis]);
    }
}

// n^2 triangles of one face; row i has i + 1 points.
static void add_face(sf_mesh *mesh, const uint32_t *face, uint32_t n, double size)
{
    uint32_t base = (uint32_t)sf_mesh_get_view(mesh).vertex_count;
    for (uint32_t i = 0; i <= n; i++) {
        for (uint32_t j = 0; j <= i; j++) {
            const uint32_t weights[3] = {n - i, i - j, j};
            double point[3];
            bumpy_point(face, weights, size, point);
            bench_must(sf_mesh_add_vertices(mesh, point, 1));
        }
    }
    for (uint32_t i = 0; i < n; i++) {
        uint32_t above = base + i * (i + 1) / 2, below = above + i + 1;
        for (uint32_t j = 0; j <= i; j++) {
            const uint32_t two[6] = {above + j, below + j,     below + j + 1,
                                     above + j, below + j + 1, above + j + 1};
            bench_must(sf_mesh_add_triangles(mesh, two, j < i ? 2 : 1));
        }
    }
}

sf_mesh *scene_bumpy_sphere(uint32_t n, double size)
{
    sf_mesh *apart = NULL, *mesh = NULL;
    bench_must(sf_mesh_create(NULL, &apart));
    for (int f = 0; f < 20; f++) {
        add_face(apart, faces[f], n, size);
    }
    bench_must(sf_mesh_merge(sf_mesh_get_view(apart), NULL, &mesh));
    sf_mesh_destroy(apart);
    return mesh;
}
