// SPDX-License-Identifier: MIT
// Fast preserve: a sweep down through the brush, word by word, for rules that are an element for
// each step.
//
// With V the shape, B the brush, E the exempt voxels, from the top layer of the brush to its
// lowest:
//
//     C = V_k and B_k            what may go
//     F = V_k \ B_k              what stays anyway
//     R = V'_{k+1} \ dilate(F), where dilate(C) is and E is not    what hangs on C alone
//     X = cover(R, C)            by priority (priority.c)
//     V'_k = F U X
//
// By induction V'_{k+1} lies within V_{k+1}, so what was carried in V is carried by F or by C, and
// what C alone carried is covered. Above the brush nothing changes; below it V' lies within V and
// the layers there are V's own. So V' is support-free where V was, and where V was not, the voxels
// that hang in V' hung in V.
//
// Only the brush's box is looked at, and around it twice as far as an element reaches: once for
// what hangs on the brush, once more for who else may carry that. The windows begin with words.
// What stays of the brush is kept apart until all of it is known.

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "base/task.h"
#include "support/preserve/cover.h"
#include "support/preserve/removal.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

enum { SLICE_TAKEN, SLICE_FIXED, SLICE_ABOVE, SLICE_REST, SLICE_FRESH, SLICE_SPREAD, SLICE_COUNT };

// The sweep, in one window of all layers.
typedef struct sweep {
    const sfi_removal *removal;
    sf_lattice lattice;
    sf_allocator allocator;
    sf_rect part;
    size_t words; // of one slice
    uint64_t *memory;
    size_t slices;
    sf_slice s[SLICE_COUNT];
} sweep;

// What stays of the brush in layer k.
static sf_slice kept_slice(const sweep *w, uint32_t k)
{
    sf_slice slice = w->s[0];
    slice.words = w->memory + (SLICE_COUNT + k - w->removal->box.z0) * w->words;
    return slice;
}

// The box's rectangle, grown by twice the reach of the steps above its layers.
static sf_status find_part(sweep *w)
{
    sf_box b = w->removal->box;
    uint32_t rx = 0, ry = 0;
    for (uint32_t k = b.z0; k < b.z1 && k + 1 < w->lattice.nz; k++) {
        sf_element e;
        SF_TRY(sf_rule_element(&w->removal->terms->rule, k, &e));
        rx = e.half_width[0] > rx ? e.half_width[0] : rx;
        ry = e.reach_y > ry ? e.reach_y : ry;
    }
    rx *= 2;
    ry *= 2;
    uint32_t x1 = w->lattice.nx - b.x1 > rx ? b.x1 + rx : w->lattice.nx;
    uint32_t x0 = b.x0 > rx ? b.x0 - rx : 0, end = (x1 + 63) / 64 * 64;
    sf_rect part = {x0 - x0 % 64, b.y0 > ry ? b.y0 - ry : 0,
                    end < w->lattice.nx ? end : w->lattice.nx,
                    w->lattice.ny - b.y1 > ry ? b.y1 + ry : w->lattice.ny};
    w->part = part;
    return SF_OK;
}

static sf_status create(sweep *w)
{
    sf_box b = w->removal->box;
    uint32_t width = w->part.x1 - w->part.x0, height = w->part.y1 - w->part.y0;
    size_t stride = sfi_row_words(width), bytes;
    w->words = stride * height; // less than the grid has
    if (!sfi_size_mul(w->words, sizeof(uint64_t), &bytes) ||
        !sfi_size_add(SLICE_COUNT, b.z1 - b.z0, &w->slices)) {
        return SF_ERR_OVERFLOW;
    }
    w->memory = sfi_alloc_array(&w->allocator, w->slices, bytes);
    if (w->memory == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < SLICE_COUNT; i++) {
        sf_slice slice = {w->memory + i * w->words, width, height, stride};
        w->s[i] = slice;
    }
    return SF_OK;
}

// rest = what of the layer above hangs on what may go.
static sf_status find_rest(const sweep *w, uint32_t k)
{
    sf_element e;
    sf_slice rest = w->s[SLICE_REST], spread = w->s[SLICE_SPREAD];
    SF_TRY(sf_rule_element(&w->removal->terms->rule, k, &e));
    SF_TRY(sf_slice_and_dilate(rest, w->s[SLICE_ABOVE], w->s[SLICE_TAKEN], &e));
    SF_TRY(sf_slice_dilate(spread, w->s[SLICE_FIXED], &e, SF_BORDER_EMPTY));
    SF_TRY(sf_slice_subtract(rest, rest, spread));
    sf_slice exempt = sfi_slice_window(sfi_mask_slice(w->removal->terms->exempt, k + 1), w->part);
    return exempt.words != NULL ? sf_slice_subtract(rest, rest, exempt) : SF_OK;
}

static sf_status sweep_layer(const sweep *w, uint32_t k)
{
    sf_slice taken = w->s[SLICE_TAKEN], fixed = w->s[SLICE_FIXED], kept = kept_slice(w, k);
    sf_rect all = {0, 0, taken.width, taken.height};
    sfi_removal_split(w->removal, w->removal->shape, k, w->part, taken, fixed);
    SF_TRY(sf_slice_fill(kept, all, 0));
    // What rests on the bed, or lies below it, asks for nothing.
    if (k >= w->removal->bed && k + 1 < w->lattice.nz && sfi_slice_any(taken)) {
        sf_element e;
        SF_TRY(sf_rule_element(&w->removal->terms->rule, k, &e));
        SF_TRY(find_rest(w, k));
        SF_TRY(sfi_cover_priority(&e, w->s[SLICE_REST], taken, kept, w->s[SLICE_FRESH],
                                  w->s[SLICE_SPREAD]));
    }
    return sf_slice_or(w->s[SLICE_ABOVE], fixed, kept);
}

static sf_status sweep_down(const sweep *w)
{
    sf_box b = w->removal->box;
    sfi_progress progress = sfi_progress_begin(w->removal->task);
    if (b.z1 < w->lattice.nz) {
        SF_TRY(sf_slice_copy(w->s[SLICE_ABOVE],
                             sfi_slice_window(sf_grid_slice(w->removal->shape, b.z1), w->part)));
    }
    for (uint32_t k = b.z1; k-- > b.z0;) {
        if (sf_task_is_cancelled(w->removal->task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(sweep_layer(w, k));
        sfi_progress_report(&progress, b.z1 - k, b.z1 - b.z0);
    }
    return sf_task_is_cancelled(w->removal->task) ? SF_ERR_CANCELLED : SF_OK;
}

// Write what stays; nothing can fail any more.
static void commit(const sweep *w, sf_preserve_report *report)
{
    sf_box b = w->removal->box;
    for (uint32_t k = b.z0; k < b.z1; k++) {
        sf_slice out = sfi_slice_window(sf_grid_slice(w->removal->grid, k), w->part);
        sf_slice taken = w->s[SLICE_TAKEN], kept = kept_slice(w, k);
        sfi_removal_split(w->removal, w->removal->grid, k, w->part, taken, w->s[SLICE_FIXED]);
        (void)!sf_slice_or(out, w->s[SLICE_FIXED], kept);
        uint64_t before = sf_slice_popcount(taken), after = sf_slice_popcount(kept);
        report->kept_voxels += after;
        report->removed_voxels += before - after;
    }
}

// ---------------------------------------------------------------------------------------------
// The shape before
// ---------------------------------------------------------------------------------------------

static int is_covered(sf_slice solid, sf_slice alive, sf_slice exempt)
{
    size_t words = sfi_row_words(solid.width);
    uint64_t hanging = 0;
    for (uint32_t y = 0; y < solid.height && hanging == 0; y++) {
        const uint64_t *in = sfi_slice_row(solid, y), *held = sfi_slice_row(alive, y);
        const uint64_t *free = exempt.words != NULL ? sfi_slice_row(exempt, y) : NULL;
        uint64_t tail = sfi_tail_mask(solid.width);
        for (size_t i = 0; i < words; i++) {
            uint64_t word = in[i] & ~held[i] & (i + 1 < words ? ~UINT64_C(0) : tail);
            hanging |= free != NULL ? word & ~free[i] : word;
        }
    }
    return hanging == 0;
}

// SF_OK where every layer lies within what the one below carries, and what is exempt.
static sf_status check_shape(const sfi_removal *r, sf_slice scratch)
{
    sf_rect all = {0, 0, scratch.width, scratch.height};
    SF_TRY(sf_slice_fill(scratch, all, 0));
    for (uint32_t k = 0; k < sf_grid_lattice(r->grid).nz; k++) {
        sf_slice solid = sf_grid_slice(r->grid, k);
        if (sf_task_is_cancelled(r->task)) {
            return SF_ERR_CANCELLED;
        }
        if (k == r->bed) {
            continue;
        }
        if (k > r->bed) {
            sf_element e;
            SF_TRY(sf_rule_element(&r->terms->rule, k - 1, &e));
            SF_TRY(sf_slice_and_dilate(scratch, solid, sf_grid_slice(r->grid, k - 1), &e));
        }
        if (!is_covered(solid, scratch, sfi_mask_slice(r->terms->exempt, k))) {
            return SF_ERR_INFEASIBLE;
        }
    }
    return SF_OK;
}

static sf_status check_whole(const sfi_removal *r, const sf_allocator *allocator)
{
    if (r->options->known_support_free || r->options->accept_unsupported ||
        r->options->must_go != NULL) {
        return SF_OK; // nothing to find: the shape was made so
    }
    sf_slice like = sf_grid_slice(r->grid, 0);
    size_t bytes = like.stride * sizeof(uint64_t);
    like.words = sfi_alloc_array(allocator, like.height, bytes);
    if (like.words == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = check_shape(r, like);
    sfi_free_array(allocator, like.words, like.height, bytes);
    return status;
}

sf_status sfi_preserve_fast(const sfi_removal *r, sf_preserve_report *report)
{
    sweep w = {.removal = r, .lattice = sf_grid_lattice(r->grid)};
    w.allocator = sfi_allocator_or_default(r->allocator);
    SF_TRY(check_whole(r, &w.allocator));
    if (r->box.z0 >= r->box.z1) {
        return SF_OK;
    }
    SF_TRY(find_part(&w));
    SF_TRY(create(&w));
    sf_rect all = {0, 0, w.s[0].width, w.s[0].height};
    sf_status status = sf_slice_fill(w.s[SLICE_ABOVE], all, 0);
    if (status == SF_OK) {
        status = sweep_down(&w);
    }
    if (status == SF_OK) {
        commit(&w, report);
    }
    sfi_free_array(&w.allocator, w.memory, w.slices, w.words * sizeof(uint64_t));
    return status;
}
