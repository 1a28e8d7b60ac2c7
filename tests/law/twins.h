// SPDX-License-Identifier: MIT
// Twins: two grids of the same voxels, one with padding of zeros and one with padding of ones. What
// is done to both must come to the same.

#ifndef SF_TEST_TWINS_H
#define SF_TEST_TWINS_H

#include "stack.h"

// Set every bit past the width, to the end of the row's words.
static inline void soil(sf_slice s)
{
    for (uint32_t y = 0; y < s.height; y++) {
        uint64_t *row = s.words + y * s.stride;
        for (size_t x = s.width; x < 64 * s.stride; x++) {
            row[x / 64] |= UINT64_C(1) << x % 64;
        }
    }
}

static inline void soil_grid(sf_grid *grid)
{
    for (uint32_t k = 0; k < sf_grid_lattice(grid).nz; k++) {
        soil(sf_grid_slice(grid, k));
    }
}

static inline int is_clean(sf_slice s)
{
    for (uint32_t y = 0; y < s.height; y++) {
        if (s.width % 64 != 0 && s.words[y * s.stride + s.width / 64] >> s.width % 64 != 0) {
            return 0;
        }
    }
    return 1;
}

static inline int grid_is_clean(const sf_grid *grid)
{
    for (uint32_t k = 0; k < sf_grid_lattice(grid).nz; k++) {
        if (!is_clean(sf_grid_slice(grid, k))) {
            return 0;
        }
    }
    return 1;
}

// Two grids of the same voxels; the second has ones past the width of every row.
typedef struct twins {
    sf_grid *clean, *soiled;
} twins;

static inline twins make_twins(int nx, int ny, int nz)
{
    static stack s;
    stack_random_boxes(&s, nx, ny, nz, 5);
    for (int y = 0; y < ny; y++) { // matter at the very edge, where padding begins
        *stack_at(&s, nx - 1, y, nz / 2) = (uint8_t)test_random_below(2);
    }
    twins t = {stack_grid(&s), stack_grid(&s)};
    soil_grid(t.soiled);
    return t;
}

static inline void end_twins(twins t)
{
    sf_grid_destroy(t.clean);
    sf_grid_destroy(t.soiled);
}

static inline void with_twins(void (*body)(twins t))
{
    static const int widths[] = {1, 3, 40, 63, 64, 65, 100, 127, 128, 130};
    static const sf_isa sets[] = {SF_ISA_REFERENCE, SF_ISA_WORD, SF_ISA_COUNT};
    for (size_t i = 0; i < 30; i++) {
        sf_isa_limit(sets[i / 10]);
        twins t = make_twins(widths[i % 10], 1 + (int)test_random_below(9), 5);
        body(t);
        end_twins(t);
    }
    sf_isa_limit(SF_ISA_COUNT);
}

#endif
