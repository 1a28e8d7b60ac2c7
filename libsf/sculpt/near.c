// SPDX-License-Identifier: MIT
// How near the voxels of a slice are to what stands in it, in steps of an element.
//
// By dilating again and again, ring after ring. For the square and the plus, which are the steps of
// nearly all rules, a ring is one pass over words: dilation, rectangle, what is new and whether
// anything is. Windows are a few words wide, so that calls of kernels would cost more than they do.

#include "sculpt/near.h"

#include "base/status.h"
#include "voxel/slice.h"

// A word with its neighbours along the row.
static uint64_t widen(const uint64_t *row, size_t i, size_t words)
{
    uint64_t low = i > 0 ? row[i - 1] >> 63 : 0, high = i + 1 < words ? row[i + 1] << 63 : 0;
    return row[i] | row[i] << 1 | row[i] >> 1 | low | high;
}

// to = from and one step more; what is new also goes into the ring. Returns what was new anywhere.
static uint64_t grow(sf_slice to, sf_slice from, sf_slice within, sf_slice ring, int is_square)
{
    size_t words = sfi_row_words(from.width);
    uint64_t any = 0;
    for (uint32_t y = 0; y < from.height; y++) {
        const uint64_t *here = sfi_slice_row(from, y);
        const uint64_t *below = y > 0 ? sfi_slice_row(from, y - 1) : here;
        const uint64_t *above = y + 1 < from.height ? sfi_slice_row(from, y + 1) : here;
        const uint64_t *inside = sfi_slice_row(within, y);
        uint64_t *out = sfi_slice_row(to, y), *band = sfi_slice_row(ring, y);
        for (size_t i = 0; i < words; i++) {
            uint64_t beside =
                is_square ? widen(below, i, words) | widen(above, i, words) : below[i] | above[i];
            uint64_t fresh = (widen(here, i, words) | beside) & inside[i] & ~here[i];
            out[i] = here[i] | fresh;
            band[i] |= fresh;
            any |= fresh;
        }
    }
    return any;
}

static int is_all_in(sf_slice wanted, sf_slice reached)
{
    size_t words = sfi_row_words(wanted.width);
    uint64_t missing = 0;
    for (uint32_t y = 0; y < wanted.height; y++) {
        const uint64_t *a = sfi_slice_row(wanted, y), *b = sfi_slice_row(reached, y);
        for (size_t i = 0; i < words; i++) {
            missing |= a[i] & ~b[i];
        }
    }
    return missing == 0;
}

// The same for any element.
static sf_status grow_any(const sf_element *e, sf_slice to, sf_slice from, sf_slice within,
                          sf_slice ring, uint64_t *any)
{
    SF_TRY(sf_slice_dilate(to, from, e, SF_BORDER_EMPTY));
    *any = 0;
    for (uint32_t y = 0; y < to.height; y++) {
        const uint64_t *here = sfi_slice_row(from, y), *inside = sfi_slice_row(within, y);
        uint64_t *out = sfi_slice_row(to, y), *band = sfi_slice_row(ring, y);
        for (size_t i = 0; i < sfi_row_words(to.width); i++) {
            uint64_t fresh = out[i] & inside[i] & ~here[i];
            out[i] = here[i] | fresh;
            band[i] |= fresh;
            *any |= fresh;
        }
    }
    return SF_OK;
}

sf_status sfi_find_near(const sf_element *element, sf_slice fixed, sf_slice within, sf_slice wanted,
                        const sf_slice rings[3], sf_slice reached, sf_slice scratch)
{
    const sf_element *e = element;
    int is_small = e->reach_y == 1 && e->half_width[0] == 1 && e->half_width[1] <= 1;
    SF_TRY(sf_slice_and(reached, fixed, within));
    SF_TRY(sf_slice_copy(rings[0], reached));
    for (int i = 1; i < 3; i++) {
        sfi_slice_clear(rings[i]);
    }
    for (int d = 1; !is_all_in(wanted, reached); d++) {
        uint64_t any = 0;
        if (is_small) {
            any = grow(scratch, reached, within, rings[d % 3], e->half_width[1] == 1);
        } else {
            SF_TRY(grow_any(e, scratch, reached, within, rings[d % 3], &any));
        }
        if (any == 0) {
            break;
        }
        sf_slice swap = reached;
        reached = scratch;
        scratch = swap;
    }
    return SF_OK;
}
