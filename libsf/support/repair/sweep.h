// SPDX-License-Identifier: MIT
// Sweeps: what goes over a grid layer by layer, reports how far it is, and ends when cancelled.

#ifndef SF_SUPPORT_SWEEP_H
#define SF_SUPPORT_SWEEP_H

#include "base/task.h"

// All sweeps of a call, one after the other. It must stay where it is.
typedef struct sfi_pace {
    sfi_progress whole;
    double done;   // when the sweep that runs has ended
    sfi_part part; // what that one reports to
} sfi_pace;

void sfi_pace_begin(sfi_pace *pace, sf_task *task);

// SF_ERR_CANCELLED, or SF_OK.
sf_status sfi_pace_ask(const sfi_pace *pace);

// A task for the next sweep, where that is a call which takes one. What ran before has ended.
sf_task *sfi_pace_next(sfi_pace *pace);

// The next sweep, over so many layers.
typedef struct sfi_sweep {
    sfi_progress progress;
    uint64_t done, total;
} sfi_sweep;

sfi_sweep sfi_sweep_begin(sfi_pace *pace, uint64_t total);

// Before each layer: the ones before it are reported. SF_ERR_CANCELLED.
sf_status sfi_sweep_layer(sfi_sweep *sweep);

// Within a layer, where that may take long. SF_ERR_CANCELLED.
sf_status sfi_sweep_pause(const sfi_sweep *sweep);

#endif
