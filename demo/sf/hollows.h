// SPDX-License-Identifier: MIT
// Voids of the part that hold what they should not, or pull at the film of a resin printer.

#ifndef DEMO_SF_HOLLOWS_H
#define DEMO_SF_HOLLOWS_H

#include "part.h"

typedef struct hollows {
    sf_voids_report counts;
    sf_void *voids;
    size_t count;
} hollows;

// Room for voids, and how to look for them; for those who do so themselves.
exit_status hollows_begin(cli_job *job, hollows *h);
sf_voids_options hollows_options(const part *p, const hollows *h);

// Find them in the part's grid.
exit_status hollows_find(cli_job *job, const part *p, hollows *h);

// Fields.
void hollows_report(cli_job *job, const part *p, const hollows *h);

// Sentences; in one line where they are to be brief.
void hollows_say(cli_job *job, const part *p, const hollows *h, int is_brief);

void hollows_release(hollows *h);

#endif
