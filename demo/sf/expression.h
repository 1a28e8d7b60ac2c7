// SPDX-License-Identifier: MIT
// Formulas of x, y, z and v, typed by people.

#ifndef DEMO_SF_EXPRESSION_H
#define DEMO_SF_EXPRESSION_H

#include <stddef.h>

typedef struct expression expression;

// Read a formula. Returns NULL with a sentence where it is none, or where this program reads none.
expression *expression_read(const char *text, char *why, size_t size);
void expression_free(expression *e);

// Its value at a place in mm, v being the value that is there. Not finite where it has none.
double expression_at(expression *e, const double place[3], double v);

#endif
