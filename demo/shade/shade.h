// SPDX-License-Identifier: MIT
// Colours of a number from 0 to 1: dark blue over green to yellow, evenly lighter, and told apart
// by the colour-blind.

#ifndef DEMO_SHADE_SHADE_H
#define DEMO_SHADE_SHADE_H

#include <stdint.h>

// What lies outside of 0 to 1 has the colour of the end; `light` from 0 to 1 darkens it, and more
// makes it lighter.
static inline void shade_of(double t, double light, uint8_t rgb[3])
{
    static const double stops[5][3] = {
        {68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}};
    t = t > 0 ? (t < 1 ? t : 1) : 0;
    int i = t >= 1 ? 3 : (int)(4 * t);
    double f = 4 * t - i;
    for (int j = 0; j < 3; j++) {
        double c = light * (stops[i][j] + f * (stops[i + 1][j] - stops[i][j]));
        rgb[j] = (uint8_t)(c < 255 ? c : 255);
    }
}

#endif
