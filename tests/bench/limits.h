// SPDX-License-Identifier: MIT
// The least that memory asks for: passes over words that do nothing of use.

#ifndef SF_BENCH_LIMITS_H
#define SF_BENCH_LIMITS_H

#include <sf/voxel.h>

// Read and write every word of a grid where it stands.
void limit_pass(const sf_grid *grid);

// Read every word of a slice, or of a grid.
void limit_read_slice(sf_slice slice);
void limit_read(const sf_grid *grid);

// Write zeros over every word of a grid.
void limit_clear(const sf_grid *grid);

#endif
