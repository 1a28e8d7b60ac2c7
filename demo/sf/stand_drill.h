// SPDX-License-Identifier: MIT
// Drain holes of a model that was made to stand.

#ifndef DEMO_SF_STAND_DRILL_H
#define DEMO_SF_STAND_DRILL_H

#include "stand_model.h"

// Drill into every void of the carved shape, where its balance changes least, and judge again.
exit_status stand_drill(cli_job *job, model *m);

// What is to be taken from the outside: cavity and holes as one body, in the axes of the input.
exit_status stand_drill_mesh(cli_job *job, const model *m, sf_mesh **mesh);

// Fields and sentences; nothing where nothing was drilled.
void stand_drill_report(cli_job *job, const model *m);

#endif
