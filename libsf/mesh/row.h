// SPDX-License-Identifier: MIT
// From the crossings of rows to their voxels.

#ifndef SF_MESH_ROW_H
#define SF_MESH_ROW_H

#include "mesh/crossing.h"

// How the winding number along a row changes from a voxel on.
typedef struct sfi_change {
    uint32_t voxel;
    int32_t mesh, cap;
} sfi_change;

// What one thread needs to fill rows; nothing in it outlives a call but the two counters.
typedef struct sfi_lane {
    sfi_crossings crossings;
    uint32_t *steps;     // the crossings' steps, row by row
    size_t *row_ends;    // for each row of the window, where its steps end
    size_t row_capacity; // rows that the window may have
    int32_t *sums;       // 2 (nx + 1) sums of changes, mesh and cap, all zero between rows
    sfi_change *changes; // nx + 1
    size_t voxel_count;  // nx + 1
    int spilled;         // whether sums hold crossings of the window's only row
    uint64_t solid_voxels, odd_rows;
} sfi_lane;

// Rows with more steps than this are summed per voxel instead of sorted.
#define SFI_SORT_MAX 32

sf_status sfi_lane_create(uint32_t nx, size_t rows, size_t crossings, const sf_allocator *allocator,
                          sfi_lane *lane);
void sfi_lane_destroy(sfi_lane *lane, const sf_allocator *allocator);

// Forget all crossings, for a window of this many rows.
void sfi_lane_clear(sfi_lane *lane, size_t rows);
// Make room by summing up what was found so far; only where the window is one row.
void sfi_lane_spill(sfi_lane *lane);
// Put the crossings in order of rows. Then sfi_lane_row gives each row's changes, by voxel.
void sfi_lane_sort(sfi_lane *lane, size_t rows);
size_t sfi_lane_row(sfi_lane *lane, size_t row);

// Write a row of a sorted window: solid where the number of changes is odd (SF_FILL_PARITY), or
// where their sum is at least 1. Counts solid voxels, and the row itself when its changes do not
// add up to nothing.
void sfi_lane_fill(sfi_lane *lane, size_t row, sf_fill fill, uint64_t *words);

// Set the voxels x0 <= x < x1 of a row.
void sfi_row_set(uint64_t *words, uint32_t x0, uint32_t x1);

#endif
