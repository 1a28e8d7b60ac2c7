// SPDX-License-Identifier: MIT
// Lists of numbers, one after the other, and the same turned around.

#include "grade/cage/complex.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

int sfi_lists_alloc(const sf_allocator *allocator, size_t count, size_t items, sfi_lists *lists)
{
    // One item more, so that lists without any hold memory all the same.
    lists->starts = sfi_alloc_array(allocator, count + 1, sizeof *lists->starts);
    lists->items = sfi_alloc_array(allocator, items + 1, sizeof *lists->items);
    if (lists->starts != NULL && lists->items != NULL) {
        lists->starts[count] = (uint32_t)items; // what sfi_lists_free() goes by
        return 1;
    }
    sfi_free_array(allocator, lists->starts, count + 1, sizeof *lists->starts);
    sfi_free_array(allocator, lists->items, items + 1, sizeof *lists->items);
    lists->starts = lists->items = NULL;
    return 0;
}

void sfi_lists_free(const sf_allocator *allocator, uint32_t count, sfi_lists *lists)
{
    if (lists->starts != NULL) {
        size_t items = lists->starts[count];
        sfi_free_array(allocator, lists->items, items + 1, sizeof *lists->items);
        sfi_free_array(allocator, lists->starts, (size_t)count + 1, sizeof *lists->starts);
        lists->starts = lists->items = NULL;
    }
}

// A counting sort: counts, their sums, then each list's number at its place.
static sf_status turn(const sf_allocator *allocator, uint32_t count, const uint32_t *starts,
                      const uint32_t *items, uint32_t targets, sfi_lists *turned)
{
    size_t total = starts == NULL ? 2 * (size_t)count : starts[count], named = 0;
    for (size_t i = 0; i < total; i++) {
        named += items[i] != SFI_NONE;
    }
    if (!sfi_lists_alloc(allocator, targets, named, turned)) {
        return SF_ERR_MEMORY;
    }
    uint32_t *at = turned->starts;
    memset(at, 0, ((size_t)targets + 1) * sizeof *at);
    for (size_t i = 0; i < total; i++) {
        if (items[i] != SFI_NONE) {
            at[items[i]]++;
        }
    }
    uint32_t sum = 0;
    for (uint32_t i = 0; i <= targets; i++) {
        uint32_t here = at[i];
        at[i] = sum;
        sum += here;
    }
    for (uint32_t list = 0; list < count; list++) {
        size_t from = starts == NULL ? 2 * (size_t)list : starts[list];
        size_t to = starts == NULL ? from + 2 : starts[list + 1];
        for (size_t i = from; i < to; i++) {
            if (items[i] != SFI_NONE) {
                turned->items[at[items[i]]++] = list;
            }
        }
    }
    memmove(at + 1, at, targets * sizeof *at); // each start has moved to the next one's place
    at[0] = 0;
    return SF_OK;
}

sf_status sfi_lists_turn(const sf_allocator *allocator, uint32_t count, const uint32_t *starts,
                         const uint32_t *items, uint32_t targets, sfi_lists *turned)
{
    return turn(allocator, count, starts, items, targets, turned);
}

sf_status sfi_pairs_turn(const sf_allocator *allocator, uint32_t count, const uint32_t *pairs,
                         uint32_t targets, sfi_lists *turned)
{
    return turn(allocator, count, NULL, pairs, targets, turned);
}
