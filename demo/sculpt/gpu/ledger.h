// SPDX-License-Identifier: MIT
// The ledger: what only the GPU knows, word by word as state.glsl says it. A test compares the two.

#ifndef SCULPT_GPU_LEDGER_H
#define SCULPT_GPU_LEDGER_H

#include <stdint.h>

typedef struct ledger_box {
    uint32_t x0, y0, z0, x1, y1, z1;
} ledger_box;

// Steps follow, two words each.
typedef struct ledger {
    ledger_box edit, touched, changed;
    uint32_t added_voxels, removed_voxels, lost_voxels, kept_back_voxels, path_voxels;
    uint32_t first, here, end, forgotten, capacity;
    uint32_t changed_words, cursor, start;
    uint32_t apply_start, apply_count;
    uint32_t is_bed_wanted, is_bed_known;
} ledger;

#define LEDGER_STEPS 4096u

#endif
