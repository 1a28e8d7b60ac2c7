// SPDX-License-Identifier: MIT
// Recipes: how a cage is painted, step by step.

#ifndef DEMO_SF_RECIPES_H
#define DEMO_SF_RECIPES_H

#include "job.h"

// Do what the file says that --paint names.
exit_status recipes_apply(cli_job *job, sf_cage *cage);

#endif
