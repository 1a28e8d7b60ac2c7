// SPDX-License-Identifier: MIT
// Memory of the caller's for zlib: its zalloc and zfree, whose opaque is an sf_allocator.

#ifndef SF_IO_ZLIB_MEMORY_H
#define SF_IO_ZLIB_MEMORY_H

void *sfi_zlib_take(void *allocator, unsigned count, unsigned size);
void sfi_zlib_give_back(void *allocator, void *memory);

#endif
