// SPDX-License-Identifier: MIT
// Whole models: another shape in place of what is drawn, ghosts let go, steps undone and done
// again.

#include <string.h>

#include "base/status.h"
#include "sculpt/delta.h"
#include "sculpt/rows.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

static int is_idle(const sf_sculpt *m)
{
    return m != NULL && !m->is_under_way;
}

// ---------------------------------------------------------------------------------------------
// Replace
// ---------------------------------------------------------------------------------------------

static void put_materials(sf_sculpt *m, const uint8_t *materials)
{
    size_t voxel = 0;
    for (uint32_t z = 0; z < m->lattice.nz; z++) {
        sf_slice drawn = sf_grid_slice(m->now.drawn, z);
        for (uint32_t y = 0; y < m->lattice.ny; y++, voxel += m->lattice.nx) {
            const uint64_t *d = sfi_slice_row(drawn, y);
            uint8_t *row = sfi_material_row(m, &m->now, y, z);
            for (uint32_t x = 0; x < m->lattice.nx; x++) {
                int is_solid = (int)(d[x / 64] >> x % 64 & 1);
                uint8_t given = materials != NULL && is_solid ? materials[voxel + x] : 1;
                row[x] = !is_solid ? 0 : given != 0 ? given : 1;
            }
        }
    }
}

sf_status sf_sculpt_replace(sf_sculpt *model, const sf_grid *drawn, const uint8_t *materials,
                            sf_sculpt_change *change)
{
    if (!is_idle(model) ||
        (drawn != NULL && (drawn == model->now.drawn || drawn == model->now.printable))) {
        return SF_ERR_ARGUMENT;
    }
    sf_box all = {0, 0, 0, model->lattice.nx, model->lattice.ny, model->lattice.nz};
    if (drawn != NULL) {
        SF_TRY(sfi_terms_match(&model->lattice, drawn));
        SF_TRY(sfi_trim_into(model->now.printable, drawn, &model->terms, model->terms.bed_layer,
                             &model->scratch, NULL));
        SF_TRY(sfi_grid_copy(model->now.drawn,
                             model->options.keep_drawn ? drawn : model->now.printable));
    } else {
        for (uint32_t z = 0; z < all.z1; z++) {
            sfi_slice_clear(sf_grid_slice(model->now.drawn, z));
            sfi_slice_clear(sf_grid_slice(model->now.printable, z));
        }
    }
    put_materials(model, materials);
    sf_sculpt_change boxes;
    sfi_area_clear(&model->work);
    sfi_area_add_box(&model->work, all);
    sfi_drawn_differences(model, &model->work, &model->touched);
    sfi_printable_differences(model, &model->work, &model->touched.printable);
    sfi_sculpt_boxes(&model->touched, &boxes);
    sfi_sculpt_commit(model, 1, change); // ghosts that may not stay were never put
    if (change != NULL) {
        change->drawn = boxes.drawn;
        change->printable = boxes.printable;
        change->material = boxes.material;
        change->removed_voxels = change->lost_voxels; // there are no tips to lie outside of
        change->lost_voxels = 0;
    }
    return SF_OK;
}

sf_status sf_sculpt_drop_ghosts(sf_sculpt *model, sf_sculpt_change *change)
{
    if (!is_idle(model)) {
        return SF_ERR_ARGUMENT;
    }
    sfi_area_add_box(&model->touched.drawn, sf_grid_bounds(model->now.drawn));
    sfi_sculpt_commit(model, 0, change);
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Undo and redo
// ---------------------------------------------------------------------------------------------

static void step(const sf_sculpt *m, sfi_step_reader reader, sf_sculpt_change *change)
{
    sf_sculpt_change made;
    sfi_delta_apply(m, reader, &made);
    if (change != NULL) {
        *change = made;
    }
}

sf_status sf_sculpt_undo(sf_sculpt *model, sf_sculpt_change *change)
{
    if (!is_idle(model)) {
        return SF_ERR_ARGUMENT;
    }
    if (model->history.undo_count == 0) {
        return SF_ERR_INFEASIBLE;
    }
    step(model, sfi_ring_back(&model->history), change);
    return SF_OK;
}

sf_status sf_sculpt_redo(sf_sculpt *model, sf_sculpt_change *change)
{
    if (!is_idle(model)) {
        return SF_ERR_ARGUMENT;
    }
    if (model->history.redo_count == 0) {
        return SF_ERR_INFEASIBLE;
    }
    step(model, sfi_ring_forward(&model->history), change);
    return SF_OK;
}
