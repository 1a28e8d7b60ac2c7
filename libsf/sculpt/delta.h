// SPDX-License-Identifier: MIT
// Delta: what one step of a history changed.

#ifndef SF_SCULPT_DELTA_H
#define SF_SCULPT_DELTA_H

#include "sculpt/model.h"

// What runs do, beside the exclusive or of bytes.
#define SFI_TURNS_DRAWN 256u
#define SFI_TURNS_PRINTABLE 512u

// A run of voxels of one row, and what it does.
typedef struct sfi_run {
    uint32_t x, length, deed;
} sfi_run;

// Write the difference between `before` and `now`, where `touched` says that there may be one, and
// make `before` what `now` is. Returns 0, with nothing written, where there is none.
int sfi_delta_write(sf_sculpt *m);

// Change both states, which are the same, by a step, which undoes or redoes it, and say what
// changed.
void sfi_delta_apply(const sf_sculpt *m, sfi_step_reader step, sf_sculpt_change *change);

#endif
