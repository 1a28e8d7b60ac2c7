// SPDX-License-Identifier: MIT
// Leaving out half-spaces that others imply.

#ifndef SF_BALANCE_REDUCE_H
#define SF_BALANCE_REDUCE_H

#include <sf/body.h>

// Leave out, in place, every half-space that those that stay imply for all points of a cube around
// `middle` with half-side `reach`; returns how many stay, in their order. Normals have length 1.
// Where no point is in all of them, all of a stretch stay. SF_ERR_MEMORY changes nothing.
sf_status sfi_halfspaces_reduce(sf_halfspace *list, size_t count, const double middle[3],
                                double reach, const sf_allocator *allocator, size_t *kept);

#endif
