// SPDX-License-Identifier: MIT
// Sums in 128 bits, for sums over grids that 64 bits would not hold. No 128-bit integers of the
// compiler's are needed, so a chip without them has the same sums.

#ifndef SF_VOXEL_WIDE_H
#define SF_VOXEL_WIDE_H

#include <sf/voxel.h>

#include "base/exact.h"

// sum += term; what does not fit in 128 bits is lost.
static inline void sfi_wide_add(sf_wide *sum, sf_wide term)
{
    sum->low += term.low;
    sum->high += term.high + (sum->low < term.low);
}

static inline sf_wide sfi_wide_product(uint64_t a, uint64_t b)
{
    sfi_exact exact = sfi_exact_widen(a, b);
    sf_wide product = {exact.low, exact.high};
    return product;
}

static inline double sfi_wide_double(sf_wide sum)
{
    sfi_exact exact = {sum.low, sum.high};
    return sfi_exact_double(exact);
}

#endif
