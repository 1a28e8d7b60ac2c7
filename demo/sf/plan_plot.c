// SPDX-License-Identifier: MIT
// A plan painted. Every pixel asks how far it is from each line, so that there is nothing to draw
// but colours; near a line sixteen places in it are asked. What lies on top is asked first.

#include "plan_plot.h"

#include "plan_marks.h"

#include <math.h>
#include <stdlib.h>

enum { SIDE = 4 };

static double clamp(double value, int most)
{
    return value > 0 ? (value < most ? value : most) : 0;
}

void plot_frame(plot *p, const double low[2], const double high[2], double margin)
{
    double width = high[0] - low[0], height = high[1] - low[1];
    for (int i = 0; i < 2; i++) {
        p->middle[i] = 0.5 * (low[i] + high[i]);
    }
    p->pixel_mm = (1 + 2 * margin) * fmax(width / p->width, height / p->height);
}

// ---------------------------------------------------------------------------------------------
// The shadow
// ---------------------------------------------------------------------------------------------

static double side_of(const double a[2], const double b[2], double x, double y)
{
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

// Corners in halves of a pixel.
static void fill_triangle(const plot *p, uint8_t *mask, double c[3][2])
{
    double low[2], high[2];
    for (int d = 0; d < 2; d++) {
        low[d] = fmin(c[0][d], fmin(c[1][d], c[2][d]));
        high[d] = fmax(c[0][d], fmax(c[1][d], c[2][d]));
    }
    int x1 = (int)clamp(ceil(high[0]), 2 * p->width), y1 = (int)clamp(ceil(high[1]), 2 * p->height);
    for (int y = (int)clamp(floor(low[1]), 2 * p->height); y < y1; y++) {
        for (int x = (int)clamp(floor(low[0]), 2 * p->width); x < x1; x++) {
            double a = side_of(c[0], c[1], x + 0.5, y + 0.5);
            double b = side_of(c[1], c[2], x + 0.5, y + 0.5);
            double d = side_of(c[2], c[0], x + 0.5, y + 0.5);
            if ((a >= 0 && b >= 0 && d >= 0) || (a <= 0 && b <= 0 && d <= 0)) {
                mask[(size_t)(y / 2) * (size_t)p->width + (size_t)(x / 2)] |=
                    (uint8_t)(1 << (2 * (y % 2) + x % 2));
            }
        }
    }
}

// A bit for each quarter of a pixel.
static void cast_shadow(const plot *p, sf_mesh_view mesh, uint8_t *mask)
{
    for (size_t t = 0; t < mesh.triangle_count; t++) {
        double corners[3][2];
        for (size_t i = 0; i < 3; i++) {
            plan_place(p->plan, mesh.vertices + 3 * (size_t)mesh.triangles[3 * t + i], corners[i]);
            corners[i][0] = 2 * ((corners[i][0] - p->middle[0]) / p->pixel_mm + 0.5 * p->width);
            corners[i][1] = 2 * ((p->middle[1] - corners[i][1]) / p->pixel_mm + 0.5 * p->height);
        }
        fill_triangle(p, mask, corners);
    }
}

static uint8_t mask_at(const plot *p, const uint8_t *mask, int x, int y)
{
    return x >= 0 && y >= 0 && x < p->width && y < p->height
               ? mask[(size_t)y * (size_t)p->width + (size_t)x]
               : 15;
}

// The shadow, with its outline, where nothing lies on it.
static void shade(const plot *p, const uint8_t *mask, int x, int y, double rgb[3])
{
    static const double quarters[16] = {0,    0.25, 0.25, 0.5,  0.25, 0.5,  0.5,  0.75,
                                        0.25, 0.5,  0.5,  0.75, 0.5,  0.75, 0.75, 1};
    double cover = quarters[mask_at(p, mask, x, y)], around = 0;
    for (int i = 0; i < 9; i++) {
        around += quarters[mask_at(p, mask, x + i % 3 - 1, y + i / 3 - 1)];
    }
    double edge = cover * clamp(2 * (1 - around / 9), 1);
    for (int c = 0; c < 3; c++) {
        double inside = (1 - edge) * marks_shadow[c] + edge * marks_outline[c];
        rgb[c] = cover * inside + (1 - cover) * marks_paper[c];
    }
}

// ---------------------------------------------------------------------------------------------
// The plan
// ---------------------------------------------------------------------------------------------

static double distance_to_segment(const double a[2], const double b[2], const double at[2])
{
    double d[2] = {b[0] - a[0], b[1] - a[1]}, square = d[0] * d[0] + d[1] * d[1];
    double t = square > 0 ? ((at[0] - a[0]) * d[0] + (at[1] - a[1]) * d[1]) / square : 0;
    t = fmin(1, fmax(0, t));
    return hypot(a[0] + t * d[0] - at[0], a[1] + t * d[1] - at[1]);
}

// How far outside of a region a place lies, or minus how far inside; infinite beyond `reach`.
static double distance_to_region(const region *r, const double at[2], double reach)
{
    for (int i = 0; i < 2; i++) {
        if (at[i] < r->low[i] - reach || at[i] > r->high[i] + reach) {
            return INFINITY;
        }
    }
    return r->corner_count > 2
               ? -plan_depth(r, at)
               : distance_to_segment(r->corners, r->corners + 2 * (r->corner_count - 1), at) -
                     0.5 * reach;
}

static double distance_to_window(const plot *p, const double at[2])
{
    double outside = -INFINITY;
    for (int i = 0; i < 2; i++) {
        outside = fmax(outside, fmax(p->window_low[i] - at[i], at[i] - p->window_high[i]));
    }
    return p->has_window ? outside : INFINITY;
}

// From the ring to the dot, where they are far enough from each other; coordinates along it and
// across, in units. Returns 0 where there is none.
static int along_arrow(const plot *p, const double at[2], double *along, double *across,
                       double *length)
{
    const plan *q = p->plan;
    double unit_mm = p->unit * p->pixel_mm;
    double d[2] = {q->after[0] - q->before[0], q->after[1] - q->before[1]};
    double total = hypot(d[0], d[1]), x = at[0] - q->before[0], y = at[1] - q->before[1];
    *length = total / unit_mm - MARKS_RING - MARKS_DOT - 3;
    if (!(*length > 10)) {
        return 0;
    }
    *along = (x * d[0] + y * d[1]) / total / unit_mm - MARKS_RING - 1;
    *across = fabs(x * d[1] - y * d[0]) / total / unit_mm;
    return 1;
}

static int is_on_arrow(const plot *p, const double at[2])
{
    double along, across, length;
    if (!along_arrow(p, at, &along, &across, &length) || along < 0 || along > length) {
        return 0;
    }
    double head = fmin(11, length);
    return along > length - head ? across < 0.45 * (length - along) : across < 1;
}

static int is_near_arrow(const plot *p, const double at[2])
{
    double along, across, length;
    return along_arrow(p, at, &along, &across, &length) && across < 8;
}

static const double *colour_of_mark(const plot *p, plan_mark mark, const double place[2],
                                    const double at[2])
{
    double unit_mm = p->unit * p->pixel_mm;
    return marks_colour(mark, (at[0] - place[0]) / unit_mm, (at[1] - place[1]) / unit_mm);
}

static const double *colour_of_region(const plot *p, const double at[2])
{
    const plan *q = p->plan;
    double pen = p->unit * p->pixel_mm;
    double safe = distance_to_region(&q->safe, at, 4 * pen);
    double support =
        q->kind == SF_STANCE_HANG ? INFINITY : distance_to_region(&q->support, at, 4 * pen);
    if (fabs(support) < pen) {
        return marks_rim;
    }
    if (fabs(safe) < 0.8 * pen) {
        return marks_safe_rim;
    }
    return safe < 0 ? marks_safe : support < 0 ? marks_support : NULL;
}

static const double *colour_at(const plot *p, const double at[2])
{
    const plan *q = p->plan;
    const double *found = colour_of_mark(p, MARK_AFTER, q->after, at);
    if (found == NULL) {
        found = colour_of_mark(p, MARK_BEFORE, q->before, at);
    }
    if (found == NULL && is_on_arrow(p, at)) {
        found = marks_before;
    }
    if (found == NULL && q->kind == SF_STANCE_HANG) {
        found = colour_of_mark(p, MARK_STRING, q->support.corners, at);
    }
    if (found == NULL && fabs(distance_to_window(p, at)) < 0.6 * p->unit * p->pixel_mm) {
        found = marks_outline;
    }
    return found != NULL ? found : colour_of_region(p, at);
}

static int is_near_mark(const plot *p, const double place[2], const double at[2])
{
    return hypot(at[0] - place[0], at[1] - place[1]) < (MARKS_REACH * p->unit + 1) * p->pixel_mm;
}

static int is_near_rim(const plot *p, const region *r, const double at[2])
{
    double near = (2 * p->unit + 1) * p->pixel_mm, d = distance_to_region(r, at, 4 * near);
    return fabs(d) < near || (r->corner_count < 3 && d < near);
}

// Whether a pixel may have more than one colour on it.
static int is_mixed(const plot *p, const double at[2])
{
    const plan *q = p->plan;
    return is_near_mark(p, q->after, at) || is_near_mark(p, q->before, at) ||
           is_near_arrow(p, at) ||
           (q->kind == SF_STANCE_HANG && is_near_mark(p, q->support.corners, at)) ||
           fabs(distance_to_window(p, at)) < (p->unit + 1) * p->pixel_mm ||
           is_near_rim(p, &q->support, at) || is_near_rim(p, &q->safe, at);
}

static void paint_pixel(const plot *p, const uint8_t *mask, int x, int y, uint8_t rgb[3])
{
    double corner[2] = {p->middle[0] + (x - 0.5 * p->width) * p->pixel_mm,
                        p->middle[1] - (y - 0.5 * p->height) * p->pixel_mm};
    double centre[2] = {corner[0] + 0.5 * p->pixel_mm, corner[1] - 0.5 * p->pixel_mm};
    double sum[3] = {0, 0, 0}, below[3];
    int side = is_mixed(p, centre) ? SIDE : 1;
    shade(p, mask, x, y, below);
    for (int i = 0; i < side * side; i++) {
        double at[2] = {corner[0] + (i % side + 0.5) / side * p->pixel_mm,
                        corner[1] - (i / side + 0.5) / side * p->pixel_mm};
        const double *found = colour_at(p, at);
        for (int c = 0; c < 3; c++) {
            sum[c] += found != NULL ? found[c] : below[c];
        }
    }
    for (int c = 0; c < 3; c++) {
        rgb[c] = (uint8_t)(255 * sum[c] / (side * side) + 0.5);
    }
}

sf_status plot_paint(const plot *p, sf_mesh_view mesh, sf_task *task, canvas *picture)
{
    uint8_t *mask = calloc((size_t)p->width * (size_t)p->height, 1);
    sf_status status = mask != NULL ? SF_OK : SF_ERR_MEMORY;
    if (mask != NULL) {
        cast_shadow(p, mesh, mask);
    }
    for (int y = 0; status == SF_OK && y < p->height; y++) {
        status = sf_task_is_cancelled(task) ? SF_ERR_CANCELLED : SF_OK;
        for (int x = 0; status == SF_OK && x < p->width; x++) {
            size_t at = (size_t)(p->y + y) * picture->width + (size_t)(p->x + x);
            paint_pixel(p, mask, x, y, picture->pixels + 3 * at);
        }
    }
    free(mask);
    return status;
}
