// SPDX-License-Identifier: MIT
// The verbs of the program. Each does its work on a job, writes its files, and leaves its report.

#ifndef DEMO_SF_VERBS_H
#define DEMO_SF_VERBS_H

#include "job.h"

typedef struct verb_entry {
    cli_verb verb;
    exit_status (*run)(cli_job *job);
} verb_entry;

extern const verb_entry verbs_table[];
extern const int verbs_count;

exit_status verb_run(cli_job *job);
exit_status verb_info(cli_job *job);
exit_status verb_check(cli_job *job);
exit_status verb_trim(cli_job *job);
exit_status verb_grow(cli_job *job);
exit_status verb_repair(cli_job *job);
exit_status verb_preserve(cli_job *job);
exit_status verb_hollow(cli_job *job);
exit_status verb_stand(cli_job *job);
exit_status verb_slice(cli_job *job);
exit_status verb_grade(cli_job *job);
exit_status verb_refine(cli_job *job);
exit_status verb_tetra(cli_job *job);
exit_status verb_exchange(cli_job *job);
exit_status verb_orient(cli_job *job);
exit_status verb_render(cli_job *job);

#endif
