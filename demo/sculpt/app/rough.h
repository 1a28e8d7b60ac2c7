// SPDX-License-Identifier: MIT
// Rough frames: smaller pictures, drawn large, while things move and whole ones take too long.

#ifndef SCULPT_APP_ROUGH_H
#define SCULPT_APP_ROUGH_H

#include "view/view.h"

typedef struct rough {
    unsigned texture, framebuffer;
    uint32_t width, height; // of the texture
    double whole_ms;        // what a whole frame took last
} rough;

// How many times smaller a frame is to be so that it keeps up: 1 where a whole one does.
uint32_t rough_part(const rough *r);

// Draw into the window's framebuffer, `part` times smaller along each side. 0 where there is no
// memory.
int rough_draw(rough *r, view *v, const view_camera *camera, const view_overlays *overlays,
               uint32_t width, uint32_t height, uint32_t part);

void rough_release(rough *r);

#endif
