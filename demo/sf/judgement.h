// SPDX-License-Identifier: MIT
// Does the part print without supports, and where not?

#ifndef DEMO_SF_JUDGEMENT_H
#define DEMO_SF_JUDGEMENT_H

#include "groups.h"
#include "hollows.h"
#include "part.h"

typedef struct judgement {
    sf_check_report counts;
    sf_finding *findings;
    sf_finding_cost *costs;
    uint32_t *order, *ranks; // findings, the dearest first; the place of each in that order
    size_t finding_count;
    int priced; // whether costs knows what growing takes
    groups groups;
    hollows hollows;
} judgement;

// Counts only, of any grid under the part's rule and bed.
sf_status count_unsupported(cli_job *job, const part *p, const sf_grid *grid,
                            sf_check_report *counts);

// Room for findings, and what is done once they are there: costs, order, groups. For those who do
// the check themselves; judgement_settle() without a grid tells costs by what a trim takes.
enum { JUDGEMENT_FINDINGS_MAX = 65536 };
exit_status judgement_begin(cli_job *job, judgement *j);
exit_status judgement_settle(cli_job *job, const part *p, judgement *j);

// Check the part's grid under its rule, and find the places.
exit_status judge(cli_job *job, const part *p, judgement *j);

// Fields and sentences of a judgement; five lines at most where they are to be brief, with that of
// the part.
void judgement_report(cli_job *job, const part *p, const judgement *j, int is_brief);

void judgement_release(judgement *j);

#endif
