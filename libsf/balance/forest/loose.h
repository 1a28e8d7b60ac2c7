// SPDX-License-Identifier: MIT
// Pieces that no wall holds.

#ifndef SF_BALANCE_LOOSE_H
#define SF_BALANCE_LOOSE_H

#include "balance/forest/interior.h"

// Take out of a shape every piece, connected through faces, edges and corners, that holds no voxel
// of the wall, if there is a wall and the rest is supported without it. SF_ERR_MEMORY,
// SF_ERR_OVERFLOW, SF_ERR_CANCELLED.
sf_status sfi_drop_loose(const sfi_interior *in, sf_grid *shape);

#endif
