// SPDX-License-Identifier: MIT
// The lattice that a mesh is put on.

#ifndef DEMO_SF_LATTICE_H
#define DEMO_SF_LATTICE_H

#include "job.h"

// Faces of voxels lie on the lower corner of the box around the part; one empty voxel stands around
// it in x and y, none below. `lift` gets the layers added below where the bed lies lower than the
// part.
exit_status lattice_fit(cli_job *job, const double low_mm[3], const double high_mm[3],
                        sf_lattice *lattice, uint32_t *lift);

// The same for a whole grid of it, which must fit into --memory.
exit_status lattice_choose(cli_job *job, const double low_mm[3], const double high_mm[3],
                           sf_lattice *lattice, uint32_t *lift);

// Refuse a lattice whose grid would take more memory than --memory allows. `below` layers of it lie
// between the bed and the part.
exit_status lattice_check_memory(cli_job *job, const sf_lattice *lattice, double below);

// The same where the lattice is not ours to choose.
exit_status lattice_check_given(cli_job *job, const sf_lattice *lattice);

#endif
