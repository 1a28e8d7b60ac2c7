// SPDX-License-Identifier: MIT
// A picture in memory. Text is drawn by cairo as a mask of coverage and mixed in here.

#include "canvas.h"

#include <stdlib.h>
#include <string.h>

#ifdef SF_HAVE_CAIRO
#include <cairo.h>
#endif

int canvas_create(canvas *c, uint32_t width, uint32_t height)
{
    size_t size = (size_t)3 * width * height;
    c->width = width;
    c->height = height;
    c->pixels = malloc(size);
    if (c->pixels != NULL) {
        memset(c->pixels, 255, size);
    }
    return c->pixels != NULL;
}

void canvas_destroy(canvas *c)
{
    free(c->pixels);
    c->pixels = NULL;
}

// Mix `ink` over a pixel; alpha 255 covers it.
static void blend(canvas *c, int x, int y, colour ink, uint8_t alpha)
{
    if (x < 0 || y < 0 || (uint32_t)x >= c->width || (uint32_t)y >= c->height) {
        return;
    }
    uint8_t *pixel = c->pixels + 3 * ((size_t)y * c->width + (size_t)x);
    const uint8_t over[3] = {ink.red, ink.green, ink.blue};
    for (int i = 0; i < 3; i++) {
        pixel[i] = (uint8_t)((over[i] * alpha + pixel[i] * (255 - alpha) + 127) / 255);
    }
}

void canvas_fill(canvas *c, int x0, int y0, int x1, int y1, colour ink)
{
    for (int y = y0; y < y1; y++) {
        for (int x = x0; x < x1; x++) {
            blend(c, x, y, ink, 255);
        }
    }
}

#ifdef SF_HAVE_CAIRO

static void blend_mask(canvas *c, cairo_surface_t *mask, int left, int top, colour ink)
{
    const unsigned char *rows = cairo_image_surface_get_data(mask);
    int width = cairo_image_surface_get_width(mask), height = cairo_image_surface_get_height(mask);
    int stride = cairo_image_surface_get_stride(mask);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            blend(c, left + x, top + y, ink, rows[y * stride + x]);
        }
    }
}

static void choose_font(cairo_t *pen, int size)
{
    cairo_select_font_face(pen, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(pen, size);
}

int canvas_text(canvas *c, int x, int y, int size, text_align align, colour ink, const char *text)
{
    cairo_surface_t *mask = cairo_image_surface_create(CAIRO_FORMAT_A8, (int)c->width, 2 * size);
    cairo_t *pen = cairo_create(mask);
    cairo_text_extents_t extents;
    choose_font(pen, size);
    cairo_text_extents(pen, text, &extents);
    cairo_move_to(pen, 0, size * 1.5);
    cairo_show_text(pen, text);
    cairo_surface_flush(mask);
    int width = cairo_status(pen) == CAIRO_STATUS_SUCCESS ? (int)(extents.x_advance + 0.5) : 0;
    if (width > 0) {
        int left = align == TEXT_LEFT ? 0 : align == TEXT_CENTRE ? width / 2 : width;
        blend_mask(c, mask, x - left, y - size * 3 / 2, ink);
    }
    cairo_destroy(pen);
    cairo_surface_destroy(mask);
    return width;
}

int canvas_text_width(int size, const char *text)
{
    cairo_surface_t *mask = cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1);
    cairo_t *pen = cairo_create(mask);
    cairo_text_extents_t extents;
    choose_font(pen, size);
    cairo_text_extents(pen, text, &extents);
    int width = cairo_status(pen) == CAIRO_STATUS_SUCCESS ? (int)(extents.x_advance + 0.5) : 0;
    cairo_destroy(pen);
    cairo_surface_destroy(mask);
    return width;
}

#else

int canvas_text(canvas *c, int x, int y, int size, text_align align, colour ink, const char *text)
{
    (void)c, (void)x, (void)y, (void)size, (void)align, (void)ink, (void)text;
    return 0;
}

int canvas_text_width(int size, const char *text)
{
    (void)size, (void)text;
    return 0;
}

#endif
