// SPDX-License-Identifier: MIT
// Lean: what a brace puts into one layer, below what must stand on it.

#ifndef SF_SCULPT_LEAN_H
#define SF_SCULPT_LEAN_H

#include "sculpt/patch.h"

// Planes that a lean works with.
#define SFI_LEAN_PLANES 14u

// One layer after the other, downwards.
typedef struct sfi_lean {
    uint64_t *memory; // of the planes, sfi_patch_room() words for each
    size_t room;
    sf_rect within; // where it is looked for what stands, and where carriers are put
    sfi_patch patch;
    uint64_t *added;  // what was put into the last layer, a plane of the patch
    sf_rect added_in; // around that; empty where it is
    uint32_t far;     // steps that are looked at first
} sfi_lean;

// A layer as it is, and the tips above it; rectangles around these.
typedef struct sfi_lean_layer {
    sf_slice printable, tips, tips_above;
    sf_rect tips_in, above_in;
} sfi_lean_layer;

// Lean in memory for patches of `within` grown by what a step reaches.
sfi_lean sfi_lean_begin(uint64_t *memory, size_t room, sf_rect within);

// added = X_k of brace.c, where it was X_{k+1}.
sf_status sfi_lean_down(sfi_lean *lean, const sf_element *element, const sfi_lean_layer *layer);

#endif
