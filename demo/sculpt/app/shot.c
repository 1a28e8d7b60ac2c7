// SPDX-License-Identifier: MIT
// Without a window: a picture, a hash, times.

#define _POSIX_C_SOURCE 200809L

#include "shot.h"

#include <epoxy/gl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

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

static int draw(const app_options *o, const editor *e)
{
    const char *why = NULL;
    sf_sculpt_options made = sf_sculpt_options_of(e->model);
    view_overlays overlays = editor_overlays(e);
    view_upload *upload = view_upload_create(&made.lattice, &why);
    view *v = upload != NULL ? view_create(&why) : NULL;
    int status = NO_RESOURCE;
    if (v == NULL ||
        !view_upload_copy(upload, sf_sculpt_drawn(e->model), sf_sculpt_printable(e->model),
                          sf_sculpt_materials(e->model), NULL)) {
        complain(NO_RESOURCE, why != NULL ? why : "There is no memory.");
    } else {
        gpu_view buffers = view_upload_view(upload);
        view_look_at(v, &buffers, &made.lattice, made.bed_layer);
        status = o->shot != NULL ? shoot(o, v, &e->camera, &overlays) : GOOD;
        status = status == GOOD && o->bench ? bench(o, v, &e->camera, &overlays) : status;
    }
    view_destroy(v);
    view_upload_destroy(upload);
    return status;
}

// The editor as the command line asks for it.
static editor *make_editor(const app_options *o, int *status)
{
    char why[APP_WHY_SIZE] = "";
    sf_session *session;
    sf_sculpt *model = app_open(o, &session, why);
    if (model == NULL) {
        *status = complain(WRONG_INPUT, why);
        return NULL;
    }
    editor *e = editor_create(model, session, o->width, o->height);
    if (e == NULL) {
        *status = complain(NO_RESOURCE, "There is no memory for the model.");
        return NULL;
    }
    app_set_out(e, o);
    if (o->input != NULL && !replay(e, o->input)) {
        *status = WRONG_INPUT;
        editor_destroy(e);
        return NULL;
    }
    return e;
}

static int run(const app_options *o, editor *e)
{
    char why[APP_WHY_SIZE] = "";
    const char *no_gl = NULL;
    int status = GOOD;
    if (o->hash) {
        printf("%016" PRIx64 "\n", app_hash(e->model));
    }
    if (o->save != NULL && !app_save_session(editor_session(e), o->save, why)) {
        return complain(NO_RESOURCE, why);
    }
    if (o->shot != NULL || o->bench) {
        gl_headless *gl = gl_headless_create(&no_gl);
        status = gl != NULL ? draw(o, e) : complain(NO_RESOURCE, no_gl);
        gl_headless_destroy(gl);
    }
    return status;
}

int app_run_headless(const app_options *options)
{
    int status = GOOD;
    editor *e = make_editor(options, &status);
    if (e != NULL) {
        status = run(options, e);
        editor_destroy(e);
    }
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
