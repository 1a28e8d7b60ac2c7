// SPDX-License-Identifier: MIT
// Dilation and erosion of slices by any structuring element, and the fused step of trimming.
//
// A row of the result is the union over dy of row y + dy widened by half_width[|dy|]. Rows of equal
// half width are united first, and widening is nested: with U_w the union of the rows of half width
// w,
//
//     result = U_0 | widen(U_1 | widen(U_2 | ... widen(U_max)))
//
// where each widen() goes from one half width that occurs to the next one (Horner's scheme on sets;
// widening by a and then by b is widening by a + b). So an element of reach r costs 2r + 1 row
// unions and about r widenings, all on a block of columns that stays in the first cache.
//
// Erosion is dilation of the complement: rows are complemented as they are read, with the border
// complemented too, and the result is complemented back. Freestanding; the scratch is on the stack.

#include "base/status.h"
#include "voxel/element.h"
#include "voxel/slice.h"

// Words of a block, and of the margin on each side that widening eats into: 4 * 64 > SF_REACH_MAX.
#define BLOCK 64
#define MARGIN 4
#define ROOM (MARGIN + BLOCK + MARGIN)

// What the result of a block is made of.
typedef struct view {
    sf_slice slice;
    const sf_element *element;
    uint64_t flip;    // all ones to complement what is read
    uint64_t outside; // what lies outside, after complementing: all ones or zero
    const sfi_kernels *kernels;
} view;

// acc |= row y of the view, words [first - MARGIN, first + count + MARGIN).
static void unite_row(const view *v, uint64_t *acc, long y, size_t first, size_t count)
{
    if (y < 0 || y >= (long)v->slice.height) {
        for (size_t i = 0; v->outside != 0 && i < MARGIN + count + MARGIN; i++) {
            acc[i] = v->outside;
        }
        return;
    }
    const uint64_t *row = sfi_slice_row(v->slice, (uint32_t)y);
    size_t words = sfi_row_words(v->slice.width);
    size_t from = first > MARGIN ? first - MARGIN : 0;
    size_t to = first + count + MARGIN < words ? first + count + MARGIN : words;
    uint64_t *into = acc + (from + MARGIN - first);
    if (v->flip == 0) {
        v->kernels->or_words(into, into, row + from, to - from);
    } else {
        for (size_t i = 0; i < to - from; i++) {
            into[i] |= ~row[from + i];
        }
    }
}

// Overwrite what lies left and right of the slice, the padding of its last word included.
static void put_outside(const view *v, uint64_t *acc, size_t first, size_t count)
{
    size_t words = sfi_row_words(v->slice.width);
    for (size_t i = 0; first + i < MARGIN; i++) {
        acc[i] = v->outside;
    }
    size_t last = words - 1 + MARGIN - first; // where the slice's last word stands, if in the block
    if (last < MARGIN + count + MARGIN) {
        uint64_t tail = sfi_tail_mask(v->slice.width);
        acc[last] = (acc[last] & tail) | (v->outside & ~tail);
        for (size_t i = last + 1; i < MARGIN + count + MARGIN; i++) {
            acc[i] = v->outside;
        }
    }
}

// acc = acc widened by s voxels, by way of other, which ends up holding it; returns that one. The
// outermost words are wrong by s voxels more after each call; the margin is wide enough for all.
static uint64_t *widen_by(const view *v, uint64_t *acc, uint64_t *other, unsigned s, size_t count)
{
    // One step by s would leave gaps. What covers [-r, r] can step by up to 2 r + 1: 1, 3, 9, 27,
    // ...
    unsigned reached = 0;
    while (reached < s) {
        unsigned step = s - reached < 2 * reached + 1 ? s - reached : 2 * reached + 1;
        step = step > 63 ? 63 : step;
        size_t total = MARGIN + count + MARGIN;
        v->kernels->widen(other + 1, acc + 1, step, total - 2);
        other[0] = acc[0];
        other[total - 1] = acc[total - 1];
        uint64_t *swap = acc;
        acc = other;
        other = swap;
        reached += step;
    }
    return acc;
}

// The dilated block; returns a pointer to its first word (past the margin).
static const uint64_t *dilate_block(const view *v, uint64_t rooms[2][ROOM], uint32_t y,
                                    size_t first, size_t count)
{
    uint64_t *acc = rooms[0];
    for (size_t i = 0; i < MARGIN + count + MARGIN; i++) {
        acc[i] = 0;
    }
    unsigned dy = 0;
    while (dy <= v->element->reach_y) {
        unsigned w = v->element->half_width[dy];
        for (; dy <= v->element->reach_y && v->element->half_width[dy] == w; dy++) {
            unite_row(v, acc, (long)y - (long)dy, first, count);
            if (dy > 0) {
                unite_row(v, acc, (long)y + (long)dy, first, count);
            }
        }
        put_outside(v, acc, first, count);
        unsigned narrower = dy <= v->element->reach_y ? v->element->half_width[dy] : 0;
        acc = widen_by(v, acc, acc == rooms[0] ? rooms[1] : rooms[0], w - narrower, count);
    }
    return acc + MARGIN;
}

// dst = dilation of the view, complemented by flip again, and with `keep` where that is given.
static void dilate(const view *v, sf_slice dst, const sf_slice *keep)
{
    size_t words = sfi_row_words(dst.width);
    uint64_t rooms[2][ROOM];
    for (size_t first = 0; first < words; first += BLOCK) {
        size_t count = words - first < BLOCK ? words - first : BLOCK;
        for (uint32_t y = 0; y < dst.height; y++) {
            const uint64_t *block = dilate_block(v, rooms, y, first, count);
            uint64_t *out = sfi_slice_row(dst, y) + first;
            if (keep != NULL) {
                v->kernels->and_words(out, sfi_slice_row(*keep, y) + first, block, count);
            } else {
                for (size_t i = 0; i < count; i++) {
                    out[i] = block[i] ^ v->flip;
                }
            }
            if (first + count == words) {
                out[count - 1] &= sfi_tail_mask(dst.width);
            }
        }
    }
}

static sf_status morph(sf_slice dst, sf_slice src, const sf_element *element, sf_border border,
                       uint64_t flip)
{
    SF_TRY(sfi_slice_validate_pair(dst, src));
    if (!sfi_element_is_valid(element) ||
        (border != SF_BORDER_EMPTY && border != SF_BORDER_SOLID) || sfi_slice_overlap(dst, src)) {
        return SF_ERR_ARGUMENT;
    }
    uint64_t outside = border == SF_BORDER_SOLID ? ~UINT64_C(0) : 0;
    view v = {src, element, flip, outside ^ flip, sfi_kernels_get()};
    dilate(&v, dst, NULL);
    return SF_OK;
}

sf_status sf_slice_dilate(sf_slice dst, sf_slice src, const sf_element *element, sf_border border)
{
    return morph(dst, src, element, border, 0);
}

sf_status sf_slice_erode(sf_slice dst, sf_slice src, const sf_element *element, sf_border border)
{
    return morph(dst, src, element, border, ~UINT64_C(0));
}

sf_status sf_slice_and_dilate(sf_slice dst, sf_slice src, sf_slice below, const sf_element *element)
{
    SF_TRY(sfi_slice_validate_pair(dst, src));
    SF_TRY(sfi_slice_validate_pair(dst, below));
    if (!sfi_element_is_valid(element) || sfi_slice_overlap(dst, below) ||
        (sfi_slice_overlap(dst, src) && !sfi_slice_same(dst, src))) {
        return SF_ERR_ARGUMENT;
    }
    const sfi_kernels *kernels = sfi_kernels_get();
    if (element->reach_y == 1 && element->half_width[0] == 1) {
        (element->half_width[1] == 1 ? kernels->trim_box3 : kernels->trim_plus3)(dst, src, below);
        return SF_OK;
    }
    view v = {below, element, 0, 0, kernels};
    dilate(&v, dst, &src);
    return SF_OK;
}
