// SPDX-License-Identifier: MIT
// Brushes that set voxels or bytes where their tips are: add-trim, remove-trim, paint.
//
// What they do to D in a voxel depends on nothing around it, so each call looks only at the
// rectangles around its own dabs, whatever came before; tips that lie there already change nothing
// again. T follows by the incremental trim.

#include "base/status.h"
#include "sculpt/model.h"
#include "sculpt/rows.h"
#include "voxel/slice.h"

// D gains U (or loses it) in word i of a row, with materials; says which bits changed.
static uint64_t set_word(uint64_t *drawn, uint64_t tips, int is_added)
{
    uint64_t changed = is_added ? tips & ~*drawn : tips & *drawn;
    *drawn ^= changed;
    return changed;
}

static sf_status set(sf_sculpt *m, int is_added)
{
    uint8_t material = is_added ? m->brush.material : 0;
    sfi_area *changed = &m->work;
    sfi_area_clear(changed);
    for (uint32_t z = m->fresh.z0; z < m->fresh.z1; z++) {
        sf_slice drawn = sf_grid_slice(m->now.drawn, z), tips = sf_grid_slice(m->tips, z);
        sf_rect r = m->fresh.rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            uint64_t *d = sfi_slice_row(drawn, y);
            const uint64_t *u = sfi_slice_row(tips, y);
            uint8_t *materials = sfi_material_row(m, &m->now, y, z);
            for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
                uint64_t bits = set_word(&d[i], u[i], is_added);
                sfi_bytes_set(materials, i, bits, material);
                sfi_area_note(changed, i, bits, y, z);
            }
        }
    }
    sfi_area_join(&m->called.drawn, changed);
    sfi_area_join(&m->called.material, changed);
    return sfi_sculpt_trim(m, changed);
}

sf_status sfi_brush_add(sf_sculpt *m)
{
    return set(m, 1);
}

sf_status sfi_brush_remove(sf_sculpt *m)
{
    return set(m, 0);
}

// The bits of word i whose byte is not `value`.
static uint64_t bits_to_paint(const uint8_t *row, size_t i, uint64_t bits, uint8_t value)
{
    uint64_t other = 0;
    for (uint64_t left = bits; left != 0; left &= left - 1) {
        uint32_t bit = sfi_lowest_bit(left);
        other |= (uint64_t)(row[i * 64 + bit] != value) << bit;
    }
    return other;
}

sf_status sfi_brush_paint(sf_sculpt *m)
{
    uint8_t material = m->brush.material;
    for (uint32_t z = m->fresh.z0; z < m->fresh.z1; z++) {
        sf_slice drawn = sf_grid_slice(m->now.drawn, z), tips = sf_grid_slice(m->tips, z);
        sf_rect r = m->fresh.rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            const uint64_t *d = sfi_slice_row(drawn, y), *u = sfi_slice_row(tips, y);
            uint8_t *materials = sfi_material_row(m, &m->now, y, z);
            for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
                uint64_t bits = bits_to_paint(materials, i, d[i] & u[i], material);
                sfi_bytes_set(materials, i, bits, material);
                sfi_area_note(&m->called.material, i, bits, y, z);
            }
        }
    }
    return SF_OK;
}
