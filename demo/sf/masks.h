// SPDX-License-Identifier: MIT
// Masks: where an operator must keep what there is, where it may add nothing, and what is to go.

#ifndef DEMO_SF_MASKS_H
#define DEMO_SF_MASKS_H

#include "part.h"

// Grids on the part's lattice; NULL where the option was not given.
typedef struct masks {
    sf_grid *keep;   // --keep
    sf_grid *forbid; // --forbid
    sf_grid *brush;  // --remove
} masks;

// Read the meshes that the options name, brought to build axes and mm as the part was (those of a
// stack or a scene are taken to be there already), and voxelise them on its lattice.
exit_status masks_read(cli_job *job, const part *p, masks *m);

// The terms of an operator: rule and bed of the part, and its masks.
sf_terms masks_terms(const part *p, const masks *m);

void masks_release(masks *m);

#endif
