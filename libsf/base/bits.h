// SPDX-License-Identifier: MIT
// Where the set bits of a word are.
//
// One of the two rooms where compiler extensions are allowed: a count of zeros is one instruction
// on every processor, and C99 has no name for it. The portable forms serve other compilers.

#ifndef SF_BASE_BITS_H
#define SF_BASE_BITS_H

#include <stdint.h>

// Index of the lowest set bit of a word that has one.
static inline uint32_t sfi_lowest_bit(uint64_t w)
{
#if defined(__GNUC__)
    return (uint32_t)__builtin_ctzll(w);
#else
    uint32_t index = 0;
    for (uint32_t step = 32; step > 0; step /= 2) {
        if ((w & ((UINT64_C(1) << step) - 1)) == 0) {
            w >>= step;
            index += step;
        }
    }
    return index;
#endif
}

// The same for 32 bits: one or two instructions on a processor that has no longer words.
static inline uint32_t sfi_lowest_bit32(uint32_t w)
{
#if defined(__GNUC__)
    return (uint32_t)__builtin_ctz(w);
#else
    return sfi_lowest_bit(w);
#endif
}

// Index of the highest set bit of a word that has one.
static inline uint32_t sfi_highest_bit(uint64_t w)
{
#if defined(__GNUC__)
    return 63 - (uint32_t)__builtin_clzll(w);
#else
    uint32_t index = 0;
    for (uint32_t step = 32; step > 0; step /= 2) {
        if (w >> step != 0) {
            w >>= step;
            index += step;
        }
    }
    return index;
#endif
}

#endif
