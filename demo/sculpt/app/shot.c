// SPDX-License-Identifier: MIT
// Without a window: a picture, a hash, times.

#define _POSIX_C_SOURCE 200809L

#include "shot.h"

#include <epoxy/gl.h>
#include <inttypes.h>
#include <sf/io.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "app/open.h"
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

static sf_sculpt *open_model(const app_options *o, char why[APP_WHY_SIZE])
{
    if (o->scene != NULL) {
        return app_open_scene(o->scene, o->resolution, why);
    }
    return o->file != NULL ? app_open_mesh(o->file, o->resolution, why)
                           : app_open_empty(o->resolution, why);
}

// The camera around what there is; around the bed where there is nothing.
static view_camera frame(const app_options *o, const sf_sculpt *model)
{
    sf_lattice l = sf_sculpt_options_of(model).lattice;
    sf_box b = sf_grid_bounds(sf_sculpt_drawn(model)), all = {0, 0, 0, l.nx, l.ny, l.nz / 2};
    b = b.x1 > 0 ? b : all;
    const double pitch[3] = {l.pitch_x_mm, l.pitch_y_mm, l.layer_mm};
    const uint32_t from[3] = {b.x0, b.y0, b.z0}, to[3] = {b.x1, b.y1, b.z1};
    double low[3], high[3];
    for (int i = 0; i < 3; i++) {
        low[i] = l.origin_mm[i] + from[i] * pitch[i];
        high[i] = l.origin_mm[i] + to[i] * pitch[i];
    }
    return view_camera_fit(low, high, o->azimuth, o->elevation, (double)o->width / o->height);
}

// ---------------------------------------------------------------------------------------------
// Pictures
// ---------------------------------------------------------------------------------------------

static int save(const char *path, const unsigned char *pixels, uint32_t width, uint32_t height)
{
    sf_save *file = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_save_begin(path, NULL, &file, &fault);
    if (status == SF_OK) {
        status = sf_png_write_rgb(pixels, width, height, sf_save_sink(file));
        if (status == SF_OK) {
            status = sf_save_commit(file, &fault);
        } else {
            sf_save_abort(file);
        }
    }
    return status == SF_OK
               ? GOOD
               : complain(NO_RESOURCE,
                          fault.message[0] != '\0' ? fault.message : sf_status_message(status));
}

static int shoot(const app_options *o, view *v, const view_camera *camera,
                 const view_overlays *overlays)
{
    unsigned char *pixels = malloc((size_t)o->width * o->height * 3);
    int status = NO_RESOURCE;
    if (pixels == NULL || !view_shot(v, camera, overlays, o->width, o->height, pixels)) {
        complain(NO_RESOURCE, "There is no memory for a picture of that size.");
    } else {
        status = save(o->shot, pixels, o->width, o->height);
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

static int draw(const app_options *o, const sf_sculpt *model)
{
    const char *why = NULL;
    sf_sculpt_options made = sf_sculpt_options_of(model);
    view_overlays overlays = view_overlays_default();
    view_camera camera = frame(o, model);
    view_upload *upload = view_upload_create(&made.lattice, &why);
    view *v = upload != NULL ? view_create(&why) : NULL;
    int status = NO_RESOURCE;
    overlays.overhangs = o->overhangs;
    overlays.is_cut = o->is_cut;
    overlays.cut_axis = 2;
    overlays.cut_mm = o->cut_mm;
    if (v == NULL || !view_upload_copy(upload, sf_sculpt_drawn(model), sf_sculpt_printable(model),
                                       sf_sculpt_materials(model), NULL)) {
        complain(NO_RESOURCE, why != NULL ? why : "There is no memory.");
    } else {
        gpu_view buffers = view_upload_view(upload);
        view_look_at(v, &buffers, &made.lattice, made.bed_layer);
        status = o->shot != NULL ? shoot(o, v, &camera, &overlays) : GOOD;
        status = status == GOOD && o->bench ? bench(o, v, &camera, &overlays) : status;
    }
    view_destroy(v);
    view_upload_destroy(upload);
    return status;
}

int app_run_headless(const app_options *options)
{
    char why[APP_WHY_SIZE] = "";
    const char *no_gl = NULL;
    int status = GOOD;
    sf_sculpt *model = open_model(options, why);
    if (model == NULL) {
        return complain(WRONG_INPUT, why);
    }
    if (options->hash) {
        printf("%016" PRIx64 "\n", app_hash(model));
    }
    if (options->shot != NULL || options->bench) {
        gl_headless *gl = gl_headless_create(&no_gl);
        status = gl != NULL ? draw(options, model) : complain(NO_RESOURCE, no_gl);
        gl_headless_destroy(gl);
    }
    sf_sculpt_destroy(model);
    return status;
}
