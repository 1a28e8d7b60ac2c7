// SPDX-License-Identifier: MIT
// The least shape by a lever where nothing needs to be carried.

#ifndef SF_BALANCE_BOUND_H
#define SF_BALANCE_BOUND_H

#include "balance/forest/lever.h"

typedef struct sfi_fractional {
    const sf_grid *solid;
    const sf_grid *given; // what must stay, within the solid
    const float *density;
    sf_body rest;
    sf_task *task;  // for its cancel
    sf_grid *shape; // of the solid's counts: what was found last
} sfi_fractional;

// context is a sfi_fractional; as sfi_search wants it (lagrange.h).
sf_status sfi_fractional_find(void *context, const sfi_lever *weight, sf_body *body);

#endif
