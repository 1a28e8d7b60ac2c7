// SPDX-License-Identifier: MIT
// Heights of a lattice's layers, and how exact its lengths are.

#ifndef SF_BALANCE_LEVELS_H
#define SF_BALANCE_LEVELS_H

#include <sf/voxel.h>

#include "base/memory.h"

// Bottoms of all layers and the top of the last, nz + 1 numbers, or NULL where memory is short.
double *sfi_levels_create(const sf_lattice *lattice, const sf_allocator *allocator);
void sfi_levels_destroy(double *levels, const sf_lattice *lattice, const sf_allocator *allocator);

// Length of the lattice's diagonal.
double sfi_levels_diagonal(const sf_lattice *lattice, const double *levels);

// A length less one part in 2^40 of the largest of itself, of `coordinate` and of the lattice's
// coordinates; not below 0. Lengths are products of what people write as decimals, and what is
// meant to be equal is so after this much is forgiven.
double sfi_levels_forgive(const sf_lattice *lattice, double length_mm, double coordinate_mm);

#endif
