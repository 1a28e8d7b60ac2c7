// SPDX-License-Identifier: MIT
// What the library itself asks of structuring elements.

#ifndef SF_VOXEL_ELEMENT_H
#define SF_VOXEL_ELEMENT_H

#include <sf/voxel.h>

// Whether an element keeps its promises: within SF_REACH_MAX, half widths that never grow.
int sfi_element_is_valid(const sf_element *element);

#endif
