// SPDX-License-Identifier: MIT
// Squares: erosion and dilation by a square of any width.
//
// The elements of <sf/voxel.h> are symmetric, so they have no square of an even width; struts two
// voxels wide are just that. A square is named by its corner of least x and y: the corners of the
// squares that lie in a slice are an erosion, all voxels of such squares a dilation, one after the
// other the opening. Both are made in place, along x and along y apart, by doubling: what is known
// of runs of n voxels tells of runs of up to 2n.

#include "voxel/square.h"

#include "voxel/slice.h"

// row(x) &= row(x + by); beyond the row nothing is solid.
static void erode_row(uint64_t *row, size_t words, uint32_t by)
{
    size_t whole = by / 64;
    unsigned part = by % 64;
    for (size_t i = 0; i < words; i++) {
        uint64_t low = i + whole < words ? row[i + whole] : 0;
        uint64_t high = i + whole + 1 < words ? row[i + whole + 1] : 0;
        row[i] &= part == 0 ? low : low >> part | high << (64 - part);
    }
}

// row(x) |= row(x - by).
static void fill_row(uint64_t *row, size_t words, uint32_t by)
{
    size_t whole = by / 64;
    unsigned part = by % 64;
    for (size_t i = words; i-- > whole;) {
        uint64_t high = row[i - whole], low = i > whole ? row[i - whole - 1] : 0;
        row[i] |= part == 0 ? high : high << part | low >> (64 - part);
    }
}

void sfi_square_corners(sf_slice slice, uint32_t width)
{
    size_t words = sfi_row_words(slice.width);
    for (uint32_t have = 1; have < width;) {
        uint32_t by = width - have < have ? width - have : have;
        for (uint32_t y = 0; y < slice.height; y++) {
            erode_row(sfi_slice_row(slice, y), words, by);
        }
        for (uint32_t y = 0; y < slice.height; y++) {
            uint64_t *row = sfi_slice_row(slice, y);
            const uint64_t *above =
                slice.height - y > by ? sfi_slice_row(slice, y + by) : sfi_empty_row;
            for (size_t i = 0; i < words; i++) {
                row[i] &= above[i];
            }
        }
        have += by;
    }
}

void sfi_square_fill(sf_slice slice, uint32_t width)
{
    size_t words = sfi_row_words(slice.width);
    for (uint32_t have = 1; have < width;) {
        uint32_t by = width - have < have ? width - have : have;
        for (uint32_t y = slice.height; y-- > by;) {
            uint64_t *row = sfi_slice_row(slice, y);
            const uint64_t *below = sfi_slice_row(slice, y - by);
            for (size_t i = 0; i < words; i++) {
                row[i] |= below[i];
            }
        }
        for (uint32_t y = 0; y < slice.height; y++) {
            uint64_t *row = sfi_slice_row(slice, y);
            fill_row(row, words, by);
            row[words - 1] &= sfi_tail_mask(slice.width);
        }
        have += by;
    }
}
