// SPDX-License-Identifier: MIT
// What sf_grid_grow() makes of a shape, where it is worth asking.

#ifndef SF_SUPPORT_AGAINST_GROW_H
#define SF_SUPPORT_AGAINST_GROW_H

#include "support/repair/repair.h"

// Whether grow is asked, where the first result costs `first`.
int sfi_is_grow_asked(const sfi_job *job, uint64_t first);

// *grown is a grid of what grow makes of all that can be kept; NULL on failure. `terms` are the
// caller's with the bed that they came to, and `room` the trim under them of all that may be solid.
sf_status sfi_grow_rest(const sfi_job *job, const sf_terms *terms, const sf_grid *room,
                        sf_grid **grown);

#endif
