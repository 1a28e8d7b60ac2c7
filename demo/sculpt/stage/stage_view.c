// SPDX-License-Identifier: MIT
// The drawing of a stage.
//
// What is on it lies in buffers, one for each kind, which are made anew where the stage has
// changed. Shaders read vertices there by number. What is solid comes first, then lines, then
// glass: its far sides before its near ones, both without leaving a depth, so that what is within
// is seen through it; then what lies over all. A pixel has four samples, so edges are smooth.

#include "stage_view.h"

#include <epoxy/gl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gl/program.h"

#define SAMPLES 4
#define NEAREST 0.004 // of the camera's distance
#define FARTHEST 60.0

enum { FACES, LINES, POINTS, BACK, PICTURE, PROGRAM_COUNT };
enum { LIT, BARE, GLASS };

typedef struct target {
    uint32_t width, height;
    GLuint framebuffer, colours, depths;
} target;

struct stage_view {
    GLuint programs[PROGRAM_COUNT];
    GLuint vertices; // an empty array of them
    GLuint buffers[STAGE_KIND_COUNT], normals, points, picture;
    const stage *drawn; // what the buffers hold
    uint64_t version;
    target target;
    char why[1100];
};

// ---------------------------------------------------------------------------------------------
// Life
// ---------------------------------------------------------------------------------------------

static const char *const sources[PROGRAM_COUNT][2] = {
    [FACES] = {"stage_face.vert", "stage_face.frag"},
    [LINES] = {"stage_line.vert", "stage_line.frag"},
    [POINTS] = {"stage_point.vert", "stage_point.frag"},
    [BACK] = {"screen.vert", "stage_back.frag"},
    [PICTURE] = {"screen.vert", "stage_picture.frag"}};

stage_view *stage_view_create(const char **why)
{
    static char said[1200];
    stage_view *v = calloc(1, sizeof *v);
    *why = "There is no memory for a view.";
    if (v == NULL) {
        return NULL;
    }
    for (int i = 0; i < PROGRAM_COUNT; i++) {
        v->programs[i] = gl_draw_program(sources[i][0], sources[i][1], v->why, sizeof v->why);
        if (v->programs[i] == 0) {
            snprintf(said, sizeof said, "A shader of the stage is refused: %s", v->why);
            *why = said;
            stage_view_destroy(v);
            return NULL;
        }
    }
    glCreateVertexArrays(1, &v->vertices);
    *why = NULL;
    return v;
}

static void drop_target(target *t)
{
    static const target none;
    glDeleteFramebuffers(1, &t->framebuffer);
    glDeleteTextures(1, &t->colours);
    glDeleteTextures(1, &t->depths);
    *t = none;
}

static void drop_buffers(stage_view *v)
{
    glDeleteBuffers(STAGE_KIND_COUNT, v->buffers);
    glDeleteBuffers(1, &v->normals);
    glDeleteBuffers(1, &v->points);
    glDeleteTextures(1, &v->picture);
    memset(v->buffers, 0, sizeof v->buffers);
    v->normals = v->points = v->picture = 0;
    v->drawn = NULL;
}

void stage_view_destroy(stage_view *v)
{
    if (v != NULL) {
        drop_target(&v->target);
        drop_buffers(v);
        for (int i = 0; i < PROGRAM_COUNT; i++) {
            glDeleteProgram(v->programs[i]);
        }
        glDeleteVertexArrays(1, &v->vertices);
        free(v);
    }
}

// Textures of a size; 0 where there is no memory, and then there are none.
static int size_target(target *t, uint32_t width, uint32_t height)
{
    if (t->width == width && t->height == height) {
        return 1;
    }
    drop_target(t);
    while (glGetError() != GL_NO_ERROR) {
    }
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &t->colours);
    glTextureStorage2DMultisample(t->colours, SAMPLES, GL_RGBA8, (GLsizei)width, (GLsizei)height,
                                  GL_TRUE);
    glCreateTextures(GL_TEXTURE_2D_MULTISAMPLE, 1, &t->depths);
    glTextureStorage2DMultisample(t->depths, SAMPLES, GL_DEPTH_COMPONENT32F, (GLsizei)width,
                                  (GLsizei)height, GL_TRUE);
    glCreateFramebuffers(1, &t->framebuffer);
    glNamedFramebufferTexture(t->framebuffer, GL_COLOR_ATTACHMENT0, t->colours, 0);
    glNamedFramebufferTexture(t->framebuffer, GL_DEPTH_ATTACHMENT, t->depths, 0);
    if (glGetError() != GL_NO_ERROR ||
        glCheckNamedFramebufferStatus(t->framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        drop_target(t);
        return 0;
    }
    t->width = width;
    t->height = height;
    return 1;
}

// ---------------------------------------------------------------------------------------------
// What is on the stage
// ---------------------------------------------------------------------------------------------

static GLuint make_buffer(const void *bytes, size_t size)
{
    GLuint buffer = 0;
    if (size > 0) {
        glCreateBuffers(1, &buffer);
        glNamedBufferStorage(buffer, (GLsizeiptr)size, bytes, 0);
    }
    return buffer;
}

static GLuint make_picture(const stage_picture *p)
{
    GLuint texture = 0;
    if (p->width > 0) {
        glCreateTextures(GL_TEXTURE_2D, 1, &texture);
        glTextureStorage2D(texture, 1, GL_RGB8, (GLsizei)p->width, (GLsizei)p->height);
        glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTextureSubImage2D(texture, 0, 0, 0, (GLsizei)p->width, (GLsizei)p->height, GL_RGB,
                            GL_UNSIGNED_BYTE, p->rgb);
    }
    return texture;
}

static int send(stage_view *v, const stage *s)
{
    size_t count;
    if (v->drawn == s && v->version == stage_version(s)) {
        return 1;
    }
    drop_buffers(v);
    while (glGetError() != GL_NO_ERROR) {
    }
    for (int k = 0; k < STAGE_KIND_COUNT; k++) {
        const stage_vertex *vertices = stage_vertices(s, (stage_kind)k, &count);
        v->buffers[k] = make_buffer(vertices, count * sizeof *vertices);
        if (k == STAGE_SMOOTH) {
            v->normals = make_buffer(stage_normals(s), 3 * count * sizeof(float));
        }
    }
    const stage_point *points = stage_points(s, &count);
    v->points = make_buffer(points, count * sizeof *points);
    stage_picture picture = stage_get_picture(s);
    v->picture = make_picture(&picture);
    if (glGetError() != GL_NO_ERROR) {
        drop_buffers(v);
        return 0;
    }
    v->drawn = s;
    v->version = stage_version(s);
    return 1;
}

// ---------------------------------------------------------------------------------------------
// Drawing
// ---------------------------------------------------------------------------------------------

static void set_vector(GLuint program, GLint at, const double x[3])
{
    glProgramUniform3f(program, at, (GLfloat)x[0], (GLfloat)x[1], (GLfloat)x[2]);
}

static void set_frame(const stage_view *v, const view_camera *camera, uint32_t width,
                      uint32_t height)
{
    view_frame f = view_camera_frame(camera, (double)width / height);
    for (int i = FACES; i <= POINTS; i++) {
        GLuint p = v->programs[i];
        set_vector(p, 0, f.eye);
        set_vector(p, 1, f.forward);
        set_vector(p, 2, f.right);
        set_vector(p, 3, f.up);
        glProgramUniform2f(p, 4, (GLfloat)(NEAREST * camera->distance),
                           (GLfloat)(FARTHEST * camera->distance));
        glProgramUniform2f(p, 5, (GLfloat)width, (GLfloat)height);
    }
}

static void draw_faces(const stage_view *v, const stage *s, stage_kind kind, int look)
{
    size_t count;
    (void)stage_vertices(s, kind, &count);
    GLuint p = v->programs[FACES];
    if (count > 0) {
        glUseProgram(p);
        glProgramUniform1i(p, 6, kind == STAGE_SMOOTH);
        glProgramUniform1i(p, 7, look);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, v->buffers[kind]);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1,
                         kind == STAGE_SMOOTH ? v->normals : v->buffers[kind]);
        glDrawArrays(GL_TRIANGLES, 0, (GLsizei)count);
    }
}

static void draw_lines(const stage_view *v, const stage *s, stage_kind kind, float width)
{
    size_t count;
    (void)stage_vertices(s, kind, &count);
    if (count > 0) {
        glUseProgram(v->programs[LINES]);
        glProgramUniform1f(v->programs[LINES], 6, width);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, v->buffers[kind]);
        glDrawArrays(GL_TRIANGLES, 0, (GLsizei)(3 * count));
    }
}

static void draw_points(const stage_view *v, const stage *s, float magnified)
{
    size_t count;
    (void)stage_points(s, &count);
    if (count > 0) {
        glUseProgram(v->programs[POINTS]);
        glProgramUniform1f(v->programs[POINTS], 6, magnified);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, v->points);
        glDrawArrays(GL_TRIANGLES, 0, (GLsizei)(6 * count));
    }
}

// Far sides, then near ones.
static void draw_glass(const stage_view *v, const stage *s)
{
    static const GLenum sides[2] = {GL_FRONT, GL_BACK};
    glEnable(GL_CULL_FACE);
    for (int i = 0; i < 2; i++) {
        glCullFace(sides[i]);
        draw_faces(v, s, STAGE_GLASS, GLASS);
    }
    glDisable(GL_CULL_FACE);
}

// In the upper right corner, as large as a third of the picture's width allows.
static void draw_picture(const stage_view *v, const stage *s, uint32_t width, uint32_t height)
{
    stage_picture picture = stage_get_picture(s);
    GLuint p = v->programs[PICTURE];
    const GLint margin = 15;
    if (picture.width == 0) {
        return;
    }
    GLint times = 1;
    while (3 * (times + 1) * (double)picture.width <= width &&
           2 * (times + 1) * (double)picture.height <= height) {
        times++;
    }
    glUseProgram(p);
    glProgramUniform2i(p, 0, (GLint)width - margin - times * (GLint)picture.width, margin);
    glProgramUniform2i(p, 1, (GLint)width, (GLint)height);
    glProgramUniform1i(p, 2, times);
    glBindTextureUnit(0, v->picture);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static void draw_all(const stage_view *v, const stage *s, uint32_t width, uint32_t height)
{
    float magnified = height > 1200 ? (float)height / 1200 : 1;
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(v->programs[BACK]);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    draw_faces(v, s, STAGE_BARE, BARE);
    draw_faces(v, s, STAGE_SOLID, LIT);
    draw_faces(v, s, STAGE_SMOOTH, LIT);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    draw_lines(v, s, STAGE_LINE, 1.4f * magnified);
    glDepthMask(GL_FALSE);
    draw_glass(v, s);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    draw_lines(v, s, STAGE_LINE_OVER, 2.0f * magnified);
    draw_points(v, s, magnified);
    glDisable(GL_BLEND);
    draw_picture(v, s, width, height);
}

int stage_view_draw(stage_view *v, const stage *s, const view_camera *camera, unsigned framebuffer,
                    uint32_t width, uint32_t height)
{
    const GLfloat far_away = 1;
    if (width == 0 || height == 0) {
        return 1;
    }
    if (!size_target(&v->target, width, height) || !send(v, s)) {
        return 0;
    }
    set_frame(v, camera, width, height);
    glBindVertexArray(v->vertices);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, v->target.framebuffer);
    glViewport(0, 0, (GLsizei)width, (GLsizei)height);
    glClearNamedFramebufferfv(v->target.framebuffer, GL_DEPTH, 0, &far_away);
    draw_all(v, s, width, height);
    glBlitNamedFramebuffer(v->target.framebuffer, framebuffer, 0, 0, (GLint)width, (GLint)height, 0,
                           0, (GLint)width, (GLint)height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    return 1;
}

int stage_view_shot(stage_view *v, const stage *s, const view_camera *camera, uint32_t width,
                    uint32_t height, unsigned char *pixels)
{
    size_t row = 3 * (size_t)width;
    GLuint framebuffer = 0, texture = 0;
    unsigned char *turned = malloc(row * height + 1);
    int good = turned != NULL;
    if (good) {
        glCreateTextures(GL_TEXTURE_2D, 1, &texture);
        glTextureStorage2D(texture, 1, GL_RGBA8, (GLsizei)width, (GLsizei)height);
        glCreateFramebuffers(1, &framebuffer);
        glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);
        good = stage_view_draw(v, s, camera, framebuffer, width, height);
    }
    if (good) {
        glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, (GLsizei)width, (GLsizei)height, GL_RGB, GL_UNSIGNED_BYTE, turned);
        for (uint32_t y = 0; y < height; y++) {
            memcpy(pixels + row * y, turned + row * (height - 1 - y), row);
        }
    }
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
    free(turned);
    return good;
}
