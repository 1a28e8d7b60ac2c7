// SPDX-License-Identifier: MIT
// What sf_grid_grow() makes of a shape, where that is cheaper than what a repair has found.

#ifndef SF_SUPPORT_AGAINST_GROW_H
#define SF_SUPPORT_AGAINST_GROW_H

#include "support/repair/repair.h"

// *grown is a grid of what grow makes of all that can be kept, where it costs less than `cost`;
// else, and on failure, NULL. `terms` are the caller's with the bed that they came to, and `room`
// the trim under them of all that may be solid.
sf_status sfi_grow_if_cheaper(const sfi_job *job, const sf_terms *terms, const sf_grid *room,
                              uint64_t cost, sf_grid **grown);

#endif
