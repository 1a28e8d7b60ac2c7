// SPDX-License-Identifier: MIT
// Bridges: gaps of a layer that matter spans between two anchored ends.
//
// A is what is carried from below. Along a direction d, A* is the opening of A by the anchor: what
// lies in runs of A of at least that length. (An erosion would do for the ends, but is no
// increasing function of A as a test for gaps, and the proofs need one: with an opening a larger A
// only splits gaps.) A gap is a maximal run along d of solid voxels outside A*; it stays when A*
// bounds it on both ends and it is no longer than the span. Cells of A that lie in it were alive
// anyway.
//
// Most layers have nothing to bridge, and none of this is done for them; in others it is done in a
// window around what hangs, as much wider as a gap and its anchor are long, so that every gap with
// something hanging in it lies in the window with both its ends. The opening is made by words:
// eroding by a run of length a is log2 a steps of "AND with itself, shifted along d", and dilating
// back as many of "OR". Gaps are then found at their beginnings, solid outside A* with A* just
// before, also by words; each is walked to its end, which takes the span at most.
//
// Freestanding: integers, no memory but the caller's.
//
// Source: bridges anchored at both ends are the slicers' idea; the opening is the library's own.

#include "support/check/row.h"
#include "support/rule/carry.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

// A direction of bridging and its limits.
typedef struct direction {
    int32_t dx; // -1, 0 or 1
    int32_t dy; // 0 or 1
    uint32_t span, anchor;
} direction;

// slice(v) &= slice(v + by * d), in place: what v needs has not been changed yet.
static void erode_by(sf_slice slice, const direction *d, uint32_t by)
{
    size_t words = sfi_row_words(slice.width);
    uint32_t rows = (uint32_t)d->dy * by;
    for (uint32_t y = 0; y < slice.height; y++) {
        uint64_t *row = sfi_slice_row(slice, y);
        int inside = slice.height - y > rows;
        const uint64_t *from = inside ? sfi_slice_row(slice, y + rows) : row;
        for (size_t i = 0; i < words; i++) {
            row[i] &= inside ? sfi_moved_word(from, words, i, (int64_t)d->dx * by) : 0;
        }
    }
}

// slice(v) |= slice(v - by * d), in place, from the far end.
static void dilate_by(sf_slice slice, const direction *d, uint32_t by)
{
    size_t words = sfi_row_words(slice.width);
    uint32_t rows = (uint32_t)d->dy * by;
    for (uint32_t y = slice.height; y-- > rows;) {
        uint64_t *row = sfi_slice_row(slice, y);
        const uint64_t *from = sfi_slice_row(slice, y - rows);
        for (size_t i = words; i-- > 0;) {
            row[i] |= sfi_moved_word(from, words, i, -(int64_t)d->dx * by);
        }
        row[words - 1] &= sfi_tail_mask(slice.width);
    }
}

// slice = its opening along d by a run of `length` voxels.
static void open_along(sf_slice slice, const direction *d, uint32_t length)
{
    for (uint32_t have = 1; have < length;) {
        uint32_t by = length - have < have ? length - have : have;
        erode_by(slice, d, by);
        have += by;
    }
    for (uint32_t have = 1; have < length;) {
        uint32_t by = length - have < have ? length - have : have;
        dilate_by(slice, d, by);
        have += by;
    }
}

static int is_solid(sf_slice slice, int64_t x, int64_t y)
{
    return x >= 0 && y >= 0 && x < slice.width && y < slice.height &&
           (sfi_slice_row(slice, (uint32_t)y)[x / 64] >> (x % 64) & 1) != 0;
}

// Follow the gap that begins at (x, y); where it is bridged, add it to gaps.
static void walk(const direction *d, int64_t x, int64_t y, sf_slice solid, sf_slice anchored,
                 sf_slice gaps)
{
    int64_t length = 0;
    while (length <= d->span && is_solid(solid, x + length * d->dx, y + length * d->dy) &&
           !is_solid(anchored, x + length * d->dx, y + length * d->dy)) {
        length++;
    }
    if (length > d->span || !is_solid(anchored, x + length * d->dx, y + length * d->dy)) {
        return;
    }
    for (int64_t i = 0; i < length; i++) {
        int64_t u = x + i * d->dx;
        sfi_slice_row(gaps, (uint32_t)(y + i * d->dy))[u / 64] |= UINT64_C(1) << (u % 64);
    }
}

static void bridge_along(const direction *d, sf_slice solid, sf_slice own, sf_slice anchored,
                         sf_slice gaps)
{
    size_t words = sfi_row_words(solid.width);
    for (uint32_t y = 0; y < solid.height; y++) {
        for (size_t i = 0; i < words; i++) {
            sfi_slice_row(anchored, y)[i] = sfi_slice_row(own, y)[i];
        }
    }
    open_along(anchored, d, d->anchor);
    for (uint32_t y = (uint32_t)d->dy; y < solid.height; y++) {
        const uint64_t *full = sfi_slice_row(solid, y), *held = sfi_slice_row(anchored, y);
        const uint64_t *before = sfi_slice_row(anchored, y - (uint32_t)d->dy);
        for (size_t i = 0; i < words; i++) {
            uint64_t starts = full[i] & ~held[i] & sfi_moved_word(before, words, i, -d->dx);
            for (; starts != 0; starts &= starts - 1) {
                walk(d, (int64_t)i * 64 + sfi_lowest_bit(starts), y, solid, anchored, gaps);
            }
        }
    }
}

// The rectangle, by whole words, around the voxels of solid outside own.
static sf_rect hanging_bounds(sf_slice solid, sf_slice own)
{
    sf_rect bounds = {UINT32_MAX, UINT32_MAX, 0, 0};
    size_t words = sfi_row_words(solid.width);
    for (uint32_t y = 0; y < solid.height; y++) {
        const uint64_t *in = sfi_slice_row(solid, y), *held = sfi_slice_row(own, y);
        for (size_t i = 0; i < words; i++) {
            uint64_t tail = i + 1 < words ? ~UINT64_C(0) : sfi_tail_mask(solid.width);
            if ((in[i] & ~held[i] & tail) != 0) {
                uint32_t x0 = (uint32_t)i * 64, x1 = solid.width - x0 > 64 ? x0 + 64 : solid.width;
                bounds.x0 = x0 < bounds.x0 ? x0 : bounds.x0;
                bounds.x1 = x1 > bounds.x1 ? x1 : bounds.x1;
                bounds.y0 = y < bounds.y0 ? y : bounds.y0;
                bounds.y1 = y + 1;
            }
        }
    }
    return bounds;
}

uint32_t sfi_bridge_margin(const sf_bridge *b)
{
    uint32_t x = (uint32_t)b->span_x + b->anchor_x, y = (uint32_t)b->span_y + b->anchor_y;
    uint32_t d = (uint32_t)b->span_diagonal + b->anchor_diagonal, most = x > y ? x : y;
    most = d > most ? d : most;
    return sfi_bridge_any(b) ? most + 1 : 0;
}

void sfi_bridge_gaps(const sf_bridge *bridge, sf_slice solid, sf_slice own, sf_slice anchored,
                     sf_slice gaps)
{
    const sf_bridge *b = bridge;
    const direction directions[4] = {{1, 0, b->span_x, b->anchor_x},
                                     {0, 1, b->span_y, b->anchor_y},
                                     {1, 1, b->span_diagonal, b->anchor_diagonal},
                                     {-1, 1, b->span_diagonal, b->anchor_diagonal}};
    size_t words = sfi_row_words(solid.width);
    for (uint32_t y = 0; y < solid.height; y++) {
        for (size_t i = 0; i < words; i++) {
            sfi_slice_row(gaps, y)[i] = 0;
        }
    }
    sf_rect part = hanging_bounds(solid, own);
    if (sfi_rect_is_empty(part)) {
        return;
    }
    uint32_t margin = sfi_bridge_margin(bridge);
    part = sfi_rect_align(sfi_rect_grow(part, margin, margin, solid), solid);
    solid = sfi_slice_window(solid, part);
    own = sfi_slice_window(own, part);
    anchored = sfi_slice_window(anchored, part);
    gaps = sfi_slice_window(gaps, part);
    for (int i = 0; i < 4; i++) {
        if (directions[i].span > 0) {
            bridge_along(&directions[i], solid, own, anchored, gaps);
        }
    }
    words = sfi_row_words(solid.width);
    for (uint32_t y = 0; y < solid.height; y++) {
        for (size_t i = 0; i < words; i++) {
            sfi_slice_row(gaps, y)[i] &= ~sfi_slice_row(own, y)[i];
        }
    }
}
