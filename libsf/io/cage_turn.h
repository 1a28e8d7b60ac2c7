// SPDX-License-Identifier: MIT
// Turning cells that are the wrong way out.

#ifndef SF_IO_CAGE_TURN_H
#define SF_IO_CAGE_TURN_H

#include <stdint.h>

// Turn a cell of dimension 3 that is inverted at every corner, by exchanging its corners; returns
// whether it was. `count` is 4, or even and at least 6; `positions` has x, y, z of each point.
int sfi_cell_turn(uint32_t *corners, uint32_t count, const double *positions);

#endif
