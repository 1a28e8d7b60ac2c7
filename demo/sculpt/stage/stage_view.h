// SPDX-License-Identifier: MIT
// The drawing of a stage by OpenGL 4.5, whose context must be current in all calls.

#ifndef SCULPT_STAGE_STAGE_VIEW_H
#define SCULPT_STAGE_STAGE_VIEW_H

#include "stage.h"
#include "view/camera.h"

typedef struct stage_view stage_view;

// NULL where that fails, and *why is a sentence that says why.
stage_view *stage_view_create(const char **why);
void stage_view_destroy(stage_view *v);

// Draw into a framebuffer of OpenGL; 0 is the window's. A size of 0 draws nothing. 0 where there
// is no memory for the picture or for what is on the stage.
int stage_view_draw(stage_view *v, const stage *s, const view_camera *camera, unsigned framebuffer,
                    uint32_t width, uint32_t height);

// Draw a picture, row 0 on top, 3 bytes a pixel. 0 where there is no memory.
int stage_view_shot(stage_view *v, const stage *s, const view_camera *camera, uint32_t width,
                    uint32_t height, unsigned char *pixels);

#endif
