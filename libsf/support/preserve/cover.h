// SPDX-License-Identifier: MIT
// Set cover of one layer: which voxels below shall carry those that hang.

#ifndef SF_SUPPORT_COVER_H
#define SF_SUPPORT_COVER_H

#include <sf/rule.h>

#include "support/rule/carry.h"

// Offers kept by a greedy cover: a heap of keys, and a list of what was chosen.
typedef struct sfi_offers {
    uint64_t *keys;
    size_t count, capacity;
} sfi_offers;

// A greedy cover at work, with memory for slices of one size. Codes are those of sfi_front.
typedef struct sfi_cover {
    uint32_t width, height;
    sf_allocator allocator;
    // The problem: set anew for each layer.
    sf_element element;   // of the step
    uint32_t gain;        // under slack: what the step gives
    sf_slice pending;     // voxels to be carried, of the layer above
    const uint8_t *need;  // under slack: code that each must have; else NULL
    sf_slice carriers;    // voxels that may carry
    const uint8_t *slack; // under slack: codes that they have
    sf_slice first;       // those of them that are there anyway, and are taken first
    // The answer.
    sf_slice chosen;
    // Scratch.
    const uint32_t *costs; // under slack: of reaching over (dx, dy), cost_stride * dy + dx
    size_t cost_stride;
    sf_slice open, offered;
    uint32_t *counts; // for each voxel of the slice, all 0 between calls
    sfi_offers heap, order;
    uint32_t *served; // places of voxels, y * width + x
    size_t served_capacity;
} sfi_cover;

// Memory for covers of slices under a rule, whose costs are worked out for layer_count layers.
// Destroying what was never created (all zero) does nothing.
sf_status sfi_cover_create(const sf_rule *rule, uint32_t width, uint32_t height,
                           uint32_t layer_count, const sf_allocator *allocator, sfi_cover *cover);
void sfi_cover_destroy(sfi_cover *cover);

// chosen = carriers of all pending voxels, none of which, but for those in `first`, could be left
// out. SF_ERR_INTERNAL where one cannot be carried, SF_ERR_MEMORY.
sf_status sfi_cover_greedy(sfi_cover *cover);

// Under slack: raise demands, the codes of the carriers' layer, so that each pending voxel is
// served by one of the chosen; each takes the one that has to be raised least.
void sfi_cover_assign(sfi_cover *cover, uint8_t *demands);

// picked = carriers of all of `rest` that any carrier reaches, word by word: for each voxel the
// first carrier in the order straight below, then by rings outwards. rest is used up; fresh is
// scratch. For rules that are elements.
sf_status sfi_cover_priority(const sf_element *element, sf_slice rest, sf_slice carriers,
                             sf_slice picked, sf_slice fresh, sf_slice spread);

#endif
