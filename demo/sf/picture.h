// SPDX-License-Identifier: MIT
// A picture of a shape: what prints, what does not, and how large it is.

#ifndef DEMO_SF_PICTURE_H
#define DEMO_SF_PICTURE_H

#include "canvas.h"
#include "part.h"

// Colours of matter, 0 to 1.
extern const double picture_matter[3], picture_lost[3], picture_added[3];

// What a picture shows.
typedef struct subject {
    const sf_grid *shape; // what is drawn
    const sf_grid *plain; // what of it has the colour of matter; may be `shape` itself
    const double *other;  // colour of the rest
    sf_box framed;        // what the camera looks at, so that pictures show the same place
} subject;

// A part of a picture, and how it is drawn.
typedef struct frame {
    uint32_t x, y, width, height;
    int rays; // along a side of each pixel: 2, or 3
} frame;

// Height over width of a box of voxels as the camera sees it, the bed's margin included.
double picture_aspect(const cli_job *job, const sf_lattice *lattice, sf_box framed);

// Draw a subject into a part of a picture. The camera comes from the options. The size of a pixel
// is left in `pixel_mm`.
exit_status picture_paint(cli_job *job, const subject *what, canvas *picture, frame where,
                          double *pixel_mm);

// A picture of one subject with its legend, as large as the options say. The length of the scale
// bar in mm is left in `bar_mm`.
exit_status picture_draw(cli_job *job, const subject *what, canvas *picture, double *bar_mm);

#endif
