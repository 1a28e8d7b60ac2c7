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
// widening by a and then by b is widening by a + b). The last step of a widening unites the rows of
// the next half width in the same pass, so an element of reach r costs 2 r + 1 row loads and about
// r passes over a block of columns that stays in the first cache.
//
// Erosion is dilation of the complement: rows are complemented as they are read, with the border
// complemented too, and the result is complemented back. Where the border is solid (after that), a
// row that reaches beyond the first or the last row of the slice is solid all along. Freestanding;
// the scratch is on the stack.

#include "base/bytes.h"
#include "base/status.h"
#include "voxel/element.h"
#include "voxel/slice.h"

// Words of a block; of the most that widening eats from each side of it (4 * 64 > SF_REACH_MAX);
// and of room for what stands beside that, so that blocks begin on a line of the cache.
#define BLOCK 64
#define MARGIN_MAX 4
#define BESIDE 8
#define ROOM (BESIDE + MARGIN_MAX + BLOCK + MARGIN_MAX + BESIDE)
#define LINE 8

// What is dilated, and a block of its columns.
typedef struct block {
    sf_slice slice;
    const sf_element *element;
    uint64_t flip;    // all ones to complement what is read
    uint64_t outside; // what lies outside, after complementing: all ones or zero
    const sfi_kernels *kernels;
    size_t first, count; // words of the result
    size_t from, span;   // words that are computed: the result's and margins, within the slice
    uint64_t *rooms[2];  // word `from` stands at [0], and what lies outside at [-1] and [span]
} block;

// Complete what a pass has written: the padding of the slice's last word lies outside.
static void seal(const block *b, uint64_t *words)
{
    uint64_t tail = sfi_tail_mask(b->slice.width);
    if (b->from + b->span == sfi_row_words(b->slice.width) && tail != ~UINT64_C(0)) {
        words[b->span - 1] = (words[b->span - 1] & tail) | (b->outside & ~tail);
    }
}

// The rows at distance *dy from y and all further ones of the same half width, in pairs; *dy
// becomes the next distance. A row that the slice lacks is replaced by its opposite.
static size_t gather(const block *b, uint32_t y, unsigned *dy, const uint64_t **rows)
{
    const sf_element *e = b->element;
    size_t count = 0;
    unsigned w = e->half_width[*dy];
    for (; *dy <= e->reach_y && e->half_width[*dy] == w; ++*dy) {
        int lower = y >= *dy, upper = b->slice.height - y > *dy;
        if (lower || upper) {
            rows[count++] = sfi_slice_row(b->slice, lower ? y - *dy : y + *dy) + b->from;
            rows[count++] = sfi_slice_row(b->slice, upper ? y + *dy : y - *dy) + b->from;
        }
    }
    return count;
}

// Widen what is in room `at` by s voxels and unite it with rows; returns the room of the result.
//
// One step by s would leave gaps. What covers [-r, r] could step by 2 r + 1; but what leaves the
// slice is forgotten after each step, so a voxel at the border covers [0, r] only, and the step is
// r + 1: 1, 2, 4, 8, ...
static int widen_by(const block *b, int at, unsigned s, const uint64_t *const *rows, size_t count)
{
    unsigned reached = 0;
    while (reached < s) {
        unsigned step = s - reached < reached + 1 ? s - reached : reached + 1;
        step = step > 63 ? 63 : step;
        reached += step;
        b->kernels->widen(b->rooms[!at], b->rooms[at], step, rows, reached == s ? count : 0,
                          b->flip, b->span);
        at = !at;
        seal(b, b->rooms[at]);
    }
    return at;
}

// Row y of the dilated block.
static const uint64_t *dilate_row(const block *b, uint32_t y)
{
    const uint64_t *rows[2 * (SF_REACH_MAX + 1)];
    const sf_element *e = b->element;
    if (b->outside != 0 && (y < e->reach_y || b->slice.height - y <= e->reach_y)) {
        memset(b->rooms[0], 0xff, b->span * sizeof(uint64_t));
        return b->rooms[0] + (b->first - b->from);
    }
    unsigned dy = 0, w = e->half_width[0];
    size_t count = gather(b, y, &dy, rows);
    int at = 0;
    b->kernels->unite(b->rooms[0], rows, count, b->flip, b->span);
    seal(b, b->rooms[0]);
    while (w > 0) {
        unsigned narrower = dy <= e->reach_y ? e->half_width[dy] : 0;
        count = dy <= e->reach_y ? gather(b, y, &dy, rows) : 0;
        at = widen_by(b, at, w - narrower, rows, count);
        w = narrower;
    }
    return b->rooms[at] + (b->first - b->from);
}

// dst = the dilated block, complemented by flip again, and with `keep` where that is given.
static void dilate_block(const block *b, sf_slice dst, const sf_slice *keep)
{
    int ends = b->first + b->count == sfi_row_words(dst.width);
    for (uint32_t y = 0; y < dst.height; y++) {
        const uint64_t *row = dilate_row(b, y);
        uint64_t *out = sfi_slice_row(dst, y) + b->first;
        if (keep != NULL) {
            b->kernels->and_words(out, sfi_slice_row(*keep, y) + b->first, row, b->count);
        } else if (b->flip == 0) {
            memcpy(out, row, b->count * sizeof *out);
        } else {
            const uint64_t *same[2] = {row, row};
            b->kernels->unite(out, same, 2, b->flip, b->count);
        }
        if (ends) {
            out[b->count - 1] &= sfi_tail_mask(dst.width);
        }
    }
}

static void dilate(block *b, sf_slice dst, const sf_slice *keep)
{
    uint64_t memory[2][ROOM + LINE];
    size_t words = sfi_row_words(dst.width);
    size_t margin = b->element->half_width[0] / 64u + 1;
    for (int i = 0; i < 2; i++) {
        size_t off = (uintptr_t)memory[i] / sizeof(uint64_t) % LINE;
        b->rooms[i] = memory[i] + (LINE - off) % LINE + BESIDE;
    }
    for (b->first = 0; b->first < words; b->first += BLOCK) {
        b->count = words - b->first < BLOCK ? words - b->first : BLOCK;
        b->from = b->first > margin ? b->first - margin : 0;
        size_t end = b->first + b->count + margin;
        b->span = (end < words ? end : words) - b->from;
        for (int i = 0; i < 2; i++) {
            b->rooms[i][-1] = b->rooms[i][b->span] = b->outside;
        }
        dilate_block(b, dst, keep);
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
    block b = {src, element, flip, outside ^ flip, sfi_kernels_get(), 0, 0, 0, 0, {NULL, NULL}};
    dilate(&b, dst, NULL);
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
    block b = {below, element, 0, 0, kernels, 0, 0, 0, 0, {NULL, NULL}};
    dilate(&b, dst, &src);
    return SF_OK;
}
