// SPDX-License-Identifier: MIT
// A byte source over memory.

#include <sf/base.h>

#include <string.h>

static sf_status memory_read(void *user, void *data, size_t capacity, size_t *size)
{
    sf_memory_cursor *cursor = user;
    size_t left = cursor->position < cursor->size ? cursor->size - cursor->position : 0;
    size_t taken = capacity < left ? capacity : left;
    if (taken > 0) {
        memcpy(data, (const unsigned char *)cursor->data + cursor->position, taken);
        cursor->position += taken;
    }
    *size = taken;
    return SF_OK;
}

sf_source sf_memory_source(sf_memory_cursor *cursor)
{
    sf_source source = {memory_read, cursor};
    return source;
}
