// SPDX-License-Identifier: MIT
// Parts for drains, put together from boxes of voxels.

#ifndef SF_TEST_DRAIN_PARTS_H
#define SF_TEST_DRAIN_PARTS_H

#include "test.h"

#include <sf/voxel.h>

static inline sf_grid *empty_grid(uint32_t nx, uint32_t ny, uint32_t nz, double pitch)
{
    sf_lattice lattice = {nx, ny, nz, pitch, pitch, pitch, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    return grid;
}

static inline void fill(sf_grid *grid, uint32_t x0, uint32_t y0, uint32_t z0, uint32_t x1,
                        uint32_t y1, uint32_t z1, int value)
{
    sf_rect rect = {x0, y0, x1, y1};
    for (uint32_t k = z0; k < z1; k++) {
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), rect, value), SF_OK);
    }
}

#endif
