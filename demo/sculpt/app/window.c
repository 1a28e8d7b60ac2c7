// SPDX-License-Identifier: MIT
// The window: GLFW's events become the editor's, what changed goes to the card, the picture is
// drawn, with the panel over it.
//
// The window waits for events; it draws when there were any. Where the graphics card is lost the
// session is written beside the program, because it is all that cannot be had again.

#include "window.h"

#include <epoxy/gl.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app.h"
#include "begin.h"
#ifdef SCULPT_HAVE_SPACE
#include "fly.h"
#endif
#include "save.h"
#include "work.h"

enum { GOOD = 0, NO_RESOURCE = 4 };

#define RESCUE "sculpt-rescued.session"

static int complain(int status, const char *why)
{
    fprintf(stderr, "sculpt: %s\n", why);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Frames
// ---------------------------------------------------------------------------------------------

static void send_changes(app *a)
{
    editor *e = a->editor;
    const sf_box none = {0, 0, 0, 0, 0, 0};
    if (e->changed.x0 >= e->changed.x1) {
        return;
    }
    if (a->twin != NULL ||
        view_upload_copy(a->upload, sf_sculpt_drawn(e->model), sf_sculpt_printable(e->model),
                         sf_sculpt_materials(e->model), &e->changed)) {
        view_changed(a->view, &e->changed);
        e->changed = none;
    }
}

// The shape; roughly where a whole frame does not keep up and that will do.
static int draw_shape(app *a, int may_be_rough)
{
    editor *e = a->editor;
    view_overlays overlays = editor_overlays(e);
    double start = glfwGetTime();
    uint32_t part = may_be_rough ? rough_part(&a->rough) : 1;
    a->is_rough = part > 1;
    if (part > 1) {
        return rough_draw(&a->rough, a->view, &e->camera, &overlays, e->width, e->height, part);
    }
    int good = view_draw(a->view, &e->camera, &overlays, 0, e->width, e->height);
    glFinish();
    a->rough.whole_ms = (glfwGetTime() - start) * 1e3;
    return good;
}

static int draw_desk(app *a)
{
    const char *why = NULL;
    editor *e = a->editor;
    a->is_rough = 0;
    if (a->show.view == NULL && !show_make(&a->show, &why)) {
        show_release(&a->show);
        return 0;
    }
    return show_draw(&a->show, e, 0, e->width, e->height);
}

static void draw(app *a, int may_be_rough)
{
    editor *e = a->editor;
    double start = glfwGetTime();
    send_changes(a);
    if (!(editor_desk(e) != NULL ? draw_desk(a) : draw_shape(a, may_be_rough))) {
        snprintf(e->said, sizeof e->said, "There is no memory for a picture of that size.");
    }
#ifdef SCULPT_HAVE_PANEL
    panel_request request = {WISH_NOTHING, ""};
    panel_draw(a->panel, e, a->frame_ms, app_take, a, &request);
    app_grant(a, &request);
#endif
    glFinish();
    a->frame_ms = (glfwGetTime() - start) * 1e3;
}

static int is_lost(void)
{
    return epoxy_has_gl_extension("GL_KHR_robustness") && glGetGraphicsResetStatus() != GL_NO_ERROR;
}

static int rescue(const app *a)
{
    char why[APP_WHY_SIZE];
    complain(NO_RESOURCE, "The graphics card was lost.");
    if (app_save_session(editor_session(a->editor), RESCUE, why)) {
        fputs("sculpt: what was done is in " RESCUE "; open it with --session.\n", stderr);
    } else {
        complain(NO_RESOURCE, why);
    }
    return NO_RESOURCE;
}

// The next event of what is played, one a frame; 0 when there is none left.
static int play_on(app *a)
{
    char path[EVENT_PATH_SIZE];
    app_event event;
    int more = a->play != NULL ? app_event_read(a->play, &event, path) : 0;
    if (more < 0) {
        snprintf(a->editor->said, sizeof a->editor->said, "%.200s: a line is no event.",
                 a->options->input);
    }
    if (more > 0 && event.kind == EVENT_SIZE) {
        glfwSetWindowSize(a->window, event.x > 1 ? (int)event.x : 1,
                          event.y > 1 ? (int)event.y : 1);
    }
    if (more > 0 && event.kind == EVENT_OPEN) {
        app_open_file(a, path);
    } else if (more > 0 && event.kind == EVENT_TIP) {
        app_open_brush(a, path);
    } else if (more > 0) {
        app_take(a, &event);
    }
    return more > 0;
}

// The window as it is, panel and all.
static int shoot(app *a)
{
    char why[APP_WHY_SIZE];
    uint32_t w = a->editor->width, h = a->editor->height;
    size_t row = 3 * (size_t)w;
    unsigned char *pixels = malloc(2 * row * h + 1);
    if (pixels == NULL) {
        return complain(NO_RESOURCE, "There is no memory for the picture.");
    }
    draw(a, 0);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, (GLsizei)w, (GLsizei)h, GL_RGB, GL_UNSIGNED_BYTE, pixels + row * h);
    for (uint32_t y = 0; y < h; y++) {
        memcpy(pixels + row * y, pixels + row * (2 * (size_t)h - 1 - y), row);
    }
    int good = app_save_picture(pixels, w, h, a->options->shot, why);
    free(pixels);
    return good ? GOOD : complain(NO_RESOURCE, why);
}

// A piece of what the desk has under way. What is played has its own pieces in it.
static int step_on(app *a)
{
    const app_event step = {EVENT_DO, DO_STEP, 0, 0, 0, 0, 0, 0};
    const app_options *o = a->options;
    if (!work_is_busy(a->editor) || (o->shot != NULL && o->input != NULL)) {
        return 0;
    }
    app_take(a, &step);
    return 1;
}

// Hear the SpaceMice. They speak to all programs, so what they say is ours only while the window is
// the one that is worked in.
static void hear_space(app *a)
{
#ifdef SCULPT_HAVE_SPACE
    const editor *e = a->editor;
    app_event events[FLY_EVENTS_MOST];
    space_motion motion;
    if (space_poll(a->space, glfwGetTime(), &motion) &&
        glfwGetWindowAttrib(a->window, GLFW_FOCUSED)) {
        int count = app_fly(&motion, e->height > 0 ? (double)e->width / e->height : 1, events);
        for (int i = 0; i < count; i++) {
            app_take(a, &events[i]);
        }
    }
    const char *trouble = space_trouble(a->space);
    if (trouble != NULL && a->space_trouble == NULL) {
        snprintf(a->editor->said, sizeof a->editor->said, "%s", trouble);
        a->is_stale = 1;
    }
    a->space_trouble = trouble;
#else
    (void)a;
#endif
}

static void wait_for_events(const app *a)
{
#ifdef SCULPT_HAVE_SPACE
    glfwWaitEventsTimeout(space_patience(a->space));
#else
    (void)a;
    glfwWaitEvents();
#endif
}

// Wait until nothing has moved for some seconds, or something has.
static void wait_for_quiet(app *a, double seconds)
{
    double end = glfwGetTime() + seconds;
    for (double left = seconds; left > 0 && !a->is_stale; left = end - glfwGetTime()) {
#ifdef SCULPT_HAVE_SPACE
        double step = space_patience(a->space);
        left = left < step ? left : step;
#endif
        glfwWaitEventsTimeout(left);
        hear_space(a);
    }
}

static int stay(app *a)
{
    int frames_after = 2; // the panel answers what happened with another frame
    for (;;) {
        int plays = play_on(a);
        if (!plays && frames_after == 0 && a->options->shot != NULL) {
            return shoot(a);
        }
        int steps = !plays && step_on(a);
        if (plays || steps || a->is_stale || frames_after > 0) {
            frames_after = a->is_stale ? 2 : frames_after > 0 ? frames_after - 1 : 0;
            a->is_stale = 0;
            draw(a, 1);
            glfwSwapBuffers(a->window);
            glfwPollEvents();
        } else if (a->is_rough) { // a whole one once nothing moves any more
            wait_for_quiet(a, 0.15);
            if (!a->is_stale) {
                draw(a, 0);
                glfwSwapBuffers(a->window);
            }
        } else {
            wait_for_events(a);
        }
        if (!plays) {
            hear_space(a);
        }
        if (is_lost()) {
            return rescue(a);
        }
        if (glfwWindowShouldClose(a->window) || a->editor->wants_close) {
            app_event close = {EVENT_DO, DO_CLOSE, 0, 0, 0, 0, 0, 0};
            app_take(a, &close);
            return GOOD;
        }
    }
}

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

static GLFWwindow *open_window(const app_options *o)
{
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
    return glfwCreateWindow((int)o->width, (int)o->height, "libsf sculpt", NULL, NULL);
}

// All but the window; 0 where something cannot be had.
static int prepare(app *a)
{
    const char *why = NULL;
    int width, height;
    a->view = view_create(&why);
    if (a->view == NULL) {
        complain(NO_RESOURCE, why);
        return 0;
    }
    if (!app_look_anew(a)) {
        complain(NO_RESOURCE, a->editor->said);
        return 0;
    }
    app_listen(a);
#ifdef SCULPT_HAVE_SPACE
    a->space = space_create();
    if (a->space == NULL) {
        complain(NO_RESOURCE, "There is no memory for SpaceMice.");
        return 0;
    }
#endif
#ifdef SCULPT_HAVE_PANEL
    a->panel = panel_create(a->window, 1.0f);
    if (a->panel == NULL) {
        complain(NO_RESOURCE, "The panel cannot be made.");
        return 0;
    }
#endif
    glfwGetFramebufferSize(a->window, &width, &height);
    app_event size = {EVENT_SIZE, 0, 0, width, height, 0, 0, 0};
    app_take(a, &size);
    return 1;
}

static void release(app *a)
{
    rough_release(&a->rough);
#ifdef SCULPT_HAVE_PANEL
    panel_destroy(a->panel);
#endif
#ifdef SCULPT_HAVE_SPACE
    space_destroy(a->space);
#endif
    show_release(&a->show);
    view_destroy(a->view);
    view_upload_destroy(a->upload);
    card_destroy(a->twin);
}

// The window with an editor in it.
static int run(app *a)
{
    char why[APP_WHY_SIZE];
    if (!glfwInit()) {
        return complain(NO_RESOURCE, "There is no display; --headless works without one.");
    }
    a->window = open_window(a->options);
    if (a->window == NULL) {
        glfwTerminate();
        return complain(NO_RESOURCE, "There is no OpenGL 4.5 for a window here; --headless draws "
                                     "pictures without one.");
    }
    glfwMakeContextCurrent(a->window);
    glfwSwapInterval(1);
    int status = prepare(a) ? stay(a) : NO_RESOURCE;
    if (status == GOOD && a->options->save != NULL &&
        !app_save_work(a->editor, a->options->save, why)) {
        status = complain(NO_RESOURCE, why);
    }
    release(a);
    glfwDestroyWindow(a->window);
    glfwTerminate();
    return status;
}

static int open_files(app *a)
{
    const app_options *o = a->options;
    a->play = o->input != NULL ? fopen(o->input, "r") : NULL;
    a->record = o->record != NULL ? fopen(o->record, "w") : NULL;
    if (o->input != NULL && a->play == NULL) {
        complain(NO_RESOURCE, "What is to be played cannot be read.");
        return 0;
    }
    if (o->record != NULL && a->record == NULL) {
        complain(NO_RESOURCE, "The record cannot be written.");
        return 0;
    }
    return 1;
}

int app_run_window(const app_options *options)
{
    app a;
    memset(&a, 0, sizeof a);
    a.options = options;
    int status = NO_RESOURCE;
    a.editor = app_begin(options, &status);
    if (a.editor == NULL) {
        return status;
    }
    status = open_files(&a) ? run(&a) : NO_RESOURCE;
    if (a.play != NULL) {
        fclose(a.play);
    }
    if (a.record != NULL && fclose(a.record) != 0) {
        status = complain(NO_RESOURCE, "The record could not be written to its end.");
    }
    editor_destroy(a.editor);
    return status;
}
