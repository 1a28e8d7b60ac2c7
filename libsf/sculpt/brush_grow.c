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

static void put_along(sf_sculpt *m, size_t count, unsigned way, sf_box *fresh)
{
    const sf_tip *tip = m->stroke.brush.tip;
    sf_dab anchor = tip->anchors[way];
    for (size_t i = 0; i < count; i++) {
        sf_voxel p = m->path[i];
        int64_t by[3] = {(int64_t)p.x - anchor.x, (int64_t)p.y - anchor.y, (int64_t)p.z - anchor.z};
        sf_box part = sfi_grid_stamp(m->grown, tip->masks[way], by);
        sf_rect one = {p.x, p.y, p.x + 1, p.y + 1};
        part = sfi_box_union(part, one, p.z);
        (void)!sf_slice_set(sf_grid_slice(m->grown, p.z), p.x, p.y, 1);
        m->stroke.grown = sfi_box_join(m->stroke.grown, part);
        *fresh = sfi_box_join(*fresh, part);
    }
}

sf_status sfi_grow_paths(sf_sculpt *m, const int64_t at[3], unsigned way, sf_box *fresh)
{
    const sf_lattice *l = &m->lattice;
    if (at[0] < 0 || at[0] >= l->nx || at[1] < 0 || at[1] >= l->ny ||
        at[2] < (int64_t)m->terms.bed_layer || at[2] >= l->nz) {
        return SF_OK; // nothing to carry there
    }
    sf_voxel from = {(uint32_t)at[0], (uint32_t)at[1], (uint32_t)at[2]};
    sf_path found;
    SF_TRY(sf_path_finder_find(m->finder, from, m->path, l->nz, &found));
    put_along(m, found.count, way, fresh);
    m->stroke.path_voxels += found.count;
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The shape
// ---------------------------------------------------------------------------------------------

// One row of D and of materials: what was before, with the tips and what grows below them.
static void redraw_row(sf_sculpt *m, sf_box box, uint32_t y, uint32_t z, sf_box *changed)
{
    const uint64_t *was = sfi_slice_row(sf_grid_slice(m->before.drawn, z), y);
    const uint64_t *tips = sfi_slice_row(sf_grid_slice(m->tips, z), y);
    const uint64_t *grown = sfi_slice_row(sf_grid_slice(m->grown, z), y);
    uint64_t *d = sfi_slice_row(sf_grid_slice(m->now.drawn, z), y);
    uint8_t *materials = sfi_material_row(m, &m->now, y, z);
    for (size_t i = sfi_box_first_word(box); i < sfi_box_end_word(box); i++) {
        uint64_t fresh = was[i] | tips[i] | grown[i], difference = fresh ^ d[i];
        sfi_bytes_set(materials, i, difference & fresh, m->stroke.brush.material);
        sfi_bytes_set(materials, i, difference & ~fresh, 0);
        sfi_box_note(changed, i, difference, y, z);
        d[i] = fresh;
    }
}

static sf_status redraw(sf_sculpt *m, sf_box box, sfi_touch *touched)
{
    sf_box changed = {0, 0, 0, 0, 0, 0};
    for (uint32_t z = box.z0; z < box.z1; z++) {
        for (uint32_t y = box.y0; y < box.y1; y++) {
            redraw_row(m, box, y, z, &changed);
        }
    }
    touched->drawn = sfi_box_join(touched->drawn, changed);
    touched->material = sfi_box_join(touched->material, changed);
    return sfi_sculpt_trim(m, changed, touched);
}

sf_status sfi_brush_grow(sf_sculpt *m, sf_box fresh, sfi_touch *touched)
{
    sf_box braced = {0, 0, 0, 0, 0, 0};
    SF_TRY(redraw(m, sfi_box_join(fresh, m->stroke.braced), touched));
    SF_TRY(sfi_brace(m, &braced));
    m->stroke.braced = braced;
    touched->drawn = sfi_box_join(touched->drawn, braced);
    touched->material = sfi_box_join(touched->material, braced);
    return sfi_sculpt_trim(m, braced, touched);
}
