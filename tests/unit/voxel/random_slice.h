// SPDX-License-Identifier: MIT
// Random slices with poisoned padding, for tests that compare with a bit-at-a-time oracle.

#ifndef TESTS_UNIT_VOXEL_RANDOM_SLICE_H
#define TESTS_UNIT_VOXEL_RANDOM_SLICE_H

#include <sf/voxel.h>

#include "test.h"

// Fill a slice with bits that are set `of_eight` times out of eight, padding included.
static inline void random_slice(sf_slice slice, uint32_t of_eight)
{
    for (size_t i = 0; i < slice.stride * slice.height; i++) {
        slice.words[i] = 0;
        for (int bit = 0; bit < 64; bit++) {
            slice.words[i] |= (uint64_t)(test_random_below(8) < of_eight) << bit;
        }
    }
}

#endif
