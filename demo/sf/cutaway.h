// SPDX-License-Identifier: MIT
// A picture of a hollow part, cut open.

#ifndef DEMO_SF_CUTAWAY_H
#define DEMO_SF_CUTAWAY_H

#include "canvas.h"
#include "cavity.h"

// The half that faces the camera is left out. The length of the scale bar is left in `bar_mm`.
exit_status cutaway_draw(cli_job *job, const part *p, const cavity *c, canvas *picture,
                         double *bar_mm);

#endif
