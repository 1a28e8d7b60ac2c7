// SPDX-License-Identifier: MIT
// The places of an interior by number, and what is known of each.

#ifndef SF_BALANCE_PLACES_H
#define SF_BALANCE_PLACES_H

#include "balance/forest/interior.h"
#include "balance/forest/lever.h"

// next of a place that needs nothing below.
#define SFI_PLACE_ROOT UINT32_MAX

// Bits of a place's state.
enum {
    SFI_PLACE_FORCED = 1, // the wall rests on it, or on what rests on it
    SFI_PLACE_KEPT = 2    // chosen
};

// Largest weight of a place, either way.
#define SFI_PLACE_WEIGHT ((int32_t)1 << 30)

// Places are numbered in (layer, y, x) order of their corners, so what a place rests on has a lower
// number.
typedef struct sfi_places {
    const sfi_interior *in;
    uint32_t count;
    uint32_t *first; // for each row, and one more at the end: the first place from its start on
    double *z_mm;    // of the middle of each layer
    double unit_mm3; // masses are divided by it
    float *mass;     // of what of a square is no wall
    float most_mass;
    // By the lever that was asked for last:
    int32_t *weight; // what a place counts, in parts of the most that it could
    int32_t *price;  // of the cheapest way down, what is favourable being free
    uint32_t *next;  // the place that it rests on
    int64_t *gain;   // scratch of the closure
    uint8_t *state;
    // Of the cheapest struts so far (scaffold.c):
    uint8_t *best;  // their states
    uint32_t *load; // how many of them stand on a place, itself included
} sfi_places;

// Number the places. density as in sf_grid_body(), checked before. SF_ERR_MEMORY, SF_ERR_OVERFLOW:
// too many, SF_ERR_CANCELLED. What fails is destroyed.
sf_status sfi_places_create(const sfi_interior *in, const float *density, sfi_places *places);
void sfi_places_destroy(sfi_places *places);

// Number of the place with its corner at (x, y) of layer k, which is one.
uint32_t sfi_place_at(const sfi_places *places, uint32_t k, uint32_t x, uint32_t y);

// Weigh all places by a lever.
void sfi_places_weigh(sfi_places *places, const sfi_lever *lever);

// slice = the corners of layer k whose state has one of `bits`.
void sfi_places_read(const sfi_places *places, uint32_t k, unsigned bits, sf_slice slice);

// ---------------------------------------------------------------------------------------------
// Supporters (route.c, struts.c, scaffold.c, closure.c)
// ---------------------------------------------------------------------------------------------

// What changes the prices of a route: a place costs its share of what stands on it, and with a seed
// that is not 0, in half of all blocks, up to three quarters more or less.
typedef struct sfi_discount {
    const uint32_t *load;
    uint32_t seed;
} sfi_discount;

// Prices of all places by their weights, those forced being free, and `next` of each: the cheapest
// place below it, of equals the one that is most straight below. `discount` may be NULL.
// SF_ERR_MEMORY, SF_ERR_CANCELLED.
sf_status sfi_places_route(sfi_places *places, const sfi_discount *discount);

// Force the places that carry all that is asked of the interior, greedily cheap ones: by the prices
// of places that none is forced of. SF_ERR_MEMORY, SF_ERR_CANCELLED, SF_ERR_INTERNAL.
sf_status sfi_places_force(sfi_places *places);

// Force places by the weights, as the cheapest of many tries, and route what is left. Tries go on
// from those of the call before. SF_ERR_MEMORY, SF_ERR_CANCELLED, SF_ERR_INTERNAL.
sf_status sfi_places_scaffold(sfi_places *places);

// Of all sets that hold with each place the one that it rests on, and all that are forced, keep the
// one of least weight; of equals the smallest. `gain` is scratch of `count`.
void sfi_closure_least(uint32_t count, const uint32_t *next, const int32_t *weight, int64_t *gain,
                       uint8_t *state);

#endif
