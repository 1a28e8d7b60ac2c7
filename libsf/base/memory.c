// SPDX-License-Identifier: MIT
// The default allocator, and arrays on any allocator.
//
// C99 has no aligned allocation, so the default allocator over-allocates and keeps the pointer that
// malloc returned in the word just below the one it hands out.

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

static void *libc_alloc(void *user, size_t size, size_t align)
{
    (void)user;
    size_t padded;
    if (align < sizeof(void *)) {
        align = sizeof(void *);
    }
    if (!sfi_size_add(size, align, &padded) || !sfi_size_add(padded, sizeof(void *), &padded)) {
        return NULL;
    }
    unsigned char *base = malloc(padded);
    if (base == NULL) {
        return NULL;
    }
    uintptr_t start = (uintptr_t)(base + sizeof(void *));
    size_t shift = (size_t)(-start & (align - 1));
    unsigned char *memory = base + sizeof(void *) + shift;
    void *kept = base;
    memcpy(memory - sizeof(void *), &kept, sizeof kept);
    return memory;
}

static void libc_free(void *user, void *memory, size_t size)
{
    (void)user;
    (void)size;
    void *base;
    memcpy(&base, (unsigned char *)memory - sizeof(void *), sizeof base);
    free(base);
}

sf_allocator sfi_allocator_or_default(const sf_allocator *allocator)
{
    if (allocator != NULL) {
        return *allocator;
    }
    sf_allocator libc = {libc_alloc, libc_free, NULL};
    return libc;
}

void *sfi_alloc_array(const sf_allocator *allocator, size_t count, size_t element_size)
{
    size_t size;
    if (!sfi_size_mul(count, element_size, &size) || size == 0) {
        return NULL;
    }
    return allocator->alloc(allocator->user, size, SFI_ALIGN);
}

void sfi_free_array(const sf_allocator *allocator, void *memory, size_t count, size_t element_size)
{
    if (memory != NULL) {
        allocator->free(allocator->user, memory, count * element_size);
    }
}

int sfi_copy_array(const sf_allocator *allocator, const void *from, size_t count,
                   size_t element_size, void **to)
{
    *to = NULL;
    if (count > 0) {
        *to = sfi_alloc_array(allocator, count, element_size);
        if (*to == NULL) {
            return 0;
        }
        memcpy(*to, from, count * element_size);
    }
    return 1;
}

int sfi_grow_array(const sf_allocator *allocator, void **memory, size_t *capacity, size_t need,
                   size_t element_size)
{
    if (need <= *capacity) {
        return 1;
    }
    size_t wanted;
    if (!sfi_size_add(*capacity, *capacity / 2, &wanted) || wanted < need) {
        wanted = need;
    }
    if (wanted < 16) {
        wanted = 16;
    }
    void *larger = sfi_alloc_array(allocator, wanted, element_size);
    if (larger == NULL) {
        return 0;
    }
    if (*capacity > 0) {
        memcpy(larger, *memory, *capacity * element_size);
        sfi_free_array(allocator, *memory, *capacity, element_size);
    }
    *memory = larger;
    *capacity = wanted;
    return 1;
}
