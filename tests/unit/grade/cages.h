// SPDX-License-Identifier: MIT
// Cages for tests: blocks of hexahedra, prisms around a line, and cages from text.

#ifndef SF_TEST_CAGES_H
#define SF_TEST_CAGES_H

#include <sf/cage.h>

#include "test.h"

// A cage in arrays that a test may change before it makes one of them.
typedef struct test_cage {
    uint32_t dimension;
    size_t points, cells;
    double *positions;
    uint32_t *starts, *corners;
    double *values;    // of the density at the points, or NULL
    uint32_t *indices; // or NULL
    size_t value_count;
    size_t creases, sharps;
    sf_crease crease[64];
    sf_sharp_point sharp[64];
} test_cage;

static inline test_cage test_cage_begin(uint32_t dimension, size_t points, size_t cells,
                                        size_t corners)
{
    test_cage c = {0};
    c.dimension = dimension;
    c.points = points;
    c.cells = cells;
    c.positions = calloc(3 * points, sizeof *c.positions);
    c.starts = calloc(cells + 1, sizeof *c.starts);
    c.corners = calloc(cells * corners, sizeof *c.corners);
    for (size_t i = 0; i <= cells; i++) {
        c.starts[i] = (uint32_t)(corners * i);
    }
    return c;
}

static inline void test_cage_free(test_cage *c)
{
    free(c->positions);
    free(c->starts);
    free(c->corners);
    free(c->values);
    free(c->indices);
    memset(c, 0, sizeof *c);
}

static inline void test_cage_place(test_cage *c, size_t point, double x, double y, double z)
{
    c->positions[3 * point] = x;
    c->positions[3 * point + 1] = y;
    c->positions[3 * point + 2] = z;
}

// nx * ny * nz unit cubes; point (x, y, z) is number x + (nx + 1) (y + (ny + 1) z).
static inline test_cage test_cage_block(uint32_t nx, uint32_t ny, uint32_t nz)
{
    test_cage c =
        test_cage_begin(3, (size_t)(nx + 1) * (ny + 1) * (nz + 1), (size_t)nx * ny * nz, 8);
    uint32_t right = 1, back = nx + 1, up = (nx + 1) * (ny + 1);
    for (uint32_t i = 0; i < c.points; i++) {
        test_cage_place(&c, i, i % back, i / back % (ny + 1), i / up);
    }
    for (uint32_t i = 0; i < c.cells; i++) {
        uint32_t x = i % nx, y = i / nx % ny, z = i / nx / ny, p = x * right + y * back + z * up;
        uint32_t corners[8] = {p,      p + right,      p + right + back,      p + back,
                               p + up, p + right + up, p + right + back + up, p + back + up};
        memcpy(c.corners + 8 * (size_t)i, corners, sizeof corners);
    }
    return c;
}

// `n` cells around a line from the middle of the bottom to that of the top, `layers` high. Point 0
// of each layer lies on the line, then 2 n around it; with `jitter` all points are moved.
static inline test_cage test_cage_wheel(uint32_t n, uint32_t layers, double jitter)
{
    uint32_t ring = 2 * n + 1;
    test_cage c = test_cage_begin(3, (size_t)ring * (layers + 1), (size_t)n * layers, 8);
    for (uint32_t i = 0; i < c.points; i++) {
        uint32_t k = i % ring, z = i / ring;
        double angle = 3.14159265358979 * (k - 1.0) / n, radius = k == 0 ? 0 : k % 2 ? 1 : 1.4;
        test_cage_place(&c, i, radius * cos(angle) + jitter * (test_random_unit() - 0.5),
                        radius * sin(angle) + jitter * (test_random_unit() - 0.5),
                        z + jitter * (test_random_unit() - 0.5));
    }
    for (uint32_t i = 0; i < c.cells; i++) {
        uint32_t k = i % n, p = i / n * ring;
        for (uint32_t up = 0; up < 2; up++, p += ring) {
            uint32_t *corners = c.corners + 8 * (size_t)i + 4 * up;
            corners[0] = p;
            corners[1] = p + 1 + 2 * k;
            corners[2] = p + 2 + 2 * k;
            corners[3] = p + 1 + (2 * k + 2) % (2 * n);
        }
    }
    return c;
}

static inline sf_cage *test_cage_make(const test_cage *c)
{
    sf_channel density = {sf_property_density(), c->indices != NULL ? c->value_count : c->points,
                          c->values, c->indices};
    sf_cage_view view = {c->dimension, c->points,  c->positions,      c->cells,
                         c->starts,    c->corners, c->creases,        c->crease,
                         c->sharps,    c->sharp,   c->values != NULL, &density};
    sf_cage *cage = NULL;
    sf_fault fault = {0};
    sf_status status = sf_cage_create(&view, NULL, &cage, &fault);
    CHECK_EQ(status, SF_OK);
    if (status != SF_OK) {
        printf("# %s\n", fault.message);
        exit(1);
    }
    return cage;
}

#endif
