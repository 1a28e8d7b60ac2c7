// SPDX-License-Identifier: MIT
// Checked size arithmetic: the only place where sizes are multiplied or added.
//
// Voxel libraries overflow in width * height * depth; so nothing in libsf computes the size of
// memory with bare operators. Each helper stores its result and returns 1, or returns 0 and leaves
// the result alone. Freestanding: no libc, no 128-bit integers, no compiler builtins.

#ifndef SF_BASE_SIZE_H
#define SF_BASE_SIZE_H

#include <stddef.h>
#include <stdint.h>

// Alignment of everything that rows of voxels live in: a cache line, and the widest vector.
#define SFI_ALIGN 64

static inline int sfi_size_add(size_t a, size_t b, size_t *sum)
{
    if (a > SIZE_MAX - b) {
        return 0;
    }
    *sum = a + b;
    return 1;
}

static inline int sfi_size_mul(size_t a, size_t b, size_t *product)
{
    if (b != 0 && a > SIZE_MAX / b) {
        return 0;
    }
    *product = a * b;
    return 1;
}

// Round up to a multiple of `align`, a power of two.
static inline int sfi_size_align(size_t size, size_t align, size_t *aligned)
{
    size_t padded;
    if (!sfi_size_add(size, align - 1, &padded)) {
        return 0;
    }
    *aligned = padded & ~(align - 1);
    return 1;
}

#endif
