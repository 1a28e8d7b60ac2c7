// SPDX-License-Identifier: MIT
// The inside of tetrahedra.

#ifndef SF_GRADE_TETRA_TETS_H
#define SF_GRADE_TETRA_TETS_H

#include <sf/tetra.h>

#include "grade/channels.h"

struct sf_tets {
    sf_allocator allocator;
    size_t points, tets;
    double *positions;  // their own; NULL where they follow a refinement
    const double *seen; // positions, their own or the refinement's
    uint32_t *corners;
    // Their own; where they follow a refinement only the indices are theirs.
    sfi_channels channels;
};

// Largest number of tetrahedra: their corners can be counted.
#define SFI_TET_MAX ((size_t)INT32_MAX / 4)

#endif
