// SPDX-License-Identifier: MIT
// Spare: which voxels of a support-free shape are not needed, tried one by one.
//
// Taking a voxel u out of V' is allowed when all that must stay, F, lies within trim(V' \ u). One
// pass over the voxels, in any order, leaves a set from which none can be taken: who was refused
// was needed in a larger V', and a trim is monotone, so it is needed in the smaller one as well.
//
// For the same reason who was refused must stay from then on, as F must: without it F does not
// stand. The order is from the top down, so above u all must stay, and the first death there ends
// the trial; in a strut that is one layer higher. Only under slack does a trial lead on, where
// codes fall and nobody dies, and it ends where they fall no more.
//
// A trial is a trim of what can have changed. Under slack that is found from loss to loss
// (trial.c). Without, or where a voxel is reached no more and a bridge may hold it, the layer is
// computed in a rectangle around what did change, grown by the step's element and by what a bridge
// reaches, as in trim_box.c. Windows begin and end with words, and are computed in a small front of
// their own, because codes of a front have the stride of its width.

#include "support/preserve/spare.h"

#include "base/bits.h"
#include "base/bytes.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/preserve/trial.h"
#include "support/rule/carry.h"
#include "voxel/rect.h"
#include "voxel/slice.h"

typedef struct sparing {
    sfi_trial trial;
    const sf_grid *needed;
    uint32_t bed;
    uint32_t margin; // what a bridge reaches within its layer
    sf_slice stay;   // of the layer that is tried: what is needed, and what was refused
    void *memory[3]; // for a carrier and two fronts of the whole width
    size_t sizes[3];
} sparing;

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

// The first layer that has a voxel which is not needed; nz where none has.
static uint32_t first_to_spare(const sf_grid *grid, const sf_grid *needed)
{
    uint32_t k = 0, nz = sf_grid_lattice(grid).nz;
    while (k < nz && sf_slice_equal(sf_grid_slice(grid, k), sf_grid_slice(needed, k))) {
        k++;
    }
    return k;
}

static sf_status create(sparing *s)
{
    const sf_rule *rule = &s->trial.terms->rule;
    sf_lattice lattice = s->trial.lattice;
    if (!sfi_carrier_size(rule, lattice.nx, lattice.ny, &s->sizes[0]) ||
        !sfi_front_size(rule, lattice.nx, lattice.ny, &s->sizes[1])) {
        return SF_ERR_OVERFLOW;
    }
    s->sizes[2] = s->sizes[1];
    for (int i = 0; i < 3; i++) {
        s->memory[i] =
            s->sizes[i] > 0 ? sfi_alloc_array(&s->trial.allocator, 1, s->sizes[i]) : NULL;
        if (s->sizes[i] > 0 && s->memory[i] == NULL) {
            return SF_ERR_MEMORY;
        }
    }
    sf_slice stay = sf_grid_slice(s->needed, 0);
    stay.words =
        sfi_alloc_array(&s->trial.allocator, stay.stride * stay.height, sizeof *stay.words);
    s->stay = stay;
    return stay.words != NULL ? SF_OK : SF_ERR_MEMORY;
}

static void destroy(sparing *s)
{
    const sf_allocator *a = &s->trial.allocator;
    for (int i = 0; i < 3; i++) {
        sfi_free_array(a, s->memory[i], 1, s->sizes[i]);
    }
    sfi_free_array(a, s->stay.words, s->stay.stride * s->stay.height, sizeof *s->stay.words);
    sfi_trial_destroy(&s->trial);
}

// Codes of the whole grid, those from the trial's first layer on kept.
static sf_status fill_codes(sparing *s)
{
    const sfi_trial *t = &s->trial;
    const sf_rule *rule = &t->terms->rule;
    uint32_t nx = t->lattice.nx, ny = t->lattice.ny;
    if (t->codes == NULL) {
        return SF_OK;
    }
    sfi_carrier carrier = sfi_carrier_place(rule, nx, ny, s->memory[0]);
    sfi_front fronts[2] = {sfi_front_place(rule, nx, ny, s->memory[1]),
                           sfi_front_place(rule, nx, ny, s->memory[2])};
    for (uint32_t k = s->bed; k < t->lattice.nz; k++) {
        sf_slice solid = sf_grid_slice(t->grid, k), exempt = sfi_mask_slice(t->terms->exempt, k);
        sfi_front front = fronts[k % 2];
        SF_TRY(sfi_carry_layer(&carrier, k, s->bed, &fronts[(k + 1) % 2], solid, exempt, front,
                               SFI_NO_SLICE));
        if (k >= t->first) {
            memcpy(sfi_trial_codes(t, k, 0), front.slack, t->layer_bytes);
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// A layer as a front
// ---------------------------------------------------------------------------------------------

// The front of layer k in a window, on what stands below: right within it but for a margin.
static sf_status compute(const sparing *s, uint32_t k, sf_rect part, sfi_front *front)
{
    const sfi_trial *t = &s->trial;
    const sf_rule *rule = &t->terms->rule;
    uint32_t width = part.x1 - part.x0, height = part.y1 - part.y0;
    sfi_carrier carrier = sfi_carrier_place(rule, width, height, s->memory[0]);
    sfi_front below = sfi_front_place(rule, width, height, s->memory[1]);
    *front = sfi_front_place(rule, width, height, s->memory[2]);
    SF_TRY(sf_slice_copy(below.alive, sfi_slice_window(sf_grid_slice(t->grid, k - 1), part)));
    for (uint32_t y = 0; t->codes != NULL && y < height; y++) {
        const uint8_t *from = sfi_trial_codes(t, k - 1, part.y0 + y) + part.x0;
        memcpy(below.slack + y * sfi_slack_stride(width), from, width);
    }
    return sfi_carry(&carrier, k, &below, sfi_slice_window(sf_grid_slice(t->grid, k), part),
                     sfi_slice_window(sfi_mask_slice(t->terms->exempt, k), part), *front,
                     SFI_NO_SLICE);
}

// Bring layer k to what the front of `part` says within r. *lost: a voxel died that must stay:
// those of `stay`, all where that has no words.
static sf_status commit(sparing *s, uint32_t k, sf_rect part, sf_rect r, const sfi_front *front,
                        sf_slice stay, int *lost)
{
    sfi_trial *t = &s->trial;
    sf_slice solid = sf_grid_slice(t->grid, k);
    size_t stride = sfi_slack_stride(part.x1 - part.x0);
    for (uint32_t y = r.y0; y < r.y1; y++) {
        for (uint32_t x = r.x0; x < r.x1; x++) {
            if (!sf_slice_get(solid, x, y)) {
                continue;
            }
            uint8_t now = (uint8_t)sf_slice_get(front->alive, x - part.x0, y - part.y0), was = 1;
            if (t->codes != NULL) {
                now = front->slack[(y - part.y0) * stride + (x - part.x0)];
                was = sfi_trial_codes(t, k, y)[x];
            }
            if (now == 0 && (stay.words == NULL || sf_slice_get(stay, x, y))) {
                *lost = 1;
                return SF_OK;
            }
            if (now != was) {
                SF_TRY(sfi_trial_lower(t, k, y, x, now));
            }
        }
    }
    return SF_OK;
}

// The rectangle around the losses from `from` on.
static sf_rect around(const sfi_trial *t, size_t from)
{
    sf_rect all = {0, 0, 0, 0};
    for (size_t i = from; i < t->count; i++) {
        const sfi_loss *l = &t->losses[i];
        sf_rect one = {l->x, l->y, l->x + 1, l->y + 1};
        all = sfi_rect_union(all, one);
    }
    return all;
}

// Layer k, what changed by losses within `dirty`: those of the layer below, or its own.
static sf_status redo(sparing *s, uint32_t k, int is_own, sf_rect dirty, int *lost)
{
    sf_element e;
    sfi_front front;
    SF_TRY(sfi_trial_element(&s->trial, k - 1, &e));
    sf_slice layer = sf_grid_slice(s->trial.grid, k);
    uint32_t rx = e.half_width[0] + s->margin, ry = e.reach_y + s->margin;
    sf_rect r = is_own ? sfi_rect_grow(dirty, s->margin, s->margin, layer)
                       : sfi_rect_grow(dirty, rx, ry, layer);
    sf_rect part = sfi_rect_align(sfi_rect_grow(r, rx, ry, layer), layer);
    SF_TRY(compute(s, k, part, &front));
    return commit(s, k, part, r, &front, is_own ? s->stay : SFI_NO_SLICE, lost);
}

// ---------------------------------------------------------------------------------------------
// A trial
// ---------------------------------------------------------------------------------------------

// One voxel of layer k is lost: trim that layer, where bridges can be held by it, and those above.
static sf_status follow(sparing *s, uint32_t k, int *lost)
{
    sfi_trial *t = &s->trial;
    size_t from = 0;
    if (s->margin > 0 && k > s->bed) {
        SF_TRY(redo(s, k, 1, around(t, 0), lost));
    }
    for (uint32_t j = k + 1; j < t->lattice.nz && !*lost && from < t->count; j++) {
        sf_rect dirty = around(t, from);
        size_t count = t->count;
        int died = 1;
        if (t->codes != NULL) {
            died = 0;
            SF_TRY(sfi_trial_rise(t, j, from, &died));
        }
        if (died && t->codes != NULL && s->margin == 0) {
            *lost = 1;
        } else if (died) {
            SF_TRY(redo(s, j, 0, dirty, lost));
        }
        from = count;
    }
    return SF_OK;
}

static sf_status try_voxel(sparing *s, uint32_t k, uint32_t y, uint32_t x)
{
    int lost = 0;
    sfi_trial_begin(&s->trial);
    SF_TRY(sfi_trial_lower(&s->trial, k, y, x, 0));
    SF_TRY(follow(s, k, &lost));
    if (lost) {
        sfi_trial_undo(&s->trial);
        return sf_slice_set(s->stay, x, y, 1);
    }
    return SF_OK;
}

static sf_status try_layer(sparing *s, uint32_t k)
{
    sf_slice solid = sf_grid_slice(s->trial.grid, k);
    SF_TRY(sf_slice_copy(s->stay, sf_grid_slice(s->needed, k)));
    for (uint32_t y = 0; y < solid.height; y++) {
        const uint64_t *row = sfi_slice_row(solid, y), *stay = sfi_slice_row(s->stay, y);
        for (size_t i = 0; i < sfi_row_words(solid.width); i++) {
            // What is tried stays or goes, and may take others of its layer with it.
            for (uint64_t word; (word = row[i] & ~stay[i]) != 0;) {
                SF_TRY(try_voxel(s, k, y, (uint32_t)i * 64 + sfi_lowest_bit(word)));
            }
        }
    }
    return SF_OK;
}

sf_status sfi_spare(sf_grid *grid, const sf_grid *needed, const sf_terms *terms, uint32_t bed,
                    const sf_allocator *allocator, sf_task *task)
{
    sparing s = {.needed = needed, .bed = bed, .margin = sfi_bridge_margin(&terms->rule.bridge)};
    uint32_t first = first_to_spare(grid, needed), nz = sf_grid_lattice(grid).nz;
    if (first == nz) {
        return SF_OK;
    }
    // A bridge's layer is computed on the one below, whose codes are needed too.
    first = first > 0 ? first - 1 : 0;
    sf_status status = sfi_trial_create(&s.trial, grid, terms, first, allocator);
    status = status == SF_OK ? create(&s) : status;
    status = status == SF_OK ? fill_codes(&s) : status;
    for (uint32_t k = nz; status == SF_OK && k-- > first;) {
        status = sf_task_is_cancelled(task) ? SF_ERR_CANCELLED : try_layer(&s, k);
    }
    destroy(&s);
    return status;
}
