// SPDX-License-Identifier: MIT
// Rows of words that end at a page nobody may touch, or start right after one: an over-read of one
// byte ends the test program.

#ifndef SF_TEST_GUARDED_H
#define SF_TEST_GUARDED_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#if defined(__unix__)
#ifndef MAP_ANONYMOUS
#define MAP_ANONYMOUS 0x20
#endif
#include <sys/mman.h>

#define GUARDED_PAGES 96
#define GUARDED_BYTES ((size_t)4096 * GUARDED_PAGES)

// GUARDED_BYTES bytes with a forbidden page on each side; never freed, there are few.
static inline unsigned char *guarded_area(void)
{
    unsigned char *base = mmap(NULL, GUARDED_BYTES + 8192, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (base == MAP_FAILED || mprotect(base, 4096, PROT_NONE) != 0 ||
        mprotect(base + 4096 + GUARDED_BYTES, 4096, PROT_NONE) != 0) {
        abort();
    }
    return base + 4096;
}
#else
#define GUARDED_BYTES ((size_t)393216)
static inline unsigned char *guarded_area(void)
{
    return calloc(1, GUARDED_BYTES);
}
#endif

// `count` words in the area: against its end, or against its beginning.
static inline uint64_t *guarded_words(unsigned char *area, size_t count, int at_end)
{
    return (uint64_t *)(void *)(at_end ? area + GUARDED_BYTES - 8 * count : area);
}

#endif
