// SPDX-License-Identifier: MIT
// A cavity that is in a file of its own.

#ifndef DEMO_SF_INNER_H
#define DEMO_SF_INNER_H

#include "part.h"

// Read the mesh of --inner, where it is given, into the part.
exit_status inner_read(cli_job *job, part *p);

// Move the corners of voxels to those that the cavity was made of.
exit_status inner_align(cli_job *job, const part *p, sf_lattice *lattice);

// Take its voxels from those of the part.
exit_status inner_take(cli_job *job, part *p);

#endif
