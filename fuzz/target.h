// SPDX-License-Identifier: MIT
// What fuzz targets share: memory to write to, and an end with a sentence.

#ifndef SF_FUZZ_TARGET_H
#define SF_FUZZ_TARGET_H

#include <sf/io.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

typedef struct buffer {
    unsigned char *bytes;
    size_t size, capacity;
} buffer;

static inline sf_status put(void *user, const void *data, size_t size)
{
    buffer *b = user;
    if (b->size + size > b->capacity) {
        b->capacity = 2 * (b->size + size);
        b->bytes = realloc(b->bytes, b->capacity);
    }
    memcpy(b->bytes + b->size, data, size);
    b->size += size;
    return SF_OK;
}

static inline void must(int truth, const char *what)
{
    if (!truth) {
        fprintf(stderr, "broken: %s\n", what);
        abort();
    }
}

#endif
