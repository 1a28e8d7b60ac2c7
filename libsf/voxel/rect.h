// SPDX-License-Identifier: MIT
// Rectangles and boxes that grow: the smallest one around whatever was put in.
//
// An empty one is all zero, as the public functions return it. Growing an empty one gives what it
// is grown by, so a sum over any number of parts needs no first case. Half-open, as in
// <sf/voxel.h>; freestanding.

#ifndef SF_VOXEL_RECT_H
#define SF_VOXEL_RECT_H

#include <sf/voxel.h>

static inline int sfi_rect_is_empty(sf_rect r)
{
    return r.x0 >= r.x1 || r.y0 >= r.y1;
}

static inline int sfi_box_is_empty(sf_box b)
{
    return b.x0 >= b.x1 || b.y0 >= b.y1 || b.z0 >= b.z1;
}

// The smallest rectangle around both.
static inline sf_rect sfi_rect_union(sf_rect a, sf_rect b)
{
    if (sfi_rect_is_empty(a) || sfi_rect_is_empty(b)) {
        return sfi_rect_is_empty(a) ? b : a;
    }
    sf_rect both = {a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0, a.x1 > b.x1 ? a.x1 : b.x1,
                    a.y1 > b.y1 ? a.y1 : b.y1};
    return both;
}

// A rectangle within a slice, grown by rx and ry on either side and clipped to the slice.
static inline sf_rect sfi_rect_grow(sf_rect r, uint32_t rx, uint32_t ry, sf_slice slice)
{
    if (sfi_rect_is_empty(r)) {
        return r;
    }
    sf_rect grown = {r.x0 > rx ? r.x0 - rx : 0, r.y0 > ry ? r.y0 - ry : 0,
                     slice.width - r.x1 > rx ? r.x1 + rx : slice.width,
                     slice.height - r.y1 > ry ? r.y1 + ry : slice.height};
    return grown;
}

// The smallest rectangle around r that starts and ends with a word of the slice.
static inline sf_rect sfi_rect_align(sf_rect r, sf_slice slice)
{
    r.x0 -= r.x0 % 64;
    uint32_t end = (r.x1 + 63) / 64 * 64;
    r.x1 = end < slice.width ? end : slice.width;
    return r;
}

// The part of a slice in a rectangle that starts with a word; of a slice without words, none.
static inline sf_slice sfi_slice_window(sf_slice slice, sf_rect r)
{
    if (slice.words == NULL) {
        return slice;
    }
    sf_slice part = {slice.words + (size_t)r.y0 * slice.stride + r.x0 / 64, r.x1 - r.x0,
                     r.y1 - r.y0, slice.stride};
    return part;
}

// The smallest box around a box and a rectangle of layer z.
static inline sf_box sfi_box_union(sf_box box, sf_rect rect, uint32_t z)
{
    if (sfi_rect_is_empty(rect)) {
        return box;
    }
    if (sfi_box_is_empty(box)) {
        sf_box alone = {rect.x0, rect.y0, z, rect.x1, rect.y1, z + 1};
        return alone;
    }
    sf_rect before = {box.x0, box.y0, box.x1, box.y1}, both = sfi_rect_union(before, rect);
    sf_box grown = {both.x0, both.y0, z < box.z0 ? z : box.z0,
                    both.x1, both.y1, z + 1 > box.z1 ? z + 1 : box.z1};
    return grown;
}

// The smallest box around two.
static inline sf_box sfi_box_join(sf_box a, sf_box b)
{
    if (sfi_box_is_empty(a) || sfi_box_is_empty(b)) {
        return sfi_box_is_empty(a) ? b : a;
    }
    sf_box both = {a.x0 < b.x0 ? a.x0 : b.x0, a.y0 < b.y0 ? a.y0 : b.y0, a.z0 < b.z0 ? a.z0 : b.z0,
                   a.x1 > b.x1 ? a.x1 : b.x1, a.y1 > b.y1 ? a.y1 : b.y1, a.z1 > b.z1 ? a.z1 : b.z1};
    return both;
}

#endif
