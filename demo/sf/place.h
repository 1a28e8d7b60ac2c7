// SPDX-License-Identifier: MIT
// Where voxels lie and how large they are, in build axes and mm.

#ifndef DEMO_SF_PLACE_H
#define DEMO_SF_PLACE_H

#include <sf/sf.h>

// Corners of a box of voxels.
void place_of_box(const sf_lattice *lattice, const sf_box *box, double low[3], double high[3]);

// Mean volume of the grid's solid voxels; of its first layer's where none is solid.
double place_voxel_mm3(const sf_grid *grid);

#endif
