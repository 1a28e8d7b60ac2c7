// SPDX-License-Identifier: MIT
// All stacks of one tiny size at once: a stack of at most 18 voxels is a number, bit (z * ny + y) *
// nx + x its voxels, and what the library's trim makes of it is looked up in a table with a place
// for each. So a law over all pairs, or all triples, costs a few table reads for each. Layer 0
// rests on the bed, whatever lies in it.

#ifndef SF_TEST_TINY_H
#define SF_TEST_TINY_H

#include "law/stack.h"

typedef struct tiny {
    int nx, ny, nz, voxels;
    uint32_t count;        // 2^voxels: one past the full stack
    uint32_t layer;        // bits of layer 0
    uint32_t carriers[18]; // voxels below that carry this one
    uint32_t *trim;        // library's trim of each stack
} tiny;

static inline void tiny_write(const tiny *t, sf_grid *grid, uint32_t s)
{
    for (int row = 0; row < t->ny * t->nz; row++) {
        sf_slice slice = sf_grid_slice(grid, (uint32_t)(row / t->ny));
        uint32_t bits = s >> (row * t->nx) & ((1u << t->nx) - 1);
        slice.words[(size_t)(row % t->ny) * slice.stride] = bits;
    }
}

static inline uint32_t tiny_read(const tiny *t, const sf_grid *grid)
{
    uint32_t s = 0;
    for (int row = 0; row < t->ny * t->nz; row++) {
        sf_slice slice = sf_grid_slice(grid, (uint32_t)(row / t->ny));
        uint64_t bits = slice.words[(size_t)(row % t->ny) * slice.stride];
        s |= (uint32_t)bits << (row * t->nx);
    }
    return s;
}

static inline tiny tiny_new(int nx, int ny, int nz, const sf_rule *rule)
{
    tiny t = {nx, ny, nz, nx * ny * nz, 0, (1u << (nx * ny)) - 1, {0}, NULL};
    t.count = 1u << t.voxels;
    t.trim = malloc(t.count * sizeof *t.trim);
    sf_lattice lattice = stack_lattice(nx, ny, nz);
    sf_grid *grid = NULL;
    if (t.trim == NULL || sf_grid_create(&lattice, stack_allocator(), &grid) != SF_OK) {
        abort();
    }
    for (uint32_t s = 0; s < t.count; s++) {
        tiny_write(&t, grid, s);
        CHECK_EQ(sf_grid_trim(grid, rule, 0, NULL, NULL), SF_OK);
        t.trim[s] = tiny_read(&t, grid);
    }
    sf_grid_destroy(grid);
    int below = nx * ny;
    for (int v = below; v < t.voxels; v++) {
        sf_element e = stack_step(rule, v / below - 1);
        for (int u = v / below * below - below; u < v / below * below; u++) {
            int dx = u % nx - v % nx, dy = u % below / nx - v % below / nx;
            t.carriers[v] |= (uint32_t)element_has(&e, dx, dy) << u;
        }
    }
    return t;
}

static inline void tiny_delete(tiny *t)
{
    free(t->trim);
}

// Support-free by definition, without the library.
static inline int tiny_is_free(const tiny *t, uint32_t s)
{
    for (int v = t->nx * t->ny; v < t->voxels; v++) {
        if ((s >> v & 1) && !(t->carriers[v] & s)) {
            return 0;
        }
    }
    return 1;
}

// "..#|#.." as a number; rows of one layer are parted by '/'.
static inline uint32_t tiny_parse(const char *text)
{
    uint32_t s = 0, bit = 1;
    for (const char *c = text; *c != '\0'; c++) {
        if (*c == '#' || *c == '.') {
            s |= *c == '#' ? bit : 0;
            bit <<= 1;
        }
    }
    return s;
}

static inline uint32_t tiny_layer(const tiny *t, uint32_t s, int z)
{
    return s >> (z * t->nx * t->ny) & t->layer;
}

static inline int tiny_volume(uint32_t s)
{
    int count = 0;
    for (; s != 0; s &= s - 1) {
        count++;
    }
    return count;
}

// ---------------------------------------------------------------------------------------------
// Slices as numbers
// ---------------------------------------------------------------------------------------------

enum { TINY_DILATE, TINY_ERODE };

// What the library makes of every slice of a size; free() it.
static inline uint32_t *tiny_morph(int nx, int ny, const sf_element *e, sf_border border, int what)
{
    uint32_t count = 1u << (nx * ny), *table = malloc(count * sizeof *table);
    uint64_t from[8], to[8];
    sf_slice src = {from, (uint32_t)nx, (uint32_t)ny, 1}, dst = {to, src.width, src.height, 1};
    if (table == NULL) {
        abort();
    }
    for (uint32_t s = 0; s < count; s++) {
        for (int y = 0; y < ny; y++) {
            from[y] = s >> (y * nx) & ((1u << nx) - 1);
        }
        CHECK_EQ(what == TINY_DILATE ? sf_slice_dilate(dst, src, e, border)
                                     : sf_slice_erode(dst, src, e, border),
                 SF_OK);
        table[s] = 0;
        for (int y = 0; y < ny; y++) {
            table[s] |= (uint32_t)to[y] << (y * nx);
        }
    }
    return table;
}

// A table of slices put to every layer of a stack.
static inline uint32_t tiny_each_layer(const tiny *t, const uint32_t *table, uint32_t s)
{
    uint32_t result = 0;
    for (int z = 0; z < t->nz; z++) {
        result |= table[tiny_layer(t, s, z)] << (z * t->nx * t->ny);
    }
    return result;
}

// Along x only, as far as `reach`: stacks of one row.
static inline sf_element element_along_x(uint16_t reach)
{
    sf_element e = {0, {reach}};
    return e;
}

#endif
