// SPDX-License-Identifier: MIT
// Files of the window: what is opened in the place of what is there, and what is taken away.

#include <stdlib.h>
#include <string.h>

#include "app.h"
#include "begin.h"
#include "save.h"

static int make_buffers(app *a, gpu_view *buffers)
{
    const char *why = NULL;
    sf_lattice lattice = sf_sculpt_options_of(a->editor->model).lattice;
    if (a->options->gpu) {
        card *twin = card_create(a->editor, a->editor->said);
        if (twin != NULL) {
            card_destroy(a->twin);
            a->twin = twin;
            *buffers = card_view(twin);
        }
        return twin != NULL;
    }
    view_upload *upload = view_upload_create(&lattice, &why);
    if (upload == NULL) {
        snprintf(a->editor->said, sizeof a->editor->said, "%s", why);
        return 0;
    }
    view_upload_destroy(a->upload);
    a->upload = upload;
    *buffers = view_upload_view(upload);
    return 1;
}

// Buffers for another model's lattice.
int app_look_anew(app *a)
{
    gpu_view buffers;
    sf_sculpt_options o = sf_sculpt_options_of(a->editor->model);
    if (!make_buffers(a, &buffers)) {
        return 0;
    }
    view_look_at(a->view, &buffers, &o.lattice, o.bed_layer);
    return 1;
}

// 0 where a record could not name it: then it is not opened either.
static int record_path(app *a, app_event_kind kind, const char *path)
{
    const app_event event = {kind, 0, 0, 0, 0, 0, 0, 0};
    a->is_stale = 1;
    if (!app_event_can_name(path)) {
        snprintf(a->editor->said, sizeof a->editor->said,
                 "A file's name has 1 to %d bytes, on one line.", EVENT_PATH_SIZE - 1);
        return 0;
    }
    if (a->record != NULL) {
        app_event_write(a->record, &event, path);
    }
    return 1;
}

void app_open_brush(app *a, const char *path)
{
    if (record_path(a, EVENT_TIP, path)) {
        (void)app_open_tip(a->editor, path);
    }
}

void app_open_file(app *a, const char *path)
{
    editor *e = a->editor;
    if (record_path(a, EVENT_OPEN, path) && app_open_in_place(e, a->options, path) &&
        editor_desk(e) == NULL) {
        (void)app_look_anew(a);
    }
}

#ifdef SCULPT_HAVE_PANEL
static int shoot(app *a, unsigned char *pixels)
{
    const editor *e = a->editor;
    view_overlays overlays = editor_overlays(e);
    overlays.has_cursor = overlays.has_plane = 0;
    return editor_desk(e) != NULL
               ? show_shot(&a->show, e, e->width, e->height, pixels)
               : view_shot(a->view, &e->camera, &overlays, e->width, e->height, pixels);
}

static void save_picture(app *a, const char *path)
{
    editor *e = a->editor;
    unsigned char *pixels = malloc((size_t)e->width * e->height * 3 + 1);
    if (pixels == NULL || e->width == 0 || e->height == 0 || !shoot(a, pixels)) {
        snprintf(e->said, sizeof e->said, "There is no memory for the picture.");
    } else if (app_save_picture(pixels, e->width, e->height, path, e->said)) {
        snprintf(e->said, sizeof e->said, "Written to %.200s.", path);
    }
    free(pixels);
}

void app_grant(app *a, const panel_request *request)
{
    editor *e = a->editor;
    int good = 0;
    switch (request->wish) {
    case WISH_OPEN:
        app_open_file(a, request->path);
        return;
    case WISH_BRUSH:
        app_open_brush(a, request->path);
        return;
    case WISH_SESSION:
        good = app_save_session(editor_session(e), request->path, e->said);
        break;
    case WISH_SHAPE:
        good = editor_desk(e) != NULL ? app_save_work(e, request->path, e->said)
                                      : app_save_shape(e->model, request->path, e->said);
        break;
    case WISH_PICTURE:
        save_picture(a, request->path);
        return;
    default:
        return;
    }
    if (good) {
        snprintf(e->said, sizeof e->said, "Written to %.200s.", request->path);
    }
}
#endif
