// SPDX-License-Identifier: MIT
// The editor that the command line asks for.

#include "begin.h"

#include <stdio.h>
#include <string.h>

#include "desk/mesh_file.h"
#include "tip.h"
#include "work.h"

enum { WRONG_INPUT = 3, NO_RESOURCE = 4 };

static void set_out(editor *e, const app_options *options)
{
    e->camera.azimuth = options->azimuth;
    e->camera.elevation = options->elevation;
    const app_event frame = {EVENT_DO, DO_FRAME, 0, 0, 0, 0, 0, 0};
    editor_take(e, &frame);
    e->overlays.overhangs = options->overhangs;
    e->overlays.is_cut = options->is_cut;
    e->overlays.cut_axis = 2;
    e->overlays.cut_mm = options->is_cut ? options->cut_mm : e->overlays.cut_mm;
}

static int ends_with(const char *text, const char *end)
{
    size_t a = strlen(text), b = strlen(end);
    return a >= b && strcmp(text + a - b, end) == 0;
}

static int open_shape(editor *e, const app_options *options, const char *path)
{
    sf_session *session = NULL;
    sf_sculpt *model = ends_with(path, ".session") ? app_open_session(path, &session, e->said)
                                                   : app_open_mesh(path, options, e->said);
    if (model == NULL) {
        return 0;
    }
    if (!editor_replace(e, model, session)) {
        sf_sculpt_destroy(model);
        sf_session_destroy(session);
        snprintf(e->said, sizeof e->said, "There is no memory for that model.");
        return 0;
    }
    return 1;
}

int app_open_in_place(editor *e, const app_options *options, const char *path)
{
    desk *d = editor_desk(e);
    if (e->drag != DRAG_NONE) {
        snprintf(e->said, sizeof e->said, "%.200s: let go of the mouse first.", path);
        return 0;
    }
    int good = d != NULL ? d->is->open(d, path, e->said) : open_shape(e, options, path);
    if (good) {
        e->said[0] = '\0';
        editor_frame_all(e);
    }
    return good;
}

int app_open_tip(editor *e, const char *path)
{
    if (e->drag != DRAG_NONE) {
        snprintf(e->said, sizeof e->said, "%.200s: let go of the mouse first.", path);
        return 0;
    }
    sf_mesh *mesh = mesh_file_read(path, e->said);
    if (mesh == NULL) {
        return 0;
    }
    if (!tip_take_mesh(e, mesh)) {
        sf_mesh_destroy(mesh);
        snprintf(e->said, sizeof e->said, "%.200s: the mesh has no size.", path);
        return 0;
    }
    e->said[0] = '\0';
    return 1;
}

// To the workspace, and what is opened there.
static int go_to_work(editor *e, const app_options *options, char why[APP_WHY_SIZE])
{
    work_go_to(e, (workspace)options->work);
    desk *d = editor_desk(e);
    if (options->work != WORK_SCULPT && d == NULL) {
        snprintf(why, APP_WHY_SIZE, "%s", e->said);
        return 0;
    }
    if (d == NULL || options->file == NULL || app_open_in_place(e, options, options->file)) {
        return 1;
    }
    snprintf(why, APP_WHY_SIZE, "%s", e->said);
    return 0;
}

editor *app_begin(const app_options *options, int *status)
{
    char why[APP_WHY_SIZE] = "There is no memory for the model.";
    sf_session *session;
    app_options shape = *options;
    shape.file = options->work == WORK_SCULPT ? options->file : NULL;
    *status = WRONG_INPUT;
    sf_sculpt *model = app_open(&shape, &session, why);
    editor *e = NULL;
    if (model != NULL) {
        *status = NO_RESOURCE;
        e = editor_create(model, session, options->width, options->height);
    }
    if (e != NULL) {
        *status = WRONG_INPUT;
        set_out(e, options);
        if (go_to_work(e, options, why)) {
            *status = 0;
            return e;
        }
    }
    editor_destroy(e);
    fprintf(stderr, "sculpt: %s\n", why);
    return NULL;
}
