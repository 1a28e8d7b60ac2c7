// SPDX-License-Identifier: MIT
// Passes over words, compiled for the widest vectors that the processor has, so that a limit is not
// slower than it need be and no job looks better than it is.

#include "limits.h"

#include <string.h>

// The slices of a grid follow each other without gaps, so a grid is one array.
static size_t words_of(const sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    return sf_grid_slice(grid, 0).stride * lattice.ny * lattice.nz;
}

static uint64_t *words_in(const sf_grid *grid)
{
    return sf_grid_slice(grid, 0).words;
}

// One body, once for every processor and once with AVX2.
#define PASSES(suffix, target)                                                                     \
    target static void pass##suffix(uint64_t *words, size_t count)                                 \
    {                                                                                              \
        for (size_t i = 0; i < count; i++) {                                                       \
            words[i] ^= UINT64_C(0x5555555555555555);                                              \
        }                                                                                          \
    }                                                                                              \
    target static uint64_t read##suffix(const uint64_t *words, size_t count)                       \
    {                                                                                              \
        uint64_t lanes[16] = {0}, all = 0;                                                         \
        size_t i = 0;                                                                              \
        for (; i + 16 <= count; i += 16) {                                                         \
            for (size_t lane = 0; lane < 16; lane++) {                                             \
                lanes[lane] ^= words[i + lane];                                                    \
            }                                                                                      \
        }                                                                                          \
        for (; i < count; i++) {                                                                   \
            all ^= words[i];                                                                       \
        }                                                                                          \
        for (size_t lane = 0; lane < 16; lane++) {                                                 \
            all ^= lanes[lane];                                                                    \
        }                                                                                          \
        return all;                                                                                \
    }

PASSES(_plain, )
#if defined(__GNUC__) && defined(__x86_64__)
PASSES(_avx2, __attribute__((target("avx2"))))
#define HAS_AVX2 __builtin_cpu_supports("avx2")
#else
#define pass_avx2 pass_plain
#define read_avx2 read_plain
#define HAS_AVX2 0
#endif

static volatile uint64_t seen; // so that no compiler leaves the reading out

void limit_pass(const sf_grid *grid)
{
    (HAS_AVX2 ? pass_avx2 : pass_plain)(words_in(grid), words_of(grid));
}

void limit_read_slice(sf_slice slice)
{
    seen = (HAS_AVX2 ? read_avx2 : read_plain)(slice.words, slice.stride * slice.height);
}

void limit_read(const sf_grid *grid)
{
    seen = (HAS_AVX2 ? read_avx2 : read_plain)(words_in(grid), words_of(grid));
}

void limit_clear(const sf_grid *grid)
{
    memset(words_in(grid), 0, words_of(grid) * sizeof(uint64_t));
}
