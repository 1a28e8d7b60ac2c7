// SPDX-License-Identifier: MIT
// What is alive in each layer of a shape under slack, from the top down.

#ifndef SF_SUPPORT_HISTORY_H
#define SF_SUPPORT_HISTORY_H

#include "support/rule/carry.h"
#include "support/rule/terms.h"

// Fronts of a shape, some kept and the others made again when they are asked for.
typedef struct sfi_history {
    const sf_grid *shape;
    const sf_terms *terms;
    uint32_t bed, layer_count;
    sf_allocator allocator;
    sfi_carrier carrier;
    uint32_t block;    // layers from one kept front to the next
    sfi_front *fronts; // those kept, then those of the block at hand
    size_t front_count;
    uint32_t at; // first layer of the block at hand; UINT32_MAX: none
    int whole;   // whether all of the shape is alive
} sfi_history;

// Sweep up once. The shape and the terms are only read and must outlive the history; the terms have
// been checked. SF_ERR_MEMORY, SF_ERR_CANCELLED. Destroying what was never created (all zero) does
// nothing.
sf_status sfi_history_create(const sf_grid *shape, const sf_terms *terms, uint32_t bed,
                             const sf_allocator *allocator, sf_task *task, sfi_history *history);
void sfi_history_destroy(sfi_history *history);

// The front of layer k. Cheap when the layers are asked for from the top down.
sf_status sfi_history_at(sfi_history *history, uint32_t k, const sfi_front **front);

#endif
