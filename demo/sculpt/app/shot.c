// SPDX-License-Identifier: MIT
// Without a window: a picture, a hash, times.

#define _POSIX_C_SOURCE 200809L

#include "shot.h"

#include <epoxy/gl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "app/begin.h"
#include "app/card.h"
#include "app/editor.h"
#include "app/save.h"
#include "app/show.h"
#include "app/work.h"
#include "gl/headless.h"
#include "view/upload.h"
#include "view/view.h"

enum { GOOD = 0, WRONG_INPUT = 3, NO_RESOURCE = 4 };
enum { FRAMES = 21 };

static int complain(int status, const char *why)
{
    fprintf(stderr, "sculpt: %s\n", why);
    return status;
}

// What cannot be opened could not be when it was recorded either, as a rule: it is said, and what
// follows is done.
static void note(int good, const char *path, int line, const editor *e)
{
    if (!good) {
        fprintf(stderr, "sculpt: %s, line %d: %s\n", path, line, e->said);
    }
}

// Do what was recorded.
static int replay(const app_options *o, editor *e)
{
    char opened[EVENT_PATH_SIZE];
    const char *path = o->input;
    FILE *file = fopen(path, "r");
    app_event event;
    int more = file != NULL ? 1 : -1, line = 0;
    while (more > 0) {
        more = app_event_read(file, &event, opened);
        line++;
        if (more > 0 && event.kind == EVENT_OPEN) {
            note(app_open_in_place(e, o, opened), path, line, e);
        } else if (more > 0 && event.kind == EVENT_TIP) {
            note(app_open_tip(e, opened), path, line, e);
        } else if (more > 0) {
            editor_take(e, &event);
        }
    }
    if (file == NULL) {
        fprintf(stderr, "sculpt: %s cannot be read.\n", path);
    } else if (more < 0) {
        fprintf(stderr, "sculpt: %s, line %d: that is no event.\n", path, line);
    }
    if (file != NULL) {
        fclose(file);
    }
    return more == 0;
}

// ---------------------------------------------------------------------------------------------
// Pictures
// ---------------------------------------------------------------------------------------------

// Who draws: the view of a shape, or the show of a desk.
typedef struct drawer {
    view *view;
    show *show;
    const editor *editor;
    view_overlays overlays;
} drawer;

static int shoot(const app_options *o, const drawer *d)
{
    char why[APP_WHY_SIZE] = "There is no memory for a picture of that size.";
    unsigned char *pixels = malloc((size_t)o->width * o->height * 3);
    int good = pixels != NULL;
    if (good && d->show != NULL) {
        good = show_shot(d->show, d->editor, o->width, o->height, pixels);
    } else if (good) {
        good = view_shot(d->view, &d->editor->camera, &d->overlays, o->width, o->height, pixels);
    }
    good = good && app_save_picture(pixels, o->width, o->height, o->shot, why);
    free(pixels);
    return good ? GOOD : complain(NO_RESOURCE, why);
}

// ---------------------------------------------------------------------------------------------
// Times
// ---------------------------------------------------------------------------------------------

static double now_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec * 1e3 + (double)t.tv_nsec * 1e-6;
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int draw_frame(const app_options *o, const drawer *d, GLuint framebuffer)
{
    return d->show != NULL ? show_draw(d->show, d->editor, framebuffer, o->width, o->height)
                           : view_draw(d->view, &d->editor->camera, &d->overlays, framebuffer,
                                       o->width, o->height);
}

static int bench(const app_options *o, const drawer *d)
{
    GLuint framebuffer = 0, target = 0;
    double times[FRAMES];
    int good = 1;
    glCreateTextures(GL_TEXTURE_2D, 1, &target);
    glTextureStorage2D(target, 1, GL_RGBA8, (GLsizei)o->width, (GLsizei)o->height);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, target, 0);
    for (int i = 0; good && i < FRAMES; i++) {
        double start = now_ms();
        good = draw_frame(o, d, framebuffer);
        glFinish();
        times[i] = now_ms() - start;
    }
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &target);
    if (!good) {
        return complain(NO_RESOURCE, "There is no memory for a frame of that size.");
    }
    qsort(times, FRAMES, sizeof *times, compare);
    printf("a frame of %ux%u: %.2f ms (median of %d, %s)\n", o->width, o->height, times[FRAMES / 2],
           FRAMES, (const char *)glGetString(GL_RENDERER));
    return GOOD;
}

// ---------------------------------------------------------------------------------------------
// The whole
// ---------------------------------------------------------------------------------------------

// What there is without a window.
typedef struct studio {
    gl_headless *gl; // NULL where nothing is drawn
    editor *editor;
    card *twin; // NULL without --gpu
} studio;

static int draw_by(const app_options *o, const drawer *d)
{
    int status = o->shot != NULL ? shoot(o, d) : GOOD;
    return status == GOOD && o->bench ? bench(o, d) : status;
}

static int draw_buffers(const app_options *o, const editor *e, const gpu_view *buffers)
{
    const char *why = NULL;
    sf_sculpt_options made = sf_sculpt_options_of(e->model);
    view *v = view_create(&why);
    if (v == NULL) {
        return complain(NO_RESOURCE, why);
    }
    view_look_at(v, buffers, &made.lattice, made.bed_layer);
    const drawer d = {v, NULL, e, editor_overlays(e)};
    int status = draw_by(o, &d);
    view_destroy(v);
    return status;
}

static int draw_desk(const app_options *o, const editor *e)
{
    const char *why = NULL;
    show made = {NULL, NULL};
    const drawer d = {NULL, &made, e, editor_overlays(e)};
    int status = show_make(&made, &why) ? draw_by(o, &d) : complain(NO_RESOURCE, why);
    show_release(&made);
    return status;
}

static int draw(const app_options *o, const studio *s)
{
    const char *why = "There is no memory.";
    const sf_sculpt *model = s->editor->model;
    sf_lattice lattice = sf_sculpt_options_of(model).lattice;
    if (editor_desk(s->editor) != NULL) {
        return draw_desk(o, s->editor);
    }
    if (s->twin != NULL) {
        gpu_view buffers = card_view(s->twin);
        return draw_buffers(o, s->editor, &buffers);
    }
    view_upload *upload = view_upload_create(&lattice, &why);
    int status = NO_RESOURCE;
    if (upload == NULL ||
        !view_upload_copy(upload, sf_sculpt_drawn(model), sf_sculpt_printable(model),
                          sf_sculpt_materials(model), NULL)) {
        complain(NO_RESOURCE, why);
    } else {
        gpu_view buffers = view_upload_view(upload);
        status = draw_buffers(o, s->editor, &buffers);
    }
    view_upload_destroy(upload);
    return status;
}

static int set_up(const app_options *o, studio *s)
{
    char why[APP_WHY_SIZE] = "";
    const char *no_gl = NULL;
    int status = GOOD;
    if (o->shot != NULL || o->bench || o->gpu) {
        s->gl = gl_headless_create(&no_gl);
        if (s->gl == NULL) {
            return complain(NO_RESOURCE, no_gl);
        }
    }
    s->editor = app_begin(o, &status);
    if (s->editor == NULL) {
        return status;
    }
    s->twin = o->gpu ? card_create(s->editor, why) : NULL;
    return o->gpu && s->twin == NULL ? complain(NO_RESOURCE, why) : GOOD;
}

// A desk that begins with something under way, which a window would have done by now.
static void finish(editor *e)
{
    const app_event step = {EVENT_DO, DO_STEP, 0, 0, 0, 0, 0, 0};
    while (work_is_busy(e)) {
        editor_take(e, &step);
    }
}

static int do_all(const app_options *o, studio *s)
{
    char why[APP_WHY_SIZE] = "";
    if (o->input != NULL && !replay(o, s->editor)) {
        return WRONG_INPUT;
    }
    if (o->input == NULL) { // what is played has its own pieces of work in it
        finish(s->editor);
    }
    if (o->hash) {
        const desk *d = editor_desk(s->editor);
        printf("%016" PRIx64 "\n", d != NULL         ? d->is->hash(d)
                                   : s->twin != NULL ? card_hash(s->twin)
                                                     : app_hash(s->editor->model));
    }
    if (o->save != NULL && !app_save_work(s->editor, o->save, why)) {
        return complain(NO_RESOURCE, why);
    }
    return o->shot != NULL || o->bench ? draw(o, s) : GOOD;
}

int app_run_headless(const app_options *options)
{
    studio s = {NULL, NULL, NULL};
    int status = set_up(options, &s);
    status = status == GOOD ? do_all(options, &s) : status;
    card_destroy(s.twin);
    editor_destroy(s.editor);
    gl_headless_destroy(s.gl);
    return status;
}
