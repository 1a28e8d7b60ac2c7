// SPDX-License-Identifier: MIT
// A folder of results that appears whole, beside whatever else it holds.

#ifndef DEMO_SF_RESULTS_H
#define DEMO_SF_RESULTS_H

#include "job.h"

enum { RESULTS_PATH_SIZE = 4096 };

typedef struct results {
    char folder[RESULTS_PATH_SIZE]; // where they are to be
    char aside[RESULTS_PATH_SIZE];  // where they are made; empty when there is nothing aside
    int is_new;                     // whether there was no folder
} results;

// Begin, with nothing changed in `folder`, or where it will be.
exit_status results_begin(cli_job *job, const char *folder, results *r);

// The path of a result while it is made: a file's, or the folder's `layers`.
exit_status results_path(cli_job *job, const results *r, const char *name,
                         char path[RESULTS_PATH_SIZE]);

// Nobody has heard of the folder aside: where the job's message names it, name the results' own.
void results_name_target(cli_job *job, const results *r);

// Put all that was made in its place. Older results are replaced, other files stay. On failure the
// message says what was replaced already.
exit_status results_publish(cli_job *job, results *r);

// Remove what is left aside.
void results_drop(results *r);

#endif
