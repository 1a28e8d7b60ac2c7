// SPDX-License-Identifier: MIT
// Sets of runs: a forest whose parents are kept in the runs' labels, so that it takes no memory.
//
// A root is its own parent, and the first run of its set. (R. E. Tarjan, "Efficiency of a Good But
// Not Linear Set Union Algorithm", 1975, with halving.) Freestanding.

#ifndef SF_VOXEL_RUN_FOREST_H
#define SF_VOXEL_RUN_FOREST_H

#include <sf/voxel.h>

static inline uint32_t sfi_run_root(sf_run *runs, uint32_t i)
{
    while (runs[i].label != i) {
        runs[i].label = runs[runs[i].label].label;
        i = runs[i].label;
    }
    return i;
}

static inline void sfi_run_join(sf_run *runs, uint32_t a, uint32_t b)
{
    a = sfi_run_root(runs, a);
    b = sfi_run_root(runs, b);
    runs[a < b ? b : a].label = a < b ? a : b;
}

#endif
