// SPDX-License-Identifier: MIT
// States: copied, compared and counted within the boxes around what changed.

#include <string.h>

#include "base/status.h"
#include "sculpt/model.h"
#include "sculpt/rows.h"
#include "support/trim/trim_area.h"
#include "voxel/slice.h"

void sfi_touch_clear(sfi_touch *touch)
{
    sfi_area_clear(&touch->drawn);
    sfi_area_clear(&touch->printable);
    sfi_area_clear(&touch->material);
}

void sfi_touch_join(sfi_touch *to, const sfi_touch *from)
{
    sfi_area_join(&to->drawn, &from->drawn);
    sfi_area_join(&to->printable, &from->printable);
    sfi_area_join(&to->material, &from->material);
}

void sfi_sculpt_boxes(const sfi_touch *touched, sf_sculpt_change *change)
{
    change->drawn = sfi_area_bounds(&touched->drawn);
    change->printable = sfi_area_bounds(&touched->printable);
    change->material = sfi_area_bounds(&touched->material);
}

// Whole words: outside the area both states are the same.
static void copy_bits(sf_grid *to, const sf_grid *from, const sfi_area *area)
{
    for (uint32_t z = area->z0; z < area->z1; z++) {
        sf_slice out = sf_grid_slice(to, z), in = sf_grid_slice(from, z);
        sf_rect r = area->rects[z];
        size_t first = sfi_rect_first_word(r), end = sfi_rect_end_word(r);
        for (uint32_t y = r.y0; y < r.y1; y++) {
            memcpy(sfi_slice_row(out, y) + first, sfi_slice_row(in, y) + first,
                   (end - first) * sizeof(uint64_t));
        }
    }
}

void sfi_sculpt_copy(const sf_sculpt *m, const sfi_state *to, const sfi_state *from,
                     const sfi_touch *touched)
{
    const sfi_area *area = &touched->material;
    copy_bits(to->drawn, from->drawn, &touched->drawn);
    copy_bits(to->printable, from->printable, &touched->printable);
    for (uint32_t z = area->z0; z < area->z1; z++) {
        sf_rect r = area->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            memcpy(sfi_material_row(m, to, y, z) + r.x0, sfi_material_row(m, from, y, z) + r.x0,
                   r.x1 - r.x0);
        }
    }
}

static void note_bits(const sf_grid *a, const sf_grid *b, const sfi_area *within, sfi_area *differs)
{
    for (uint32_t z = within->z0; z < within->z1; z++) {
        sf_slice sa = sf_grid_slice(a, z), sb = sf_grid_slice(b, z);
        sf_rect r = within->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            const uint64_t *one = sfi_slice_row(sa, y), *other = sfi_slice_row(sb, y);
            for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
                sfi_area_note(differs, i, one[i] ^ other[i], y, z);
            }
        }
    }
}

// From the first byte that differs to the last.
static void note_bytes(const uint8_t *a, const uint8_t *b, sf_rect r, uint32_t y, uint32_t z,
                       sfi_area *differs)
{
    uint32_t x0 = r.x0, x1 = r.x1;
    if (x0 == x1 || memcmp(a + x0, b + x0, x1 - x0) == 0) {
        return;
    }
    while (a[x0] == b[x0]) {
        x0++;
    }
    while (a[x1 - 1] == b[x1 - 1]) {
        x1--;
    }
    sf_rect part = {x0, y, x1, y + 1};
    sfi_area_add(differs, part, z);
}

void sfi_drawn_differences(const sf_sculpt *m, const sfi_area *within, sfi_touch *differs)
{
    note_bits(m->now.drawn, m->before.drawn, within, &differs->drawn);
    for (uint32_t z = within->z0; z < within->z1; z++) {
        sf_rect r = within->rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            note_bytes(sfi_material_row(m, &m->now, y, z), sfi_material_row(m, &m->before, y, z), r,
                       y, z, &differs->material);
        }
    }
}

void sfi_printable_differences(const sf_sculpt *m, const sfi_area *within, sfi_area *differs)
{
    note_bits(m->now.printable, m->before.printable, within, differs);
}

sf_status sfi_sculpt_trim(sf_sculpt *m, const sfi_area *changed)
{
    return sfi_trim_area(m->now.drawn, m->now.printable, &m->terms.rule, m->terms.bed_layer,
                         changed, &m->called.printable);
}

// ---------------------------------------------------------------------------------------------
// Counting
// ---------------------------------------------------------------------------------------------

// Of the tips, what a brush of this kind kept back, in terms of what is printable now.
static uint64_t kept_back(sf_brush_kind kind, uint64_t tips, uint64_t now)
{
    switch (kind) {
    case SF_BRUSH_ADD_TRIM:
    case SF_BRUSH_ADD_GROW:
        return tips & ~now;
    case SF_BRUSH_REMOVE_PRESERVE:
        return tips & now;
    default:
        return 0;
    }
}

// The counts of one word of before and now and of the tips.
static void count_word(sf_brush_kind kind, uint64_t before, uint64_t now, uint64_t tips,
                       sf_sculpt_change *change)
{
    uint64_t gone = before & ~now, kept = kept_back(kind, tips, now);
    if (now != before) {
        change->added_voxels += sfi_count_bits(now & ~before);
        change->removed_voxels += sfi_count_bits(gone & tips);
        change->lost_voxels += sfi_count_bits(gone & ~tips);
    }
    if (kept != 0) {
        change->kept_back_voxels += sfi_count_bits(kept);
    }
}

// The counts of one row.
static void count_row(const sf_sculpt *m, sf_rect r, const uint64_t *before, const uint64_t *now,
                      const uint64_t *tips, sf_sculpt_change *change)
{
    for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
        count_word(m->brush.kind, before[i], now[i], tips[i], change);
    }
}

void sfi_sculpt_count(const sf_sculpt *m, sf_sculpt_change *change)
{
    const sfi_area *a = &m->touched.printable, *b = &m->in_tips;
    uint32_t z0 = sfi_area_is_empty(a) ? b->z0 : a->z0, z1 = a->z1 > b->z1 ? a->z1 : b->z1;
    z0 = !sfi_area_is_empty(b) && b->z0 < z0 ? b->z0 : z0;
    for (uint32_t z = z0; z < z1; z++) {
        sf_slice now = sf_grid_slice(m->now.printable, z), tips = sf_grid_slice(m->tips, z);
        sf_slice before = sf_grid_slice(m->before.printable, z);
        sf_rect r = sfi_rect_union(sfi_area_rect(a, z), sfi_area_rect(b, z));
        for (uint32_t y = r.y0; y < r.y1; y++) {
            count_row(m, r, sfi_slice_row(before, y), sfi_slice_row(now, y), sfi_slice_row(tips, y),
                      change);
        }
    }
    change->path_voxels = m->path_voxels;
}
