// SPDX-License-Identifier: MIT
// The edges of snapped triangles: do they cancel, and which belong together?

#ifndef SF_MESH_CHAIN_H
#define SF_MESH_CHAIN_H

#include "mesh/frame.h"

// Half-edge h is edge h % 3 of triangle h / 3; it runs from corner h % 3 to the next.
#define SFI_NOBODY UINT32_MAX
// Most triangles of a chain, so that half-edges have 32-bit numbers.
#define SFI_CHAIN_MAX (1u << 30)

static inline uint32_t sfi_edge_from(const uint32_t *triangles, uint32_t h)
{
    return triangles[h];
}

static inline uint32_t sfi_edge_to(const uint32_t *triangles, uint32_t h)
{
    return triangles[h % 3 == 2 ? h - 2 : h + 1];
}

// Whether every edge is run as often one way as the other; points are the same where they have
// one number, or lie at the same place. A chain that is not closed passes with a chance of 2^-64.
int sfi_chain_closed(const sfi_point *points, const uint32_t *triangles, size_t triangle_count);

// Copy triangles with the corners renamed so that equal points have one number.
sf_status sfi_chain_weld(const sfi_point *points, size_t point_count, const uint32_t *triangles,
                         size_t triangle_count, const sf_allocator *allocator, uint32_t *welded);

// The half-edges (3 a triangle), sorted by their lower corner, then their upper, then their number.
// Those of a collapsed edge stand there too.
sf_status sfi_chain_sort(const uint32_t *triangles, size_t triangle_count, size_t point_count,
                         const sf_allocator *allocator, uint32_t *order);

// End of the group of half-edges on one edge that starts at order[first]. `net` gets how much
// oftener the edge is run from its lower to its upper corner than back; 0 for a collapsed edge.
size_t sfi_chain_group(const uint32_t *triangles, const uint32_t *order, size_t count, size_t first,
                       int64_t *net);

#endif
