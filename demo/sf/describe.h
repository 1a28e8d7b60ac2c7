// SPDX-License-Identifier: MIT
// What every verb says about its input and its lattice.

#ifndef DEMO_SF_DESCRIBE_H
#define DEMO_SF_DESCRIBE_H

#include "part.h"

// Volume of the solid voxels of a grid in mm3.
double describe_volume(const sf_grid *grid);

// A volume for people: four digits, all of them where it has more before the point. In `text`,
// which is returned.
enum { DESCRIBE_MM3_SIZE = 32 };
const char *describe_mm3(double volume_mm3, char text[DESCRIBE_MM3_SIZE]);

// An object "lattice", along build axes.
void describe_lattice(report *r, const sf_lattice *lattice);

// Fields: verb, input, lattice, rule, bed layer; and the sentence that opens the text.
void describe_part(cli_job *job, const part *p, const char *verb);

#endif
