// SPDX-License-Identifier: MIT
// Memory through the caller's allocator.

#ifndef SF_BASE_MEMORY_H
#define SF_BASE_MEMORY_H

#include <sf/base.h>

#include "base/size.h"

// The allocator to keep: a copy of the caller's, or the C library's when `allocator` is NULL.
sf_allocator sfi_allocator_or_default(const sf_allocator *allocator);

// `count` elements of `element_size` bytes, SFI_ALIGN-aligned. NULL when the product overflows,
// when it is 0, or when the allocator refuses. Free with the same two numbers.
void *sfi_alloc_array(const sf_allocator *allocator, size_t count, size_t element_size);
void sfi_free_array(const sf_allocator *allocator, void *memory, size_t count, size_t element_size);

// A copy of an array, which may be empty: then `*to` is NULL. Returns 0 when memory is short. Free
// with the same two numbers.
int sfi_copy_array(const sf_allocator *allocator, const void *from, size_t count,
                   size_t element_size, void **to);

// Make room for `need` elements in a growing array, by half again or more. Returns 0, with nothing
// changed, when memory is short.
int sfi_grow_array(const sf_allocator *allocator, void **memory, size_t *capacity, size_t need,
                   size_t element_size);

// The next `count` numbers of a block that is shared out.
static inline double *sfi_cut(double **at, size_t count)
{
    double *piece = *at;
    *at += count;
    return piece;
}

#endif
