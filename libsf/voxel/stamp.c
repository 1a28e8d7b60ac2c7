// SPDX-License-Identifier: MIT
// Stamp: one grid's voxels put into another, moved by whole voxels; a row at a time, word by word.

#include "voxel/stamp.h"

#include "voxel/slice.h"

// to |= from, moved by dx voxels; what leaves the row on either side is lost.
static void stamp_row(uint64_t *to, uint32_t to_width, const uint64_t *from, uint32_t from_width,
                      int64_t dx)
{
    size_t to_words = sfi_row_words(to_width), from_words = sfi_row_words(from_width);
    unsigned shift = (unsigned)(dx & 63);
    int64_t first = (dx - (int64_t)shift) / 64;
    for (size_t i = 0; i < from_words; i++) {
        int64_t at = first + (int64_t)i;
        uint64_t word = sfi_row_word(from, i, from_width);
        if (at >= 0 && at < (int64_t)to_words) {
            to[at] |= word << shift;
        }
        if (shift > 0 && at + 1 >= 0 && at + 1 < (int64_t)to_words) {
            to[at + 1] |= word >> (64 - shift);
        }
    }
    to[to_words - 1] &= sfi_tail_mask(to_width);
}

// What of `count` places, moved by `by`, lies within `limit`.
static void clip(uint32_t count, int64_t by, uint32_t limit, uint32_t *low, uint32_t *high)
{
    int64_t end = by + count;
    *low = by <= 0 ? 0 : by < limit ? (uint32_t)by : limit;
    *high = end <= 0 ? 0 : end < limit ? (uint32_t)end : limit;
}

sf_box sfi_grid_stamp(sf_grid *to, const sf_grid *from, const int64_t by[3])
{
    sf_lattice a = sf_grid_lattice(to), b = sf_grid_lattice(from);
    sf_box part, none = {0, 0, 0, 0, 0, 0};
    clip(b.nx, by[0], a.nx, &part.x0, &part.x1);
    clip(b.ny, by[1], a.ny, &part.y0, &part.y1);
    clip(b.nz, by[2], a.nz, &part.z0, &part.z1);
    if (part.x0 >= part.x1 || part.y0 >= part.y1 || part.z0 >= part.z1) {
        return none;
    }
    for (uint32_t z = part.z0; z < part.z1; z++) {
        sf_slice out = sf_grid_slice(to, z), in = sf_grid_slice(from, (uint32_t)(z - by[2]));
        for (uint32_t y = part.y0; y < part.y1; y++) {
            stamp_row(sfi_slice_row(out, y), out.width, sfi_slice_row(in, (uint32_t)(y - by[1])),
                      in.width, by[0]);
        }
    }
    return part;
}
