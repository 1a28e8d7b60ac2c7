// SPDX-License-Identifier: MIT
// Complete: a support-free part V' of a support-free shape V that holds what must stay, F.
//
// One routine for every monotone rule. A field of demands d, one for each voxel that stays (0 to
// the cap under slack, else 0), is a certificate: if in each layer what is asked of it is given by
// the demands below, its voxels are support-free with at least that slack, by induction from the
// bed up. So demands are made from the top down:
//
//     Y = what stays of layer k
//     close    under bridges: where a voxel of Y hung on a bridge of V, the bridge stays (beam.c)
//     thin     which of Y must be carried from below; without bridges all (beam.c)
//     free     what F carries anyway: under slack what the field of F alone reaches; and what is
//              exempt and has no demand on it
//     cover    the others are served by voxels of V below with slack enough (cover.c), whose
//              demands are raised
//
// and Y of layer k - 1 is F there and what was chosen. The cover never fails: demands never exceed
// the slack that V has, so whoever carried v in V can serve it. F's own voxels count as carriers
// even where F alone would not be alive, because all of F stays and will be carried.
//
// Under slack a sweep up over F comes before the sweep down, to know how far F reaches by itself.
// It is right without, F's voxels then having nothing to spare, but more stays: 1785 voxels instead
// of 1547 where tests/bench takes a ball out.
//
// V is checked on the way: each layer must be alive on the one below, as it is when all are.

#include "support/preserve/descent.h"

#include <sf/preserve.h>

#include "base/bytes.h"
#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/preserve/beam.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static sf_status create_slices(sfi_descent *d)
{
    size_t one = sf_slice_stride(d->lattice.nx) * d->lattice.ny; // as in a grid: does not overflow
    d->words = sfi_alloc_array(&d->allocator, SFI_DESCENT_COUNT, one * sizeof *d->words);
    if (d->words == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < SFI_DESCENT_COUNT; i++) {
        sf_slice slice = {d->words + i * one, d->lattice.nx, d->lattice.ny,
                          sf_slice_stride(d->lattice.nx)};
        d->s[i] = slice;
    }
    return SF_OK;
}

static sf_status create_fields(sfi_descent *d, sf_task *task)
{
    const sfi_completion *c = d->task;
    size_t one = sfi_slack_stride(d->lattice.nx);
    d->codes = sfi_alloc_array(&d->allocator, 4 * (size_t)d->lattice.ny, one);
    if (d->codes == NULL) {
        return SF_ERR_MEMORY;
    }
    one *= d->lattice.ny;
    memset(d->codes, 0, 4 * one);
    d->need = d->codes;
    d->next_need = d->codes + one;
    d->reached = d->codes + 2 * one;
    d->below = d->codes + 3 * one;
    SF_TRY(sfi_history_create(c->shape, c->terms, c->bed, &d->allocator, task, &d->all));
    if (!d->all.whole) {
        return SF_ERR_INFEASIBLE;
    }
    return sfi_history_create(c->needed, c->terms, c->bed, &d->allocator, task, &d->kept);
}

static sf_status create(sfi_descent *d, const sfi_completion *c, const sf_allocator *allocator,
                        sf_task *task)
{
    const sf_rule *rule = &c->terms->rule;
    *d = (sfi_descent){.task = c, .lattice = sf_grid_lattice(c->shape)};
    d->allocator = sfi_allocator_or_default(allocator);
    d->is_slack = rule->kind == SF_RULE_SLACK;
    d->has_bridges = sfi_bridge_any(&rule->bridge);
    uint32_t nx = d->lattice.nx, ny = d->lattice.ny;
    SF_TRY(create_slices(d));
    SF_TRY(sfi_carrier_create(rule, nx, ny, &d->allocator, &d->carrier));
    SF_TRY(sfi_cover_create(rule, nx, ny, d->lattice.nz, &d->allocator, &d->cover));
    return d->is_slack ? create_fields(d, task) : SF_OK;
}

static void destroy(sfi_descent *d)
{
    sfi_history_destroy(&d->all);
    sfi_history_destroy(&d->kept);
    sfi_cover_destroy(&d->cover);
    sfi_carrier_destroy(&d->carrier, &d->allocator);
    size_t one = sf_slice_stride(d->lattice.nx) * d->lattice.ny;
    sfi_free_array(&d->allocator, d->words, SFI_DESCENT_COUNT, one * sizeof *d->words);
    sfi_free_array(&d->allocator, d->codes, 4 * (size_t)d->lattice.ny,
                   sfi_slack_stride(d->lattice.nx));
}

// ---------------------------------------------------------------------------------------------
// Parts of a step
// ---------------------------------------------------------------------------------------------

static int is_within(sf_slice a, sf_slice b)
{
    for (uint32_t y = 0; y < a.height; y++) {
        const uint64_t *in = sfi_slice_row(a, y), *out = sfi_slice_row(b, y);
        size_t last = sfi_row_words(a.width) - 1;
        uint64_t outside = in[last] & ~out[last] & sfi_tail_mask(a.width);
        for (size_t i = 0; i < last; i++) {
            outside |= in[i] & ~out[i];
        }
        if (outside != 0) {
            return 0;
        }
    }
    return 1;
}

// dst |= a and b.
static void add_common(sf_slice dst, sf_slice a, sf_slice b)
{
    for (uint32_t y = 0; y < dst.height; y++) {
        const uint64_t *p = sfi_slice_row(a, y), *q = sfi_slice_row(b, y);
        uint64_t *out = sfi_slice_row(dst, y);
        for (size_t i = 0; i < sfi_row_words(dst.width); i++) {
            out[i] |= p[i] & q[i];
        }
        out[sfi_row_words(dst.width) - 1] &= sfi_tail_mask(dst.width);
    }
}

// The layer of V is alive on the one below, and which of it without bridges.
static sf_status check_layer(sfi_descent *d, uint32_t k, const sfi_front *below)
{
    sf_slice solid = sf_grid_slice(d->task->shape, k);
    sf_slice exempt = sfi_mask_slice(d->task->terms->exempt, k);
    if (!is_within(sf_grid_slice(d->task->needed, k), solid)) {
        return SF_ERR_INFEASIBLE;
    }
    if (k == d->task->bed || (d->is_slack && !d->has_bridges)) {
        return SF_OK; // under slack the history has told
    }
    if (k < d->task->bed) {
        int carried = exempt.words != NULL ? is_within(solid, exempt) : !sfi_slice_any(solid);
        return carried ? SF_OK : SF_ERR_INFEASIBLE;
    }
    sfi_front front = {d->s[SFI_DESCENT_ALIVE], d->reached};
    sf_slice own = d->has_bridges ? d->s[SFI_DESCENT_OWN] : SFI_NO_SLICE;
    SF_TRY(sfi_carry(&d->carrier, k, below, solid, exempt, front, own));
    return is_within(solid, front.alive) ? SF_OK : SF_ERR_INFEASIBLE;
}

// s[SFI_DESCENT_FREE] = what of Y is carried by what stays anyway in layer k - 1, or is exempt.
static sf_status find_free(sfi_descent *d, uint32_t k)
{
    const sf_terms *terms = d->task->terms;
    sf_slice want = d->s[SFI_DESCENT_WANT], kept = sf_grid_slice(d->task->needed, k - 1);
    sf_slice exempt = sfi_mask_slice(terms->exempt, k), one = d->s[SFI_DESCENT_MUST];
    sf_element *element = &d->cover.element;
    SF_TRY(sf_rule_element(&terms->rule, k - 1, element));
    if (!d->is_slack) {
        SF_TRY(sf_slice_and_dilate(d->s[SFI_DESCENT_FREE], want, kept, element));
        if (exempt.words != NULL) {
            add_common(d->s[SFI_DESCENT_FREE], want, exempt);
        }
        return SF_OK;
    }
    const sfi_front *front;
    size_t bytes = sfi_slack_stride(d->lattice.nx) * d->lattice.ny;
    SF_TRY(sfi_history_at(&d->kept, k - 1, &front));
    memcpy(d->below, front->slack, bytes);
    sfi_demand_raise(d, d->below, kept);
    d->cover.gain = sfi_slack_gain(&terms->rule, k - 1);
    // What has a code below lies within both; the slices are free until their turn comes.
    sfi_front below = {d->s[SFI_DESCENT_FREE], d->below}, reached = {one, d->reached};
    SF_TRY(sf_slice_or(below.alive, front->alive, kept));
    sfi_slack_step(&terms->rule, k - 1, element, &below, want, SFI_NO_SLICE, reached);
    sfi_demand_select(d, want, d->reached, d->s[SFI_DESCENT_FREE]);
    if (exempt.words != NULL) {
        sfi_demand_select(d, want, NULL, one);
        add_common(d->s[SFI_DESCENT_FREE], one, exempt);
    }
    return SF_OK;
}

// s[SFI_DESCENT_PENDING] = what of Y must be carried by voxels that are yet to be chosen.
static sf_status find_pending(sfi_descent *d)
{
    sf_slice want = d->s[SFI_DESCENT_WANT], free = d->s[SFI_DESCENT_FREE],
             must = d->s[SFI_DESCENT_MUST];
    if (!d->has_bridges) {
        return sf_slice_subtract(d->s[SFI_DESCENT_PENDING], want, free);
    }
    SF_TRY(sf_slice_copy(must, free));
    if (d->is_slack) {
        sfi_demand_select(d, want, NULL, d->s[SFI_DESCENT_PENDING]); // those without a demand
        SF_TRY(sf_slice_subtract(d->s[SFI_DESCENT_PENDING], want, d->s[SFI_DESCENT_PENDING]));
        SF_TRY(sf_slice_or(must, must, d->s[SFI_DESCENT_PENDING]));
    }
    sfi_beam beam = {.bridge = &d->task->terms->rule.bridge,
                     .own = d->s[SFI_DESCENT_OWN],
                     .want = want,
                     .ends = d->s[SFI_DESCENT_ENDS],
                     .anchored = d->s[SFI_DESCENT_ANCHORED],
                     .gaps = d->s[SFI_DESCENT_GAPS],
                     .added = d->s[SFI_DESCENT_ADDED]};
    SF_TRY(sfi_beam_thin(&beam, must));
    return sf_slice_subtract(d->s[SFI_DESCENT_PENDING], beam.ends, free);
}

static void close_bridges(sfi_descent *d, uint32_t k)
{
    sfi_beam beam = {.bridge = &d->task->terms->rule.bridge,
                     .solid = sf_grid_slice(d->task->shape, k),
                     .own = d->s[SFI_DESCENT_OWN],
                     .want = d->s[SFI_DESCENT_WANT],
                     .ends = d->s[SFI_DESCENT_ENDS],
                     .anchored = d->s[SFI_DESCENT_ANCHORED],
                     .gaps = d->s[SFI_DESCENT_GAPS],
                     .added = d->s[SFI_DESCENT_ADDED]};
    sfi_beam_close(&beam, d->is_slack ? d->need : NULL);
}

// ---------------------------------------------------------------------------------------------
// The sweep
// ---------------------------------------------------------------------------------------------

// Layer k of the result, and what it asks of layer k - 1.
static sf_status descend(sfi_descent *d, uint32_t k, sf_slice result)
{
    uint32_t bed = d->task->bed;
    sfi_front plain = {SFI_NO_SLICE, NULL};
    const sfi_front *below = &plain;
    if (k > bed) {
        plain.alive = sf_grid_slice(d->task->shape, k - 1);
        if (d->is_slack) {
            SF_TRY(sfi_history_at(&d->all, k - 1, &below));
        }
    }
    SF_TRY(check_layer(d, k, below));
    if (k < bed) {
        return sf_slice_copy(result, sf_grid_slice(d->task->needed, k));
    }
    if (k > bed && d->has_bridges) {
        close_bridges(d, k);
    }
    SF_TRY(sf_slice_copy(result, d->s[SFI_DESCENT_WANT]));
    if (k == bed) {
        return SF_OK;
    }
    SF_TRY(find_free(d, k));
    SF_TRY(find_pending(d));
    return sfi_descent_choose(d, k, below);
}

static void turn(sfi_descent *d)
{
    sf_slice want = d->s[SFI_DESCENT_WANT];
    uint8_t *need = d->need;
    d->s[SFI_DESCENT_WANT] = d->s[SFI_DESCENT_NEXT];
    d->s[SFI_DESCENT_NEXT] = want;
    d->need = d->next_need;
    d->next_need = need;
}

sf_status sfi_complete_into(sf_grid *to, const sfi_completion *c, const sf_allocator *allocator,
                            sf_task *task)
{
    sfi_descent d;
    uint32_t nz = sf_grid_lattice(c->shape).nz;
    sfi_progress progress = sfi_progress_begin(task);
    sf_status status = create(&d, c, allocator, task);
    if (status == SF_OK) {
        for (int i = 0; i < SFI_DESCENT_COUNT; i++) {
            sfi_slice_clear(d.s[i]);
        }
        status = sf_slice_copy(d.s[SFI_DESCENT_WANT], sf_grid_slice(c->needed, nz - 1));
    }
    if (status == SF_OK && d.is_slack) {
        sfi_demand_raise(&d, d.need, d.s[SFI_DESCENT_WANT]);
    }
    for (uint32_t k = nz; status == SF_OK && k-- > 0;) {
        status =
            sf_task_is_cancelled(task) ? SF_ERR_CANCELLED : descend(&d, k, sf_grid_slice(to, k));
        turn(&d);
        sfi_progress_report(&progress, nz - k, nz);
    }
    destroy(&d);
    return status;
}

// Copy all voxels; both have one size.
static void assign(sf_grid *to, const sf_grid *from)
{
    uint32_t nz = sf_grid_lattice(from).nz;
    for (uint32_t k = 0; k < nz; k++) {
        (void)!sf_slice_copy(sf_grid_slice(to, k), sf_grid_slice(from, k));
    }
}

sf_status sf_grid_complete(const sf_grid *shape, const sf_grid *needed, const sf_terms *terms,
                           const sf_allocator *allocator, sf_task *task, sf_grid *result)
{
    sfi_ground ground;
    SF_TRY(sfi_terms_check(terms, shape, &ground));
    if (needed == NULL || result == NULL || result == shape || result == needed ||
        result == terms->exempt) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_terms_match(&ground.lattice, needed));
    SF_TRY(sfi_terms_match(&ground.lattice, result));
    sf_grid *made;
    sfi_completion completion = {shape, needed, terms, ground.bed, 0};
    SF_TRY(sf_grid_create(&ground.lattice, allocator, &made));
    sf_status status = sfi_complete_into(made, &completion, allocator, task);
    if (status == SF_OK) {
        assign(result, made);
    }
    sf_grid_destroy(made);
    return status;
}
