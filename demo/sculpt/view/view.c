// SPDX-License-Identifier: MIT
// The view of a model.
//
// Two passes over the picture: what rays meet, into textures (march.frag), and light on it
// (shade.frag). Rays are in voxels, so the camera's frame is brought there; its directions keep
// their lengths in the picture, and a distance along a ray is the same number in voxels and in mm.
//
// Pictures for files are drawn twice as wide and high and averaged, so that edges are smooth.

#include "view.h"

#include <epoxy/gl.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "gl/program.h"

#define BRICK 8u

const unsigned char view_palette[VIEW_PALETTE_COUNT][3] = {
    {214, 201, 178}, {86, 122, 162},  {196, 106, 66}, {112, 146, 98},
    {222, 178, 82},  {142, 106, 142}, {72, 76, 84},   {232, 228, 220}};

// Textures that rays leave things in.
typedef struct picture {
    uint32_t width, height;
    GLuint framebuffer, distances, kinds;
} picture;

struct view {
    GLuint march, shade, bricks_program, vertices, bricks;
    picture picture;
    gpu_view model;
    sf_lattice lattice;
    uint32_t bed;
    uint32_t brick_counts[3];
    char why[1024];
};

view_overlays view_overlays_default(void)
{
    view_overlays o = {.ghosts = 1, .ground = 1, .shadows = 1};
    return o;
}

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

static char said[1100];

view *view_create(const char **why)
{
    view *v = calloc(1, sizeof *v);
    *why = "There is no memory for a view.";
    if (v == NULL) {
        return NULL;
    }
    glCreateVertexArrays(1, &v->vertices);
    v->march = gl_draw_program("screen.vert", "march.frag", v->why, sizeof v->why);
    if (v->march != 0) {
        v->shade = gl_draw_program("screen.vert", "shade.frag", v->why, sizeof v->why);
    }
    if (v->shade != 0) {
        v->bricks_program = gl_compute_program("bricks.comp", v->why, sizeof v->why);
    }
    if (v->bricks_program == 0) {
        snprintf(said, sizeof said, "A shader of the view is refused: %s", v->why);
        *why = said;
        view_destroy(v);
        return NULL;
    }
    *why = NULL;
    return v;
}

static void drop_picture(picture *p)
{
    glDeleteFramebuffers(1, &p->framebuffer);
    glDeleteTextures(1, &p->distances);
    glDeleteTextures(1, &p->kinds);
    picture none = {0, 0, 0, 0, 0};
    *p = none;
}

void view_destroy(view *v)
{
    if (v != NULL) {
        drop_picture(&v->picture);
        glDeleteProgram(v->march);
        glDeleteProgram(v->shade);
        glDeleteProgram(v->bricks_program);
        glDeleteVertexArrays(1, &v->vertices);
        glDeleteBuffers(1, &v->bricks);
        free(v);
    }
}

// Textures of a size; 0 where there is no memory, and then there are none.
static int size_picture(picture *p, uint32_t width, uint32_t height)
{
    static const GLenum places[2] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    if (p->width == width && p->height == height) {
        return 1;
    }
    drop_picture(p);
    while (glGetError() != GL_NO_ERROR) {
    }
    glCreateTextures(GL_TEXTURE_2D, 1, &p->distances);
    glTextureStorage2D(p->distances, 1, GL_RG32F, (GLsizei)width, (GLsizei)height);
    glCreateTextures(GL_TEXTURE_2D, 1, &p->kinds);
    glTextureStorage2D(p->kinds, 1, GL_RGBA8UI, (GLsizei)width, (GLsizei)height);
    const GLuint textures[2] = {p->distances, p->kinds};
    for (int i = 0; i < 2; i++) { // numbers have no filter, and without this no value
        glTextureParameteri(textures[i], GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(textures[i], GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }
    glCreateFramebuffers(1, &p->framebuffer);
    glNamedFramebufferTexture(p->framebuffer, places[0], p->distances, 0);
    glNamedFramebufferTexture(p->framebuffer, places[1], p->kinds, 0);
    glNamedFramebufferDrawBuffers(p->framebuffer, 2, places);
    if (glGetError() != GL_NO_ERROR ||
        glCheckNamedFramebufferStatus(p->framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        drop_picture(p);
        return 0;
    }
    p->width = width;
    p->height = height;
    return 1;
}

// ---------------------------------------------------------------------------------------------
// The model
// ---------------------------------------------------------------------------------------------

void view_look_at(view *v, const gpu_view *buffers, const sf_lattice *lattice, uint32_t bed_layer)
{
    v->model = *buffers;
    v->lattice = *lattice;
    v->bed = bed_layer;
    const uint32_t counts[3] = {buffers->nx, buffers->ny, buffers->nz};
    size_t bricks = 1;
    for (int i = 0; i < 3; i++) {
        v->brick_counts[i] = (counts[i] + BRICK - 1) / BRICK;
        bricks *= v->brick_counts[i];
    }
    glDeleteBuffers(1, &v->bricks);
    glCreateBuffers(1, &v->bricks);
    glNamedBufferStorage(v->bricks, (GLsizeiptr)(bricks * 4), NULL, 0);
    view_changed(v, NULL);
}

static void bind_model(const view *v)
{
    const GLuint buffers[4] = {v->model.drawn, v->model.printable, v->model.materials, v->bricks};
    glBindBuffersBase(GL_SHADER_STORAGE_BUFFER, 0, 4, buffers);
}

static void set_counts(const view *v, GLuint program)
{
    glProgramUniform4ui(program, 0, v->model.nx, v->model.ny, v->model.nz, v->model.row_words);
    glProgramUniform4ui(program, 1, v->brick_counts[0], v->brick_counts[1], v->brick_counts[2], 0);
}

void view_changed(view *v, const sf_box *box)
{
    uint32_t first[3] = {0, 0, 0}, past[3], groups[3];
    const uint32_t *counts = v->brick_counts;
    for (int i = 0; i < 3; i++) {
        past[i] = counts[i];
    }
    if (box != NULL) {
        const uint32_t low[3] = {box->x0, box->y0, box->z0}, high[3] = {box->x1, box->y1, box->z1};
        for (int i = 0; i < 3; i++) {
            if (low[i] >= high[i]) {
                return;
            }
            first[i] = low[i] / BRICK;
            past[i] = (high[i] + BRICK - 1) / BRICK;
        }
    }
    for (int i = 0; i < 3; i++) {
        groups[i] = (past[i] - first[i] + 3) / 4;
    }
    bind_model(v);
    set_counts(v, v->bricks_program);
    glProgramUniform3ui(v->bricks_program, 2, first[0], first[1], first[2]);
    glProgramUniform3ui(v->bricks_program, 3, past[0], past[1], past[2]);
    glUseProgram(v->bricks_program);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    glDispatchCompute(groups[0], groups[1], groups[2]);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

// ---------------------------------------------------------------------------------------------
// Drawing
// ---------------------------------------------------------------------------------------------

static void pitch_of(const view *v, double pitch[3])
{
    pitch[0] = v->lattice.pitch_x_mm;
    pitch[1] = v->lattice.pitch_y_mm;
    pitch[2] = v->lattice.layer_mm;
}

static void set_vector(GLuint program, GLint at, const double x[3])
{
    glProgramUniform3f(program, at, (GLfloat)x[0], (GLfloat)x[1], (GLfloat)x[2]);
}

// A place in voxels; a length without the origin.
static void to_voxels(const view *v, const double from[3], int is_place, double to[3])
{
    double pitch[3];
    pitch_of(v, pitch);
    for (int i = 0; i < 3; i++) {
        to[i] = (from[i] - (is_place ? v->lattice.origin_mm[i] : 0)) / pitch[i];
    }
}

static void set_frame(const view *v, GLuint program, const view_frame *f)
{
    const double *const parts[4] = {f->eye, f->forward, f->right, f->up};
    for (int i = 0; i < 4; i++) {
        double in_voxels[3];
        to_voxels(v, parts[i], i == 0, in_voxels);
        set_vector(program, 4 + i, in_voxels);
    }
}

// The voxels that are there: all, or those on the far side of a cut.
static void set_cut(const view *v, GLuint program, const view_overlays *o)
{
    int32_t low[3] = {0, 0, 0};
    int32_t high[3] = {(int32_t)v->model.nx, (int32_t)v->model.ny, (int32_t)v->model.nz};
    if (o->is_cut) {
        double pitch[3];
        pitch_of(v, pitch);
        int a = o->cut_axis;
        double at = floor((o->cut_mm - v->lattice.origin_mm[a]) / pitch[a] + 0.5);
        high[a] = at < 1 ? 1 : at < high[a] ? (int32_t)at : high[a];
    }
    glProgramUniform3i(program, 2, low[0], low[1], low[2]);
    glProgramUniform3i(program, 3, high[0], high[1], high[2]);
}

static void set_shading(const view *v, const view_overlays *o)
{
    GLuint p = v->shade;
    double pitch[3], at[3], reach[3];
    GLfloat colours[3 * VIEW_PALETTE_COUNT];
    pitch_of(v, pitch);
    to_voxels(v, o->cursor, 1, at);
    to_voxels(v, o->reach, 0, reach);
    set_vector(p, 8, pitch);
    glProgramUniform1i(p, 9, (GLint)v->bed);
    glProgramUniform4i(p, 10, o->ghosts, o->overhangs, o->ground, o->shadows);
    glProgramUniform4i(p, 11, o->has_cursor, o->is_box, o->has_plane, o->plane_axis);
    set_vector(p, 12, at);
    set_vector(p, 13, reach);
    for (int i = 0; i < 3 * VIEW_PALETTE_COUNT; i++) {
        colours[i] = (GLfloat)(view_palette[i / 3][i % 3] / 255.0);
    }
    glProgramUniform3fv(p, 15, VIEW_PALETTE_COUNT, colours);
}

int view_draw(view *v, const view_camera *camera, const view_overlays *overlays,
              unsigned framebuffer, uint32_t width, uint32_t height)
{
    if (width == 0 || height == 0) {
        return 1;
    }
    if (!size_picture(&v->picture, width, height)) {
        return 0;
    }
    view_frame frame = view_camera_frame(camera, (double)width / height);
    const GLuint programs[2] = {v->march, v->shade};
    const GLuint targets[2] = {v->picture.framebuffer, framebuffer};
    bind_model(v);
    glProgramUniform1i(v->march, 8, overlays->ghosts);
    glProgramUniform1i(v->march, 9, (GLint)v->bed);
    set_shading(v, overlays);
    glBindTextureUnit(0, v->picture.distances);
    glBindTextureUnit(1, v->picture.kinds);
    glBindVertexArray(v->vertices);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glViewport(0, 0, (GLsizei)width, (GLsizei)height);
    for (int i = 0; i < 2; i++) {
        set_counts(v, programs[i]);
        set_cut(v, programs[i], overlays);
        set_frame(v, programs[i], &frame);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, targets[i]);
        glUseProgram(programs[i]);
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Shots
// ---------------------------------------------------------------------------------------------

// Four pixels to one, and the rows turned over.
static void average(const unsigned char *from, size_t width, size_t height, unsigned char *to)
{
    for (size_t y = 0; y < height; y++) {
        const unsigned char *a = from + (height - 1 - y) * 12 * width, *b = a + 6 * width;
        for (size_t i = 0; i < 3 * width; i++) {
            size_t at = i / 3 * 6 + i % 3;
            unsigned sum = (unsigned)a[at] + a[at + 3] + b[at] + b[at + 3];
            to[3 * width * y + i] = (unsigned char)((sum + 2) / 4);
        }
    }
}

int view_shot(view *v, const view_camera *camera, const view_overlays *overlays, uint32_t width,
              uint32_t height, unsigned char *pixels)
{
    GLuint framebuffer = 0, target = 0;
    unsigned char *large = malloc((size_t)width * height * 12);
    int good = large != NULL;
    if (good) {
        glCreateTextures(GL_TEXTURE_2D, 1, &target);
        glTextureStorage2D(target, 1, GL_RGBA8, (GLsizei)(2 * width), (GLsizei)(2 * height));
        glCreateFramebuffers(1, &framebuffer);
        glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, target, 0);
        good = view_draw(v, camera, overlays, framebuffer, 2 * width, 2 * height);
    }
    if (good) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, (GLsizei)(2 * width), (GLsizei)(2 * height), GL_RGB, GL_UNSIGNED_BYTE,
                     large);
        average(large, width, height, pixels);
    }
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &target);
    free(large);
    return good;
}
