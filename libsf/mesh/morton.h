// SPDX-License-Identifier: MIT
// An order of points in which neighbours in space are mostly neighbours in memory.

#ifndef SF_MESH_MORTON_H
#define SF_MESH_MORTON_H

#include <sf/base.h>

// order[i] = which of the points comes i-th along a space-filling curve through their box; equal
// places in their order. Coordinates are finite. SF_ERR_MEMORY.
sf_status sfi_morton_order(const double *points, size_t count, const sf_allocator *allocator,
                           uint32_t *order);

#endif
