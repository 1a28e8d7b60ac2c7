// SPDX-License-Identifier: MIT
// Hanging nodes, found by where points are.

#ifndef SF_IO_CAGE_HANGING_H
#define SF_IO_CAGE_HANGING_H

#include <sf/cage.h>

// A point of one cell, in the middle of an edge of another.
typedef struct sfi_hanging {
    uint32_t point, ends[2];
} sfi_hanging;

// Whether a cage, whose arrays are sound as far as indices go, has a hanging node, and which. Says
// no when memory is short: it is asked only for the sake of a better sentence.
int sfi_hanging_find(const sf_cage_view *view, const sf_allocator *allocator, sfi_hanging *found);

#endif
