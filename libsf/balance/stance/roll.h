// SPDX-License-Identifier: MIT
// A convex body that rolls on the ground until it rests.

#ifndef SF_BALANCE_ROLL_H
#define SF_BALANCE_ROLL_H

#include <sf/stance.h>

#include "base/polygon.h"
#include "mesh/hull.h"

// The corners of a body's hull, somebody else's, and room to work in.
typedef struct sfi_roller {
    const double *corners; // three a corner
    size_t count;
    double diagonal_mm;
    double contact_mm; // corners this close above the lowest one touch
    uint32_t *touching;
    sfi_corner *polygon;
} sfi_roller;

// Where the corners of a hull of these points lie, three numbers each. SF_ERR_MEMORY.
sf_status sfi_hull_corners(const sfi_hull *hull, const double *points,
                           const sf_allocator *allocator, double **corners);

// SF_ERR_MEMORY.
sf_status sfi_roller_create(const double *corners, size_t count, double diagonal_mm,
                            double contact_mm, const sf_allocator *allocator, sfi_roller *roller);
void sfi_roller_destroy(sfi_roller *roller, const sf_allocator *allocator);

// Where it comes to rest, from a start of length 1. `edge`: the edge of what it rests on over which
// it would leave first.
void sfi_roll(const sfi_roller *roller, const double com[3], const double start[3], sf_rest *rest,
              double edge[2][3]);

#endif
