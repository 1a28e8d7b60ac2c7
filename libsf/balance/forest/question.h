// SPDX-License-Identifier: MIT
// What a carving is asked, checked and put into levers.

#ifndef SF_BALANCE_QUESTION_H
#define SF_BALANCE_QUESTION_H

#include "balance/forest/forest.h"

typedef struct sfi_question {
    const sf_grid *solid, *wall;
    const sf_terms *terms;
    const sfi_forest_options *options;
    sf_allocator allocator;
    sf_task *task;
    sf_lattice lattice;
    uint32_t bed, width;
    sf_body whole;              // the solid and the rest
    double mass_unit;           // masses are divided by it
    sfi_lever *levers, *slopes; // of the half-spaces, over a unit of mass times length
} sfi_question;

// Check a call, and make its levers. terms may be NULL for a question that asks for no supports.
// What fails is destroyed. Codes as in forest.h.
sf_status sfi_question_create(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                              const sfi_forest_options *options, const sf_allocator *allocator,
                              sf_task *task, sfi_question *question);
void sfi_question_destroy(sfi_question *question);

// given = what must stay: the wall, and of the solid what `keep` names and what lies outside `act`.
// All have one size; terms may be NULL.
sf_status sfi_question_given(const sf_grid *solid, const sf_grid *wall, const sf_terms *terms,
                             sf_grid *given);

// The search that a question comes down to; find and context are left to the caller.
sfi_search sfi_question_search(const sfi_question *question, sfi_forest_goal goal);

#endif
