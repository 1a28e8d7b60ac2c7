// SPDX-License-Identifier: MIT
// The solid that a verb works on: a cage that stands for a smooth one, or tetrahedra as they are.

#ifndef DEMO_SF_SOLIDS_H
#define DEMO_SF_SOLIDS_H

#include "job.h"

// One of the two.
typedef struct solid_input {
    sf_cage *cage;
    sf_tets *tets;
} solid_input;

// Read the input: an exchange file (.h5) has tetrahedra, and so has a VTK file of nothing else; all
// other files have cages. The caller releases it, whatever is returned.
exit_status solids_read(cli_job *job, solid_input *read);
void solids_release(solid_input *s);

size_t solids_channels(const solid_input *s, const sf_channel **channels);

// Fields of a solid: an object "cage" or "tetrahedra".
void solids_report(cli_job *job, const solid_input *s);

// The number of the property of a name. EXIT_INPUT with the names that there are.
exit_status solids_find_property(cli_job *job, const solid_input *s, const char *name,
                                 size_t *channel);

#endif
