// SPDX-License-Identifier: MIT
// What bridges make cheaper in a repair.

#ifndef SF_SUPPORT_BRIDGED_H
#define SF_SUPPORT_BRIDGED_H

#include "support/repair/repair.h"

// Make `result`, found without bridges (or not found: report->cost is SF_REPAIR_NO_COST), cheaper
// under the full rule. `room` is the trim under it of all that may be solid.
sf_status sfi_bridged_improve(const sfi_job *job, const sf_terms *full, const sf_grid *room,
                              sf_grid *result, sf_repair_report *report);

#endif
