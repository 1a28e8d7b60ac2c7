// SPDX-License-Identifier: MIT
// From voxel to voxel through a solid, knowing at each which place it is.

#ifndef SF_GRADE_SAMPLE_WALK_H
#define SF_GRADE_SAMPLE_WALK_H

#include "grade/sample/tree.h"

#include <sf/locate.h>

typedef struct sfi_walker {
    sfi_tree tree;           // positions and one property
    const uint32_t *corners; // of pieces: eight points each
    const sf_locator *locator;
    double reach;     // how far outside of the shape a point may be, mm
    uint64_t located; // points that had to be searched for
} sfi_walker;

// Go to a point from a place that may be near it, or from nowhere (its piece is SF_NO_PIECE), and
// give the place and the property there. Returns 0 if the point is not within reach of the shape,
// and then changes nothing. SF_ERR_MEMORY is taken for that, too.
int sfi_walk_to(sfi_walker *walker, const double point[3], sf_place *place, double *value);

#endif
