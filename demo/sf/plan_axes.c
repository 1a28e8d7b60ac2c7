// SPDX-License-Identifier: MIT
// The frame of a plot. Ticks are at 1, 2 or 5 times a power of ten, as close as their numbers can
// stand beside each other; both sides have one scale, so a length is a length whichever way it
// lies.

#include "plan_axes.h"

#include "legend.h"

#include <math.h>
#include <stdio.h>

enum { NUMBER_SIZE = 40, TICKS_MOST = 200 };

static const colour ink = {60, 64, 70};

int axes_left(int size)
{
    return 5 * size;
}

int axes_top(int size)
{
    return 2 * size;
}

int axes_right(int size)
{
    return 2 * size;
}

int axes_bottom(int size)
{
    return 7 * size / 2;
}

static int line_width(const plot *p)
{
    return p->unit > 1 ? (int)(p->unit + 0.5) : 1;
}

// What a side of the plot counts at its lower end, and where its numbers end.
static double low_end(const plot *p, int d)
{
    return p->middle[d] - 0.5 * (d == 0 ? p->width : p->height) * p->pixel_mm;
}

static double high_end(const plot *p, int d)
{
    return p->middle[d] + 0.5 * (d == 0 ? p->width : p->height) * p->pixel_mm;
}

static void write_number(double value, double step, char text[NUMBER_SIZE])
{
    double digits = fmin(12, fmax(0, -floor(log10(step) + 1e-9)));
    value = fabs(value) < 0.01 * step ? 0 : value;
    snprintf(text, NUMBER_SIZE, "%.*f", (int)digits, value);
}

// After 1, 2, 5, 10, ... times a power of ten comes the next of them.
static double next_step(double step)
{
    return legend_round_length(2.5001 * step);
}

// Wide numbers stand farther apart, and how wide they are depends on how far.
static double choose_step(const plot *p, int d, int size)
{
    double least = 2.4 * size * p->pixel_mm, step = legend_round_length(least);
    char text[NUMBER_SIZE];
    step = step < least ? next_step(step) : step;
    for (int tries = 0; d == 0 && tries < 8; tries++) {
        write_number(low_end(p, d), step, text);
        int low = canvas_text_width(size, text);
        write_number(high_end(p, d), step, text);
        int high = canvas_text_width(size, text);
        if (step / p->pixel_mm >= (low > high ? low : high) + size) {
            break;
        }
        step = next_step(step);
    }
    return step;
}

static void draw_tick(const plot *p, int d, double value, double step, int size, canvas *picture)
{
    int wide = line_width(p), length = size / 3 + 1;
    char text[NUMBER_SIZE];
    int at = (int)floor((value - low_end(p, d)) / p->pixel_mm);
    write_number(value, step, text);
    if (d == 0) {
        int x = p->x + at, y = p->y + p->height;
        canvas_fill(picture, x - wide / 2, y, x - wide / 2 + wide, y + length, ink);
        canvas_text(picture, x, y + length + size, size, TEXT_CENTRE, ink, text);
    } else {
        int x = p->x, y = p->y + p->height - at;
        canvas_fill(picture, x - length, y - wide / 2, x, y - wide / 2 + wide, ink);
        canvas_text(picture, x - length - size / 4, y + size * 3 / 8, size, TEXT_RIGHT, ink, text);
    }
}

static void draw_ticks(const plot *p, int d, int size, canvas *picture)
{
    double step = choose_step(p, d, size);
    double first = ceil(low_end(p, d) / step), last = floor(high_end(p, d) / step);
    for (int i = 0; i < TICKS_MOST && first + i <= last; i++) {
        draw_tick(p, d, (first + i) * step, step, size, picture);
    }
}

void axes_draw(const plot *p, int size, canvas *picture)
{
    int wide = line_width(p);
    int left = p->x - wide, right = p->x + p->width + wide;
    int top = p->y - wide, bottom = p->y + p->height + wide;
    canvas_fill(picture, left, top, right, p->y, ink);
    canvas_fill(picture, left, p->y + p->height, right, bottom, ink);
    canvas_fill(picture, left, top, p->x, bottom, ink);
    canvas_fill(picture, p->x + p->width, top, right, bottom, ink);
    draw_ticks(p, 0, size, picture);
    draw_ticks(p, 1, size, picture);
    canvas_text(picture, p->x + p->width / 2, bottom + size * 29 / 10, size, TEXT_CENTRE, ink,
                p->plan->names[0]);
    canvas_text(picture, p->x - axes_left(size) + size, p->y - size * 7 / 10, size, TEXT_LEFT, ink,
                p->plan->names[1]);
}
