// SPDX-License-Identifier: MIT
// Pieces of the solid that no handle holds.

#ifndef SF_BALANCE_WEIGHTS_LOOSE_H
#define SF_BALANCE_WEIGHTS_LOOSE_H

#include "balance/handle/weights.h"
#include "balance/handle/weights_claim.h"

// Give the nodes that are SFI_NODE_LOOSE, piece by piece, the weights of the closest point of the
// cells that are not; there is such a cell. All other nodes have their weights. SF_ERR_MEMORY.
sf_status sfi_loose_settle(const uint8_t *owner, const uint32_t *piece,
                           const sf_allocator *allocator, sf_weights *weights);

#endif
