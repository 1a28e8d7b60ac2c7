// SPDX-License-Identifier: MIT
// What the desk that is worked at shows, drawn. A context of OpenGL must be current.

#ifndef SCULPT_APP_SHOW_H
#define SCULPT_APP_SHOW_H

#include "editor.h"
#include "stage/stage_view.h"

typedef struct show {
    stage *stage;
    stage_view *view;
} show;

// 0 where that fails, and *why is a sentence that says why. `s` is all 0 before.
int show_make(show *s, const char **why);
void show_release(show *s);

// Draw as stage_view_draw() and stage_view_shot() do; what the desk shows is put on the stage anew
// where it has changed.
int show_draw(show *s, const editor *e, unsigned framebuffer, uint32_t width, uint32_t height);
int show_shot(show *s, const editor *e, uint32_t width, uint32_t height, unsigned char *pixels);

#endif
