// SPDX-License-Identifier: MIT
// What a mask is inside.

#ifndef SF_GRADE_TONE_MASK_H
#define SF_GRADE_TONE_MASK_H

#include <sf/halftone.h>

struct sf_mask {
    uint32_t n[3];
    const uint16_t *small; // ranks in (layer, y, x) order, where they fit 16 bits,
    const uint32_t *large; // or else here
    void *owned;           // NULL in the mask that is part of the library
    size_t owned_size;
    sf_allocator allocator;
};

static inline uint32_t sfi_mask_count(const sf_mask *mask)
{
    return mask->n[0] * mask->n[1] * mask->n[2];
}

// The rank at place i of the block.
static inline uint32_t sfi_mask_at(const sf_mask *mask, size_t i)
{
    return mask->small != NULL ? mask->small[i] : mask->large[i];
}

#endif
