// SPDX-License-Identifier: MIT
// The last voxels: squares put in and taken out of a shape until the half-spaces hold.

#ifndef SF_BALANCE_POLISH_H
#define SF_BALANCE_POLISH_H

#include "balance/forest/lagrange.h"
#include "balance/forest/places.h"

// A shape at work: the wall and the squares of the kept places.
typedef struct sfi_polish {
    const sfi_places *places; // weighed by the lever that the shape was found with
    const sfi_search *search;
    const float *density;
    sf_grid *kept;  // corners
    sf_grid *shape; // R
    sf_body body;   // of R and of the rest
    // Scratch: what half-spaces miss of the body, and its depth; the half-space to ask first.
    double missing, depth;
    size_t hint;
} sfi_polish;

// Change the shape, so that half-spaces that do not hold do, as nearly as can be, and then so that
// it is better by the goal and they still hold. It stays supported as it was. SF_ERR_CANCELLED
// leaves it half done, but supported.
sf_status sfi_polish_shape(sfi_polish *polish);

#endif
