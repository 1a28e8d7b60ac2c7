// SPDX-License-Identifier: MIT
// Scaffold: the cheapest struts of many tries.
//
// Struts are chosen greedily by the price of their way down, and that is wrong in one respect: ways
// join, and what many share costs each only its share. How many share a place is known when all
// have been chosen, so they are chosen again, at a place's cost over what stood on it the last
// time; and again, as long as that is cheaper (slope scaling).
//
// Where that has settled, prices are shaken, in half of all blocks of places: each try then leans
// on the ways of the cheapest struts so far, which are shared and so cheap, and differs from them
// here and there. What is cheaper is where the next tries go on (iterated local search). What
// struts cost is summed up from their places, without discount. Numbers are integers, and shaking
// is a hash of the place's number, so that the result is the same everywhere.
//
// Tries are many for parts of up to seventy thousand places, where one takes three milliseconds,
// and fewer beyond, so that the time goes on to grow as the part does; and they end where many
// found nothing.
//
// Source: D. Kim, P. M. Pardalos, "A solution approach to the fixed charge network flow problem
// using a dynamic slope scaling procedure", 1999; H. R. Lourenco, O. C. Martin, T. Stutzle,
// "Iterated local search", 2003.

#include "balance/forest/places.h"

#include "base/status.h"

#include <string.h>

enum { TRIES_MOST = 80, TRIES_LEAST = 8, PLACES_TRIED = 5600000 };

static uint32_t tries_for(uint32_t count)
{
    uint32_t tries = count > 0 ? PLACES_TRIED / count : 1;
    return tries < TRIES_LEAST ? TRIES_LEAST : tries > TRIES_MOST ? TRIES_MOST : tries;
}

// What the places that are forced cost.
static int64_t cost_of(const sfi_places *p)
{
    int64_t cost = 0;
    for (uint32_t i = 0; i < p->count; i++) {
        int is_forced = (p->state[i] & SFI_PLACE_FORCED) != 0;
        cost += is_forced && p->weight[i] > 0 ? p->weight[i] : 0;
    }
    return cost;
}

// How many forced places stand on each, by `next`: numbers rise from the bottom up.
static void find_loads(sfi_places *p)
{
    for (uint32_t i = 0; i < p->count; i++) {
        p->load[i] = (p->state[i] & SFI_PLACE_FORCED) != 0;
    }
    for (uint32_t i = p->count; i-- > 0;) {
        if (p->next[i] != SFI_PLACE_ROOT) {
            p->load[p->next[i]] += p->load[i];
        }
    }
}

static sf_status choose(sfi_places *p, uint32_t seed)
{
    sfi_discount discount = {p->load, seed};
    memset(p->state, 0, p->count);
    SF_TRY(sfi_places_route(p, &discount));
    return sfi_places_force(p);
}

sf_status sfi_places_scaffold(sfi_places *p)
{
    int64_t least = INT64_MAX;
    uint32_t tries = tries_for(p->count), idle = 0; // tries since one was cheaper
    for (uint32_t i = 0; i < tries && least > 0 && p->count > 0; i++) {
        SF_TRY(choose(p, idle > 0 ? i : 0));
        int64_t cost = cost_of(p);
        idle++;
        if (cost < least) {
            least = cost;
            idle = 0;
            memcpy(p->best, p->state, p->count);
            SF_TRY(sfi_places_route(p, NULL));
            find_loads(p);
        }
    }
    if (p->count > 0) {
        memcpy(p->state, p->best, p->count);
    }
    return sfi_places_route(p, NULL);
}
