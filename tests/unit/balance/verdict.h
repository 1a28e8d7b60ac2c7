// SPDX-License-Identifier: MIT
// Stances of soups of triangles, and what they say of a centre of mass, for the tests of stances.

#ifndef SF_TEST_BALANCE_VERDICT_H
#define SF_TEST_BALANCE_VERDICT_H

#include "turn.h"

#include <sf/stance.h>

static inline sf_stance *stance_of(soup *s, const sf_stance_options *options)
{
    sf_stance *stance = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_stance_create(soup_view(s), options, NULL, &stance, &fault), SF_OK);
    CHECK_STR(fault.message, "");
    return stance;
}

static inline sf_stance_verdict verdict_of(const sf_stance *stance, const double com[3])
{
    sf_stance_verdict v = {0, 0, {{0, 0, 0}, {0, 0, 0}}, 0, 0};
    CHECK_EQ(sf_stance_judge(stance, com, &v), SF_OK);
    return v;
}

#endif
