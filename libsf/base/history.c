// SPDX-License-Identifier: MIT
// Histories: which steps are kept, and which come next.
//
// A history knows nothing of what is edited. It holds blocks of bytes in their order and a place
// among them: those before it can be undone, those behind it redone. A block is what was there
// before its step; whoever undoes exchanges it with what is there now, which makes of it what was
// there after the step, so that one block serves both ways and nothing is worked out anew.
//
// Memory is bounded by the number of bytes that all blocks have together. The oldest go first; what
// is left is always a chain without a gap that ends at the present.

#include "base/history.h"

#include "base/memory.h"

#include <string.h>

void sfi_history_begin(size_t bytes_max, const sf_allocator *allocator, sfi_history *history)
{
    memset(history, 0, sizeof *history);
    history->allocator = *allocator;
    history->bytes_max = bytes_max;
}

// Free steps first to last - 1; those behind them move up.
static void forget(sfi_history *h, size_t first, size_t last)
{
    for (size_t i = first; i < last; i++) {
        h->bytes -= h->steps[i].size;
        sfi_free_array(&h->allocator, h->steps[i].bytes, h->steps[i].size, 1);
    }
    if (h->count > last) {
        memmove(h->steps + first, h->steps + last, (h->count - last) * sizeof *h->steps);
    }
    h->count -= last - first;
    h->done = h->done < first ? h->done : h->done < last ? first : h->done - (last - first);
}

void sfi_history_end(sfi_history *history)
{
    forget(history, 0, history->count);
    sfi_free_array(&history->allocator, history->steps, history->capacity, sizeof *history->steps);
    memset(history, 0, sizeof *history);
}

sf_status sfi_history_add(sfi_history *history, size_t size, void **bytes)
{
    sfi_history *h = history;
    if (size > h->bytes_max) {
        forget(h, 0, h->count);
        *bytes = NULL;
        return SF_OK;
    }
    if (!sfi_grow_array(&h->allocator, (void **)&h->steps, &h->capacity, h->done + 1,
                        sizeof *h->steps)) {
        return SF_ERR_MEMORY;
    }
    sfi_step step = {sfi_alloc_array(&h->allocator, size, 1), size};
    if (step.bytes == NULL) {
        return SF_ERR_MEMORY;
    }
    forget(h, h->done, h->count);
    size_t oldest = 0, left = h->bytes;
    while (left > h->bytes_max - size) {
        left -= h->steps[oldest++].size;
    }
    forget(h, 0, oldest);
    h->steps[h->count++] = step;
    h->done = h->count;
    h->bytes += size;
    *bytes = step.bytes;
    return SF_OK;
}

const sfi_step *sfi_history_back(sfi_history *history)
{
    return history->done > 0 ? &history->steps[--history->done] : NULL;
}

const sfi_step *sfi_history_forth(sfi_history *history)
{
    return history->done < history->count ? &history->steps[history->done++] : NULL;
}
