// SPDX-License-Identifier: MIT
// Arena: one block of memory, handed out and taken back in pieces.

#ifndef SF_SCULPT_ARENA_H
#define SF_SCULPT_ARENA_H

#include <sf/base.h>

// A piece of the block that nobody has, in order of address.
typedef struct sfi_gap {
    size_t units; // of SFI_ALIGN bytes, this one counted
    struct sfi_gap *next;
} sfi_gap;

typedef struct sfi_arena {
    sfi_gap *gaps;
} sfi_arena;

// Bytes that an allocation of `size` bytes takes from an arena; 0 where they do not fit a size_t.
size_t sfi_arena_cost(size_t size);

// Set up an arena in a block that starts on SFI_ALIGN bytes; what does not fill a unit is left.
void sfi_arena_place(sfi_arena *arena, void *block, size_t size);

// An allocator that takes from the arena, which must stay where it is.
sf_allocator sfi_arena_allocator(sfi_arena *arena);

#endif
