// SPDX-License-Identifier: MIT
// Where voxels lie and how large they are, in mm of the part as it is printed.
//
// Whoever reads of a place looks for it in the file that was read. So places are in the axes of the
// input, whichever of them points up in the printer; only a lattice is along build axes.

#ifndef DEMO_SF_PLACE_H
#define DEMO_SF_PLACE_H

#include "upright.h"

#include <sf/sf.h>

// A lattice, and the axis of the input that is its z.
typedef struct places {
    sf_lattice lattice;
    axis up;
} places;

// Corners of a box of voxels, in build axes.
void place_of_box(const sf_lattice *lattice, const sf_box *box, double low[3], double high[3]);

// The same in the axes of the input; and a point in build axes there. `to` may be `from`.
void place_box(const places *in, const sf_box *box, double low[3], double high[3]);
void place_point(axis up, const double from[3], double to[3]);

// Where a box of voxels begins and what it lies over, as "z = 1.00 mm, x 2.0 to 3.0, y 4.0 to 5.0",
// the axis that points up first, in as many digits as tell one voxel from the next; `in_column`:
// heights below each other.
#define PLACE_WORDS_SIZE 256
void place_words(const places *in, const sf_box *box, int in_column, char words[PLACE_WORDS_SIZE]);

// Mean volume of the grid's solid voxels; of its first layer's where none is solid.
double place_voxel_mm3(const sf_grid *grid);

#endif
