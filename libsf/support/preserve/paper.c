// SPDX-License-Identifier: MIT
// The paper's own preserve, in the two ways that it is written there, for comparison.
//
// Text: remove the whole brush; then sweep down from the slice just above the brush to the slice
// just below it and replace S_k by its union with the erosion of S_{k+1}. That can close holes, and
// add matter outside the brush, because an erosion of S_{k+1} need not lie in S_k.
//
// Shader: in the brush, layer by layer from the top, a voxel stays only where all that the element
// around it has in the layer above is solid, S_k and the erosion of S_{k+1}.
//
// Neither is sure to carry what is above: an erosion is the largest set whose dilation lies within
// S_{k+1}, not one whose dilation covers it, and it shrinks with every layer; under a pillar of
// 11 x 11 nothing is left of it after six. Both then count on a trim, which takes away what hangs.
//
// Outside a slice is empty, also for erosions. Under slack and with bridges the element of the step
// stands for the rule.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 2.2 (text) and 3.2 (shader).

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/preserve/removal.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

// scratch = the erosion of layer k + 1 by the element of the step; empty above the grid.
static sf_status erode_above(const sfi_removal *r, const sf_grid *after, uint32_t k,
                             sf_slice scratch)
{
    sf_element e;
    if (k + 1 >= sf_grid_lattice(after).nz) {
        sf_rect all = {0, 0, scratch.width, scratch.height};
        return sf_slice_fill(scratch, all, 0);
    }
    SF_TRY(sf_rule_element(&r->terms->rule, k, &e));
    return sf_slice_erode(scratch, sf_grid_slice(after, k + 1), &e, SF_BORDER_EMPTY);
}

// Layer k |= scratch, where the terms allow it.
static sf_status unite(const sfi_removal *r, sf_grid *after, uint32_t k, sf_slice scratch)
{
    sf_slice layer = sf_grid_slice(after, k);
    if (r->terms->act != NULL) {
        SF_TRY(sf_slice_and(scratch, scratch, sf_grid_slice(r->terms->act, k)));
    }
    if (r->terms->forbid != NULL) {
        SF_TRY(sf_slice_subtract(scratch, scratch, sf_grid_slice(r->terms->forbid, k)));
    }
    return sf_slice_or(layer, layer, scratch);
}

static sf_status sweep_text(const sfi_removal *r, sf_grid *after, sf_slice scratch)
{
    sf_box b = r->box;
    uint32_t nz = sf_grid_lattice(after).nz, top = b.z1 < nz ? b.z1 + 1 : nz;
    sf_rect all = {0, 0, scratch.width, scratch.height};
    for (uint32_t k = b.z0; k < b.z1; k++) {
        sfi_removal_split(r, r->grid, k, all, SFI_NO_SLICE, sf_grid_slice(after, k));
    }
    uint32_t last = b.z0 > 0 ? b.z0 - 1 : 0;
    sfi_progress progress = sfi_progress_begin(r->task);
    for (uint32_t k = top; k-- > last;) {
        if (sf_task_is_cancelled(r->task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(erode_above(r, after, k, scratch));
        SF_TRY(unite(r, after, k, scratch));
        sfi_progress_report(&progress, top - k, top - last);
    }
    return SF_OK;
}

static sf_status sweep_shader(const sfi_removal *r, sf_grid *after, sf_slice scratch,
                              sf_slice taken)
{
    sf_rect all = {0, 0, scratch.width, scratch.height};
    sfi_progress progress = sfi_progress_begin(r->task);
    for (uint32_t k = r->box.z1; k-- > r->box.z0;) {
        if (sf_task_is_cancelled(r->task)) {
            return SF_ERR_CANCELLED;
        }
        sf_slice layer = sf_grid_slice(after, k);
        SF_TRY(erode_above(r, after, k, scratch));
        sfi_removal_split(r, r->grid, k, all, taken, layer);
        SF_TRY(sf_slice_and(taken, taken, scratch));
        SF_TRY(sf_slice_or(layer, layer, taken));
        sfi_progress_report(&progress, r->box.z1 - k, r->box.z1 - r->box.z0);
    }
    return SF_OK;
}

static sf_status sweep(const sfi_removal *r, sf_grid *after, const sf_allocator *allocator)
{
    sf_slice scratch = sf_grid_slice(after, 0), taken;
    size_t bytes = scratch.stride * scratch.height * sizeof(uint64_t); // as in the grid
    uint64_t *words = sfi_alloc_array(allocator, 2, bytes);
    if (words == NULL) {
        return SF_ERR_MEMORY;
    }
    scratch.words = words;
    taken = scratch;
    taken.words = words + scratch.stride * scratch.height;
    sf_status status = SF_OK;
    if (r->box.z0 < r->box.z1) {
        status = r->options->mode == SF_PRESERVE_PAPER_TEXT
                     ? sweep_text(r, after, scratch)
                     : sweep_shader(r, after, scratch, taken);
    }
    sfi_free_array(allocator, words, 2, bytes);
    return status == SF_OK && sf_task_is_cancelled(r->task) ? SF_ERR_CANCELLED : status;
}

sf_status sfi_preserve_paper(const sfi_removal *r, sf_preserve_report *report)
{
    sf_allocator allocator = sfi_allocator_or_default(r->allocator);
    sf_grid *after;
    SF_TRY(sf_grid_clone(r->grid, &allocator, &after));
    sf_status status = sweep(r, after, &allocator);
    if (status == SF_OK && r->options->trim_after) {
        sfi_quiet quiet;
        sf_task *task = sfi_quiet_begin(&quiet, r->task);
        status = sfi_trim_into(after, after, r->terms, r->bed, &allocator, task);
    }
    if (status == SF_OK) {
        sfi_removal_commit(r, after, report);
    }
    sf_grid_destroy(after);
    return status;
}
