// SPDX-License-Identifier: MIT
// Without a window: a picture, a hash, times.

#define _POSIX_C_SOURCE 200809L

#include "shot.h"

#include <epoxy/gl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "app/card.h"
#include "app/editor.h"
#include "app/save.h"
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

// Do what was recorded.
static int replay(editor *e, const char *path)
{
    FILE *file = fopen(path, "r");
    app_event event;
    int more = file != NULL ? 1 : -1, line = 0;
    while (more > 0) {
        more = app_event_read(file, &event);
        line++;
        if (more > 0) {
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

static int shoot(const app_options *o, view *v, const view_camera *camera,
                 const view_overlays *overlays)
{
    unsigned char *pixels = malloc((size_t)o->width * o->height * 3);
    int status = NO_RESOURCE;
    if (pixels == NULL || !view_shot(v, camera, overlays, o->width, o->height, pixels)) {
        complain(NO_RESOURCE, "There is no memory for a picture of that size.");
    } else {
        char why[APP_WHY_SIZE];
        status = app_save_picture(pixels, o->width, o->height, o->shot, why)
                     ? GOOD
                     : complain(NO_RESOURCE, why);
    }
    free(pixels);
    return status;
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

static int bench(const app_options *o, view *v, const view_camera *camera,
                 const view_overlays *overlays)
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
        good = view_draw(v, camera, overlays, framebuffer, o->width, o->height);
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

static int draw_buffers(const app_options *o, const editor *e, const gpu_view *buffers)
{
    const char *why = NULL;
    sf_sculpt_options made = sf_sculpt_options_of(e->model);
    view_overlays overlays = editor_overlays(e);
    view *v = view_create(&why);
    if (v == NULL) {
        return complain(NO_RESOURCE, why);
    }
    view_look_at(v, buffers, &made.lattice, made.bed_layer);
    int status = o->shot != NULL ? shoot(o, v, &e->camera, &overlays) : GOOD;
    status = status == GOOD && o->bench ? bench(o, v, &e->camera, &overlays) : status;
    view_destroy(v);
    return status;
}

static int draw(const app_options *o, const studio *s)
{
    const char *why = "There is no memory.";
    const sf_sculpt *model = s->editor->model;
    sf_lattice lattice = sf_sculpt_options_of(model).lattice;
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
    sf_session *session;
    if (o->shot != NULL || o->bench || o->gpu) {
        s->gl = gl_headless_create(&no_gl);
        if (s->gl == NULL) {
            return complain(NO_RESOURCE, no_gl);
        }
    }
    sf_sculpt *model = app_open(o, &session, why);
    if (model == NULL) {
        return complain(WRONG_INPUT, why);
    }
    s->editor = editor_create(model, session, o->width, o->height);
    if (s->editor == NULL) {
        return complain(NO_RESOURCE, "There is no memory for the model.");
    }
    app_set_out(s->editor, o);
    s->twin = o->gpu ? card_create(s->editor, why) : NULL;
    return o->gpu && s->twin == NULL ? complain(NO_RESOURCE, why) : GOOD;
}

static int work(const app_options *o, studio *s)
{
    char why[APP_WHY_SIZE] = "";
    if (o->input != NULL && !replay(s->editor, o->input)) {
        return WRONG_INPUT;
    }
    if (o->hash) {
        printf("%016" PRIx64 "\n",
               s->twin != NULL ? card_hash(s->twin) : app_hash(s->editor->model));
    }
    if (o->save != NULL && !app_save_session(editor_session(s->editor), o->save, why)) {
        return complain(NO_RESOURCE, why);
    }
    return o->shot != NULL || o->bench ? draw(o, s) : GOOD;
}

int app_run_headless(const app_options *options)
{
    studio s = {NULL, NULL, NULL};
    int status = set_up(options, &s);
    status = status == GOOD ? work(options, &s) : status;
    card_destroy(s.twin);
    editor_destroy(s.editor);
    gl_headless_destroy(s.gl);
    return status;
}

void app_set_out(editor *e, const app_options *options)
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
