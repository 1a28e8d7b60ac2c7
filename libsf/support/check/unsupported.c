// SPDX-License-Identifier: MIT
// Which voxels nothing carries, in a shape as it is drawn.
//
// A check counts them and names their regions; here they are a grid, for whoever wants to take them
// as given: with these exempt the shape is support-free, and an operator that keeps it so makes
// nothing hang that did not. (What a trim would take is far more: all that rests on them.)
//
// From the bottom up, layer by layer; what is not carried is then made alive all the same, with no
// reach to spare, just as an exempt voxel is.

#include "base/memory.h"
#include "base/status.h"
#include "base/task.h"
#include "support/rule/carry.h"
#include "support/rule/terms.h"
#include "voxel/grid.h"
#include "voxel/slice.h"

#include <sf/support.h>

#include <string.h>

typedef struct sweep {
    const sf_grid *grid;
    const sf_terms *terms;
    sfi_ground ground;
    sfi_carrier carrier;
    sfi_front fronts[2];
    sf_grid *found;
} sweep;

// What of layer k is alive by what lies below it, or exempt.
static sf_status carry_layer(sweep *s, uint32_t k, sf_slice solid, sfi_front front)
{
    return sfi_carry_layer(&s->carrier, k, s->ground.bed, &s->fronts[(k + 1) % 2], solid,
                           sfi_mask_slice(s->terms->exempt, k), front, SFI_NO_SLICE);
}

static sf_status find(sweep *s, sf_task *task)
{
    sfi_progress progress = sfi_progress_begin(task);
    for (uint32_t k = 0; k < s->ground.lattice.nz; k++) {
        sf_slice solid = sf_grid_slice(s->grid, k);
        sfi_front front = s->fronts[k % 2];
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        SF_TRY(carry_layer(s, k, solid, front));
        SF_TRY(sf_slice_subtract(sf_grid_slice(s->found, k), solid, front.alive));
        SF_TRY(sfi_carry_anyway(&s->carrier, solid, front));
        sfi_progress_report(&progress, k + 1, s->ground.lattice.nz);
    }
    return SF_OK;
}

static sf_status run(sweep *s, const sf_allocator *allocator, sf_task *task)
{
    const sf_lattice *l = &s->ground.lattice;
    SF_TRY(sf_grid_create(l, allocator, &s->found));
    SF_TRY(sfi_carrier_create(&s->terms->rule, l->nx, l->ny, allocator, &s->carrier));
    for (int i = 0; i < 2; i++) {
        SF_TRY(sfi_front_create(&s->terms->rule, l->nx, l->ny, allocator, &s->fronts[i]));
    }
    return find(s, task);
}

sf_status sf_grid_unsupported(const sf_grid *grid, const sf_terms *terms,
                              const sf_allocator *allocator, sf_task *task, sf_grid *unsupported,
                              uint64_t *count)
{
    sweep s;
    memset(&s, 0, sizeof s);
    SF_TRY(sfi_terms_check(terms, grid, &s.ground));
    if (unsupported == NULL || unsupported == grid || sfi_terms_mask(terms, unsupported)) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(sfi_terms_match(&s.ground.lattice, unsupported));
    sf_allocator memory = sfi_allocator_or_default(allocator);
    s.grid = grid;
    s.terms = terms;
    sf_status status = run(&s, &memory, task);
    if (status == SF_OK) {
        status = sfi_grid_copy(unsupported, s.found);
    }
    if (status == SF_OK && count != NULL) {
        *count = sf_grid_popcount(unsupported);
    }
    for (int i = 0; i < 2; i++) {
        sfi_front_destroy(&s.fronts[i], &terms->rule, &memory);
    }
    sfi_carrier_destroy(&s.carrier, &memory);
    sf_grid_destroy(s.found);
    return status;
}
