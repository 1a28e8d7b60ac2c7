// SPDX-License-Identifier: MIT
// Sweeps: the progress of a repair, and how it hears of a cancel.
//
// A repair is a number of sweeps over the grid, and nobody knows how many there will be: it goes on
// until it gets no better. So each is given a sixteenth of the progress that is left. Every sweep
// asks before each layer whether to go on, and reports the layers that are done before it starts
// the next; none runs to its end unasked. A cancel therefore costs a layer's work at most, and no
// report comes after it.

#include "support/repair/sweep.h"

#define PARTS 16

void sfi_pace_begin(sfi_pace *pace, sf_task *task)
{
    pace->whole = sfi_progress_begin(task);
    pace->done = 0;
}

sf_status sfi_pace_ask(const sfi_pace *pace)
{
    return sf_task_is_cancelled(pace->whole.task) ? SF_ERR_CANCELLED : SF_OK;
}

sf_task *sfi_pace_next(sfi_pace *pace)
{
    double from = pace->done;
    pace->done += (1 - pace->done) / PARTS;
    sfi_part_begin(&pace->part, &pace->whole, from, pace->done);
    return &pace->part.task;
}

sfi_sweep sfi_sweep_begin(sfi_pace *pace, uint64_t total)
{
    sfi_sweep sweep = {sfi_progress_begin(sfi_pace_next(pace)), 0, total};
    return sweep;
}

sf_status sfi_sweep_layer(sfi_sweep *sweep)
{
    if (sfi_sweep_pause(sweep) != SF_OK) {
        return SF_ERR_CANCELLED;
    }
    sfi_progress_report(&sweep->progress, sweep->done++, sweep->total);
    return sfi_sweep_pause(sweep);
}

sf_status sfi_sweep_pause(const sfi_sweep *sweep)
{
    return sf_task_is_cancelled(sweep->progress.task) ? SF_ERR_CANCELLED : SF_OK;
}
