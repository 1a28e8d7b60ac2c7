// SPDX-License-Identifier: MIT
// How near the voxels of a patch are to what stands in it, in steps of an element.
//
// By dilating again and again, ring after ring. For the square and the plus, which are the steps of
// nearly all rules, a ring is two passes over a string of words: wider, and then what is new; other
// elements are dilated as slices are.
//
// What is d steps away is told by what lies within d steps of it. So where a patch ends `limit`
// steps beside what is wanted, that many rings are right there, and ring d is asked for only within
// limit - d steps of it.

#include "sculpt/near.h"

#include <string.h>

#include "base/status.h"
#include "voxel/slice.h"

static uint64_t *row_of(const sfi_patch *p, uint64_t *plane, uint32_t y)
{
    return plane + y * p->stride;
}

static void fill_inside(const sfi_near *n)
{
    const sfi_patch *p = &n->patch;
    uint64_t tail = (UINT64_C(1) << (p->rect.x1 - p->rect.x0) % 64) - 1;
    for (uint32_t y = 0; y < p->height; y++) {
        uint64_t *row = row_of(p, n->inside, y);
        memset(row, 0xff, (p->stride - 1) * sizeof *row);
        row[p->stride - 1] = tail;
    }
}

// The rows that ring d is asked for.
static sfi_rows rows_of_ring(const sfi_near *n, uint32_t d)
{
    sfi_rows all = {0, n->patch.height};
    if (n->limit == 0) {
        return all;
    }
    sfi_rows rows = sfi_rows_grow(n->rows, (int64_t)(n->limit - d) * n->element->reach_y);
    rows.first = rows.first > all.first ? rows.first : all.first;
    rows.end = rows.end < all.end ? rows.end : all.end;
    return rows;
}

// other = reached and one step more, of a plus or a square; what is new also goes into the ring.
// Returns what was new anywhere.
static uint64_t step_small(const sfi_near *n, sfi_step_shape shape, uint64_t *into, sfi_rows rows)
{
    int64_t stride = (int64_t)n->patch.stride;
    const uint64_t *from = n->reached, *inside = n->inside, *wide = n->wide;
    const uint64_t *beside = shape == SFI_STEP_SQUARE ? wide : from;
    uint64_t *restrict out = n->other, *restrict ring = into, any = 0;
    sfi_patch_widen(&n->patch, n->wide, from, sfi_rows_grow(rows, 1));
    for (int64_t i = rows.first * stride; i < rows.end * stride; i++) {
        uint64_t fresh = (wide[i] | beside[i - stride] | beside[i + stride]) & inside[i] & ~from[i];
        out[i] = from[i] | fresh;
        ring[i] |= fresh;
        any |= fresh;
    }
    return any;
}

// The same for any element.
static sf_status step_any(const sfi_near *n, uint64_t *ring, uint64_t *any)
{
    const sfi_patch *p = &n->patch;
    SF_TRY(sf_slice_dilate(sfi_patch_slice(p, n->other), sfi_patch_slice(p, n->reached), n->element,
                           SF_BORDER_EMPTY));
    *any = 0;
    for (size_t i = 0; i < p->stride * p->height; i++) {
        uint64_t fresh = n->other[i] & n->inside[i] & ~n->reached[i];
        n->other[i] = n->reached[i] | fresh;
        ring[i] |= fresh;
        *any |= fresh;
    }
    return SF_OK;
}

static int is_all_reached(const sfi_near *n)
{
    int64_t stride = (int64_t)n->patch.stride;
    uint64_t missing = 0;
    for (int64_t i = n->rows.first * stride; i < n->rows.end * stride; i++) {
        missing |= n->wanted[i] & ~n->reached[i];
    }
    return missing == 0;
}

sf_status sfi_find_near(sfi_near *near, uint32_t *steps, int *is_all)
{
    const sfi_patch *p = &near->patch;
    size_t bytes = p->stride * p->height * sizeof(uint64_t);
    sfi_step_shape shape = sfi_step_shape_of(near->element);
    uint64_t any = 1;
    fill_inside(near);
    memcpy(near->rings[0], near->reached, bytes);
    *is_all = is_all_reached(near);
    uint32_t d = 0;
    while (!*is_all && any != 0 && (near->limit == 0 || d < near->limit)) {
        d++;
        if (shape != SFI_STEP_OTHER) {
            any = step_small(near, shape, near->rings[d % 3], rows_of_ring(near, d));
        } else {
            SF_TRY(step_any(near, near->rings[d % 3], &any));
        }
        uint64_t *swap = near->reached;
        near->reached = near->other;
        near->other = swap;
        *is_all = is_all_reached(near);
    }
    *steps = d;
    return SF_OK;
}
