// SPDX-License-Identifier: MIT
// How near the voxels of a slice are to what stands in it, in steps of an element.

#ifndef SF_SCULPT_NEAR_H
#define SF_SCULPT_NEAR_H

#include <sf/voxel.h>

// rings[d % 3] = what is d steps from `fixed`, all within `within`; until all of `wanted` is
// reached, or nothing more is. Slices of one size; reached and scratch are written.
sf_status sfi_find_near(const sf_element *element, sf_slice fixed, sf_slice within, sf_slice wanted,
                        const sf_slice rings[3], sf_slice reached, sf_slice scratch);

#endif
