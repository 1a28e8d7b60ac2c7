// SPDX-License-Identifier: MIT
// What there is to say of a model that was made to stand.

#ifndef DEMO_SF_STAND_SAY_H
#define DEMO_SF_STAND_SAY_H

#include "stand_model.h"

// Fields and sentences; all but what was written.
void stand_report(cli_job *job, const model *m);

// A direction in words: "+z" where it is an axis, "(0.100, 0.000, 0.995)" where it is none.
#define STAND_DIRECTION_SIZE 64
const char *stand_direction(const double up[3], char words[STAND_DIRECTION_SIZE]);

#endif
