// SPDX-License-Identifier: MIT
// A whole grid being grown: what its parts share.

#ifndef SF_SUPPORT_GROWTH_H
#define SF_SUPPORT_GROWTH_H

#include "support/grow/grow_cover.h"

// Which bridges a growth counts on: none, or new ones along x or along y.
typedef enum sfi_growth_kind { SFI_GROW_PLAIN = 0, SFI_GROW_X = 1, SFI_GROW_Y = 2 } sfi_growth_kind;

typedef struct sfi_growth {
    sfi_site site; // the shape, and the terms
    sf_task *task;
    sfi_progress progress;
    uint64_t done, total; // layers, over all sweeps
    size_t area;

    // What may be alive at most: the trim of the shape with all that may be added. All NULL where
    // that is everything from the bed up.
    sf_grid *possible, *own;
    uint8_t *spare;

    // What of the shape is alive as it is; NULL where its bits tell.
    sf_grid *alive;
    uint8_t *codes;

    uint16_t *price; // of each voxel from the bed layer up

    // One run from the top down.
    sf_grid *result;
    sf_grid *bits;      // working memory, by what follows
    uint8_t *demand[2]; // under slack, by voxels: of the layer and of the one below, by parity
    sfi_grow_cover cover;
} sfi_growth;

// Layers of `bits`, for the layer at work: what the shape below carries (not under slack), what a
// bridge holds, what holds a bridge; and by parity which voxels are asked to have slack to spare.
enum {
    SFI_GROW_CARRIED = 0,
    SFI_GROW_SPANNED = 1,
    SFI_GROW_ANCHOR = 2,
    SFI_GROW_RAISED = 3,
    SFI_GROW_BITS = 5
};

// Before the first layer of a run.
sf_status sfi_growth_begin(sfi_growth *g);

// Give the voxels of layer k > bed of g->result supporters in layer k - 1.
sf_status sfi_growth_layer(sfi_growth *g, uint32_t k, sfi_growth_kind kind);

#endif
