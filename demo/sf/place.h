// SPDX-License-Identifier: MIT
// Where voxels lie and how large they are, in build axes and mm.

#ifndef DEMO_SF_PLACE_H
#define DEMO_SF_PLACE_H

#include <sf/sf.h>

// Corners of a box of voxels.
void place_of_box(const sf_lattice *lattice, const sf_box *box, double low[3], double high[3]);

// Where a box of voxels begins and what it lies over, as "z = 1.00 mm, x 2.0 to 3.0, y 4.0 to 5.0",
// in as many digits as tell one voxel from the next; `in_column`: heights below each other.
#define PLACE_WORDS_SIZE 256
void place_words(const sf_lattice *lattice, const sf_box *box, int in_column,
                 char words[PLACE_WORDS_SIZE]);

// Mean volume of the grid's solid voxels; of its first layer's where none is solid.
double place_voxel_mm3(const sf_grid *grid);

#endif
