// SPDX-License-Identifier: MIT
// The strip below a picture: a scale bar, and what the colours mean.

#ifndef DEMO_SF_LEGEND_H
#define DEMO_SF_LEGEND_H

#include "canvas.h"

// Rows of a picture that the strip takes.
uint32_t legend_height(uint32_t picture_height);

// The largest of 1, 2, 5, 10, ... (times any power of ten) that is not above `most_mm`.
double legend_round_length(double most_mm);

// Draw the strip. `with_lost`: explain the colour of what cannot print. Returns the bar's length.
double legend_draw(canvas *picture, double pixel_mm, int with_lost, const double kept[3],
                   const double lost[3]);

#endif
