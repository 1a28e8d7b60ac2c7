// SPDX-License-Identifier: MIT
// An allocator that counts what is out, refuses the k-th request and every later one, and knows
// when memory is freed with another size than it was taken with.

#ifndef SF_TEST_FAILING_ALLOCATOR_H
#define SF_TEST_FAILING_ALLOCATOR_H

#include <sf/base.h>

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct failing_allocator {
    long requests; // made so far
    long fail_at;  // index of the first request that is refused; negative: none
    long live;     // blocks out
    long faults;   // frees with a wrong size
    sf_allocator allocator;
} failing_allocator;

static void *failing_alloc(void *user, size_t size, size_t align)
{
    static const unsigned char fills[5] = {0xdb, 0xff, 0x01, 0xfe, 0x80};
    failing_allocator *f = user;
    long index = f->requests++;
    if (f->fail_at >= 0 && index >= f->fail_at) {
        return NULL;
    }
    // The block: padding, the pointer to free, the size, then the caller's bytes.
    unsigned char *base = malloc(size + align + 2 * sizeof(uint64_t) + 16);
    if (base == NULL) {
        return NULL;
    }
    uintptr_t start = ((uintptr_t)base + 16 + align - 1) & ~(uintptr_t)(align - 1);
    unsigned char *memory = base + (start - (uintptr_t)base);
    uint64_t head[2] = {(uint64_t)(memory - base), size};
    memcpy(memory - 16, head, 16);
    memset(memory, fills[index % 5], size); // nobody may count on what is there
    f->live++;
    return memory;
}

static void failing_free(void *user, void *memory, size_t size)
{
    failing_allocator *f = user;
    uint64_t head[2];
    memcpy(head, (unsigned char *)memory - 16, 16);
    f->faults += head[1] != size;
    f->live--;
    free((unsigned char *)memory - head[0]);
}

static inline void failing_begin(failing_allocator *f, long fail_at)
{
    sf_allocator allocator = {failing_alloc, failing_free, f};
    f->requests = f->live = f->faults = 0;
    f->fail_at = fail_at;
    f->allocator = allocator;
}

#endif
