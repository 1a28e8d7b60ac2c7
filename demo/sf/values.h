// SPDX-License-Identifier: MIT
// What the values of options mean, and what they are where none is given.

#ifndef DEMO_SF_VALUES_H
#define DEMO_SF_VALUES_H

#include "options.h"

// All options as they are on an empty command line.
cli_options values_default(void);

// Take one option's argument. Returns 0 when it makes no sense.
int values_parse(uint64_t bit, const char *text, cli_options *made);

// The angle for people: the round number that it was made from, where there is one.
double values_angle_deg(const cli_options *options);

#endif
