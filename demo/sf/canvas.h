// SPDX-License-Identifier: MIT
// A picture in memory: 8-bit RGB, row 0 on top.

#ifndef DEMO_SF_CANVAS_H
#define DEMO_SF_CANVAS_H

#include <stdint.h>

typedef struct colour {
    uint8_t red, green, blue;
} colour;

typedef struct canvas {
    uint8_t *pixels; // 3 * width * height bytes
    uint32_t width, height;
} canvas;

// Returns 0 when there is no memory. The canvas is white.
int canvas_create(canvas *c, uint32_t width, uint32_t height);
void canvas_destroy(canvas *c);

// Fill x0 <= x < x1, y0 <= y < y1, as far as it lies on the canvas.
void canvas_fill(canvas *c, int x0, int y0, int x1, int y1, colour ink);

// Where text stands about its point.
typedef enum text_align { TEXT_LEFT, TEXT_CENTRE, TEXT_RIGHT } text_align;

// Write text, its baseline at y. Returns its width in pixels; 0 in a build without cairo, where
// nothing is written.
int canvas_text(canvas *c, int x, int y, int size, text_align align, colour ink, const char *text);

// The width that it would take.
int canvas_text_width(int size, const char *text);

#endif
