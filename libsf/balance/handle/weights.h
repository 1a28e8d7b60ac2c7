// SPDX-License-Identifier: MIT
// What weights are made of, for those who look inside.

#ifndef SF_BALANCE_WEIGHTS_H
#define SF_BALANCE_WEIGHTS_H

#include "balance/handle/weights_domain.h"

#include <sf/weights.h>

struct sf_weights {
    sf_allocator allocator;
    sfi_domain domain;
    size_t count;    // handles
    double *values;  // count for each node
    double *centers; // x, y, z of each handle
    sf_weights_facts facts;
};

// Weights at a spot, and their gradient by the point that was looked for; `gradient` may be NULL.
void sfi_weights_at(const sf_weights *weights, const sfi_spot *spot, double *w, double *gradient);

#endif
