// SPDX-License-Identifier: MIT
// Sums in 128 bits, for sums over grids that 64 bits would not hold. No 128-bit integers of the
// compiler's are needed, so a chip without them has the same sums.

#ifndef SF_VOXEL_WIDE_H
#define SF_VOXEL_WIDE_H

#include <stdint.h>

#include <sf/voxel.h>

// sum += term; what does not fit in 128 bits is lost.
static inline void sfi_wide_add(sf_wide *sum, sf_wide term)
{
    sum->low += term.low;
    sum->high += term.high + (sum->low < term.low);
}

static inline sf_wide sfi_wide_product(uint64_t a, uint64_t b)
{
    uint64_t a0 = (uint32_t)a, a1 = a >> 32, b0 = (uint32_t)b, b1 = b >> 32;
    uint64_t low = a0 * b0, middle = a1 * b0 + (low >> 32);
    uint64_t cross = a0 * b1 + (uint32_t)middle;
    sf_wide product = {cross << 32 | (uint32_t)low, a1 * b1 + (middle >> 32) + (cross >> 32)};
    return product;
}

#endif
