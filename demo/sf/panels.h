// SPDX-License-Identifier: MIT
// Pictures of several shapes side by side, seen alike, with a caption each.

#ifndef DEMO_SF_PANELS_H
#define DEMO_SF_PANELS_H

#include "canvas.h"
#include "part.h"

typedef struct panel {
    const sf_grid *shape;
    const char *title;
    const char *figures; // the line below it
} panel;

// Draw what became of `before`; what a shape has and that has not is drawn as added. A panel is
// half as wide as the options say, and as high as what it shows.
exit_status panels_draw(cli_job *job, const sf_grid *before, const panel *panels, uint32_t count,
                        canvas *picture);

#endif
