// SPDX-License-Identifier: MIT
// Supports: what to add below a region so that all of it is carried.

#ifndef SF_SUPPORT_SUPPORTS_H
#define SF_SUPPORT_SUPPORTS_H

#include "support/check/price_map.h"

// One place that may be added, while a layer is covered.
typedef struct sfi_support_place {
    uint32_t x, y;
    uint32_t price, covers; // voxels above that it carries, when they were last counted
    uint32_t away;          // from the middle of the region
} sfi_support_place;

// Voxels as runs, in any order.
typedef struct sfi_support_runs {
    sf_run *runs;
    size_t capacity, count;
} sfi_support_runs;

// What finding them works with. The slices have no voxel between calls, but after a call that
// failed.
typedef struct sfi_supports {
    const sf_rule *rule;
    const sfi_price_map *prices;
    sf_allocator allocator;
    sf_slice need, next; // what is yet to be carried, in this layer and in the one below
    sf_slice seen;       // where places were looked for
    sfi_support_runs asked, next_asked; // what there was to be carried, in both
    sfi_support_place *places;
    size_t capacity, count;
    sf_grid *added; // where what is added is drawn, or NULL
} sfi_supports;

// Memory for the slices; SF_ERR_MEMORY. Destroying what is all zero does nothing.
sf_status sfi_supports_create(sfi_supports *s, const sf_rule *rule, const sfi_price_map *prices,
                              const sf_lattice *lattice, const sf_allocator *allocator,
                              sf_grid *added);
void sfi_supports_destroy(sfi_supports *s);

// Number of voxels that carry a region of layer k, given as runs, none of which anything carries;
// SF_COST_NONE where there are none. SF_ERR_MEMORY.
sf_status sfi_supports_find(sfi_supports *s, uint32_t k, const sf_run *runs, size_t count,
                            uint64_t *cost);

#endif
