// SPDX-License-Identifier: MIT
// The search for a cheap repair: where it starts, and rounds that make it cheaper.

#ifndef SF_SUPPORT_IMPROVE_H
#define SF_SUPPORT_IMPROVE_H

#include "support/repair/repair.h"

// In all of these *result may be another grid after the call, also after a failing one.

// The first result: the cheapest of the trim and the forests. Fills trim_cost, grow_cost,
// first_cost and cost; a cost of SF_REPAIR_NO_COST says that there is none.
sf_status sfi_start(const sfi_job *job, sf_grid **result, sf_repair_report *report);

// Make a result cheaper, by rounds of which `rounds` are made at most (0: as long as they pay), and
// where asked for also by holding it against a grow of one path after the other. Adds to rounds,
// and fills cost.
sf_status sfi_rounds(const sfi_job *job, uint32_t rounds, int is_in_turn, sf_grid **result,
                     sf_repair_report *report);

// Both: the first result alone with SF_REPAIR_FIRST.
sf_status sfi_improve(const sfi_job *job, uint32_t rounds, sf_grid **result,
                      sf_repair_report *report);

#endif
