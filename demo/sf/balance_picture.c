// SPDX-License-Identifier: MIT
// A picture of a balance, seen straight from above: the shape as a pale shadow, on it what it
// stands on, in that where its centre of mass may lie, where that was and where it is now.
//
// Every pixel asks how far it is from each line, so that there is nothing to draw but colours; near
// a line sixteen places in it are asked. All panels have one scale, that of the bar below them.

#include "balance_picture.h"

#include "legend.h"
#include "plan_view.h"
#include "stand_say.h"
#include "turned.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PANELS_MAX = 4, SIDE = 4 };
#define LEAST_PART 0.25 // of the model's size that a picture shows at least
#define MARGIN 0.22     // around what must be seen

static const double paper[3] = {1, 1, 1}, shadow[3] = {0.925, 0.93, 0.94};
static const double support[3] = {0.62, 0.76, 0.93}, rim[3] = {0.20, 0.38, 0.62};
static const double safe[3] = {0.56, 0.83, 0.58}, safe_rim[3] = {0.20, 0.52, 0.25};
static const double before[3] = {0.90, 0.40, 0.10}, after[3] = {0.10, 0.12, 0.16};

typedef struct panel {
    plan plan;
    int x, y, width, height;
    double middle[2], pixel_mm;
    double pen;    // half the width of a line, in mm
    uint8_t *mask; // of the shape: a bit for each quarter of a pixel
} panel;

// ---------------------------------------------------------------------------------------------
// The shadow
// ---------------------------------------------------------------------------------------------

static double side_of(const double a[2], const double b[2], double x, double y)
{
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

static int clamp(double value, int most)
{
    return value > 0 ? (value < most ? (int)value : most) : 0;
}

// Corners in halves of a pixel.
static void fill_triangle(panel *p, double c[3][2])
{
    double low[2], high[2];
    for (int d = 0; d < 2; d++) {
        low[d] = fmin(c[0][d], fmin(c[1][d], c[2][d]));
        high[d] = fmax(c[0][d], fmax(c[1][d], c[2][d]));
    }
    int x1 = clamp(ceil(high[0]), 2 * p->width), y1 = clamp(ceil(high[1]), 2 * p->height);
    for (int y = clamp(floor(low[1]), 2 * p->height); y < y1; y++) {
        for (int x = clamp(floor(low[0]), 2 * p->width); x < x1; x++) {
            double a = side_of(c[0], c[1], x + 0.5, y + 0.5);
            double b = side_of(c[1], c[2], x + 0.5, y + 0.5);
            double d = side_of(c[2], c[0], x + 0.5, y + 0.5);
            if ((a >= 0 && b >= 0 && d >= 0) || (a <= 0 && b <= 0 && d <= 0)) {
                p->mask[(size_t)(y / 2) * (size_t)p->width + (size_t)(x / 2)] |=
                    (uint8_t)(1 << (2 * (y % 2) + x % 2));
            }
        }
    }
}

static int cast_shadow(const model *m, panel *p)
{
    sf_mesh_view mesh = sf_stand_outer(m->stand);
    p->mask = calloc((size_t)p->width * (size_t)p->height, 1);
    for (size_t t = 0; p->mask != NULL && t < mesh.triangle_count; t++) {
        double corners[3][2];
        for (int i = 0; i < 3; i++) {
            plan_place(&p->plan, mesh.vertices + 3 * (size_t)mesh.triangles[3 * t + (size_t)i],
                       corners[i]);
            corners[i][0] = 2 * ((corners[i][0] - p->middle[0]) / p->pixel_mm + 0.5 * p->width);
            corners[i][1] = 2 * ((p->middle[1] - corners[i][1]) / p->pixel_mm + 0.5 * p->height);
        }
        fill_triangle(p, corners);
    }
    return p->mask != NULL;
}

// ---------------------------------------------------------------------------------------------
// Colours
// ---------------------------------------------------------------------------------------------

static double distance(const double a[2], const double b[2])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}

static double distance_to_segment(const double a[2], const double b[2], const double at[2])
{
    double d[2] = {b[0] - a[0], b[1] - a[1]}, square = d[0] * d[0] + d[1] * d[1];
    double t = square > 0 ? ((at[0] - a[0]) * d[0] + (at[1] - a[1]) * d[1]) / square : 0;
    t = fmin(1, fmax(0, t));
    double foot[2] = {a[0] + t * d[0], a[1] + t * d[1]};
    return distance(foot, at);
}

// How far a place lies from each thing that is drawn, in mm; what has an inside, negative in it.
typedef struct distances {
    double support, safe, thread, before, after;
} distances;

static distances look(const panel *p, const double at[2])
{
    const plan *q = &p->plan;
    const double *last = q->corners + 2 * (q->corner_count > 0 ? q->corner_count - 1 : 0);
    distances d;
    d.support = q->corner_count > 2   ? -plan_depth(q->edges, q->edge_count, at)
                : q->corner_count > 0 ? distance_to_segment(q->corners, last, at) - 2 * p->pen
                                      : INFINITY;
    d.safe = q->is_never_safe || q->safe_count == 0 ? INFINITY
                                                    : -plan_depth(q->safes, q->safe_count, at);
    d.thread = distance_to_segment(q->before, q->after, at);
    d.before = distance(q->before, at);
    d.after = distance(q->after, at);
    return d;
}

static const double *colour_at(const panel *p, const distances *d)
{
    double pen = p->pen;
    if (d->after < 6 * pen) {
        return d->after < 5 * pen ? after : paper;
    }
    if (d->before < 6 * pen) {
        return d->before > 5 * pen || d->before < 2.6 * pen ? paper : before;
    }
    if (d->thread < 0.6 * pen) {
        return before;
    }
    if (fabs(d->support) < pen) {
        return rim;
    }
    if (fabs(d->safe) < 0.7 * pen) {
        return safe_rim;
    }
    return d->safe < 0 ? safe : d->support < 0 ? support : NULL;
}

// Whether a whole pixel has one colour.
static int is_plain(const panel *p, const distances *d)
{
    double near = p->pixel_mm, pen = p->pen;
    return fabs(d->support) > pen + near && fabs(d->safe) > pen + near && d->thread > pen + near &&
           d->before > 6 * pen + near && d->after > 6 * pen + near;
}

static void paint_pixel(const panel *p, int x, int y, uint8_t rgb[3])
{
    static const double quarters[16] = {0,    0.25, 0.25, 0.5,  0.25, 0.5,  0.5,  0.75,
                                        0.25, 0.5,  0.5,  0.75, 0.5,  0.75, 0.75, 1};
    double cover = quarters[p->mask[(size_t)y * (size_t)p->width + (size_t)x] & 15];
    double corner[2] = {p->middle[0] + (x - 0.5 * p->width) * p->pixel_mm,
                        p->middle[1] - (y - 0.5 * p->height) * p->pixel_mm};
    double centre[2] = {corner[0] + 0.5 * p->pixel_mm, corner[1] - 0.5 * p->pixel_mm};
    double sum[3] = {0, 0, 0};
    distances d = look(p, centre);
    int side = is_plain(p, &d) ? 1 : SIDE;
    for (int i = 0; i < side * side; i++) {
        double at[2] = {corner[0] + (i % side + 0.5) / side * p->pixel_mm,
                        corner[1] - (i / side + 0.5) / side * p->pixel_mm};
        d = look(p, at);
        const double *found = colour_at(p, &d);
        for (int c = 0; c < 3; c++) {
            sum[c] += found != NULL ? found[c] : cover * shadow[c] + (1 - cover) * paper[c];
        }
    }
    for (int c = 0; c < 3; c++) {
        rgb[c] = (uint8_t)(255 * sum[c] / (side * side) + 0.5);
    }
}

static sf_status paint(const panel *p, sf_task *task, canvas *picture)
{
    for (int y = 0; y < p->height; y++) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        for (int x = 0; x < p->width; x++) {
            size_t at = (size_t)(p->y + y) * picture->width + (size_t)(p->x + x);
            paint_pixel(p, x, y, picture->pixels + 3 * at);
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// Panels
// ---------------------------------------------------------------------------------------------

static void take_in(const double at[2], double low[2], double high[2])
{
    for (int i = 0; i < 2; i++) {
        low[i] = fmin(low[i], at[i]);
        high[i] = fmax(high[i], at[i]);
    }
}

// What must be seen, and the size of a pixel that it takes.
static double frame(const model *m, panel *p)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    take_in(p->plan.before, low, high);
    take_in(p->plan.after, low, high);
    for (size_t i = 0; i < p->plan.corner_count; i++) {
        take_in(p->plan.corners + 2 * i, low, high);
    }
    double least = LEAST_PART * m->size_mm;
    for (int i = 0; i < 2; i++) {
        p->middle[i] = 0.5 * (low[i] + high[i]);
    }
    return (1 + 2 * MARGIN) * fmax(fmax(high[0] - low[0], least) / p->width,
                                   fmax(high[1] - low[1], least) / p->height);
}

static void title(const cli_job *job, const model *m, size_t index, const panel *p, int size,
                  canvas *picture)
{
    const sf_stance *stance = sf_stand_stance(m->stand, index);
    sf_stance_options asked = sf_stance_get_options(stance);
    char way[STAND_DIRECTION_SIZE], words[160];
    static const colour ink = {40, 44, 50};
    sf_stance_verdict v;
    double up[3];
    turned_to_input(job, asked.up, up);
    if (sf_stance_judge(stance, m->report.com_mm, &v) != SF_OK) {
        return;
    }
    const double degrees = 180 / 3.14159265358979323846;
    stand_direction(up, way);
    if (asked.kind != SF_STANCE_STAND) {
        snprintf(words, sizeof words, "%s up: rests %.1f degrees from it", way,
                 -v.margin_rad * degrees);
    } else if (m->stances.count == 1) {
        snprintf(words, sizeof words, "%s up: margin %.1f degrees, before %.1f", way,
                 v.margin_rad * degrees, m->report.margin_before_rad * degrees);
    } else {
        snprintf(words, sizeof words, "%s up: margin %.1f degrees", way, v.margin_rad * degrees);
    }
    canvas_text(picture, p->x + size, p->y - size * 2 / 3, size, TEXT_LEFT, ink, words);
}

static void lay_out(const cli_job *job, size_t count, int strip, panel *panels)
{
    int columns = count > 1 ? 2 : 1, rows = count > 2 ? 2 : 1;
    int width = (int)job->options.pixels[0] / columns;
    int height = ((int)job->options.pixels[1] - (int)legend_height(job->options.pixels[1])) / rows;
    for (size_t i = 0; i < count; i++) {
        panels[i].x = (int)i % columns * width;
        panels[i].y = (int)i / columns * height + strip;
        panels[i].width = width;
        panels[i].height = height - strip;
    }
}

static sf_status draw(cli_job *job, const model *m, panel *panels, size_t count, canvas *picture)
{
    static const swatch swatches[] = {
        {support, "stands on"}, {safe, "safe"}, {before, "mass before"}, {after, "mass now"}};
    int size = (int)picture->height / 32 > 10 ? (int)picture->height / 32 : 10;
    double pixel_mm = 0;
    lay_out(job, count, 2 * size, panels);
    for (size_t i = 0; i < count; i++) {
        if (!plan_make(m, i, &panels[i].plan)) {
            return SF_ERR_MEMORY;
        }
        pixel_mm = fmax(pixel_mm, frame(m, &panels[i]));
    }
    for (size_t i = 0; i < count; i++) {
        panels[i].pixel_mm = pixel_mm;
        panels[i].pen = pixel_mm * fmax(0.8, picture->height / 600.0);
        if (!cast_shadow(m, &panels[i])) {
            return SF_ERR_MEMORY;
        }
        sf_status status = paint(&panels[i], &job->task, picture);
        if (status != SF_OK) {
            return status;
        }
        title(job, m, i, &panels[i], size, picture);
    }
    legend_draw(picture, pixel_mm, 0.15 * picture->width, swatches, 4);
    return SF_OK;
}

exit_status balance_picture_draw(cli_job *job, const model *m, canvas *picture)
{
    panel panels[PANELS_MAX];
    size_t count = m->stances.count < PANELS_MAX ? m->stances.count : PANELS_MAX;
    memset(panels, 0, sizeof panels);
    sf_status status = SF_ERR_MEMORY;
    if (canvas_create(picture, job->options.pixels[0], job->options.pixels[1])) {
        status = draw(job, m, panels, count, picture);
    }
    for (size_t i = 0; i < count; i++) {
        plan_release(&panels[i].plan);
        free(panels[i].mask);
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, NULL, "the picture", EXIT_RESOURCE);
}
