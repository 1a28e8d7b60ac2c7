// SPDX-License-Identifier: MIT
// Trim: the largest support-free part of a shape.
//
// T_bed = S_bed, T_{k+1} = what of S_{k+1} is alive on T_k. Support-free sets are closed under
// union, so a greatest one within S exists, and by induction it lies within T, which is
// support-free itself: one sweep from the bottom up, reading each slice once, is exact. It needs of
// a rule only that it is monotone (carry.c), so it holds for all of them.
//
// Without slack and bridges the step is one pass over a slice, in place, and memory is all that it
// costs; else it works between two fronts.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 3.2 (the sweep).

#include "base/status.h"
#include "base/task.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

// Zeros in the padding, where nothing else is written.
static void seal(sf_slice slice)
{
    size_t last = sfi_row_words(slice.width) - 1;
    for (uint32_t y = 0; y < slice.height; y++) {
        sfi_slice_row(slice, y)[last] &= sfi_tail_mask(slice.width);
    }
}

// Layer k of the trim, in place, given the layer below; for rules that are elements.
static sf_status trim_slice(sf_grid *grid, const sf_rule *rule, uint32_t bed, uint32_t k)
{
    sf_slice slice = sf_grid_slice(grid, k);
    if (k < bed) {
        sfi_slice_clear(slice);
        return SF_OK;
    }
    if (k == bed) {
        seal(slice);
        return SF_OK;
    }
    sf_element element;
    SF_TRY(sf_rule_element(rule, k - 1, &element));
    return sf_slice_and_dilate(slice, slice, sf_grid_slice(grid, k - 1), &element);
}

static sf_status trim_by_elements(sf_grid *grid, const sf_rule *rule, uint32_t bed, sf_task *task,
                                  sf_trim_report *counts)
{
    uint32_t nz = sf_grid_lattice(grid).nz;
    sfi_progress progress = sfi_progress_begin(task);
    for (uint32_t k = 0; k < nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        uint64_t solid = counts != NULL ? sf_slice_popcount(slice) : 0;
        SF_TRY(trim_slice(grid, rule, bed, k));
        if (counts != NULL) {
            uint64_t kept = sf_slice_popcount(slice);
            counts->kept_voxels += kept;
            counts->removed_voxels += solid - kept;
        }
        sfi_progress_report(&progress, k + 1, nz);
    }
    sfi_progress_report(&progress, 1, 1);
    return SF_OK;
}

static sf_status trim_by_fronts(sf_grid *grid, const sf_terms *terms, uint32_t bed, sf_task *task,
                                sf_trim_report *counts)
{
    sf_task silent = sf_task_default(); // a cancel would leave the grid half done
    sf_allocator allocator = sfi_grid_allocator(grid);
    uint64_t solid = counts != NULL ? sf_grid_popcount(grid) : 0;
    if (task != NULL) {
        silent.progress = task->progress;
        silent.parallel_for = task->parallel_for;
        silent.user = task->user;
    }
    SF_TRY(sfi_trim_into(grid, grid, terms, bed, &allocator, &silent));
    if (counts != NULL) {
        counts->kept_voxels = sf_grid_popcount(grid);
        counts->removed_voxels = solid - counts->kept_voxels;
    }
    return SF_OK;
}

sf_status sf_grid_trim(sf_grid *grid, const sf_rule *rule, uint32_t bed_layer, sf_task *task,
                       sf_trim_report *report)
{
    if (grid == NULL || rule == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sf_terms terms = sf_terms_default();
    sfi_ground ground;
    terms.rule = *rule;
    terms.bed_layer = bed_layer;
    SF_TRY(sfi_terms_check(&terms, grid, &ground));
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    sf_trim_report counts = {0, 0, ground.bed < ground.lattice.nz ? ground.bed : SF_BED_AUTO};
    sf_trim_report *wanted = report != NULL ? &counts : NULL;
    if (sfi_rule_is_element(rule)) {
        SF_TRY(trim_by_elements(grid, rule, ground.bed, task, wanted));
    } else {
        SF_TRY(trim_by_fronts(grid, &terms, ground.bed, task, wanted));
    }
    if (report != NULL) {
        *report = counts;
    }
    return SF_OK;
}
