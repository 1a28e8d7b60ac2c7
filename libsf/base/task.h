// SPDX-License-Identifier: MIT
// What long work calls: report how far it is, ask whether to stop, run pieces side by side.

#ifndef SF_BASE_TASK_H
#define SF_BASE_TASK_H

#include <sf/base.h>

// Progress on behalf of one call: remembers the largest fraction, so that what the host sees never
// falls. Lives on the stack of the call; all of it runs on the calling thread.
typedef struct sfi_progress {
    sf_task *task;
    double reported;
} sfi_progress;

sfi_progress sfi_progress_begin(sf_task *task);

// Report `done` of `total`. Cheap enough for every slice.
void sfi_progress_report(sfi_progress *progress, uint64_t done, uint64_t total);

// A call within a call: its task reports to a stretch of the whole's progress, uses the host's
// threads, and is cancelled when the whole is. Hand &part.task on; part must stay where it is
// while that call runs.
typedef struct sfi_part {
    sf_task task;
    sfi_progress *whole;
    double from, to;
} sfi_part;

void sfi_part_begin(sfi_part *part, sfi_progress *whole, double from, double to);

// body(context, i) for each i below count, on the host's threads if it brings any.
void sfi_task_for(sf_task *task, size_t count, sf_task_body body, void *context);

#endif
