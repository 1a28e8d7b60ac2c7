// SPDX-License-Identifier: MIT
// Rough frames: smaller pictures, drawn large, while things move and whole ones take too long. So
// one can work where the processor draws.

#include "rough.h"

#include <epoxy/gl.h>

// A frame that takes longer is felt.
#define FELT_MS 50.0

uint32_t rough_part(const rough *r)
{
    return r->whole_ms > 8 * FELT_MS   ? 4
           : r->whole_ms > 4 * FELT_MS ? 3
           : r->whole_ms > FELT_MS     ? 2
                                       : 1;
}

static int size_texture(rough *r, uint32_t width, uint32_t height)
{
    if (r->width == width && r->height == height) {
        return 1;
    }
    rough_release(r);
    while (glGetError() != GL_NO_ERROR) {
    }
    glCreateTextures(GL_TEXTURE_2D, 1, &r->texture);
    glTextureStorage2D(r->texture, 1, GL_RGBA8, (GLsizei)width, (GLsizei)height);
    glCreateFramebuffers(1, &r->framebuffer);
    glNamedFramebufferTexture(r->framebuffer, GL_COLOR_ATTACHMENT0, r->texture, 0);
    if (glGetError() != GL_NO_ERROR) {
        rough_release(r);
        return 0;
    }
    r->width = width;
    r->height = height;
    return 1;
}

int rough_draw(rough *r, view *v, const view_camera *camera, const view_overlays *overlays,
               uint32_t width, uint32_t height, uint32_t part)
{
    uint32_t w = (width + part - 1) / part, h = (height + part - 1) / part;
    if (width == 0 || height == 0) {
        return 1;
    }
    if (!size_texture(r, w, h) || !view_draw(v, camera, overlays, r->framebuffer, w, h)) {
        return 0;
    }
    glBlitNamedFramebuffer(r->framebuffer, 0, 0, 0, (GLint)w, (GLint)h, 0, 0, (GLint)width,
                           (GLint)height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glViewport(0, 0, (GLsizei)width, (GLsizei)height);
    return 1;
}

void rough_release(rough *r)
{
    glDeleteFramebuffers(1, &r->framebuffer);
    glDeleteTextures(1, &r->texture);
    r->framebuffer = r->texture = 0;
    r->width = r->height = 0;
}
