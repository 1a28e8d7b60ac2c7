// SPDX-License-Identifier: MIT
// What the desk that is worked at shows, drawn.

#include "show.h"

int show_make(show *s, const char **why)
{
    *why = "There is no memory for a stage.";
    s->stage = stage_create();
    s->view = s->stage != NULL ? stage_view_create(why) : NULL;
    return s->view != NULL;
}

void show_release(show *s)
{
    stage_view_destroy(s->view);
    stage_destroy(s->stage);
    s->view = NULL;
    s->stage = NULL;
}

static int fill(show *s, desk *d)
{
    if (!d->is_stale) {
        return 1;
    }
    stage_clear(s->stage);
    if (!d->is->show(d, s->stage)) {
        return 0;
    }
    d->is_stale = 0;
    return 1;
}

int show_draw(show *s, const editor *e, unsigned framebuffer, uint32_t width, uint32_t height)
{
    return fill(s, editor_desk(e)) &&
           stage_view_draw(s->view, s->stage, &e->camera, framebuffer, width, height);
}

int show_shot(show *s, const editor *e, uint32_t width, uint32_t height, unsigned char *pixels)
{
    return fill(s, editor_desk(e)) &&
           stage_view_shot(s->view, s->stage, &e->camera, width, height, pixels);
}
