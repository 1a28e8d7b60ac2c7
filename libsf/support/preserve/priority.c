// SPDX-License-Identifier: MIT
// Priority cover: word by word, each hanging voxel takes the first carrier in a fixed order.
//
// The order of offsets is by rings: straight below; then for r = 1, 2, ... the offsets whose longer
// side is r, by their shorter side t = 0 .. r, and of one (r, t)
//
//     (r,t) (-r,t) (r,-t) (-r,-t) (t,r) (-t,r) (t,-r) (-t,-r)     (dx, dy), each once
//
// so for the 3x3 square: below, the four edge neighbours, the four corners. For one offset all
// voxels that hang and have a carrier there take it, and all that these carry hang no more: a
// handful of word operations and a dilation, without anything that depends on the data but the end.
// A processor of pictures does the same with a pass for each offset.
//
// It keeps more than greedy does, some ten times as much under a wide ceiling, because voxels of
// one pass do not see what their neighbours take.

#include "support/preserve/cover.h"

#include "base/status.h"
#include "voxel/slice.h"

// The cover at work.
typedef struct priority {
    const sf_element *element;
    sf_slice rest, carriers, picked, fresh, spread;
} priority;

// fresh |= the carriers at (dx, dy) from what hangs; returns whether there are any.
static int take(const priority *p, int32_t dx, int32_t dy)
{
    size_t words = sfi_row_words(p->rest.width);
    uint64_t any = 0;
    for (uint32_t y = 0; y < p->rest.height; y++) {
        int64_t uy = (int64_t)y + dy;
        if (uy < 0 || uy >= p->rest.height) {
            continue;
        }
        const uint64_t *hanging = sfi_slice_row(p->rest, y);
        const uint64_t *carriers = sfi_slice_row(p->carriers, (uint32_t)uy);
        uint64_t *fresh = sfi_slice_row(p->fresh, (uint32_t)uy);
        for (size_t i = 0; i < words; i++) {
            uint64_t taken = carriers[i] & sfi_moved_word(hanging, words, i, -dx);
            fresh[i] |= taken;
            any |= taken;
        }
    }
    return any != 0;
}

// Serve what hangs from offset (dx, dy); returns whether anything still hangs, or a failure.
static sf_status serve(const priority *p, int32_t dx, int32_t dy, int *left)
{
    sf_rect all = {0, 0, p->rest.width, p->rest.height};
    SF_TRY(sf_slice_fill(p->fresh, all, 0));
    if (take(p, dx, dy)) {
        SF_TRY(sf_slice_or(p->picked, p->picked, p->fresh));
        SF_TRY(sf_slice_dilate(p->spread, p->fresh, p->element, SF_BORDER_EMPTY));
        SF_TRY(sf_slice_subtract(p->rest, p->rest, p->spread));
        *left = sfi_slice_any(p->rest);
    }
    return SF_OK;
}

// The offsets (r, t) and their mirror images that the element has.
static sf_status serve_ring(const priority *p, int32_t r, int32_t t, int *left)
{
    for (int i = 0; *left && i < 8; i++) {
        int32_t dx = i < 4 ? r : t, dy = i < 4 ? t : r;
        int mirror_x = i & 1, mirror_y = (i & 2) != 0;
        int twice = (mirror_x && dx == 0) || (mirror_y && dy == 0) || (i >= 4 && r == t);
        if (twice || dy > p->element->reach_y || dx > p->element->half_width[dy]) {
            continue;
        }
        SF_TRY(serve(p, mirror_x ? -dx : dx, mirror_y ? -dy : dy, left));
    }
    return SF_OK;
}

sf_status sfi_cover_priority(const sf_element *element, sf_slice rest, sf_slice carriers,
                             sf_slice picked, sf_slice fresh, sf_slice spread)
{
    priority p = {element, rest, carriers, picked, fresh, spread};
    int32_t reach =
        element->reach_y > element->half_width[0] ? element->reach_y : element->half_width[0];
    int left = sfi_slice_any(rest);
    sf_rect all = {0, 0, rest.width, rest.height};
    SF_TRY(sf_slice_fill(picked, all, 0));
    for (int32_t r = 0; left && r <= reach; r++) {
        for (int32_t t = 0; left && t <= r; t++) {
            SF_TRY(serve_ring(&p, r, t, &left));
        }
    }
    return SF_OK;
}
