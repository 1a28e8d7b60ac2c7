// SPDX-License-Identifier: MIT
// Where in a piece a point of space is.

#ifndef SF_GRADE_LIMIT_SEARCH_H
#define SF_GRADE_LIMIT_SEARCH_H

#include "grade/limit/atlas.h"

// A search for one point, in one piece after the other, and the best place so far.
typedef struct sfi_search {
    const sfi_atlas *atlas;
    double point[3];
    double close;    // a place that near is it, and the search ends
    double reach2;   // square of the distance within which a place is wanted; falls
    int split;       // whether splines are cut where a few steps of Newton do not get there
    double *scratch; // sfi_search_scratch() numbers
    double u[3];     // the best place, in the piece where it was found
    uint32_t left;   // parts that may still be looked into; with none left the search ends
    int found;       // whether there is one within reach since the last look
} sfi_search;

// Parts that one search may look into. Hundreds are many inside of a solid, and outside, close to
// what is irregular, ten thousand are not rare; where a shape is folded flat all parts of a whole
// plane of it can be equally near, and there is no end to halving them.
enum { SFI_SEARCH_PARTS = 1 << 17 };

// Numbers of scratch that a search needs.
size_t sfi_search_scratch(const sfi_atlas *atlas);

// Look in a piece of a kind, of which the ring's positions are given. Returns 1 when a place is
// close enough, or no more parts may be looked into.
int sfi_search_piece(sfi_search *search, uint32_t kind, const double *values);

#endif
