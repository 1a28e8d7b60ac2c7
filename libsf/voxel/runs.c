// SPDX-License-Identifier: MIT
// Runs: the solid voxels of a slice as intervals of its rows.
//
// Bits and runs say the same; a run costs 16 bytes however long it is, and the labelling of
// components, the checker's stream and the formats of resin printers all speak in runs. The borders
// of the runs of a row are the bits that differ from their left neighbour: word ^ (word << 1 | last
// bit before), taken out from the lowest. No bit of the inside of a run is ever looked at.

#include "base/bits.h"
#include "base/status.h"
#include "simd/kernels.h"
#include "voxel/slice.h"

sf_status sf_slice_run_count(sf_slice slice, size_t *count)
{
    const sfi_kernels *kernels = sfi_kernels_get();
    SF_TRY(sfi_slice_validate(slice));
    if (count == NULL) {
        return SF_ERR_ARGUMENT;
    }
    uint64_t begins = 0;
    size_t words = sfi_row_words(slice.width);
    for (uint32_t y = 0; y < slice.height; y++) {
        const uint64_t *row = sfi_slice_row(slice, y);
        uint64_t before = 0;
        for (size_t i = 0; i < words; i++) {
            uint64_t word = sfi_row_word(row, i, slice.width);
            uint64_t begin = word & ~(word << 1 | before);
            before = word >> 63;
            begins += begin == 0 ? 0 : kernels->popcount(&begin, 1);
        }
    }
    if (begins > SIZE_MAX) {
        return SF_ERR_OVERFLOW;
    }
    *count = (size_t)begins;
    return SF_OK;
}

// The runs of one row; returns how many.
static size_t row_runs(const uint64_t *row, uint32_t width, uint32_t y, sf_run *runs)
{
    size_t words = sfi_row_words(width), count = 0;
    uint64_t before = 0;
    for (size_t i = 0; i < words; i++) {
        uint64_t word = sfi_row_word(row, i, width), borders = word ^ (word << 1 | before);
        before = word >> 63;
        for (; borders != 0; borders &= borders - 1) {
            uint32_t bit = sfi_lowest_bit(borders), x = (uint32_t)(64 * i) + bit;
            if ((word >> bit & 1) != 0) {
                sf_run begun = {x, width, y, 0};
                runs[count++] = begun;
            } else {
                runs[count - 1].x1 = x;
            }
        }
    }
    return count;
}

sf_status sf_slice_runs(sf_slice slice, sf_run *runs, size_t capacity, size_t *count)
{
    size_t need = 0, done = 0;
    if (count == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sf_slice_run_count(slice, &need));
    if (need > capacity) {
        *count = need;
        return SF_ERR_CAPACITY;
    }
    if (runs == NULL && need > 0) {
        return SF_ERR_ARGUMENT;
    }
    for (uint32_t y = 0; done < need; y++) {
        done += row_runs(sfi_slice_row(slice, y), slice.width, y, runs + done);
    }
    *count = need;
    return SF_OK;
}

sf_status sf_slice_from_runs(sf_slice dst, const sf_run *runs, size_t count)
{
    SF_TRY(sfi_slice_validate(dst));
    if (runs == NULL && count > 0) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        if (runs[i].x0 >= runs[i].x1 || runs[i].x1 > dst.width || runs[i].y >= dst.height) {
            return SF_ERR_ARGUMENT;
        }
    }
    sf_rect all = {0, 0, dst.width, dst.height};
    SF_TRY(sf_slice_fill(dst, all, 0));
    for (size_t i = 0; i < count; i++) {
        sf_rect rect = {runs[i].x0, runs[i].y, runs[i].x1, runs[i].y + 1};
        SF_TRY(sf_slice_fill(dst, rect, 1));
    }
    return SF_OK;
}
