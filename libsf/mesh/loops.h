// SPDX-License-Identifier: MIT
// The holes of a mesh: its boundary, taken apart into simple loops.

#ifndef SF_MESH_LOOPS_H
#define SF_MESH_LOOPS_H

#include "mesh/chain.h"

// Loop i runs through points[starts[i]] .. points[starts[i + 1] - 1] and back to the first. Edge e
// starts at points[e]. Loops that lie near each other stand near each other.
typedef struct sfi_loops {
    uint32_t *points;
    size_t edge_count;
    size_t *starts; // loop_count + 1
    size_t loop_count;
    size_t start_capacity;
} sfi_loops;

// The loops that would close a welded chain: they run against its boundary.
sf_status sfi_loops_create(const sfi_point *points, size_t point_count, const uint32_t *triangles,
                           size_t triangle_count, const sf_allocator *allocator, sfi_loops *loops);
void sfi_loops_destroy(sfi_loops *loops, const sf_allocator *allocator);

#endif
