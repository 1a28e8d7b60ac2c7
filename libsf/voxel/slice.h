// SPDX-License-Identifier: MIT
// What the library itself asks of slices.

#ifndef SF_VOXEL_SLICE_H
#define SF_VOXEL_SLICE_H

#include <sf/voxel.h>

#include "simd/kernels.h"

static inline uint64_t *sfi_slice_row(sf_slice slice, uint32_t y)
{
    return slice.words + (size_t)y * slice.stride;
}

// Word i of a row of `width` voxels: whatever stands past the width reads as empty.
static inline uint64_t sfi_row_word(const uint64_t *row, size_t i, uint32_t width)
{
    size_t last = sfi_row_words(width) - 1;
    return i < last ? row[i] : i == last ? row[i] & sfi_tail_mask(width) : 0;
}

// SF_OK, or SF_ERR_ARGUMENT for a slice that is no slice.
sf_status sfi_slice_validate(sf_slice slice);

// The same for two slices that must have one size: SF_ERR_SHAPE when they have not.
sf_status sfi_slice_validate_pair(sf_slice a, sf_slice b);

// Whether any byte of one lies between the first and the last byte of the other.
int sfi_slice_overlap(sf_slice a, sf_slice b);

// Word i of a row whose bits are moved: bit x of the result is bit x + by of the row; 0 outside.
static inline uint64_t sfi_moved_word(const uint64_t *row, size_t words, size_t i, int64_t by)
{
    int64_t bit = (int64_t)i * 64 + by;
    int64_t word = bit >= 0 ? bit / 64 : -((63 - bit) / 64);
    unsigned shift = (unsigned)(bit - word * 64);
    uint64_t low = word >= 0 && word < (int64_t)words ? row[word] : 0;
    uint64_t high = word + 1 >= 0 && word + 1 < (int64_t)words ? row[word + 1] : 0;
    return shift == 0 ? low : (low >> shift) | (high << (64 - shift));
}

// All words of a slice's rows to zero, padding included. The slice must be one.
void sfi_slice_clear(sf_slice slice);

// Whether any voxel is solid. The slice must be one.
int sfi_slice_any(sf_slice slice);

// Whether both are the same view: same words, same stride.
int sfi_slice_same(sf_slice a, sf_slice b);

#endif
