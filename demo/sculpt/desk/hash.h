// SPDX-License-Identifier: MIT
// A number for bytes. G. Fowler, L. C. Noll, K.-P. Vo, FNV-1a of 64 bits.

#ifndef SCULPT_DESK_HASH_H
#define SCULPT_DESK_HASH_H

#include <stddef.h>
#include <stdint.h>

#define HASH_NONE UINT64_C(0xcbf29ce484222325)

static inline uint64_t hash_add(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *at = bytes;
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ at[i]) * UINT64_C(0x100000001b3);
    }
    return hash;
}

// The lower bytes of a number, the lowest first, on every machine.
static inline uint64_t hash_number(uint64_t hash, uint64_t number, int bytes)
{
    for (int i = 0; i < bytes; i++) {
        hash = (hash ^ (number >> 8 * i & 255)) * UINT64_C(0x100000001b3);
    }
    return hash;
}

#endif
