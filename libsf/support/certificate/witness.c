// SPDX-License-Identifier: MIT
// Witnesses: one sweep over a shape that finds it support-free, and notes what shows it.
//
// The sweep is the trim's, but writes nothing: a layer of which all is alive is as it should be,
// and the first that is not ends the sweep. What is noted is what somebody who looks at the result
// would have to search for: the exempt voxels, as runs, and the gaps that bridges span.
//
// Bridges leave their mark as voxels that are alive, but not by their own supporters (`own`, the
// set A). In a layer that has such voxels, each is asked along each direction for the gap that it
// lies in: back from it to the first voxel of A* and forth to the next (bridge.c says what A* is).
// Only the first such voxel of a gap answers, so each gap is noted once, and in an order that needs
// no sorting. A voxel is in A* when the run of A through it, along the direction, is long enough.

#include "support/certificate/witness.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/check/row.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/slice.h"

// A direction of bridging, its number and its limits.
typedef struct direction {
    int32_t dx, dy;
    uint32_t number, span, anchor;
} direction;

// One sweep. `own` and `scratch` are slices of their own.
typedef struct sweep {
    sfi_witness *witness;
    const sf_terms *terms;
    sfi_carrier carrier;
    sfi_front fronts[2];
    sf_grid *memory; // of the two slices
    sf_slice own, scratch;
} sweep;

// ---------------------------------------------------------------------------------------------
// Gaps
// ---------------------------------------------------------------------------------------------

static int has(sf_slice slice, int64_t x, int64_t y)
{
    return x >= 0 && y >= 0 && x < slice.width && y < slice.height &&
           (sfi_slice_row(slice, (uint32_t)y)[x / 64] >> (x % 64) & 1) != 0;
}

// Voxels of own from (x, y) on, that one not counted, at most `most`.
static uint32_t count_on(sf_slice own, int64_t x, int64_t y, int64_t dx, int64_t dy, uint32_t most)
{
    uint32_t count = 0;
    while (count < most && has(own, x + (count + 1) * dx, y + (count + 1) * dy)) {
        count++;
    }
    return count;
}

static int is_anchored(const direction *d, sf_slice own, int64_t x, int64_t y)
{
    if (!has(own, x, y)) {
        return 0;
    }
    uint32_t back = count_on(own, x, y, -d->dx, -d->dy, d->anchor);
    return back + 1 + count_on(own, x, y, d->dx, d->dy, d->anchor) >= d->anchor;
}

// The gap whose first voxel outside own is (x, y); a length of 0 where there is none, or where
// another voxel comes first.
static sf_certificate_span gap_at(const direction *d, sf_slice solid, sf_slice own, uint32_t k,
                                  int64_t x, int64_t y)
{
    sf_certificate_span none = {k, d->number, 0, 0, 0};
    int64_t back = 0, length = 1;
    for (;;) {
        int64_t u = x - (back + 1) * d->dx, v = y - (back + 1) * d->dy;
        if (is_anchored(d, own, u, v)) {
            break;
        }
        if (!has(own, u, v) || ++back >= d->span) {
            return none;
        }
    }
    x -= back * d->dx;
    y -= back * d->dy;
    for (length += back; !is_anchored(d, own, x + length * d->dx, y + length * d->dy); length++) {
        if (length >= d->span || !has(solid, x + length * d->dx, y + length * d->dy)) {
            return none;
        }
    }
    sf_certificate_span gap = {k, d->number, (uint32_t)y, (uint32_t)x, (uint32_t)length};
    return length <= d->span ? gap : none;
}

static sf_status add_span(sfi_witness *w, const sf_certificate_span *span)
{
    void *spans = w->spans;
    if (!sfi_grow_array(&w->allocator, &spans, &w->span_capacity, w->span_count + 1,
                        sizeof *w->spans)) {
        return SF_ERR_MEMORY;
    }
    w->spans = spans;
    w->spans[w->span_count++] = *span;
    return SF_OK;
}

// Gaps of a layer along one direction; `hanging` is what of solid is not in own.
static sf_status note_gaps_along(sfi_witness *w, const direction *d, sf_slice solid, sf_slice own,
                                 sf_slice hanging, uint32_t k)
{
    for (uint32_t y = 0; y < solid.height; y++) {
        const uint64_t *row = sfi_slice_row(hanging, y);
        for (size_t i = 0; i < sfi_row_words(solid.width); i++) {
            for (uint64_t left = row[i]; left != 0; left &= left - 1) {
                int64_t x = (int64_t)i * 64 + sfi_lowest_bit(left);
                sf_certificate_span gap = gap_at(d, solid, own, k, x, y);
                if (gap.length > 0) {
                    SF_TRY(add_span(w, &gap));
                }
            }
        }
    }
    return SF_OK;
}

static uint32_t at_least_one(uint32_t anchor)
{
    return anchor > 0 ? anchor : 1;
}

static sf_status note_gaps(sweep *s, uint32_t k, sf_slice solid)
{
    sfi_witness *w = s->witness;
    const sf_bridge *b = &s->terms->rule.bridge;
    uint32_t diagonal = at_least_one(b->anchor_diagonal);
    const direction directions[4] = {{1, 0, 0, b->span_x, at_least_one(b->anchor_x)},
                                     {0, 1, 1, b->span_y, at_least_one(b->anchor_y)},
                                     {1, 1, 2, b->span_diagonal, diagonal},
                                     {-1, 1, 3, b->span_diagonal, diagonal}};
    SF_TRY(sf_slice_subtract(s->scratch, solid, s->own));
    w->layers[k].bridged = sf_slice_popcount(s->scratch);
    for (int i = 0; w->layers[k].bridged > 0 && i < 4; i++) {
        if (directions[i].span > 0) {
            SF_TRY(note_gaps_along(w, &directions[i], solid, s->own, s->scratch, k));
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// The sweep
// ---------------------------------------------------------------------------------------------

// The solid exempt voxels of a layer, as runs.
static sf_status note_exempt(sweep *s, uint32_t k, sf_slice solid, sf_slice exempt)
{
    sfi_witness *w = s->witness;
    size_t count, need;
    if (exempt.words == NULL) {
        return SF_OK;
    }
    SF_TRY(sf_slice_and(s->scratch, solid, exempt));
    SF_TRY(sf_slice_run_count(s->scratch, &count));
    void *runs = w->exempt;
    if (count == 0) {
        return SF_OK;
    }
    if (!sfi_size_add(w->exempt_count, count, &need) ||
        !sfi_grow_array(&w->allocator, &runs, &w->exempt_capacity, need, sizeof *w->exempt)) {
        return SF_ERR_MEMORY;
    }
    w->exempt = runs;
    SF_TRY(sf_slice_runs(s->scratch, w->exempt + w->exempt_count, count, &count));
    for (; w->exempt_count < need; w->exempt_count++) {
        w->exempt[w->exempt_count].label = k;
    }
    w->layers[k].exempt = sf_slice_popcount(s->scratch);
    return SF_OK;
}

// The front of layer k, and what of it needs no bridge.
static sf_status carry_layer(sweep *s, uint32_t k, uint32_t bed, sf_slice solid, sf_slice exempt)
{
    return sfi_carry_layer(&s->carrier, k, bed, &s->fronts[(k + 1) % 2], solid, exempt,
                           s->fronts[k % 2], s->own);
}

static sf_status refuse(sweep *s, uint32_t k, sf_slice solid, sf_fault *fault)
{
    uint32_t x0 = 0, x1 = 0, y = 0;
    SF_TRY(sf_slice_subtract(s->scratch, solid, s->fronts[k % 2].alive));
    while (!sfi_row_next_run(sfi_slice_row(s->scratch, y), solid.width, &x0, &x1)) {
        x1 = 0;
        y++;
    }
    return sfi_fault_set(fault, SF_ERR_INFEASIBLE, 0, 0,
                         "the shape is not support-free: nothing carries voxel x %u, y %u of layer "
                         "%u; trim it first, or name the voxel exempt",
                         (unsigned)x0, (unsigned)y, (unsigned)k);
}

static sf_status look_at_layer(sweep *s, uint32_t k, uint32_t bed, sf_slice solid, sf_slice exempt,
                               sf_fault *fault)
{
    SF_TRY(carry_layer(s, k, bed, solid, exempt));
    if (!sf_slice_equal(s->fronts[k % 2].alive, solid)) {
        return refuse(s, k, solid, fault);
    }
    s->witness->layers[k].solid = sf_slice_popcount(solid);
    SF_TRY(note_exempt(s, k, solid, exempt));
    return note_gaps(s, k, solid);
}

static sf_status sweep_create(sweep *s, const sf_lattice *lattice)
{
    const sf_allocator *allocator = &s->witness->allocator;
    const sf_rule *rule = &s->terms->rule;
    sf_lattice two = *lattice;
    two.nz = 2;
    two.heights_mm = NULL;
    two.layer_mm = 1.0;
    SF_TRY(sf_grid_create(&two, allocator, &s->memory));
    s->own = sf_grid_slice(s->memory, 0);
    s->scratch = sf_grid_slice(s->memory, 1);
    SF_TRY(sfi_carrier_create(rule, lattice->nx, lattice->ny, allocator, &s->carrier));
    SF_TRY(sfi_front_create(rule, lattice->nx, lattice->ny, allocator, &s->fronts[0]));
    return sfi_front_create(rule, lattice->nx, lattice->ny, allocator, &s->fronts[1]);
}

static void sweep_destroy(sweep *s)
{
    const sf_allocator *allocator = &s->witness->allocator;
    sfi_front_destroy(&s->fronts[0], &s->terms->rule, allocator);
    sfi_front_destroy(&s->fronts[1], &s->terms->rule, allocator);
    sfi_carrier_destroy(&s->carrier, allocator);
    sf_grid_destroy(s->memory);
}

sf_status sfi_witness_find(sfi_witness *witness, const sf_grid *shape, const sf_terms *terms,
                           uint32_t bed, sfi_progress *progress, uint64_t done, uint64_t total,
                           sf_fault *fault)
{
    sf_lattice lattice = sf_grid_lattice(shape);
    witness->layers = sfi_alloc_array(&witness->allocator, lattice.nz, sizeof *witness->layers);
    if (witness->layers == NULL) {
        return SF_ERR_MEMORY;
    }
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_certificate_layer nothing = {0, 0, 0};
        witness->layers[k] = nothing;
    }
    sweep s = {.witness = witness, .terms = terms};
    sf_status status = sweep_create(&s, &lattice);
    for (uint32_t k = 0; status == SF_OK && k < lattice.nz; k++) {
        if (sf_task_is_cancelled(progress->task)) {
            status = SF_ERR_CANCELLED;
            break;
        }
        status = look_at_layer(&s, k, bed, sf_grid_slice(shape, k),
                               sfi_mask_slice(terms->exempt, k), fault);
        sfi_progress_report(progress, done + k + 1, total);
    }
    sweep_destroy(&s);
    return status;
}

void sfi_witness_release(sfi_witness *w, uint32_t layer_count)
{
    sfi_free_array(&w->allocator, w->layers, layer_count, sizeof *w->layers);
    sfi_free_array(&w->allocator, w->exempt, w->exempt_capacity, sizeof *w->exempt);
    sfi_free_array(&w->allocator, w->spans, w->span_capacity, sizeof *w->spans);
}
