// SPDX-License-Identifier: MIT
// Delta: what one step of a history changed.

#ifndef SF_SCULPT_DELTA_H
#define SF_SCULPT_DELTA_H

#include "sculpt/model.h"

// Write the difference between `before` and `now`. Returns 0, with nothing written, where there is
// none.
int sfi_delta_write(sf_sculpt *m);

// Change `now` by a step, which undoes or redoes it, and say what changed; `touched` says where.
void sfi_delta_apply(sf_sculpt *m, sfi_step_reader *reader, sf_sculpt_change *change);

#endif
