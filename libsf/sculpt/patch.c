// SPDX-License-Identifier: MIT
// Patches: filled, widened, and what a step of one reaches taken from another.

#include "sculpt/patch.h"

#include <string.h>

#include "voxel/slice.h"

// Rows that lie around a plane before and after.
#define ROWS_AROUND 2u

sfi_patch sfi_patch_make(sf_rect rect)
{
    sfi_patch patch = {rect, rect.y1 - rect.y0, (rect.x1 - rect.x0) / 64 + 1};
    return patch;
}

size_t sfi_patch_room(uint32_t width, uint32_t height)
{
    return (width / 64 + 1) * ((size_t)height + 2 * ROWS_AROUND) + 2;
}

uint64_t *sfi_patch_place(const sfi_patch *p, uint64_t *memory)
{
    size_t around = ROWS_AROUND * p->stride + 1;
    memset(memory, 0, (2 * around + p->stride * p->height) * sizeof *memory);
    return memory + around;
}

void sfi_patch_load(const sfi_patch *p, uint64_t *plane, sf_slice slice, uint32_t x0, uint32_t y0)
{
    sf_rect r = p->rect;
    uint32_t first = r.y0 > y0 ? r.y0 : y0;
    uint32_t end = r.y1 < y0 + slice.height ? r.y1 : y0 + slice.height;
    int64_t by = (int64_t)r.x0 - x0;
    size_t words = sfi_row_words(slice.width), last = p->stride - 1;
    uint64_t tail = (UINT64_C(1) << (r.x1 - r.x0) % 64) - 1;
    for (uint32_t y = first; y < end; y++) {
        const uint64_t *from = sfi_slice_row(slice, y - y0);
        uint64_t *to = plane + (y - r.y0) * p->stride;
        for (size_t i = 0; i < last; i++) {
            to[i] |= sfi_moved_word(from, words, i, by);
        }
        to[last] |= sfi_moved_word(from, words, last, by) & tail;
    }
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

sfi_step_shape sfi_step_shape_of(const sf_element *element)
{
    int is_small = element->reach_y == 1 && element->half_width[0] == 1;
    unsigned beside = element->half_width[1];
    return !is_small || beside > 1 ? SFI_STEP_OTHER : beside == 1 ? SFI_STEP_SQUARE : SFI_STEP_PLUS;
}

void sfi_patch_widen(const sfi_patch *p, uint64_t *to, const uint64_t *from, sfi_rows rows)
{
    int64_t stride = (int64_t)p->stride;
    uint64_t *restrict out = to;
    for (int64_t i = rows.first * stride; i < rows.end * stride; i++) {
        out[i] = from[i] | from[i] << 1 | from[i] >> 1 | from[i - 1] >> 63 | from[i + 1] << 63;
    }
}

int sfi_patch_subtract_step(const sfi_patch *p, sfi_step_shape shape, uint64_t *from,
                            const uint64_t *taken, uint64_t *scratch, sfi_rows rows)
{
    int64_t stride = (int64_t)p->stride;
    const uint64_t *wide = scratch, *beside = shape == SFI_STEP_SQUARE ? scratch : taken;
    uint64_t *restrict out = from, left = 0;
    sfi_patch_widen(p, scratch, taken, sfi_rows_grow(rows, 1));
    for (int64_t i = rows.first * stride; i < rows.end * stride; i++) {
        out[i] &= ~(wide[i] | beside[i - stride] | beside[i + stride]);
        left |= out[i];
    }
    return left != 0;
}
