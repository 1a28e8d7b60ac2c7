// SPDX-License-Identifier: MIT
// A picture of a shape: what prints, what does not, and how large it is.

#ifndef DEMO_SF_PICTURE_H
#define DEMO_SF_PICTURE_H

#include "canvas.h"
#include "part.h"

// Draw `shape` with what `kept` lacks of it coloured; `kept` may be `shape` itself. The camera and
// the size come from the options. The length of the scale bar in mm is left in `bar_mm`.
exit_status picture_draw(cli_job *job, const sf_grid *shape, const sf_grid *kept, canvas *picture,
                         double *bar_mm);

#endif
