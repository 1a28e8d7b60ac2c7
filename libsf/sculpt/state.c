// SPDX-License-Identifier: MIT
// States: copied, compared and counted within the boxes around what changed.

#include <string.h>

#include "base/status.h"
#include "sculpt/model.h"
#include "sculpt/rows.h"
#include "voxel/slice.h"

void sfi_touch_join(sfi_touch *to, const sfi_touch *from)
{
    to->drawn = sfi_box_join(to->drawn, from->drawn);
    to->printable = sfi_box_join(to->printable, from->printable);
    to->material = sfi_box_join(to->material, from->material);
}

// Whole words: outside the box both states are the same.
static void copy_bits(sf_grid *to, const sf_grid *from, sf_box box)
{
    size_t first = sfi_box_first_word(box), end = sfi_box_end_word(box);
    for (uint32_t z = box.z0; z < box.z1; z++) {
        sf_slice out = sf_grid_slice(to, z), in = sf_grid_slice(from, z);
        for (uint32_t y = box.y0; y < box.y1; y++) {
            memcpy(sfi_slice_row(out, y) + first, sfi_slice_row(in, y) + first,
                   (end - first) * sizeof(uint64_t));
        }
    }
}

void sfi_sculpt_copy(const sf_sculpt *m, const sfi_state *to, const sfi_state *from,
                     const sfi_touch *touched)
{
    sf_box box = touched->material;
    copy_bits(to->drawn, from->drawn, touched->drawn);
    copy_bits(to->printable, from->printable, touched->printable);
    for (uint32_t z = box.z0; z < box.z1; z++) {
        for (uint32_t y = box.y0; y < box.y1; y++) {
            memcpy(sfi_material_row(m, to, y, z) + box.x0, sfi_material_row(m, from, y, z) + box.x0,
                   box.x1 - box.x0);
        }
    }
}

sf_status sfi_sculpt_trim(sf_sculpt *m, sf_box box, sfi_touch *touched)
{
    sf_box changed;
    SF_TRY(sf_grid_trim_box(m->now.drawn, m->now.printable, &m->terms.rule, m->terms.bed_layer, box,
                            &changed));
    touched->printable = sfi_box_join(touched->printable, changed);
    return SF_OK;
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

void sfi_sculpt_count(const sf_sculpt *m, sf_sculpt_change *change)
{
    const sfi_kernels *kernels = sfi_kernels_get();
    sf_box box = sfi_box_join(m->stroke.touched.printable, m->stroke.tips);
    for (uint32_t z = box.z0; z < box.z1; z++) {
        sf_slice now = sf_grid_slice(m->now.printable, z), tips = sf_grid_slice(m->tips, z);
        sf_slice before = sf_grid_slice(m->before.printable, z);
        for (uint32_t y = box.y0; y < box.y1; y++) {
            const uint64_t *a = sfi_slice_row(now, y), *b = sfi_slice_row(before, y);
            const uint64_t *u = sfi_slice_row(tips, y);
            for (size_t i = sfi_box_first_word(box); i < sfi_box_end_word(box); i++) {
                const uint64_t words[4] = {a[i] & ~b[i], b[i] & ~a[i] & u[i], b[i] & ~a[i] & ~u[i],
                                           kept_back(m->stroke.brush.kind, u[i], a[i])};
                uint64_t *sums[4] = {&change->added_voxels, &change->removed_voxels,
                                     &change->lost_voxels, &change->kept_back_voxels};
                for (int s = 0; s < 4; s++) {
                    *sums[s] += words[s] != 0 ? kernels->popcount(&words[s], 1) : 0;
                }
            }
        }
    }
    change->path_voxels = m->stroke.path_voxels;
}
