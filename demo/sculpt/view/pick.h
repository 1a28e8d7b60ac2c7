// SPDX-License-Identifier: MIT
// What a ray meets.

#ifndef SCULPT_VIEW_PICK_H
#define SCULPT_VIEW_PICK_H

#include <sf/voxel.h>

// The first solid voxel on a ray, and the face through which it is entered.
typedef struct view_hit {
    uint32_t x, y, z;
    int axis, is_high; // the face: at right angles to x, y or z; whether it is the high one
    double distance;   // along the ray, in lengths of its direction
    double at_mm[3];
} view_hit;

// Follow a ray through a grid whose layers have one height. 0 where it meets nothing.
int view_pick(const sf_grid *grid, const double from_mm[3], const double direction[3],
              view_hit *hit);

#endif
