// SPDX-License-Identifier: MIT
// Everything that a repair tries for one set that must stay.

#ifndef SF_SUPPORT_ATTEMPT_H
#define SF_SUPPORT_ATTEMPT_H

#include "support/repair/repair.h"

// What all attempts of a call share. The last part is made when it is first asked for.
typedef struct sfi_quest {
    const sfi_job *job;    // under the rule without bridges
    const sf_terms *terms; // the caller's, with the bed that they came to
    const sf_grid *room;   // what may be solid, trimmed under the whole rule
    uint32_t rounds;
    int is_grow_asked; // whether grow may be
    int has_careful;   // under slack
    sfi_job careful;   // steps that use up no reach
    sf_grid *careful_room, *careful_exempt;
    sf_grid *grown; // what grow makes of all that can be kept; or NULL
    uint64_t grown_cost;
} sfi_quest;

void sfi_quest_destroy(sfi_quest *quest);

// The cheapest that was found: by the rule without bridges, and under the whole rule, where that is
// another. Costs are SF_REPAIR_NO_COST where there is none.
typedef struct sfi_attempt {
    sf_grid *plain, *bridged;
    sf_grid *dearer;     // by the rule without bridges: what rounds came to from elsewhere; or NULL
    uint64_t plain_cost; // at the job's prices
    sf_repair_report report;
} sfi_attempt;

// Try to keep `must` (NULL: nothing). `before` is an attempt that kept more, and may have come to
// nothing. A function of the quest and these alone.
sf_status sfi_attempt_make(sfi_quest *quest, const sf_grid *must, const sfi_attempt *before,
                           sfi_attempt *attempt);
void sfi_attempt_destroy(sfi_attempt *attempt);

// The result under the whole rule; NULL where there is none.
static inline sf_grid *sfi_attempt_result(const sfi_attempt *attempt)
{
    return attempt->bridged != NULL                   ? attempt->bridged
           : attempt->plain_cost != SF_REPAIR_NO_COST ? attempt->plain
                                                      : NULL;
}

#endif
