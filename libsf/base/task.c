// SPDX-License-Identifier: MIT
// Tasks: progress that never falls, a cancel that sticks, the host's threads.
//
// The cancel flag is the only thing that two threads may touch at once. It goes from 0 to 1 and
// never back, and guards no other memory, so relaxed atomics are enough.

#include "base/task.h"

sf_task sf_task_default(void)
{
    sf_task task = {sizeof(sf_task), NULL, NULL, NULL, 0, NULL};
    return task;
}

void sf_task_cancel(sf_task *task)
{
    if (task != NULL) {
        __atomic_store_n(&task->cancel_state, 1, __ATOMIC_RELAXED);
    }
}

int sf_task_is_cancelled(const sf_task *task)
{
    // A part is cancelled with the whole that it belongs to.
    for (; task != NULL; task = task->whole) {
        if (__atomic_load_n(&task->cancel_state, __ATOMIC_RELAXED) != 0) {
            return 1;
        }
    }
    return 0;
}

sfi_progress sfi_progress_begin(sf_task *task)
{
    sfi_progress progress = {task, -1.0};
    return progress;
}

void sfi_progress_report(sfi_progress *progress, uint64_t done, uint64_t total)
{
    sf_task *task = progress->task;
    if (task == NULL || task->progress == NULL) {
        return;
    }
    double fraction = total == 0 ? 1.0 : (double)done / (double)total;
    if (fraction > 1.0) {
        fraction = 1.0;
    }
    if (fraction > progress->reported) {
        progress->reported = fraction;
        task->progress(task->user, fraction);
    }
}

// Report from + fraction * (to - from) of the whole.
static void report_part(void *user, double fraction)
{
    sfi_part *part = user;
    double done = part->from + fraction * (part->to - part->from);
    sfi_progress_report(part->whole, (uint64_t)(done * 1e6), 1000000);
}

static void run_part(void *user, size_t count, sf_task_body body, void *context)
{
    const sfi_part *part = user;
    sfi_task_for(part->whole->task, count, body, context);
}

void sfi_part_begin(sfi_part *part, sfi_progress *whole, double from, double to)
{
    part->task = sf_task_default();
    part->task.progress = report_part;
    part->task.parallel_for = run_part;
    part->task.user = part;
    part->whole = whole;
    part->from = from;
    part->task.whole = whole->task;
    part->to = to;
}

void sfi_task_for(sf_task *task, size_t count, sf_task_body body, void *context)
{
    if (task != NULL && task->parallel_for != NULL && count > 1) {
        task->parallel_for(task->user, count, body, context);
        return;
    }
    for (size_t i = 0; i < count; i++) {
        body(context, i);
    }
}
