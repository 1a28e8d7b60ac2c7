// SPDX-License-Identifier: MIT
// How bending stretches the solid, at places spread through it.

#ifndef SF_BALANCE_STRETCH_H
#define SF_BALANCE_STRETCH_H

#include "balance/handle/weights.h"

// The derivatives of the basis' functions by x, y, z at each place: 12 numbers a handle.
typedef struct sfi_stretch {
    double *slopes;
    size_t place_count, handle_count, number_count;
} sfi_stretch;

// Places in the solid voxels of a grid, `most` at most, evenly by number. SF_ERR_MEMORY.
sf_status sfi_stretch_make(const sf_weights *weights, const sf_grid *solid, size_t most,
                           const sf_allocator *allocator, sfi_stretch *stretch);

// Room for as many places, none of them taken yet; and take one, at a spot. SF_ERR_MEMORY: the
// former has failed; SF_ERR_CAPACITY: there is no room left.
sf_status sfi_stretch_reserve(size_t handle_count, size_t most, const sf_allocator *allocator,
                              sfi_stretch *stretch);
sf_status sfi_stretch_add(const sf_weights *weights, const sfi_spot *spot, sfi_stretch *stretch);

void sfi_stretch_free(const sf_allocator *allocator, sfi_stretch *stretch);

// The factor by which volume grows at a place: below 0 the solid is turned inside out there.
double sfi_stretch_at(const sfi_stretch *stretch, size_t place, const double *coefficients);

// Its derivatives by the coefficients, 12 numbers a handle.
void sfi_stretch_gradient(const sfi_stretch *stretch, size_t place, const double *coefficients,
                          double *gradient);

#endif
