// SPDX-License-Identifier: MIT
// Contours, cut into pieces that are monotone.

#ifndef SF_MESH_SWEEP_H
#define SF_MESH_SWEEP_H

#include "mesh/contour.h"

// From one node to another, through the inside.
typedef struct sfi_diagonal {
    uint32_t a, b;
} sfi_diagonal;

// Most diagonals that are found for each node.
#define SFI_DIAGONALS_PER_NODE 2

// Diagonals that join holes to what is around them and cut the inside into pieces that any upright
// line meets in one stretch. They cross nothing where the contours do not cross. `diagonals` has
// room for SFI_DIAGONALS_PER_NODE for each node.
sf_status sfi_sweep_diagonals(const sfi_contour *contour, const sf_allocator *allocator,
                              sfi_diagonal *diagonals, size_t *count);

#endif
