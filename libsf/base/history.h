// SPDX-License-Identifier: MIT
// A list of steps that can be taken back and taken again, within so many bytes.

#ifndef SF_BASE_HISTORY_H
#define SF_BASE_HISTORY_H

#include <sf/base.h>

// What one step holds is its owner's affair. It should be such that exchanging it with what is
// there undoes the step, and exchanging it again redoes it.
typedef struct sfi_step {
    void *bytes;
    size_t size;
} sfi_step;

typedef struct sfi_history {
    sf_allocator allocator;
    size_t bytes_max;   // of all steps
    size_t bytes;       // that they have now
    size_t count, done; // steps; the first `done` can be undone, the others redone
    size_t capacity;
    sfi_step *steps; // the oldest first
} sfi_history;

void sfi_history_begin(size_t bytes_max, const sf_allocator *allocator, sfi_history *history);
void sfi_history_end(sfi_history *history);

// One more step of `size` bytes, which the caller fills at once. The steps that could be redone are
// forgotten, and then the oldest ones, until all fit. If it does not fit alone, all are forgotten
// and *bytes is NULL: a list with a hole would lead elsewhere. SF_ERR_MEMORY: nothing has changed.
sf_status sfi_history_add(sfi_history *history, size_t size, void **bytes);

// The step to be undone or redone next, counted as done so; NULL where there is none.
const sfi_step *sfi_history_back(sfi_history *history);
const sfi_step *sfi_history_forth(sfi_history *history);

#endif
