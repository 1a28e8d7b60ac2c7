// SPDX-License-Identifier: MIT
// Beams: bridges of a layer that is being chosen from the top down.
//
// Let S be the layer of the shape, A what of it is alive on its own, Y what is to stay. A voxel of
// Y outside A hung on a bridge in S. Y keeps that bridge when it has the whole gap and, at each
// end, as many anchored cells as the rule asks for. The cell next to a gap begins a run of A that
// goes outwards for at least the anchor: were the gap's own cell in A, it would be of that run and
// no gap. So the gap and `anchor` cells beyond each end are all that is added, and in Y they are a
// bridge again. Adding more never breaks another bridge: ends stay ends, and more ends only split
// gaps. Nor does closing cascade: the added cells hang on the bridge that they belong to, and its
// anchors lie in A.
//
// Of the four directions the one with the least new voxels is taken, the first of equals.
//
// Then not all of Y in A must be carried by what is below: of a beam that hangs in Y between two
// ends, the middle may be alive on its own in S and need not be. Leaving a voxel out is tried one
// by one, and looks only as far as a bridge reaches.

#include "support/preserve/beam.h"

#include "base/bits.h"
#include "base/status.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

// A direction of bridging, its limits, and the gap found along it.
typedef struct line {
    int32_t dx, dy;
    uint32_t span, anchor;
    int64_t x, y;   // first cell of the gap
    int64_t length; // 0: none
} line;

static int has(sf_slice s, int64_t x, int64_t y)
{
    return x >= 0 && y >= 0 && x < s.width && y < s.height &&
           (sfi_slice_row(s, (uint32_t)y)[x / 64] >> (x % 64) & 1) != 0;
}

static void add(sf_slice s, int64_t x, int64_t y)
{
    sfi_slice_row(s, (uint32_t)y)[x / 64] |= UINT64_C(1) << (x % 64);
}

static uint32_t at_least_one(uint32_t anchor)
{
    return anchor > 0 ? anchor : 1;
}

// Whether `anchor` cells of own begin at (x, y) and go on along `sign` times the direction.
static int is_end(const sfi_beam *b, const line *l, int64_t x, int64_t y, int sign)
{
    for (int64_t i = 0; i < at_least_one(l->anchor); i++) {
        if (!has(b->own, x + i * sign * l->dx, y + i * sign * l->dy)) {
            return 0;
        }
    }
    return 1;
}

// Cells from (x, y), itself included, to the end of its gap along `sign` times the direction; more
// than the span where there is none. A run of own that is too short to anchor belongs to the gap,
// and (x, y) may lie in none that is long enough.
static int64_t reach(const sfi_beam *b, const line *l, int64_t x, int64_t y, int sign)
{
    int64_t n = 1;
    for (; n <= l->span; n++) {
        int64_t ux = x + n * sign * l->dx, uy = y + n * sign * l->dy;
        if (!has(b->solid, ux, uy)) {
            return (int64_t)l->span + 1;
        }
        if (is_end(b, l, ux, uy, sign)) {
            return n;
        }
    }
    return n;
}

// Find the gap of (x, y) along a line; returns the voxels that keeping it would add to want.
static int64_t measure(const sfi_beam *b, line *l, int64_t x, int64_t y)
{
    int64_t ahead = reach(b, l, x, y, 1), behind = reach(b, l, x, y, -1), fresh = 0;
    l->length = ahead + behind - 1;
    if (l->span == 0 || l->length > l->span) {
        l->length = 0;
        return INT64_MAX;
    }
    l->x = x - (behind - 1) * l->dx;
    l->y = y - (behind - 1) * l->dy;
    int64_t anchor = at_least_one(l->anchor);
    for (int64_t i = -anchor; i < l->length + anchor; i++) {
        fresh += !has(b->want, l->x + i * l->dx, l->y + i * l->dy);
    }
    return fresh;
}

static void keep_line(const sfi_beam *b, const line *l, uint8_t *need)
{
    int64_t anchor = at_least_one(l->anchor);
    for (int64_t i = -anchor; i < l->length + anchor; i++) {
        int64_t x = l->x + i * l->dx, y = l->y + i * l->dy;
        add(b->want, x, y);
        if (i >= 0 && i < l->length) {
            add(b->added, x, y);
        }
        if (need != NULL) {
            uint8_t *code = &need[(size_t)y * sfi_slack_stride(b->want.width) + (size_t)x];
            *code = *code > 0 ? *code : 1;
        }
    }
}

static void close_voxel(const sfi_beam *b, int64_t x, int64_t y, uint8_t *need)
{
    const sf_bridge *r = b->bridge;
    line lines[4] = {{1, 0, r->span_x, r->anchor_x, 0, 0, 0},
                     {0, 1, r->span_y, r->anchor_y, 0, 0, 0},
                     {1, 1, r->span_diagonal, r->anchor_diagonal, 0, 0, 0},
                     {-1, 1, r->span_diagonal, r->anchor_diagonal, 0, 0, 0}};
    int64_t least = INT64_MAX;
    int best = -1;
    for (int i = 0; i < 4; i++) {
        int64_t fresh = measure(b, &lines[i], x, y);
        if (fresh < least) {
            least = fresh;
            best = i;
        }
    }
    if (best >= 0) {
        keep_line(b, &lines[best], need);
    }
}

// dst = want without ends, and without the gaps that bridge between them.
static int find_hanging(const sfi_beam *b, sf_slice ends, sf_slice dst)
{
    uint64_t any = 0;
    sfi_bridge_gaps(b->bridge, b->want, ends, b->anchored, b->gaps);
    for (uint32_t y = 0; y < dst.height; y++) {
        const uint64_t *want = sfi_slice_row(b->want, y), *held = sfi_slice_row(ends, y);
        const uint64_t *gaps = sfi_slice_row(b->gaps, y);
        uint64_t *out = sfi_slice_row(dst, y);
        for (size_t i = 0; i < sfi_row_words(dst.width); i++) {
            out[i] = want[i] & ~held[i] & ~gaps[i];
            any |= out[i];
        }
    }
    return any != 0;
}

static void set_ends(const sfi_beam *b)
{
    (void)!sf_slice_and(b->ends, b->want, b->own);
}

void sfi_beam_close(const sfi_beam *b, uint8_t *need)
{
    // ends serves as scratch, and `hanging` shares the gaps' words: they are read before they are
    // written, word by word.
    sf_slice hanging = b->gaps;
    sf_rect all = {0, 0, b->want.width, b->want.height};
    set_ends(b);
    if (!find_hanging(b, b->ends, hanging)) {
        return;
    }
    (void)!sf_slice_fill(b->added, all, 0);
    for (uint32_t y = 0; y < hanging.height; y++) {
        for (size_t i = 0; i < sfi_row_words(hanging.width); i++) {
            for (uint64_t w = sfi_slice_row(hanging, y)[i]; w != 0; w &= w - 1) {
                int64_t x = (int64_t)i * 64 + sfi_lowest_bit(w);
                if (!has(b->added, x, y)) {
                    close_voxel(b, x, y, need);
                }
            }
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Thinning
// ---------------------------------------------------------------------------------------------

static sf_rect around(sf_slice s, uint32_t x, uint32_t y, uint32_t by)
{
    uint32_t x0 = x > by ? x - by : 0, x1 = s.width - x > by ? x + by + 1 : s.width;
    uint32_t end = (x1 + 63) / 64 * 64;
    sf_rect r = {x0 - x0 % 64, y > by ? y - by : 0, end < s.width ? end : s.width,
                 s.height - y > by ? y + by + 1 : s.height};
    return r;
}

// Whether all of want near (x, y) holds. Twice the margin is computed: what is right in the inner
// half depends on no more. What hangs farther out is cut off, not wrong.
static int holds_near(const sfi_beam *b, uint32_t x, uint32_t y)
{
    uint32_t by = sfi_bridge_margin(b->bridge);
    sf_rect outer = around(b->want, x, y, 2 * by);
    sfi_beam part = *b;
    part.want = sfi_slice_window(b->want, outer);
    part.anchored = sfi_slice_window(b->anchored, outer);
    part.gaps = sfi_slice_window(b->gaps, outer);
    part.added = sfi_slice_window(b->added, outer);
    (void)find_hanging(&part, sfi_slice_window(b->ends, outer), part.added);
    uint32_t y0 = y > by ? y - by : 0, y1 = b->want.height - y > by ? y + by + 1 : b->want.height;
    uint32_t x0 = x > by ? x - by : 0, x1 = b->want.width - x > by ? x + by + 1 : b->want.width;
    for (uint32_t v = y0; v < y1; v++) {
        for (uint32_t u = x0; u < x1; u++) {
            if (has(b->added, u, v)) {
                return 0;
            }
        }
    }
    return 1;
}

sf_status sfi_beam_thin(const sfi_beam *b, sf_slice must)
{
    if (!find_hanging(b, must, b->added)) {
        return sf_slice_copy(b->ends, must);
    }
    set_ends(b);
    for (uint32_t y = 0; y < b->want.height; y++) {
        const uint64_t *stay = sfi_slice_row(must, y);
        uint64_t *ends = sfi_slice_row(b->ends, y);
        for (size_t i = 0; i < sfi_row_words(b->want.width); i++) {
            for (uint64_t w = ends[i] & ~stay[i]; w != 0; w &= w - 1) {
                uint64_t bit = w & (~w + 1);
                ends[i] &= ~bit;
                if (!holds_near(b, (uint32_t)i * 64 + sfi_lowest_bit(bit), y)) {
                    ends[i] |= bit;
                }
            }
        }
    }
    return SF_OK;
}
