// SPDX-License-Identifier: MIT
// Rows of bits as the checker reads them: runs of solid voxels, and whether a stretch has any.
//
// Padding must be zero, as it is in every slice that the checker keeps.

#ifndef SF_SUPPORT_ROW_H
#define SF_SUPPORT_ROW_H

#include "base/bits.h"
#include "simd/kernels.h"

// The first x >= from whose bit, exclusive-ored with flip (0 or all ones), is set; width if none.
static inline uint32_t sfi_row_find(const uint64_t *row, uint32_t width, uint32_t from,
                                    uint64_t flip)
{
    if (from >= width) {
        return width;
    }
    size_t words = sfi_row_words(width), i = from / 64;
    uint64_t w = (row[i] ^ flip) & (~UINT64_C(0) << (from % 64));
    while (w == 0) {
        if (++i == words) {
            return width;
        }
        w = row[i] ^ flip;
    }
    uint32_t x = (uint32_t)i * 64 + sfi_lowest_bit(w);
    return x < width ? x : width;
}

// Step to the next run x0 <= x < x1 at or after *x1 (0 at first); 0 when there is none.
static inline int sfi_row_next_run(const uint64_t *row, uint32_t width, uint32_t *x0, uint32_t *x1)
{
    *x0 = sfi_row_find(row, width, *x1, 0);
    *x1 = sfi_row_find(row, width, *x0, ~UINT64_C(0));
    return *x0 < width;
}

// Whether any voxel x0 <= x < x1 is solid.
static inline int sfi_row_any(const uint64_t *row, uint32_t width, uint32_t x0, uint32_t x1)
{
    return sfi_row_find(row, x1 < width ? x1 : width, x0, 0) < (x1 < width ? x1 : width);
}

// dst = a without b; returns whether anything is left. dst may be a.
static inline int sfi_row_without(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t words)
{
    uint64_t any = 0;
    for (size_t i = 0; i < words; i++) {
        dst[i] = a[i] & ~b[i];
        any |= dst[i];
    }
    return any != 0;
}

#endif
