// SPDX-License-Identifier: MIT
// Weights within their bounds.

#ifndef SF_BALANCE_WEIGHTS_BOUNDS_H
#define SF_BALANCE_WEIGHTS_BOUNDS_H

#include "balance/handle/weights_plate.h"

// Four times the number of nodes, each.
#define SFI_BOUNDS_VECTORS 6

// Find the w of least w . A w with 0 <= w <= 1 on free nodes, four side by side. w holds the values
// of fixed nodes, which stay, and something to begin from; only lanes below `lanes` are worked on.
// `scratch` has SFI_BOUNDS_VECTORS vectors. `left` receives what is left: the largest correction
// asked for, or the furthest that a number lay off a bound that holds it, at most `tolerance`.
// SF_ERR_CANCELLED and SF_ERR_INTERNAL leave w unfinished.
sf_status sfi_bounds_solve(sfi_plate *plate, size_t lanes, double tolerance, const sf_task *task,
                           double *scratch, double *w, double *left);

#endif
