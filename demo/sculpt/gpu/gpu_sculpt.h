// SPDX-License-Identifier: MIT
// Sculpt on the GPU: the brushes of <sf/sculpt.h> as compute shaders, on a model that lives in the
// memory of the graphics card.
//
// Bit for bit what sf_sculpt does, for the rule box3. Nothing is read back from the card by any
// call but the two that say so, gpu_sculpt_fetch() and gpu_sculpt_report(): not between strokes,
// not within them, not by undo. So a call does not tell what it changed; who draws reads the
// buffers where they are.
//
// A context of OpenGL 4.5 must be current, the one that the model was made in or one that shares
// with it. Binding points 0 to 14 of shader storage and the current program are left changed.

#ifndef SCULPT_GPU_GPU_SCULPT_H
#define SCULPT_GPU_GPU_SCULPT_H

#include <sf/sculpt.h>

typedef struct gpu_sculpt gpu_sculpt;

// Make an empty model. SF_OK; SF_ERR_ARGUMENT: options that are none, or a rule that is not box3;
// SF_ERR_OVERFLOW: a lattice that the card's buffers cannot hold; SF_ERR_MEMORY; SF_ERR_INFEASIBLE:
// the card or its driver cannot do this. *why is a sentence where it is not SF_OK, and lives until
// the next call.
sf_status gpu_sculpt_create(const sf_sculpt_options *options, const char **why, gpu_sculpt **model);
void gpu_sculpt_destroy(gpu_sculpt *model);

// As sf_sculpt_begin() and the rest. SF_ERR_MEMORY from gpu_sculpt_begin(): the tip does not fit.
sf_status gpu_sculpt_begin(gpu_sculpt *model, const sf_brush *brush);
sf_status gpu_sculpt_dab(gpu_sculpt *model, const sf_dab *dabs, size_t count);
sf_status gpu_sculpt_end(gpu_sculpt *model);
sf_status gpu_sculpt_abandon(gpu_sculpt *model);
sf_status gpu_sculpt_stroke(gpu_sculpt *model, const sf_brush *brush, const sf_dab *dabs,
                            size_t count);

// As sf_sculpt_replace() and sf_sculpt_drop_ghosts(): one step of the history each.
sf_status gpu_sculpt_replace(gpu_sculpt *model, const sf_grid *drawn, const uint8_t *materials);
sf_status gpu_sculpt_drop_ghosts(gpu_sculpt *model);

// As sf_sculpt_undo() and sf_sculpt_redo(), but that only the card knows whether there is a step;
// where there is none nothing happens. SF_OK, or SF_ERR_ARGUMENT during a stroke.
sf_status gpu_sculpt_undo(gpu_sculpt *model);
sf_status gpu_sculpt_redo(gpu_sculpt *model);

// ---------------------------------------------------------------------------------------------
// Drawing
// ---------------------------------------------------------------------------------------------

// Buffers of OpenGL that a view may bind and read, never write. They keep their names and sizes as
// long as the model lives. All that calls did is visible to shaders that read them afterwards.
//
// Voxel x of row y of layer z is bit x % 32 of word i = (z * ny + y) * row_words + x / 32 of
// `drawn` and of `printable`, and byte 32 * i + x % 32 of `materials`, byte b of a word being its
// bits 8 b to 8 b + 7. `ledger` holds at words 12 to 17 the box x0 y0 z0 x1 y1 z1 (high ends
// without; x0 >= x1 where it is empty) within which the last call changed anything.
typedef struct gpu_view {
    unsigned drawn, printable, materials, ledger;
    uint32_t nx, ny, nz, row_words;
} gpu_view;

gpu_view gpu_sculpt_view(const gpu_sculpt *model);

// ---------------------------------------------------------------------------------------------
// Reading back
// ---------------------------------------------------------------------------------------------

// Copy the model from the card: what is drawn, what is printable, materials as
// sf_sculpt_materials() gives them. Each may be NULL; grids must be of the model's counts.
// SF_OK, SF_ERR_ARGUMENT, SF_ERR_SHAPE, SF_ERR_MEMORY: then nothing is written.
sf_status gpu_sculpt_fetch(const gpu_sculpt *model, sf_grid *drawn, sf_grid *printable,
                           uint8_t *materials);

// What the card keeps count of.
typedef struct gpu_report {
    // Of the last stroke that ended, as in sf_sculpt_change; path_voxels also while it is going on.
    uint32_t added_voxels, removed_voxels, lost_voxels, kept_back_voxels, path_voxels;
    uint32_t undo_count, redo_count, forgotten_count; // steps
} gpu_report;

sf_status gpu_sculpt_report(const gpu_sculpt *model, gpu_report *report);

#endif
