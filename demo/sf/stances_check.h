// SPDX-License-Identifier: MIT
// Whether what a model is to rest on or hang from lies where the model is.

#ifndef DEMO_SF_STANCES_CHECK_H
#define DEMO_SF_STANCES_CHECK_H

#include "stances_read.h"

// Refuses a string that is tied to the air, and a box of contacts without a vertex in it.
exit_status stances_check(cli_job *job, const part *p, const stances *s);

#endif
