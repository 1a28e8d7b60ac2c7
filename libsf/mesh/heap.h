// SPDX-License-Identifier: MIT
// Sorting numbers by a caller's order, in place.

#ifndef SF_MESH_HEAP_H
#define SF_MESH_HEAP_H

#include <stddef.h>
#include <stdint.h>

// Whether item a stands before item b; must tell any two items apart, so that the order is one.
typedef int (*sfi_before)(const void *user, uint32_t a, uint32_t b);

// J. W. J. Williams, "Algorithm 232: Heapsort", 1964.
static inline void sfi_heap_sink(uint32_t *items, size_t at, size_t count, sfi_before before,
                                 const void *user)
{
    uint32_t held = items[at];
    for (size_t child; (child = 2 * at + 1) < count; at = child) {
        if (child + 1 < count && before(user, items[child], items[child + 1])) {
            child++;
        }
        if (!before(user, held, items[child])) {
            break;
        }
        items[at] = items[child];
    }
    items[at] = held;
}

static inline void sfi_heap_sort(uint32_t *items, size_t count, sfi_before before, const void *user)
{
    for (size_t i = count / 2; i-- > 0;) {
        sfi_heap_sink(items, i, count, before, user);
    }
    for (size_t i = count; i-- > 1;) {
        uint32_t last = items[i];
        items[i] = items[0];
        items[0] = last;
        sfi_heap_sink(items, 0, i, before, user);
    }
}

#endif
