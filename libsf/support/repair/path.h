// SPDX-License-Identifier: MIT
// The cheapest short chain of additions that carries something, through what is free.

#ifndef SF_SUPPORT_PATH_H
#define SF_SUPPORT_PATH_H

#include "support/repair/repair.h"

typedef struct sfi_path_cell {
    uint32_t k, x, y;
} sfi_path_cell;

// A window of one layer: costs of reaching its cells.
typedef struct sfi_path_window {
    sf_rect rect;
    size_t start;
} sfi_path_window;

// Layers that a search looks at, at most.
#define SFI_PATH_DEPTH 64u

typedef struct sfi_path_finder {
    const sfi_job *job;
    const sf_grid *grid;  // what stands already
    sf_element *elements; // of each step, by the layer below
    sfi_path_window windows[SFI_PATH_DEPTH];
    int32_t *costs;
    size_t capacity;
    int32_t *rows[2]; // scratch
    size_t row_count;
    uint64_t looked;                     // cells of all windows until now
    sfi_path_cell cells[SFI_PATH_DEPTH]; // the path, from its end up
    uint32_t count;
} sfi_path_finder;

// For rules that are elements. SF_ERR_MEMORY, SF_ERR_OVERFLOW.
sf_status sfi_path_finder_create(const sfi_job *job, sfi_path_finder *finder);
void sfi_path_finder_destroy(sfi_path_finder *finder);

// The cheapest path of less than `bound` that begins in layer k at a cell that all `heads` (voxels
// of layer k + 1) can rest on, and ends at one that stands by itself. count is 0 where there is
// none.
sf_status sfi_path_find(sfi_path_finder *finder, uint32_t k, const sfi_path_cell *heads,
                        size_t head_count, uint64_t bound);

// Whether a slice has a voxel in the element around (x, y), other than (ux, uy).
int sfi_has_other(sf_slice slice, const sf_element *e, uint32_t x, uint32_t y, uint32_t ux,
                  uint32_t uy);

#endif
