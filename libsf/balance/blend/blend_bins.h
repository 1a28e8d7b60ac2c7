// SPDX-License-Identifier: MIT
// Cells by where they are bent to.

#ifndef SF_BALANCE_BLEND_BINS_H
#define SF_BALANCE_BLEND_BINS_H

#include "balance/blend/blend.h"
#include "balance/handle/weights.h"

// Bins along each axis at most.
#define SFI_BINS_MAX 48

// What the corners of a cell are bent to.
typedef struct sfi_bin_entry {
    double low[3], high[3];
    uint32_t cell;
} sfi_bin_entry;

typedef struct sfi_bins {
    const sf_weights *weights;
    double *bent;           // x, y, z of each node
    sfi_bin_entry *entries; // of each cell, bin after bin
    uint32_t *begin;        // where each bin's begin
    double low[3], edge;
    uint32_t count[3];
} sfi_bins;

sf_status sfi_bins_create(const sf_weights *weights, const sf_allocator *allocator, sfi_bins *bins);
void sfi_bins_destroy(sfi_bins *bins, const sf_allocator *allocator);

// Bend all cells and sort them.
void sfi_bins_fill(sfi_bins *bins, const sfi_map *maps);

// Hand each cell whose bent corners have `p` within their bounds to `visit`, in a fixed order,
// until it returns 0. Returns the closest of the cells around, or SFI_NO_CELL.
uint32_t sfi_bins_visit(const sfi_bins *bins, const double p[3],
                        int (*visit)(void *user, uint32_t cell), void *user);

#endif
