// SPDX-License-Identifier: MIT
// Bridges in a layer that is being chosen: what must be added for them to hold, and which of their
// ends need no support.

#ifndef SF_SUPPORT_BEAM_H
#define SF_SUPPORT_BEAM_H

#include "support/rule/carry.h"

// One layer under a rule with bridges, with scratch. All slices have one size and do not overlap.
typedef struct sfi_beam {
    const sf_bridge *bridge;
    sf_slice solid; // the layer of the shape
    sf_slice own;   // what of it is alive without bridges
    sf_slice want;  // what is to stay of it
    sf_slice ends;  // what of `want` will be carried
    sf_slice anchored, gaps, added;
} sfi_beam;

// Add to `want` the bridges of `solid`, with their anchors, that its voxels outside `own` need:
// after that all of it holds where `want` and `own` are carried. Under slack what is added gets the
// code 1 in `need`, where it had none.
void sfi_beam_close(const sfi_beam *beam, uint8_t *need);

// ends = `must` where that is enough for all of `want` to hold; else `want` and `own`, without as
// many of those outside `must` as it takes for none to be superfluous, in row order.
sf_status sfi_beam_thin(const sfi_beam *beam, sf_slice must);

#endif
