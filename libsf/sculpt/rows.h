// SPDX-License-Identifier: MIT
// Rows of bits and of bytes beside them.

#ifndef SF_SCULPT_ROWS_H
#define SF_SCULPT_ROWS_H

#include <sf/voxel.h>

#include <string.h>

#include "voxel/area.h"

// The lowest and past the last bit of a run of ones in `bits`, which is not 0, from below.
static inline uint32_t sfi_take_run(uint64_t *bits, uint32_t *start)
{
    uint32_t first = sfi_lowest_bit(*bits);
    uint64_t rest = ~(*bits >> first);
    uint32_t length = rest != 0 ? sfi_lowest_bit(rest) : 64;
    length = length > 64 - first ? 64 - first : length;
    uint64_t ones = length < 64 ? (UINT64_C(1) << length) - 1 : ~UINT64_C(0);
    *bits &= ~(ones << first);
    *start = first;
    return length;
}

// The bytes of the set bits of word i to a value.
static inline void sfi_bytes_set(uint8_t *row, size_t i, uint64_t bits, uint8_t value)
{
    while (bits != 0) {
        uint32_t start, length = sfi_take_run(&bits, &start);
        memset(row + i * 64 + start, value, length);
    }
}

// The bytes of the set bits of word i to those of another row.
static inline void sfi_bytes_copy(uint8_t *row, const uint8_t *from, size_t i, uint64_t bits)
{
    while (bits != 0) {
        uint32_t start, length = sfi_take_run(&bits, &start);
        memcpy(row + i * 64 + start, from + i * 64 + start, length);
    }
}

static inline uint64_t sfi_load_eight(const uint8_t *bytes)
{
    uint64_t word;
    memcpy(&word, bytes, sizeof word);
    return word;
}

static inline uint32_t sfi_count_bits(uint64_t w)
{
    w -= w >> 1 & UINT64_C(0x5555555555555555);
    w = (w & UINT64_C(0x3333333333333333)) + (w >> 2 & UINT64_C(0x3333333333333333));
    w = (w + (w >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f);
    return (uint32_t)(w * UINT64_C(0x0101010101010101) >> 56);
}

#endif
