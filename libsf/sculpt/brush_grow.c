// SPDX-License-Identifier: MIT
// Add-grow: add the tips, and below them what they need.
//
// The closest supporting path of each dab is looked for in T as it was before the stroke, so it
// does not depend on the other dabs. The tip is put on every voxel of the path, as in the paper; so
// what is below the tip has its shape, and only the lowest of them, where the path lands on matter
// that is smaller than the tip, can hang. What then is not carried of a dab's own tip (grow's
// promise is that all of it is) gets a brace below it (brace.c).
//
// All is redrawn from the state before the stroke: D = D before with U, with paths, with braces.
// Braces depend on the whole union, so those of earlier calls go first.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, sections 2.2 and 3.2 (the brush); that what hangs is trimmed, and braced where
// it was drawn, is the library's own.

#include "base/status.h"
#include "sculpt/model.h"
#include "sculpt/rows.h"
#include "sculpt/tip.h"
#include "voxel/slice.h"
#include "voxel/stamp.h"

// ---------------------------------------------------------------------------------------------
// Paths
// ---------------------------------------------------------------------------------------------

static void put_along(sf_sculpt *m, size_t count, unsigned way)
{
    const sf_tip *tip = m->brush.tip;
    sf_dab anchor = tip->anchors[way];
    for (size_t i = 0; i < count; i++) {
        sf_voxel p = m->path[i];
        int64_t by[3] = {(int64_t)p.x - anchor.x, (int64_t)p.y - anchor.y, (int64_t)p.z - anchor.z};
        sf_box part = sfi_grid_stamp(m->grown, tip->masks[way], by);
        sf_rect one = {p.x, p.y, p.x + 1, p.y + 1};
        (void)!sf_slice_set(sf_grid_slice(m->grown, p.z), p.x, p.y, 1);
        sfi_area_add_box(&m->in_grown, part);
        sfi_area_add(&m->in_grown, one, p.z);
        sfi_area_add_box(&m->fresh, part);
        sfi_area_add(&m->fresh, one, p.z);
    }
}

sf_status sfi_grow_paths(sf_sculpt *m, const int64_t at[3], unsigned way)
{
    const sf_lattice *l = &m->lattice;
    if (at[0] < 0 || at[0] >= l->nx || at[1] < 0 || at[1] >= l->ny ||
        at[2] < (int64_t)m->terms.bed_layer || at[2] >= l->nz) {
        return SF_OK; // nothing to carry there
    }
    sf_voxel from = {(uint32_t)at[0], (uint32_t)at[1], (uint32_t)at[2]};
    sf_path found;
    SF_TRY(sf_path_finder_find(m->finder, from, m->path, l->nz, &found));
    put_along(m, found.count, way);
    m->path_voxels += found.count;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The shape
// ---------------------------------------------------------------------------------------------

// One row of D and of materials: what was before, with the tips and what grows below them.
static void redraw_row(sf_sculpt *m, sf_rect r, uint32_t y, uint32_t z)
{
    const uint64_t *was = sfi_slice_row(sf_grid_slice(m->before.drawn, z), y);
    const uint64_t *tips = sfi_slice_row(sf_grid_slice(m->tips, z), y);
    const uint64_t *grown = sfi_slice_row(sf_grid_slice(m->grown, z), y);
    uint64_t *d = sfi_slice_row(sf_grid_slice(m->now.drawn, z), y);
    uint8_t *materials = sfi_material_row(m, &m->now, y, z);
    for (size_t i = sfi_rect_first_word(r); i < sfi_rect_end_word(r); i++) {
        uint64_t fresh = was[i] | tips[i] | grown[i], difference = fresh ^ d[i];
        sfi_bytes_set(materials, i, difference & fresh, m->brush.material);
        sfi_bytes_set(materials, i, difference & ~fresh, 0);
        sfi_area_note(&m->work, i, difference, y, z);
        d[i] = fresh;
    }
}

// Where this call put something, and where braces were, which have to be found anew.
static sf_status redraw(sf_sculpt *m)
{
    sfi_area_join(&m->fresh, &m->braced);
    sfi_area_clear(&m->work);
    for (uint32_t z = m->fresh.z0; z < m->fresh.z1; z++) {
        sf_rect r = m->fresh.rects[z];
        for (uint32_t y = r.y0; y < r.y1; y++) {
            redraw_row(m, r, y, z);
        }
    }
    sfi_area_join(&m->called.drawn, &m->work);
    sfi_area_join(&m->called.material, &m->work);
    return sfi_sculpt_trim(m, &m->work);
}

sf_status sfi_brush_grow(sf_sculpt *m)
{
    SF_TRY(redraw(m));
    sfi_area_clear(&m->braced);
    SF_TRY(sfi_brace(m));
    sfi_area_join(&m->called.drawn, &m->braced);
    sfi_area_join(&m->called.material, &m->braced);
    return sfi_sculpt_trim(m, &m->braced);
}
