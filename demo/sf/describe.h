// SPDX-License-Identifier: MIT
// What every verb says about its input and its lattice.

#ifndef DEMO_SF_DESCRIBE_H
#define DEMO_SF_DESCRIBE_H

#include "part.h"

// Volume of the solid voxels of a grid in mm3.
double describe_volume(const sf_grid *grid);

// Fields: verb, input, lattice, rule, bed layer; and the sentence that opens the text.
void describe_part(cli_job *job, const part *p, const char *verb);

#endif
