// SPDX-License-Identifier: MIT
// Where a model comes to rest that is put down, and left alone.

#ifndef DEMO_SF_STAND_REST_H
#define DEMO_SF_STAND_REST_H

#include "stand_model.h"

// Find it, and report it.
exit_status stand_rest(cli_job *job, const model *m);

#endif
