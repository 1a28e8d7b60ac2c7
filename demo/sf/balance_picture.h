// SPDX-License-Identifier: MIT
// A picture of a balance: what a model stands on or hangs from, where its centre of mass may lie,
// was, and is.

#ifndef DEMO_SF_BALANCE_PICTURE_H
#define DEMO_SF_BALANCE_PICTURE_H

#include "canvas.h"
#include "stand_model.h"

// Draw it, as large as the options say: a plan for each of the first four stances, and beside it
// what happens in the middle of it, where that is small.
exit_status balance_picture_draw(cli_job *job, const model *m, canvas *picture);

#endif
