// SPDX-License-Identifier: MIT
// The inside of a solid, as carving sees it: what must stay, what stands by that, what may stay.

#ifndef SF_BALANCE_INTERIOR_H
#define SF_BALANCE_INTERIOR_H

#include "support/rule/terms.h"

typedef struct sfi_interior {
    sf_lattice lattice;
    uint32_t bed, width;       // layer on the bed; width of struts
    uint32_t reach_x, reach_y; // most of any step of the plain rule
    sf_rule full, plain;       // the terms' rule, and the one that struts go by
    sf_allocator allocator;
    sf_task *task;
    const sf_grid *solid;  // S
    sf_grid *given;        // what must stay by the call: the wall, and what the masks keep
    sf_grid *exempt;       // E: of the solid, what the terms exempt or nothing carries
    sf_grid *wall;         // F: `given` and thin voxels
    sf_grid *held;         // of the solid, what needs nothing of what may be added
    sf_grid *places;       // squares that may be added: their corners
    sf_grid *rooted;       // of those, what stands on the wall, the bed or exempt voxels
    uint64_t thin_voxels;  // of the wall, those that were not given
    uint64_t asked_voxels; // of the wall, those that are not held
    int is_open; // something of the wall is carried by no place: it counts as held, and the
                 // result must be completed under the full rule
} sfi_interior;

// Look at a solid. The terms have been checked against it, and the wall lies within it.
// SF_ERR_MEMORY, SF_ERR_OVERFLOW, SF_ERR_CANCELLED. What fails is destroyed.
sf_status sfi_interior_create(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                              uint32_t bed, uint32_t strut_width, const sf_allocator *allocator,
                              sf_task *task, sfi_interior *in);
void sfi_interior_destroy(sfi_interior *in);

// The terms of the full rule, with E and the bed.
sf_terms sfi_interior_terms(const sfi_interior *in);

// Take the voxels of `more` that are in the solid into the wall, and look again.
sf_status sfi_interior_thicken(sfi_interior *in, const sf_grid *more);

#endif
