// SPDX-License-Identifier: MIT
// Where a void could be drained, the best places first.

#ifndef SF_BALANCE_OUTLET_H
#define SF_BALANCE_OUTLET_H

#include "balance/carve/drill.h"

// A void that is closed.
typedef struct sfi_closed_void {
    uint32_t piece;
    uint64_t voxels;
    sf_box box;
    int is_narrow; // no hole fits into it, or it is too small to have one
} sfi_closed_void;

#define SFI_OUTLET_TAKEN 1u // there is a hole
#define SFI_OUTLET_VAIN 2u  // tried, or next to one that was
#define SFI_OUTLET_CLOSE 4u // too close to a hole

// A place to begin a shaft at.
typedef struct sfi_outlet {
    double cost;
    uint32_t layer;
    uint16_t x, y;
    uint8_t direction, state; // SFI_OUTLET_*
} sfi_outlet;

typedef struct sfi_outlets {
    sfi_outlet *list;
    size_t count, capacity;
} sfi_outlets;

// What a balance makes of a place.
typedef struct sfi_levers {
    const double (*ups)[3];
    size_t count;
    double com[3];
    double diagonal; // of the lattice
} sfi_levers;

// Add all places of a void for straight shafts (aslant 0) or for those aslant. `slices` are three
// of the lattice's size. SF_ERR_MEMORY.
sf_status sfi_outlets_find(const sfi_ground_plan *plan, const sfi_closed_void *hollow, int aslant,
                           const sfi_levers *levers, const sf_slice slices[3],
                           const sf_allocator *allocator, sfi_outlets *outlets);

// The cheapest that is in none of these states; NULL where there is none.
sfi_outlet *sfi_outlets_best(const sfi_outlets *outlets);

// Those of a direction that begin less than `radius_mm` away across z from one of it are in vain.
void sfi_outlets_give_up(const sfi_outlets *outlets, const sf_lattice *lattice,
                         const sfi_outlet *one, double radius_mm);

// Say anew which ones are less than `radius_mm` away from one that is taken.
void sfi_outlets_keep_apart(const sfi_outlets *outlets, const sf_lattice *lattice,
                            double radius_mm);

#endif
