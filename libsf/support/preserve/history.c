// SPDX-License-Identifier: MIT
// History: the fronts of a shape, read from the top down although they are made from the bottom up.
//
// Under slack a front is a byte for each voxel, and all of them together would be eight times the
// shape. So every b-th front is kept, and the layers between two of them are made again, a block at
// a time, when the sweep downwards comes to them: with b = sqrt(nz) that is 2 sqrt(nz) fronts and
// twice the work.
//
// The place of layer k: kept fronts are those of layers 0, b, 2b, ...; a block holds its kept front
// and the b - 1 after it.
//
// Source: A. Griewank, "Achieving logarithmic growth of temporal and spatial complexity in reverse
// automatic differentiation", 1992 (the scheme with one level of it).

#include "support/preserve/history.h"

#include "base/memory.h"
#include "base/status.h"
#include "voxel/slice.h"

static uint32_t kept_count(const sfi_history *h)
{
    return (h->layer_count - 1) / h->block + 1;
}

// Layer k from the layer below it.
static sf_status make_front(const sfi_history *h, uint32_t k, const sfi_front *below,
                            sfi_front front)
{
    sf_slice solid = sf_grid_slice(h->shape, k), exempt = sfi_mask_slice(h->terms->exempt, k);
    return sfi_carry_layer(&h->carrier, k, h->bed, below, solid, exempt, front, SFI_NO_SLICE);
}

// The front that layer k has in a block of its own.
static sfi_front *place_in_block(sfi_history *h, uint32_t k)
{
    uint32_t i = k % h->block;
    return i == 0 ? &h->fronts[k / h->block] : &h->fronts[kept_count(h) + i - 1];
}

static sf_status sweep_up(sfi_history *h, sf_task *task)
{
    h->whole = 1;
    for (uint32_t k = 0; k < h->layer_count; k++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        sfi_front *front = place_in_block(h, k);
        SF_TRY(make_front(h, k, k > 0 ? place_in_block(h, k - 1) : NULL, *front));
        h->whole = h->whole && sf_slice_equal(front->alive, sf_grid_slice(h->shape, k));
    }
    h->at = (h->layer_count - 1) / h->block * h->block;
    return SF_OK;
}

static sf_status create_fronts(sfi_history *h)
{
    sf_lattice lattice = sf_grid_lattice(h->shape);
    size_t count = (size_t)kept_count(h) + h->block - 1;
    sfi_front *fronts = sfi_alloc_array(&h->allocator, count, sizeof *fronts);
    if (fronts == NULL) {
        return SF_ERR_MEMORY;
    }
    for (size_t i = 0; i < count; i++) {
        fronts[i] = (sfi_front){.slack = NULL};
    }
    h->fronts = fronts;
    h->front_count = count;
    for (size_t i = 0; i < count; i++) {
        SF_TRY(sfi_front_create(&h->terms->rule, lattice.nx, lattice.ny, &h->allocator,
                                &h->fronts[i]));
    }
    return sfi_carrier_create(&h->terms->rule, lattice.nx, lattice.ny, &h->allocator, &h->carrier);
}

sf_status sfi_history_create(const sf_grid *shape, const sf_terms *terms, uint32_t bed,
                             const sf_allocator *allocator, sf_task *task, sfi_history *h)
{
    *h = (sfi_history){.shape = shape, .terms = terms, .bed = bed, .block = 1, .at = UINT32_MAX};
    h->layer_count = sf_grid_lattice(shape).nz;
    h->allocator = sfi_allocator_or_default(allocator);
    while ((uint64_t)h->block * h->block < h->layer_count) {
        h->block++;
    }
    SF_TRY(create_fronts(h));
    return sweep_up(h, task);
}

void sfi_history_destroy(sfi_history *h)
{
    for (size_t i = 0; i < h->front_count; i++) {
        sfi_front_destroy(&h->fronts[i], &h->terms->rule, &h->allocator);
    }
    if (h->allocator.alloc != NULL) {
        sfi_free_array(&h->allocator, h->fronts, h->front_count, sizeof *h->fronts);
        sfi_carrier_destroy(&h->carrier, &h->allocator);
    }
}

sf_status sfi_history_at(sfi_history *h, uint32_t k, const sfi_front **front)
{
    uint32_t start = k / h->block * h->block;
    if (start != h->at && k != start) {
        for (uint32_t i = start + 1; i < h->layer_count && i < start + h->block; i++) {
            SF_TRY(make_front(h, i, place_in_block(h, i - 1), *place_in_block(h, i)));
        }
        h->at = start;
    }
    *front = place_in_block(h, k);
    return SF_OK;
}
