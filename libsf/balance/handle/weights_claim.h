// SPDX-License-Identifier: MIT
// Which nodes handles hold, and which pieces hold none.

#ifndef SF_BALANCE_WEIGHTS_CLAIM_H
#define SF_BALANCE_WEIGHTS_CLAIM_H

#include "balance/handle/poisson.h"

#include <sf/weights.h>

// Nobody holds this node; it belongs to a piece without a handle.
#define SFI_NODE_FREE UINT8_MAX
#define SFI_NODE_LOOSE (UINT8_MAX - 1)

// owner[node] = the handle that holds it, or SFI_NODE_FREE. The handles must be what the header
// says: finite, of a kind, with regions of the lattice's counts. SF_ERR_INFEASIBLE: one that holds
// nothing, two that hold one node; SF_ERR_ARGUMENT: a region without voxels.
sf_status sfi_claim(const sfi_domain *domain, const sf_handle *handles, size_t count,
                    uint8_t *owner, sf_fault *fault);

// Mark nodes of pieces that hold no handle as SFI_NODE_LOOSE, and number all pieces: piece[node].
// `queue` has a place for each node. Returns how many pieces are loose.
size_t sfi_claim_pieces(const sfi_level *level, uint8_t *owner, uint32_t *piece, uint32_t *queue);

#endif
