// SPDX-License-Identifier: MIT
// A plan, or a part of one, painted onto a canvas.

#ifndef DEMO_SF_PLAN_PLOT_H
#define DEMO_SF_PLAN_PLOT_H

#include "canvas.h"
#include "plan_view.h"

typedef struct plot {
    const plan *plan;
    int x, y, width, height;              // its place on the canvas
    double middle[2];                     // what lies in the middle of it
    double pixel_mm;                      // how large a pixel is
    double unit;                          // what marks are drawn in, in pixels
    int has_window;                       // whether a part of it is shown elsewhere:
    double window_low[2], window_high[2]; // that part
} plot;

// Show a box as large as it fits, with a margin that is a part of it.
void plot_frame(plot *p, const double low[2], const double high[2], double margin);

// Paint the shadow of a mesh, and the plan on it.
sf_status plot_paint(const plot *p, sf_mesh_view mesh, sf_task *task, canvas *picture);

#endif
