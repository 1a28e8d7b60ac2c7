// SPDX-License-Identifier: MIT
// Slices: planes of bits in somebody's memory.
//
// Every function checks its slices before it writes, ignores what stands in the padding of its
// inputs and leaves zeros in the padding of its result. Freestanding, without allocation.

#include "voxel/slice.h"

#include "base/bits.h"
#include "base/status.h"

sf_status sfi_slice_validate(sf_slice slice)
{
    if (slice.words == NULL || slice.width == 0 || slice.height == 0 ||
        slice.width > SF_EXTENT_MAX || slice.height > SF_EXTENT_MAX ||
        slice.stride < sfi_row_words(slice.width) || slice.stride > SIZE_MAX / 8 / slice.height) {
        return SF_ERR_ARGUMENT;
    }
    return SF_OK;
}

sf_status sfi_slice_validate_pair(sf_slice a, sf_slice b)
{
    SF_TRY(sfi_slice_validate(a));
    SF_TRY(sfi_slice_validate(b));
    return a.width == b.width && a.height == b.height ? SF_OK : SF_ERR_SHAPE;
}

int sfi_slice_overlap(sf_slice a, sf_slice b)
{
    uintptr_t a_first = (uintptr_t)a.words, b_first = (uintptr_t)b.words;
    uintptr_t a_end = (uintptr_t)(sfi_slice_row(a, a.height - 1) + sfi_row_words(a.width));
    uintptr_t b_end = (uintptr_t)(sfi_slice_row(b, b.height - 1) + sfi_row_words(b.width));
    return a_first < b_end && b_first < a_end;
}

void sfi_slice_clear(sf_slice slice)
{
    size_t words = sfi_row_words(slice.width);
    for (uint32_t y = 0; y < slice.height; y++) {
        uint64_t *row = sfi_slice_row(slice, y);
        for (size_t i = 0; i < words; i++) {
            row[i] = 0;
        }
    }
}

int sfi_slice_any(sf_slice slice)
{
    size_t last = sfi_row_words(slice.width) - 1;
    for (uint32_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(slice, y);
        uint64_t any = row[last] & sfi_tail_mask(slice.width);
        for (size_t i = 0; i < last; i++) {
            any |= row[i];
        }
        if (any != 0) {
            return 1;
        }
    }
    return 0;
}

int sfi_slice_same(sf_slice a, sf_slice b)
{
    return a.words == b.words && a.stride == b.stride;
}

size_t sf_slice_stride(uint32_t width)
{
    return (sfi_row_words(width) + 7) / 8 * 8;
}

int sf_slice_get(sf_slice slice, uint32_t x, uint32_t y)
{
    if (slice.words == NULL || x >= slice.width || y >= slice.height) {
        return 0;
    }
    return (int)(sfi_slice_row(slice, y)[x / 64] >> (x % 64) & 1);
}

sf_status sf_slice_set(sf_slice slice, uint32_t x, uint32_t y, int value)
{
    SF_TRY(sfi_slice_validate(slice));
    if (x >= slice.width || y >= slice.height) {
        return SF_ERR_ARGUMENT;
    }
    uint64_t *word = sfi_slice_row(slice, y) + x / 64, bit = UINT64_C(1) << (x % 64);
    *word = value ? *word | bit : *word & ~bit;
    return SF_OK;
}

// Set or clear bits x0 <= x < x1 of a row.
static void fill_row(uint64_t *row, uint32_t x0, uint32_t x1, int value)
{
    size_t first = x0 / 64, last = (x1 - 1) / 64;
    uint64_t head = ~UINT64_C(0) << (x0 % 64), tail = sfi_tail_mask(x1);
    for (size_t i = first; i <= last; i++) {
        uint64_t mask = (i == first ? head : ~UINT64_C(0)) & (i == last ? tail : ~UINT64_C(0));
        row[i] = value ? row[i] | mask : row[i] & ~mask;
    }
}

sf_status sf_slice_fill(sf_slice slice, sf_rect rect, int value)
{
    SF_TRY(sfi_slice_validate(slice));
    if (rect.x1 > slice.width || rect.y1 > slice.height) {
        return SF_ERR_ARGUMENT;
    }
    for (uint32_t y = rect.y0; y < rect.y1 && rect.x0 < rect.x1; y++) {
        uint64_t *row = sfi_slice_row(slice, y);
        fill_row(row, rect.x0, rect.x1, value);
        row[sfi_row_words(slice.width) - 1] &= sfi_tail_mask(slice.width);
    }
    return SF_OK;
}

typedef void (*word_operation)(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count);

// Inputs may be the result itself, but not lie across it.
static sf_status combine(sf_slice dst, sf_slice a, sf_slice b, word_operation operation)
{
    SF_TRY(sfi_slice_validate_pair(dst, a));
    SF_TRY(sfi_slice_validate_pair(dst, b));
    if ((sfi_slice_overlap(dst, a) && !sfi_slice_same(dst, a)) ||
        (sfi_slice_overlap(dst, b) && !sfi_slice_same(dst, b))) {
        return SF_ERR_ARGUMENT;
    }
    size_t count = sfi_row_words(dst.width);
    for (uint32_t y = 0; y < dst.height; y++) {
        uint64_t *row = sfi_slice_row(dst, y);
        operation(row, sfi_slice_row(a, y), sfi_slice_row(b, y), count);
        row[count - 1] &= sfi_tail_mask(dst.width);
    }
    return SF_OK;
}

sf_status sf_slice_copy(sf_slice dst, sf_slice src)
{
    return combine(dst, src, src, sfi_kernels_get()->or_words);
}

sf_status sf_slice_and(sf_slice dst, sf_slice a, sf_slice b)
{
    return combine(dst, a, b, sfi_kernels_get()->and_words);
}

sf_status sf_slice_or(sf_slice dst, sf_slice a, sf_slice b)
{
    return combine(dst, a, b, sfi_kernels_get()->or_words);
}

sf_status sf_slice_xor(sf_slice dst, sf_slice a, sf_slice b)
{
    return combine(dst, a, b, sfi_kernels_get()->xor_words);
}

sf_status sf_slice_subtract(sf_slice dst, sf_slice a, sf_slice b)
{
    return combine(dst, a, b, sfi_kernels_get()->subtract_words);
}

int sf_slice_equal(sf_slice a, sf_slice b)
{
    if (sfi_slice_validate_pair(a, b) != SF_OK) {
        return 0;
    }
    size_t last = sfi_row_words(a.width) - 1;
    for (uint32_t y = 0; y < a.height; y++) {
        const uint64_t *p = sfi_slice_row(a, y), *q = sfi_slice_row(b, y);
        uint64_t differ = (p[last] ^ q[last]) & sfi_tail_mask(a.width);
        for (size_t i = 0; i < last; i++) {
            differ |= p[i] ^ q[i];
        }
        if (differ != 0) {
            return 0;
        }
    }
    return 1;
}

uint64_t sf_slice_popcount(sf_slice slice)
{
    if (sfi_slice_validate(slice) != SF_OK) {
        return 0;
    }
    const sfi_kernels *kernels = sfi_kernels_get();
    size_t last = sfi_row_words(slice.width) - 1;
    uint64_t sum = 0;
    for (uint32_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(slice, y);
        uint64_t tail = row[last] & sfi_tail_mask(slice.width);
        sum += kernels->popcount(&tail, 1);
        if (last > 0) {
            sum += kernels->popcount(row, last);
        }
    }
    return sum;
}

// Widen x0..x1 to the solid voxels of one row; returns whether it has any.
static int widen_to_row(const uint64_t *row, uint32_t width, uint32_t *x0, uint32_t *x1)
{
    size_t count = sfi_row_words(width), first = 0, last = count;
    uint64_t tail = sfi_tail_mask(width);
    while (first + 1 < count && row[first] == 0) {
        first++;
    }
    uint64_t low = row[first] & (first + 1 == count ? tail : ~UINT64_C(0));
    if (low == 0) {
        return 0;
    }
    uint64_t high;
    do {
        last--;
        high = row[last] & (last + 1 == count ? tail : ~UINT64_C(0));
    } while (high == 0);
    uint32_t left = (uint32_t)first * 64 + sfi_lowest_bit(low);
    uint32_t right = (uint32_t)last * 64 + sfi_highest_bit(high) + 1;
    *x0 = left < *x0 ? left : *x0;
    *x1 = right > *x1 ? right : *x1;
    return 1;
}

sf_rect sf_slice_bounds(sf_slice slice)
{
    sf_rect none = {0, 0, 0, 0}, bounds = {UINT32_MAX, UINT32_MAX, 0, 0};
    if (sfi_slice_validate(slice) != SF_OK) {
        return none;
    }
    for (uint32_t y = 0; y < slice.height; y++) {
        if (widen_to_row(sfi_slice_row(slice, y), slice.width, &bounds.x0, &bounds.x1)) {
            bounds.y0 = y < bounds.y0 ? y : bounds.y0;
            bounds.y1 = y + 1;
        }
    }
    return bounds.y1 == 0 ? none : bounds;
}
