// SPDX-License-Identifier: MIT
// Multipliers: from "the least by one lever", asked again and again, to "the best that the
// half-spaces allow".

#ifndef SF_BALANCE_LAGRANGE_H
#define SF_BALANCE_LAGRANGE_H

#include "balance/forest/lever.h"

// What is looked for.
typedef enum sfi_forest_goal {
    SFI_FOREST_MOST = 0,   // as much mass as can be while every half-space holds
    SFI_FOREST_LEAST = 1,  // as little
    SFI_FOREST_DEEPEST = 2 // all half-spaces as deep as can be
} sfi_forest_goal;

// The question. Half-space e holds to a depth where levers[e] - depth * slopes[e] counts 0 or more;
// slopes count more than 0 for every body that is found.
typedef struct sfi_search {
    sfi_forest_goal goal;
    const sfi_lever *levers, *slopes;
    size_t count;     // of half-spaces; at least 1 for the deepest
    double mass_unit; // masses are divided by it
    sf_body start;    // of a shape that may be
    // A shape for which `weight` sums up to as little as can be, and its body.
    sf_status (*find)(void *context, const sfi_lever *weight, sf_body *body);
    void *context;
    uint32_t most; // times that find may be called
} sfi_search;

// The answer: the best mixture of shapes, and what it proves. A mixture is no shape, but only few
// voxels away from that of the last `find`, which was asked for `weight`.
typedef struct sfi_multipliers {
    sfi_lever weight;
    int holds;    // the mixture fulfils every half-space
    double value; // of the mixture: its mass, or its depth
    double bound; // none is better, as far as `find` found the least
    uint32_t evaluations;
} sfi_multipliers;

sf_status sfi_multipliers_find(const sfi_search *search, sfi_multipliers *answer);

// The least depth to which a body holds every half-space; 0 without any.
double sfi_depth_of(const sfi_search *search, const sf_body *body);

#endif
