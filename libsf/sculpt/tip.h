// SPDX-License-Identifier: MIT
// Tips, seen from inside.

#ifndef SF_SCULPT_TIP_H
#define SF_SCULPT_TIP_H

#include <sf/sculpt.h>

// A dab lies within this of 0 in each coordinate.
#define SFI_DAB_MAX (INT32_C(1) << 30)

// Ways to mirror a tip: bit 0 along x, bit 1 along y.
#define SFI_FLIP_COUNT 4u

struct sf_tip {
    sf_allocator allocator;
    sf_grid *masks[SFI_FLIP_COUNT]; // by way; those that look alike are one grid
    sf_dab anchors[SFI_FLIP_COUNT]; // of each
};

static inline int sfi_dab_is_valid(sf_dab d)
{
    return d.x >= -SFI_DAB_MAX && d.x <= SFI_DAB_MAX && d.y >= -SFI_DAB_MAX && d.y <= SFI_DAB_MAX &&
           d.z >= -SFI_DAB_MAX && d.z <= SFI_DAB_MAX;
}

#endif
