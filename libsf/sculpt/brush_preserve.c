// SPDX-License-Identifier: MIT
// Remove-preserve: remove the tips, and keep of them what carries the rest.
//
// What is kept is what sf_grid_preserve() keeps of T for the union of the tips; two tips removed
// one after the other are not what both are at once, so each call begins anew with the state before
// the stroke. With V' the result and D' = (D \ U) + V', T' = trim(D') is V': it holds V', which is
// support-free, and lies within trim(D) = T, of which D' holds only V'.

#include "base/status.h"
#include "sculpt/model.h"
#include "sculpt/rows.h"
#include "voxel/slice.h"

static sf_status preserve(sf_sculpt *m)
{
    sf_preserve_options options = sf_preserve_options_default();
    options.brush_box = sfi_area_bounds(&m->in_tips);
    options.known_support_free = 1;
    return sf_grid_preserve(m->now.printable, m->tips, &m->terms, &options, &m->scratch, NULL,
                            NULL);
}

// D and materials follow T, in one row. What changes is printable where it was before the stroke;
// the rest are ghosts.
static void follow(sf_sculpt *m, sf_rect r, uint32_t y, uint32_t z)
{
    const uint64_t *was = sfi_slice_row(sf_grid_slice(m->before.drawn, z), y);
    const uint64_t *u = sfi_slice_row(sf_grid_slice(m->tips, z), y);
    const uint64_t *lived = sfi_slice_row(sf_grid_slice(m->before.printable, z), y);
    const uint64_t *t = sfi_slice_row(sf_grid_slice(m->now.printable, z), y);
    uint64_t *d = sfi_slice_row(sf_grid_slice(m->now.drawn, z), y);
    uint8_t *materials = sfi_material_row(m, &m->now, y, z);
    const uint8_t *were = sfi_material_row(m, &m->before, y, z);
    for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
        uint64_t fresh = was[i] & (~u[i] | t[i]), changed = fresh ^ d[i];
        d[i] = fresh;
        sfi_bytes_set(materials, i, changed & ~fresh, 0);
        sfi_bytes_copy(materials, were, i, changed & fresh);
        sfi_area_note(&m->called.drawn, i, changed, y, z);
        sfi_area_note(&m->called.printable, i, changed & lived[i], y, z);
        sfi_area_note(&m->called.material, i, changed, y, z);
    }
}

sf_status sfi_brush_preserve(sf_sculpt *m)
{
    sfi_touch restored = {{0, 0, NULL}, m->in_tips, {0, 0, NULL}};
    if (!sfi_area_is_empty(&m->touched.printable)) {
        sfi_sculpt_copy(m, &m->now, &m->before, &restored); // what earlier calls did
    }
    SF_TRY(preserve(m));
    for (uint32_t z = m->in_tips.z0; z < m->in_tips.z1; z++) {
        sf_rect r = m->in_tips.rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            follow(m, r, y, z);
        }
    }
    return SF_OK;
}
