// SPDX-License-Identifier: MIT
// Volume, centre of mass and inertia of a grid.

#ifndef DEMO_SF_MASS_H
#define DEMO_SF_MASS_H

#include <sf/sf.h>

// Of the boxes that the solid voxels are, in the axes of the lattice; the area stays 0. An empty
// grid has no centre: not a number.
sf_mass mass_of_grid(const sf_grid *grid);

#endif
