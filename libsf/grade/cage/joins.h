// SPDX-License-Identifier: MIT
// Disjoint sets: things that are found to be the same, one pair after the other.

#ifndef SF_GRADE_CAGE_JOINS_H
#define SF_GRADE_CAGE_JOINS_H

#include <stddef.h>
#include <stdint.h>

// Each thing a set of its own. `roots` has `count` places.
static inline void sfi_joins_begin(uint32_t *roots, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        roots[i] = i;
    }
}

// The least thing of the set that `i` is in. Paths are halved on the way (R. E. Tarjan, J. van
// Leeuwen, "Worst-case analysis of set union algorithms", 1984).
static inline uint32_t sfi_joins_root(uint32_t *roots, uint32_t i)
{
    while (roots[i] != i) {
        roots[i] = roots[roots[i]];
        i = roots[i];
    }
    return i;
}

static inline void sfi_joins_add(uint32_t *roots, uint32_t a, uint32_t b)
{
    uint32_t x = sfi_joins_root(roots, a), y = sfi_joins_root(roots, b);
    roots[x < y ? y : x] = x < y ? x : y;
}

#endif
