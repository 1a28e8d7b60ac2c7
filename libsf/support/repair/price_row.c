// SPDX-License-Identifier: MIT
// Rows of the price map: minima of int16_t that any compiler turns into vectors.
//
// Bits become lanes of all ones or none by a table of bytes, so that everything after is arithmetic
// without branches. The minimum over an element is made one row at a time:
//
//     least(x) = min over dy of min over |dx| <= w(dy) of below(y + dy, x + dx)
//
// Rows that share w are merged first. Let m_n(x) be the minimum of n elements from x on; m_2n(x) =
// min(m_n(x), m_n(x + n)), and any other width is two of these that overlap. That is van Herk's
// problem without his blocks, which for widths below 16 or so only get in the way of vectors.
//
// Under slack each voxel below offers a price and a code, and the least price is taken, then the
// most that any of that price leaves. Codes are int16_t here too, so that both go through the same
// lanes: what is dearer than the least yet is masked out, what is cheaper masks out the most yet.

#include "support/repair/price_row.h"

#include "base/memory.h"
#include "base/size.h"

#define ROWS 6

sf_status sfi_price_lanes_create(sfi_price_lanes *lanes, const sfi_plane *plane,
                                 const sf_allocator *allocator)
{
    *lanes = (sfi_price_lanes){0};
    lanes->width = (plane->stride + 127) & ~(size_t)63;
    size_t count;
    if (!sfi_size_mul(lanes->width, ROWS, &count)) {
        return SF_ERR_OVERFLOW;
    }
    lanes->memory = sfi_alloc_array(allocator, count, sizeof(int16_t));
    if (lanes->memory == NULL) {
        return SF_ERR_MEMORY;
    }
    int16_t **rows[ROWS] = {&lanes->add,   &lanes->inside, &lanes->exempt,
                            &lanes->least, &lanes->left,   &lanes->merged};
    for (size_t i = 0; i < ROWS; i++) {
        // Merged rows reach out on both sides; the others begin at voxel 0.
        *rows[i] = lanes->memory + i * lanes->width + (i == ROWS - 1 ? plane->reach_x : 0);
    }
    return SF_OK;
}

void sfi_price_lanes_destroy(sfi_price_lanes *lanes, const sf_allocator *allocator)
{
    sfi_free_array(allocator, lanes->memory, lanes->width * ROWS, sizeof(int16_t));
    *lanes = (sfi_price_lanes){0};
}

// Lanes of all ones for the set bits of the words that hold voxels x0..x1 - 1.
static void expand(const uint64_t *row, int16_t *lanes, uint32_t x0, uint32_t x1)
{
    for (uint32_t i = x0 / 64; i < (x1 + 63) / 64; i++) {
        uint64_t w = row[i];
        int16_t *out = lanes + (size_t)i * 64;
        if (w == 0 || w == ~UINT64_C(0)) {
            int16_t all = (int16_t)(w == 0 ? 0 : -1);
            for (int b = 0; b < 64; b++) {
                out[b] = all;
            }
            continue;
        }
        for (int b = 0; b < 64; b++) {
            out[b] = (int16_t) - (int16_t)(w >> b & 1);
        }
    }
}

void sfi_price_lanes_load(sfi_price_lanes *lanes, const sfi_price_voxels *voxels, uint32_t x0,
                          uint32_t x1)
{
    int16_t *restrict add = lanes->add;
    const int16_t *restrict free = lanes->merged;
    lanes->has_exempt = voxels->exempt != NULL;
    expand(voxels->room, lanes->inside, x0, x1);
    if (lanes->has_exempt) {
        expand(voxels->exempt, lanes->exempt, x0, x1);
    }
    expand(voxels->free, lanes->merged, x0, x1);
    const int16_t scale = voxels->scale;
    if (voxels->add == NULL) {
        for (uint32_t x = x0; x < x1; x++) {
            add[x] = (int16_t)(scale & ~free[x]);
        }
        return;
    }
    const uint8_t *restrict costs = voxels->add;
    for (uint32_t x = x0; x < x1; x++) {
        add[x] = (int16_t)((costs[x] * scale) & ~free[x]);
    }
}

void sfi_price_free_row(sfi_price_lanes *lanes, uint32_t x0, uint32_t x1)
{
    for (uint32_t x = x0; x < x1; x++) {
        lanes->least[x] = SFI_PRICE_FREE;
    }
}

static void least_of_3x3(sfi_price_lanes *lanes, size_t stride, const int16_t *below, int32_t x0,
                         int32_t x1)
{
    const int16_t *restrict a = below - stride, *restrict b = below, *restrict c = below + stride;
    int16_t *restrict m = lanes->merged, *restrict out = lanes->least;
    for (int32_t x = x0 - 1; x < x1 + 1; x++) {
        int16_t least = a[x] < b[x] ? a[x] : b[x];
        m[x] = least < c[x] ? least : c[x];
    }
    for (int32_t x = x0; x < x1; x++) {
        int16_t least = m[x - 1] < m[x] ? m[x - 1] : m[x];
        out[x] = least < m[x + 1] ? least : m[x + 1];
    }
}

// row[x] = min(row[x], other[x]) for from <= x < to.
static void merge(int16_t *restrict row, const int16_t *restrict other, int32_t from, int32_t to)
{
    for (int32_t x = from; x < to; x++) {
        row[x] = row[x] < other[x] ? row[x] : other[x];
    }
}

// Merge the rows at distance dy above and below into merged, reaching out by w.
static void merge_pair(sfi_price_lanes *lanes, size_t stride, const int16_t *below, uint32_t dy,
                       int32_t from, int32_t to)
{
    merge(lanes->merged, below + dy * stride, from, to);
    if (dy > 0) {
        merge(lanes->merged, below - dy * stride, from, to);
    }
}

// least = min(least, minimum of merged over x - w .. x + w). merged is used up.
static void widen_into(sfi_price_lanes *lanes, int32_t w, int32_t x0, int32_t x1)
{
    int16_t *m = lanes->merged;
    int32_t have = 1, want = 2 * w + 1;
    while (2 * have <= want) {
        // In place: element x takes from x + have, which has not been changed yet.
        for (int32_t x = x0 - w; x < x1 + w + 1 - 2 * have; x++) {
            m[x] = m[x] < m[x + have] ? m[x] : m[x + have];
        }
        have *= 2;
    }
    const int16_t *left = m - w, *right = m + w + 1 - have;
    for (int32_t x = x0; x < x1; x++) {
        int16_t least = left[x] < right[x] ? left[x] : right[x];
        lanes->least[x] = lanes->least[x] < least ? lanes->least[x] : least;
    }
}

void sfi_price_least_row(sfi_price_lanes *lanes, const sfi_plane *plane, const int16_t *below,
                         const sf_element *e, uint32_t x0, uint32_t x1)
{
    int32_t from = (int32_t)x0, to = (int32_t)x1;
    if (e->reach_y == 1 && e->half_width[0] == 1 && e->half_width[1] == 1) {
        least_of_3x3(lanes, plane->stride, below, from, to);
        return;
    }
    for (uint32_t x = x0; x < x1; x++) {
        lanes->least[x] = SFI_PRICE_NONE;
    }
    for (uint32_t dy = 0; dy <= e->reach_y;) {
        int32_t w = e->half_width[dy];
        for (int32_t x = from - w; x < to + w; x++) {
            lanes->merged[x] = SFI_PRICE_NONE;
        }
        for (; dy <= e->reach_y && e->half_width[dy] == w; dy++) {
            merge_pair(lanes, plane->stride, below, dy, from - w, to + w);
        }
        widen_into(lanes, w, from, to);
    }
}

void sfi_price_add_row(const sfi_price_lanes *lanes, int16_t *row, uint32_t x0, uint32_t x1)
{
    const int16_t *restrict least = lanes->least, *restrict add = lanes->add;
    const int16_t *restrict inside = lanes->inside, *restrict exempt = lanes->exempt;
    int16_t *restrict out = row;
    if (lanes->has_exempt) {
        int16_t *restrict writable = lanes->least;
        for (uint32_t x = x0; x < x1; x++) {
            writable[x] = exempt[x] != 0 ? SFI_PRICE_FREE : writable[x];
        }
    }
    for (uint32_t x = x0; x < x1; x++) {
        int16_t most = (int16_t)(SFI_PRICE_MOST - add[x]);
        int16_t price = least[x] < most ? least[x] : most;
        price = (int16_t)(price + add[x]);
        out[x] = (int16_t)((price & inside[x]) | (SFI_PRICE_NONE & ~inside[x]));
    }
}

// ---------------------------------------------------------------------------------------------
// Under slack
// ---------------------------------------------------------------------------------------------

// least, left = the better of themselves and what the voxels at an offset below offer. Who has a
// code of at most `floor` offers nothing; price and code of those are 0 or without meaning.
static void take_offers(int16_t *restrict least, int16_t *restrict left,
                        const int16_t *restrict prices, const int16_t *restrict codes,
                        int16_t change, int16_t top, uint32_t count)
{
    const int16_t floor = change < 0 ? (int16_t)-change : 0;
    for (uint32_t x = 0; x < count; x++) {
        int16_t able = (int16_t) - (int16_t)(codes[x] > floor);
        int16_t code = (int16_t)(codes[x] + change);
        code = code < top ? code : top;
        code = (int16_t)(code & able);
        int16_t price = (int16_t)((prices[x] & able) | (SFI_PRICE_NONE & ~able));
        int16_t is_cheaper = (int16_t) - (int16_t)(price < least[x]);
        int16_t is_dearer = (int16_t) - (int16_t)(price > least[x]);
        int16_t kept = (int16_t)(left[x] & ~is_cheaper), offered = (int16_t)(code & ~is_dearer);
        left[x] = kept > offered ? kept : offered;
        least[x] = price < least[x] ? price : least[x];
    }
}

// What is exempt costs nothing, and has a code of 1 at least.
static void spare_exempt(const sfi_price_lanes *lanes, uint32_t x0, uint32_t x1)
{
    int16_t *restrict least = lanes->least, *restrict left = lanes->left;
    const int16_t *restrict exempt = lanes->exempt;
    for (uint32_t x = x0; x < x1; x++) {
        int16_t changed = (int16_t)(exempt[x] & -(int16_t)(least[x] != SFI_PRICE_FREE));
        least[x] = (int16_t)((least[x] & ~changed) | (SFI_PRICE_FREE & changed));
        left[x] = (int16_t)((left[x] & ~changed) | (1 & changed));
    }
}

void sfi_price_label_row(sfi_price_lanes *lanes, const sfi_price_labels *l, int is_bed, uint32_t x0,
                         uint32_t x1)
{
    for (uint32_t x = x0; x < x1; x++) {
        lanes->least[x] = (int16_t)(is_bed ? SFI_PRICE_FREE : SFI_PRICE_NONE);
        lanes->left[x] = (int16_t)(is_bed ? l->top : 0);
    }
    for (size_t s = 0; !is_bed && s < l->step_count; s++) {
        int32_t change = (int32_t)l->gain - (int32_t)l->steps[s].cost;
        ptrdiff_t from = l->steps[s].offset + (ptrdiff_t)x0;
        if (change + l->top > 0) {
            change = change < l->top ? change : l->top;
            take_offers(lanes->least + x0, lanes->left + x0, l->below + from, l->low_codes + from,
                        (int16_t)change, l->top, x1 - x0);
        }
    }
    if (lanes->has_exempt) {
        spare_exempt(lanes, x0, x1);
    }
    const int16_t *restrict least = lanes->least, *restrict left = lanes->left;
    const int16_t *restrict add = lanes->add, *restrict inside = lanes->inside;
    int16_t *restrict here = l->here, *restrict codes = l->codes;
    for (uint32_t x = x0; x < x1; x++) {
        int16_t is_possible = (int16_t)(inside[x] & -(int16_t)(left[x] > 0));
        int16_t most = (int16_t)(SFI_PRICE_MOST - add[x]);
        int16_t price = (int16_t)((least[x] < most ? least[x] : most) + add[x]);
        here[x] = (int16_t)((price & is_possible) | (SFI_PRICE_NONE & ~is_possible));
        codes[x] = (int16_t)(left[x] & is_possible);
    }
}
