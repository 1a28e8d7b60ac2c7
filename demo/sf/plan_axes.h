// SPDX-License-Identifier: MIT
// The frame of a plot: its sides in mm, with ticks.

#ifndef DEMO_SF_PLAN_AXES_H
#define DEMO_SF_PLAN_AXES_H

#include "plan_plot.h"

// Room that the frame takes around a plot for words of a size, in pixels.
int axes_left(int size);
int axes_top(int size);
int axes_right(int size);
int axes_bottom(int size);

// Draw it.
void axes_draw(const plot *p, int size, canvas *picture);

#endif
