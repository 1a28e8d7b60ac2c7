// SPDX-License-Identifier: MIT
// The strip below a picture: a scale bar, and what the colours mean.

#ifndef DEMO_SF_LEGEND_H
#define DEMO_SF_LEGEND_H

#include "canvas.h"

#include <stddef.h>

// Rows of a picture that the strip takes.
uint32_t legend_height(uint32_t picture_height);

// The largest of 1, 2, 5, 10, ... (times any power of ten) that is not above `most_mm`.
double legend_round_length(double most_mm);

// A colour and what it means.
typedef struct swatch {
    const double *rgb; // 0 to 1
    const char *words;
} swatch;

// Draw the strip, the bar at most `most` pixels long. Returns the bar's length in mm.
double legend_draw(canvas *picture, double pixel_mm, double most, const swatch *swatches,
                   size_t count);

#endif
