// SPDX-License-Identifier: MIT
// An array that grows as the bytes of a file come.

#ifndef SF_IO_LIST_H
#define SF_IO_LIST_H

#include "base/memory.h"

#include <string.h>

typedef struct sfi_list {
    void *items;
    size_t count, capacity;
    size_t size; // of an item, in bytes
} sfi_list;

static inline sfi_list sfi_list_of(size_t size)
{
    sfi_list list = {NULL, 0, 0, size};
    return list;
}

static inline void sfi_list_free(const sf_allocator *allocator, sfi_list *list)
{
    sfi_free_array(allocator, list->items, list->capacity, list->size);
    *list = sfi_list_of(list->size);
}

// Append an item; SF_ERR_MEMORY, and nothing has changed, when there is no room for it.
static inline sf_status sfi_list_push(const sf_allocator *allocator, sfi_list *list,
                                      const void *item)
{
    if (list->count == list->capacity &&
        !sfi_grow_array(allocator, &list->items, &list->capacity, list->count + 1, list->size)) {
        return SF_ERR_MEMORY;
    }
    memcpy((char *)list->items + list->count++ * list->size, item, list->size);
    return SF_OK;
}

#endif
