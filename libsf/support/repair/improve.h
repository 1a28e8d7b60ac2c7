// SPDX-License-Identifier: MIT
// The search for a cheap repair.

#ifndef SF_SUPPORT_IMPROVE_H
#define SF_SUPPORT_IMPROVE_H

#include "support/repair/repair.h"

// The cheapest result that is found, into *result, which may be another grid after the call (also
// a failing one). `given` is a result to start from as well, or NULL. Fills first_cost, trim_cost,
// grow_cost, rounds and cost; a cost of SF_REPAIR_NO_COST says that none was found.
sf_status sfi_improve(const sfi_job *job, const sf_grid *given, uint32_t rounds, sf_grid **result,
                      sf_repair_report *report);

#endif
