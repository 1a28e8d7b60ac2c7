// SPDX-License-Identifier: MIT
// Whether a model that was made to stand prints without supports.

#ifndef DEMO_SF_STAND_PRINTS_H
#define DEMO_SF_STAND_PRINTS_H

#include "stand_model.h"

// Fields and sentences, in the words of `sf check`.
exit_status stand_prints(cli_job *job, const model *m);

// Say how to check what was written; a file that was not is NULL. `inner` is what is to be taken
// from the outside.
exit_status stand_prints_advise(cli_job *job, const model *m, const char *outer, const char *inner,
                                const char *layers);

#endif
