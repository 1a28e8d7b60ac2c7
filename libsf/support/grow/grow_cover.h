// SPDX-License-Identifier: MIT
// Supporters for the voxels of one layer: the step that sf_grid_grow() is made of.

#ifndef SF_SUPPORT_GROW_COVER_H
#define SF_SUPPORT_GROW_COVER_H

#include "support/grow/site.h"

// A price that no voxel has: it is not to be had.
#define SFI_PRICE_NONE UINT16_MAX

// One voxel that can carry another: how far it lies away, and under slack what that costs.
typedef struct sfi_reach {
    int16_t dx, dy;
    uint32_t cost;
} sfi_reach;

// Squares of 3, 9, 27, ... voxels, and how many needy voxels each of them holds.
#define SFI_BLOCK_LEVELS 11u // 3^11 is more than SF_EXTENT_MAX

typedef struct sfi_blocks {
    uint32_t width, height, levels;
    size_t first[SFI_BLOCK_LEVELS]; // of each level, in count
    uint32_t *count;
    size_t places;
} sfi_blocks;

sf_status sfi_blocks_create(sfi_blocks *blocks, uint32_t width, uint32_t height,
                            const sf_allocator *allocator);
void sfi_blocks_destroy(sfi_blocks *blocks, const sf_allocator *allocator);

// Add to the counts of all squares around voxel v (UINT32_MAX: take one away).
void sfi_blocks_add(sfi_blocks *blocks, uint32_t v, uint32_t add);

// The voxel that v is drawn to, where it lands after so many steps.
uint32_t sfi_blocks_goal(const sfi_blocks *blocks, uint32_t v, uint32_t steps);

// What a layer needs, and what the layer below offers. Voxels are numbers y * width + x.
typedef struct sfi_grow_cover {
    sf_allocator allocator;
    uint32_t width, height;
    size_t area;
    sfi_reach *reach; // of the step, closest first by rows
    size_t reach_count, reach_capacity;
    int has_slack;
    uint32_t gain, cap;

    // Asked by the caller for each layer:
    uint32_t *needy; // voxels without a supporter, in ascending order
    size_t needy_count;
    const uint8_t *demand; // under slack: what each of them must have to spare
    const uint16_t *price; // of each voxel below, SFI_PRICE_NONE for what may not be there
    const uint8_t *spare;  // under slack: codes of what is possible below; NULL: the cap

    // The answer:
    uint32_t *chosen;
    size_t chosen_count;
    uint8_t *asked; // under slack, for the chosen ones: what they must have to spare

    // Working memory, zero between layers but for `least`.
    uint8_t *mark;
    uint16_t *least;    // of a needy voxel: the price of its cheapest supporter
    uint32_t *have;     // of a needy voxel: chosen supporters
    uint64_t *count;    // of a candidate: who looks at it, and who would rather have no other
    uint64_t *possible; // bits of the candidates
    size_t words;
    sfi_blocks blocks;
} sfi_grow_cover;

// SF_ERR_MEMORY, SF_ERR_OVERFLOW; destroying what was never created (all zero) does nothing.
sf_status sfi_grow_cover_create(sfi_grow_cover *cover, const sfi_site *site);
void sfi_grow_cover_destroy(sfi_grow_cover *cover);

// Make the reach that of the step between layers k and k + 1.
sf_status sfi_grow_cover_set_step(sfi_grow_cover *cover, const sf_rule *plain, uint32_t k);

// Drop needy voxels that bridges will hold between those that are left: along x (step 1) or along y
// (step width), with gaps of at most `span` between at least `anchor` voxels.
void sfi_grow_cover_thin(sfi_grow_cover *cover, uint32_t step, uint32_t span, uint32_t anchor);

// Choose supporters for all needy voxels. SF_ERR_INTERNAL where one of them can have none.
sf_status sfi_grow_cover_choose(sfi_grow_cover *cover);

#endif
