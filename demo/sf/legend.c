// SPDX-License-Identifier: MIT
// The strip below a picture: a scale bar, and what the colours mean.

#include "legend.h"

#include <math.h>
#include <stdio.h>

static const colour ink = {60, 64, 70};

uint32_t legend_height(uint32_t picture_height)
{
    uint32_t height = picture_height / 14;
    return height < 24 ? 24 : height;
}

double legend_round_length(double most_mm)
{
    double unit = pow(10, floor(log10(most_mm)));
    double times = most_mm / unit;
    return unit * (times >= 5 ? 5 : times >= 2 ? 2 : 1);
}

// Large enough to be read where the picture is shown at half its size, or a wide one narrower
// still; and no wider than it.
static int text_size(const canvas *c)
{
    int size = (int)c->height / 34, wide = (int)c->width / 80, most = (int)c->width / 38;
    size = size < wide ? wide : size;
    size = size < 11 ? 11 : size;
    return size < most ? size : most;
}

static void draw_bar(canvas *c, int left, int middle, int length, int size)
{
    int thick = size / 10 < 1 ? 1 : size / 10, end = size / 3;
    canvas_fill(c, left, middle - thick, left + length, middle + thick, ink);
    canvas_fill(c, left, middle - end, left + 2 * thick, middle + end, ink);
    canvas_fill(c, left + length - 2 * thick, middle - end, left + length, middle + end, ink);
}

static int draw_swatch(canvas *c, int left, int middle, int size, const double rgb[3],
                       const char *words)
{
    colour fill = {(uint8_t)(255 * rgb[0]), (uint8_t)(255 * rgb[1]), (uint8_t)(255 * rgb[2])};
    canvas_fill(c, left, middle - size / 2, left + size, middle + size / 2, fill);
    return left + 2 * size +
           canvas_text(c, left + 3 * size / 2, middle + size * 3 / 8, size, TEXT_LEFT, ink, words) +
           size;
}

double legend_draw(canvas *picture, double pixel_mm, double most, const swatch *swatches,
                   size_t count)
{
    int strip = (int)legend_height(picture->height), size = text_size(picture);
    int middle = (int)picture->height - strip / 2, margin = strip / 2;
    double bar_mm = legend_round_length(most * pixel_mm);
    int length = (int)(bar_mm / pixel_mm + 0.5);
    char words[32];
    snprintf(words, sizeof words, "%g mm", bar_mm);
    draw_bar(picture, margin, middle, length, size);
    int next = margin + length + size +
               canvas_text(picture, margin + length + size, middle + size * 3 / 8, size, TEXT_LEFT,
                           ink, words) +
               3 * size;
    for (size_t i = 0; i < count; i++) {
        next = draw_swatch(picture, next, middle, size, swatches[i].rgb, swatches[i].words);
    }
    return bar_mm;
}
