// SPDX-License-Identifier: MIT
// Choose: who carries what hangs, in the sweep down of complete (complete.c).
//
// Few: a greedy cover, and under slack a demand on each of the chosen (cover.c).
//
// Thick: of what hangs, eroded by the step's element, the core stays below it where it is as wide
// as a strut; what is left is served by squares of that width where V has room for them, which
// reach farther for being wide; only the rest by single voxels. All of that is more to stay, so
// nothing else changes.
//
// A square of width w serves from its centre what lies within the step's element and w / 2 more, so
// squares are a cover by a larger element, among the centres of squares that lie in V. Under slack
// a square that stays has no demand on it, so only voxels without a demand are served by it, and
// only as far as the step alone reaches.
//
// Source: the core is the paper's (T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free
// Shapes for Fabrication", Eurographics 2016, section 2.2), of what hangs alone; squares are the
// library's own.

#include "support/preserve/descent.h"

#include "base/bytes.h"
#include "base/status.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// Demands
// ---------------------------------------------------------------------------------------------

void sfi_demand_raise(const sfi_descent *d, uint8_t *codes, sf_slice s)
{
    size_t stride = sfi_slack_stride(d->lattice.nx), words = sfi_row_words(s.width);
    for (uint32_t y = 0; y < s.height; y++) {
        const uint64_t *row = sfi_slice_row(s, y);
        for (size_t i = 0; i < words; i++) {
            uint64_t word = row[i] & (i + 1 < words ? ~UINT64_C(0) : sfi_tail_mask(s.width));
            uint8_t *line = codes + y * stride + i * 64;
            for (unsigned b = 0; word != 0 && b < 64; b++) {
                uint8_t least = (uint8_t)(word >> b & 1);
                line[b] = line[b] > least ? line[b] : least;
            }
        }
    }
}

void sfi_demand_select(const sfi_descent *d, sf_slice among, const uint8_t *reached, sf_slice s)
{
    size_t stride = sfi_slack_stride(d->lattice.nx);
    for (uint32_t y = 0; y < s.height; y++) {
        const uint64_t *in = sfi_slice_row(among, y);
        const uint8_t *need = d->need + y * stride;
        uint64_t *out = sfi_slice_row(s, y);
        for (size_t i = 0; i < sfi_row_words(s.width); i++) {
            uint64_t word = 0;
            for (unsigned b = 0; in[i] != 0 && b < 64; b++) {
                uint8_t got = reached != NULL ? reached[y * stride + i * 64 + b] : 1;
                word |= (uint64_t)(need[i * 64 + b] <= got) << b;
            }
            out[i] = in[i] & word;
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Carriers
// ---------------------------------------------------------------------------------------------

// The offsets over which a voxel without slack serves one without demand.
static sf_element plain_element(const sfi_descent *d)
{
    sf_element e = d->cover.element, plain = {0, {0}};
    for (uint32_t dy = 0; d->is_slack && dy <= e.reach_y; dy++) {
        const uint32_t *costs = d->cover.costs + dy * d->cover.cost_stride;
        uint32_t dx = e.half_width[dy] + 1u;
        while (dx > 0 && costs[dx - 1] > d->cover.gain) {
            dx--;
        }
        if (dx == 0) {
            break;
        }
        plain.reach_y = (uint16_t)dy;
        plain.half_width[dy] = (uint16_t)(dx - 1);
    }
    return d->is_slack ? plain : e;
}

// `fresh`, of layer k - 1, stays; whom it serves without slack is no longer pending.
static sf_status settle(sfi_descent *d, sf_slice fresh, const sf_element *plain)
{
    sf_slice next = d->s[SFI_DESCENT_NEXT], served = d->s[SFI_DESCENT_ALIVE],
             pending = d->s[SFI_DESCENT_PENDING];
    SF_TRY(sf_slice_or(next, next, fresh));
    SF_TRY(sf_slice_and_dilate(served, pending, fresh, plain));
    if (d->is_slack) {
        sfi_demand_raise(d, d->next_need, fresh);
        sfi_demand_select(d, served, NULL, served);
    }
    return sf_slice_subtract(pending, pending, served);
}

// s[SFI_DESCENT_FREE] = what is pending and has no demand.
static sf_status find_plain_pending(sfi_descent *d)
{
    sf_slice out = d->s[SFI_DESCENT_FREE];
    SF_TRY(sf_slice_copy(out, d->s[SFI_DESCENT_PENDING]));
    if (d->is_slack) {
        sfi_demand_select(d, out, NULL, out);
    }
    return SF_OK;
}

// The core of what hangs, but for what of it is narrower than a square.
static sf_status settle_core(sfi_descent *d, uint32_t k, const sf_element *plain,
                             const sf_element *square)
{
    sf_slice work = d->s[SFI_DESCENT_ALIVE], core = d->s[SFI_DESCENT_ENDS];
    SF_TRY(find_plain_pending(d));
    SF_TRY(sf_slice_erode(work, d->s[SFI_DESCENT_FREE], plain, SF_BORDER_EMPTY));
    SF_TRY(sf_slice_and(core, work, sf_grid_slice(d->task->shape, k - 1)));
    SF_TRY(sf_slice_erode(work, core, square, SF_BORDER_EMPTY));
    SF_TRY(sf_slice_dilate(core, work, square, SF_BORDER_EMPTY));
    return settle(d, core, plain);
}

// Squares under what is left, where there is room for them.
static sf_status settle_squares(sfi_descent *d, uint32_t k, const sf_element *plain,
                                const sf_element *square)
{
    sfi_cover *c = &d->cover;
    sf_slice centres = d->s[SFI_DESCENT_MUST], squares = d->s[SFI_DESCENT_ENDS];
    sf_element step = c->element, wide;
    if (sf_element_sum(plain, square, &wide) != SF_OK) {
        return SF_OK; // wider than an element may be: leave it to single voxels
    }
    SF_TRY(find_plain_pending(d));
    SF_TRY(sf_slice_erode(centres, sf_grid_slice(d->task->shape, k - 1), square, SF_BORDER_EMPTY));
    SF_TRY(sf_slice_and_dilate(d->s[SFI_DESCENT_ALIVE], d->s[SFI_DESCENT_FREE], centres, &wide));
    c->element = wide;
    c->pending = d->s[SFI_DESCENT_ALIVE];
    c->need = c->slack = NULL;
    c->carriers = centres;
    c->first = d->s[SFI_DESCENT_NEXT];
    sf_status status = sfi_cover_greedy(c);
    c->element = step;
    SF_TRY(status);
    SF_TRY(sf_slice_dilate(squares, c->chosen, square, SF_BORDER_EMPTY));
    return settle(d, squares, plain);
}

static sf_status settle_thick(sfi_descent *d, uint32_t k)
{
    sf_element plain = plain_element(d), square = {0, {0}};
    square.reach_y = (uint16_t)(d->task->strut_width / 2);
    for (uint32_t dy = 0; dy <= square.reach_y; dy++) {
        square.half_width[dy] = square.reach_y;
    }
    SF_TRY(settle_core(d, k, &plain, &square));
    return settle_squares(d, k, &plain, &square);
}

sf_status sfi_descent_choose(sfi_descent *d, uint32_t k, const sfi_front *below)
{
    sfi_cover *c = &d->cover;
    sf_slice next = d->s[SFI_DESCENT_NEXT], pending = d->s[SFI_DESCENT_PENDING];
    SF_TRY(sf_slice_copy(next, sf_grid_slice(d->task->needed, k - 1)));
    if (d->is_slack) {
        memset(d->next_need, 0, sfi_slack_stride(d->lattice.nx) * d->lattice.ny);
        sfi_demand_raise(d, d->next_need, next);
    }
    if (d->task->strut_width > 0 && sfi_slice_any(pending)) {
        SF_TRY(settle_thick(d, k));
    }
    if (!sfi_slice_any(pending)) {
        return SF_OK;
    }
    c->pending = pending;
    c->need = d->is_slack ? d->need : NULL;
    c->slack = d->is_slack ? below->slack : NULL;
    c->carriers = sf_grid_slice(d->task->shape, k - 1);
    c->first = next;
    SF_TRY(sfi_cover_greedy(c));
    if (d->is_slack) {
        sfi_demand_raise(d, d->next_need, c->chosen);
        sfi_cover_assign(c, d->next_need);
    }
    return sf_slice_or(next, next, c->chosen);
}
