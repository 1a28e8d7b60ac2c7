// SPDX-License-Identifier: MIT
// Rulers: what lengths and colours in a picture are in numbers.

#ifndef DEMO_SF_RULER_H
#define DEMO_SF_RULER_H

#include "canvas.h"

#include <sf/property.h>

enum { RULER_UNIT_SIZE = 64 };

// A range of numbers and the pixels along x that it takes.
typedef struct ruler {
    double low, high;
    int left, width;
} ruler;

// Ticks below y at round numbers, as many as there is room for, and the numbers under them; in
// place of the last one stands the unit, unless that is NULL. Takes 2.2 times the size of the text.
void ruler_draw(const ruler *r, int y, int size, const char *unit, canvas *to);

// A property's unit in words, such as kg/m^3; empty where it has none.
const char *ruler_unit(const sf_property *property, char words[RULER_UNIT_SIZE]);

#endif
