// SPDX-License-Identifier: MIT
// Carving for bases: what sf_grid_carve() makes of its stances.

#ifndef SF_BALANCE_CARVE_H
#define SF_BALANCE_CARVE_H

#include "balance/carve/carving.h"

// As sf_grid_carve(), the stances of the options not looked at: the bases are what they were made
// into.
sf_status sfi_carve(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                    const sf_carve_options *options, const sfi_base *bases, size_t base_count,
                    const sf_allocator *allocator, sf_task *task, sf_grid *result,
                    sf_carve_report *report);

#endif
