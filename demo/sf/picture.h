// SPDX-License-Identifier: MIT
// A picture of a shape: what prints, what does not, and how large it is.

#ifndef DEMO_SF_PICTURE_H
#define DEMO_SF_PICTURE_H

#include "canvas.h"
#include "part.h"

// What a picture shows.
typedef struct subject {
    const sf_grid *shape;  // what is drawn
    const sf_grid *kept;   // what of it is not coloured; may be `shape` itself
    const sf_grid *framed; // what the camera looks at, so that two pictures show the same place
} subject;

// Draw a subject. The camera and the size come from the options. The length of the scale bar in mm
// is left in `bar_mm`.
exit_status picture_draw(cli_job *job, const subject *what, canvas *picture, double *bar_mm);

#endif
