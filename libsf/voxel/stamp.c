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

// Bits of word i of a row that lie within it; none where there is no such word.
static uint64_t within(uint32_t width, int64_t i)
{
    int64_t last = (int64_t)sfi_row_words(width) - 1;
    return i < 0 || i > last ? 0 : i < last ? ~UINT64_C(0) : sfi_tail_mask(width);
}

// The same for rows y0 <= y < y1 of a layer, where the mask is at most a word wide, as that of most
// brushes is: two words at most, and which they are is known for all rows.
static void stamp_narrow(sf_slice out, sf_slice in, const int64_t by[3], uint32_t y0, uint32_t y1)
{
    unsigned shift = (unsigned)(by[0] & 63);
    int64_t at = (by[0] - (int64_t)shift) / 64;
    uint64_t mask = sfi_tail_mask(in.width), low = within(out.width, at);
    uint64_t high = shift + in.width > 64 ? within(out.width, at + 1) : 0;
    for (uint32_t y = y0; y < y1; y++) {
        uint64_t word = sfi_slice_row(in, (uint32_t)(y - by[1]))[0] & mask;
        uint64_t *to = sfi_slice_row(out, y);
        if (low != 0) {
            to[at] |= word << shift & low;
        }
        if (high != 0) {
            to[at + 1] |= word >> (64 - shift) & high;
        }
    }
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
    int is_narrow = b.nx <= 64;
    for (uint32_t z = part.z0; z < part.z1; z++) {
        sf_slice out = sf_grid_slice(to, z), in = sf_grid_slice(from, (uint32_t)(z - by[2]));
        if (is_narrow) {
            stamp_narrow(out, in, by, part.y0, part.y1);
            continue;
        }
        for (uint32_t y = part.y0; y < part.y1; y++) {
            stamp_row(sfi_slice_row(out, y), out.width, sfi_slice_row(in, (uint32_t)(y - by[1])),
                      in.width, by[0]);
        }
    }
    return part;
}
