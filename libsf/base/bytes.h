// SPDX-License-Identifier: MIT
// Moving and setting bytes, with a C library or without.
//
// Compilers call memcpy and memset by themselves and so ask every environment for them, but the
// header that declares them is only there where the rest of a C library is. Code of the
// freestanding core includes this one.

#ifndef SF_BASE_BYTES_H
#define SF_BASE_BYTES_H

#if __STDC_HOSTED__
#include <string.h>
#else
#include <stddef.h>

void *memcpy(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);
#endif

#endif
