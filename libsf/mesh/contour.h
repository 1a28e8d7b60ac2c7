// SPDX-License-Identifier: MIT
// Contours in a plane: directed edges, linked into tours.

#ifndef SF_MESH_CONTOUR_H
#define SF_MESH_CONTOUR_H

#include <sf/base.h>

#include "base/exact.h"

#include <stddef.h>
#include <stdint.h>

// A place in the plane; no coordinate is negative or above 2^60.
typedef struct sfi_spot {
    int64_t x, y;
} sfi_spot;

// Edges with what they enclose on their left. Edge i starts in node i, which is one visit of a tour
// to a spot. Spots are numbered from left to right, those above each other upwards: a lower number
// lies before a higher one.
typedef struct sfi_contour {
    const sfi_spot *spots;
    size_t spot_count, count; // count: of edges, and of nodes
    uint32_t *from;           // spot of each node
    uint32_t *next, *prev;    // nodes beside it on its tour
} sfi_contour;

// What a node is to a line that comes from the left. The neighbours of a start and of a split lie
// after it, those of an end and of a merge before it. The inside of a start and of an end is less
// than half a turn; that of a split or a merge more. Beside a lower node the inside is above.
typedef enum sfi_node_kind {
    SFI_NODE_START,
    SFI_NODE_SPLIT,
    SFI_NODE_END,
    SFI_NODE_MERGE,
    SFI_NODE_LOWER,
    SFI_NODE_UPPER
} sfi_node_kind;

// Link edges (two spots each, that differ) into tours. As many edges must end in each spot as start
// there.
sf_status sfi_contour_create(const sfi_spot *spots, size_t spot_count, const uint32_t *edges,
                             size_t edge_count, const sf_allocator *allocator, sfi_contour *made);
void sfi_contour_destroy(sfi_contour *contour, const sf_allocator *allocator);

sfi_node_kind sfi_contour_kind(const sfi_contour *contour, uint32_t node);

// 1 where a, b, c turn to the left, -1 to the right, 0 where they lie on a line; exact.
static inline int sfi_spot_turn(const sfi_spot *spots, uint32_t a, uint32_t b, uint32_t c)
{
    const sfi_spot *p = spots + a, *q = spots + b, *r = spots + c;
    return sfi_exact_turn(q->x - p->x, q->y - p->y, r->x - p->x, r->y - p->y);
}

// Whether b is met before c by who stands in `at`, looks to a, and turns; `way` is 1 for turning
// left, -1 for right. What lies in the direction of a is met last.
int sfi_spot_sooner(const sfi_spot *spots, uint32_t at, uint32_t a, uint32_t b, uint32_t c,
                    int way);

#endif
