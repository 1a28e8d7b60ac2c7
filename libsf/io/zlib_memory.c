// SPDX-License-Identifier: MIT
// zlib frees blocks without their sizes, which the caller's allocator asks for: each carries its
// own in front.

#include "io/zlib_memory.h"

#include "base/memory.h"

#include <string.h>

void *sfi_zlib_take(void *allocator, unsigned count, unsigned size)
{
    size_t bytes;
    if (!sfi_size_mul(count, size, &bytes) || !sfi_size_add(bytes, SFI_ALIGN, &bytes)) {
        return NULL;
    }
    unsigned char *memory = sfi_alloc_array(allocator, bytes, 1);
    if (memory == NULL) {
        return NULL;
    }
    memcpy(memory, &bytes, sizeof bytes);
    return memory + SFI_ALIGN;
}

void sfi_zlib_give_back(void *allocator, void *memory)
{
    unsigned char *block = (unsigned char *)memory - SFI_ALIGN;
    size_t bytes;
    memcpy(&bytes, block, sizeof bytes);
    sfi_free_array(allocator, block, bytes, 1);
}
