// SPDX-License-Identifier: MIT
// Area: a rectangle for each layer, around whatever was put in. Where a box around something that
// runs across a grid holds mostly what lies beside it, an area does not.

#ifndef SF_VOXEL_AREA_H
#define SF_VOXEL_AREA_H

#include <string.h>

#include "base/bits.h"
#include "voxel/rect.h"

// The layers z0 <= z < z1 count; empty where there are none. The rectangles are the owner's, one
// for each layer of a grid.
typedef struct sfi_area {
    uint32_t z0, z1;
    sf_rect *rects;
} sfi_area;

static inline void sfi_area_clear(sfi_area *area)
{
    area->z0 = area->z1 = 0;
}

static inline int sfi_area_is_empty(const sfi_area *area)
{
    return area->z0 >= area->z1;
}

// Make layer z count.
static inline void sfi_area_reach(sfi_area *area, uint32_t z)
{
    if (sfi_area_is_empty(area)) {
        area->z0 = z;
        area->z1 = z;
    }
    for (; z < area->z0; area->z0--) {
        memset(&area->rects[area->z0 - 1], 0, sizeof *area->rects);
    }
    for (; z >= area->z1; area->z1++) {
        memset(&area->rects[area->z1], 0, sizeof *area->rects);
    }
}

static inline void sfi_area_add(sfi_area *area, sf_rect rect, uint32_t z)
{
    if (!sfi_rect_is_empty(rect)) {
        sfi_area_reach(area, z);
        area->rects[z] = sfi_rect_union(area->rects[z], rect);
    }
}

static inline void sfi_area_add_box(sfi_area *area, sf_box box)
{
    sf_rect rect = {box.x0, box.y0, box.x1, box.y1};
    for (uint32_t z = box.z0; z < box.z1; z++) {
        sfi_area_add(area, rect, z);
    }
}

static inline void sfi_area_join(sfi_area *area, const sfi_area *other)
{
    for (uint32_t z = other->z0; z < other->z1; z++) {
        sfi_area_add(area, other->rects[z], z);
    }
}

// *area grown by the set bits of word i of row y in layer z.
static inline void sfi_area_note(sfi_area *area, size_t i, uint64_t bits, uint32_t y, uint32_t z)
{
    if (bits != 0) {
        uint32_t x = (uint32_t)i * 64;
        sf_rect rect = {x + sfi_lowest_bit(bits), y, x + sfi_highest_bit(bits) + 1, y + 1};
        sfi_area_add(area, rect, z);
    }
}

// The rectangle of a layer; empty where it does not count.
static inline sf_rect sfi_area_rect(const sfi_area *area, uint32_t z)
{
    sf_rect none = {0, 0, 0, 0};
    return z >= area->z0 && z < area->z1 ? area->rects[z] : none;
}

// The box around all of it.
static inline sf_box sfi_area_bounds(const sfi_area *area)
{
    sf_box box = {0, 0, 0, 0, 0, 0};
    for (uint32_t z = area->z0; z < area->z1; z++) {
        box = sfi_box_union(box, area->rects[z], z);
    }
    return box;
}

// Words of a row that hold the columns of a rectangle: first <= i < end.
static inline size_t sfi_rect_first_word(sf_rect rect)
{
    return rect.x0 / 64;
}

static inline size_t sfi_rect_end_word(sf_rect rect)
{
    return ((size_t)rect.x1 + 63) / 64;
}

#endif
