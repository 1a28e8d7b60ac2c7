// SPDX-License-Identifier: MIT
// All kinds of rings that a complex has, and those that come of them by subdivision.

#ifndef SF_GRADE_LIMIT_ATLAS_H
#define SF_GRADE_LIMIT_ATLAS_H

#include "grade/limit/ring.h"
#include "grade/refine/matrix.h"

// Points of a ring that is regular, as a grid of 4 along each axis. Where a side is outside the
// outermost layer is missing: it follows from the two next to it.
typedef struct sfi_net {
    uint32_t outside; // the sides without a layer of points: bit 2 * axis, and one more if high
    uint32_t at[64];  // ring points; x fastest
} sfi_net;

// A kind of ring.
typedef struct sfi_kind {
    sfi_ring ring;
    int is_regular;
    sfi_net net; // of a regular kind
    // Of others: for each place of the first cell the piece there, its kind, and how its ring's
    // values come of this ring's.
    uint32_t children[SFI_RING_CORNERS];
    sfi_matrix steps[SFI_RING_CORNERS];
    // Weights of the ring's points for the limit of each corner of the first cell.
    double *corners;
} sfi_kind;

typedef struct sfi_atlas {
    sf_allocator allocator;
    uint32_t dimension;
    int separable;
    uint32_t count;
    uint32_t most_points; // of any kind's ring
    sfi_kind *kinds;
    size_t capacity;
    uint32_t *slots; // a hash table of kinds
    size_t slot_count;
} sfi_atlas;

// An atlas without kinds. SF_ERR_MEMORY.
sf_status sfi_atlas_begin(const sf_allocator *allocator, uint32_t dimension, int separable,
                          sfi_atlas *atlas);
void sfi_atlas_free(sfi_atlas *atlas);

// The kind of a ring, which is added if it is new, without what comes of it. SF_ERR_MEMORY.
sf_status sfi_atlas_add(sfi_atlas *atlas, const sfi_ring *ring, uint32_t *kind);

// Work out what comes of all kinds, which may add more, until nothing new comes. SF_ERR_MEMORY;
// SF_ERR_CANCELLED; SF_ERR_OVERFLOW: no end of it.
sf_status sfi_atlas_close(sfi_atlas *atlas, sf_task *task);

#endif
