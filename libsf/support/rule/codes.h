// SPDX-License-Identifier: MIT
// Between bits and the bytes of slack, eight at a time.
//
// Multiplication spreads and gathers: spreading puts the eight bits into every byte and keeps one
// in each; gathering moves the lowest bit of byte i to place 56 + i. Plain C, the same on every
// machine; the loops over bytes are single loads and stores to a compiler that knows its processor.

#ifndef SF_SUPPORT_CODES_H
#define SF_SUPPORT_CODES_H

#include <stdint.h>

// Eight bits as eight bytes, 255 for a bit that is set.
static inline uint64_t sfi_spread_bits(uint64_t bits)
{
    uint64_t one_each = (bits & 255) * UINT64_C(0x0101010101010101) & UINT64_C(0x8040201008040201);
    return ((one_each + UINT64_C(0x7f7f7f7f7f7f7f7f)) >> 7 & UINT64_C(0x0101010101010101)) * 255;
}

// Eight bytes as eight bits, set for a byte that is not 0.
static inline uint64_t sfi_gather_bytes(uint64_t bytes)
{
    uint64_t low = (bytes & UINT64_C(0x7f7f7f7f7f7f7f7f)) + UINT64_C(0x7f7f7f7f7f7f7f7f);
    uint64_t ones = (low | bytes) >> 7 & UINT64_C(0x0101010101010101);
    return ones * UINT64_C(0x0102040810204080) >> 56;
}

// Eight bytes as a number, the first lowest, and back: the same on every machine.
static inline uint64_t sfi_load_bytes(const uint8_t *bytes)
{
    uint64_t value = 0;
    for (unsigned i = 0; i < 8; i++) {
        value |= (uint64_t)bytes[i] << (8 * i);
    }
    return value;
}

static inline void sfi_store_bytes(uint8_t *bytes, uint64_t value)
{
    for (unsigned i = 0; i < 8; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
}

#endif
