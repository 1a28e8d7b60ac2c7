// SPDX-License-Identifier: MIT
// A picture of a balance, seen straight from above: all of the shape as a pale shadow, on it what
// it stands on or hangs from, where its centre of mass may lie, where that was and where it is now.
//
// Every stance has a plan, with sides that count mm of the input's axes. A foot is often small
// under what stands on it: then a second plan shows it larger, beside the first, in which a frame
// says where it is. The key has room of its own at the bottom.

#include "balance_picture.h"

#include "plan_axes.h"
#include "plan_key.h"
#include "stand_say.h"
#include "turned.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PLANS_MAX = 4, LEAST_SIDE = 24, TITLE_SIZE = 200 };

#define MARGIN 0.06      // around a shape
#define MARGIN_LARGE 0.2 // around what is shown larger
#define FAR 5.0          // times as large: then where the centre of mass was is left out of that
#define SMALL 0.45       // of a plan: what takes less of it is shown larger
#define DEGREES (180 / 3.14159265358979323846)

static const colour ink = {40, 44, 50};

// A plan of a stance, its place in the picture, and what it shows.
typedef struct view {
    plan plan;
    double low[2], high[2];           // of all that it shows
    double core_low[2], core_high[2]; // and without the shape
    plot whole, part;
    int x, y, width, height; // with titles and numbers
    int has_part;
} view;

typedef struct sheet {
    view views[PLANS_MAX];
    size_t count;
    int size; // of words
    double unit;
    plan_key key;
} sheet;

// ---------------------------------------------------------------------------------------------
// What is seen
// ---------------------------------------------------------------------------------------------

static double extent(const double low[2], const double high[2])
{
    return fmax(high[0] - low[0], high[1] - low[1]);
}

static void measure(const model *m, view *v)
{
    sf_mesh_view mesh = sf_stand_outer(m->stand);
    const plan *p = &v->plan;
    for (int i = 0; i < 2; i++) {
        v->core_low[i] = fmin(p->support.low[i], p->safe.low[i]);
        v->core_high[i] = fmax(p->support.high[i], p->safe.high[i]);
    }
    plan_take_in(p->after, v->core_low, v->core_high);
    memcpy(v->low, v->core_low, sizeof v->low);
    memcpy(v->high, v->core_high, sizeof v->high);
    plan_take_in(p->before, v->low, v->high);
    if (FAR * extent(v->core_low, v->core_high) > extent(v->low, v->high)) {
        plan_take_in(p->before, v->core_low, v->core_high);
    }
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        double at[2];
        plan_place(p, mesh.vertices + 3 * (size_t)mesh.triangles[i], at);
        plan_take_in(at, v->low, v->high);
    }
    double least = 1e-3 * m->size_mm; // where all lies in a point
    for (int i = 0; i < 2; i++) {
        double missing = fmax(0, least - (v->core_high[i] - v->core_low[i]));
        v->core_low[i] -= 0.5 * missing;
        v->core_high[i] += 0.5 * missing;
    }
}

static int is_small(const view *v)
{
    return extent(v->core_low, v->core_high) < SMALL * extent(v->low, v->high);
}

// ---------------------------------------------------------------------------------------------
// Places
// ---------------------------------------------------------------------------------------------

// A plot in a part of a view, within its frame; bare where there is no room for one.
static void place_plot(const sheet *s, const view *v, int x, int width, plot *p)
{
    int title = 2 * s->size, left = axes_left(s->size), top = axes_top(s->size);
    p->plan = &v->plan;
    p->unit = s->unit;
    p->x = x + left;
    p->y = v->y + title + top;
    p->width = width - left - axes_right(s->size);
    p->height = v->height - title - top - axes_bottom(s->size);
    if (p->width < LEAST_SIDE || p->height < LEAST_SIDE) {
        p->x = x + 1;
        p->y = v->y + 1;
        p->width = width - 2;
        p->height = v->height - 2;
    }
}

static void place_view(const sheet *s, view *v)
{
    int half = v->has_part ? v->width / 2 : v->width;
    place_plot(s, v, v->x, half, &v->whole);
    plot_frame(&v->whole, v->low, v->high, MARGIN);
    if (!v->has_part) {
        return;
    }
    place_plot(s, v, v->x + half, v->width - half, &v->part);
    plot_frame(&v->part, v->core_low, v->core_high, MARGIN_LARGE);
    v->whole.has_window = 1;
    for (int i = 0; i < 2; i++) {
        double reach = 0.5 * v->part.pixel_mm * (i == 0 ? v->part.width : v->part.height);
        v->whole.window_low[i] = v->part.middle[i] - reach;
        v->whole.window_high[i] = v->part.middle[i] + reach;
    }
}

// Two plans that are shown larger in part stand below each other, others beside each other.
static void lay_out(const cli_job *job, sheet *s)
{
    int width = (int)job->options.pixels[0], height = (int)job->options.pixels[1];
    int larger = 0, key = key_height(&s->key, s->size, width);
    height -= key < height / 3 ? key : 0;
    for (size_t i = 0; i < s->count; i++) {
        larger = larger || (s->count <= 2 && is_small(&s->views[i]));
    }
    int columns = s->count > 2 || (s->count == 2 && !larger) ? 2 : 1;
    int rows = ((int)s->count + columns - 1) / columns;
    for (int i = 0; i < (int)s->count; i++) {
        view *v = &s->views[i];
        v->width = width / columns;
        v->height = height / rows;
        v->x = i % columns * v->width;
        v->y = i / columns * v->height;
        v->has_part = larger && is_small(v) && v->width / 2 > 12 * s->size;
        place_view(s, v);
    }
}

// ---------------------------------------------------------------------------------------------
// Words
// ---------------------------------------------------------------------------------------------

static void choose_words(sheet *s)
{
    int rocks = 0;
    s->key.words[MARK_SHADOW] = "the shape from above";
    s->key.words[MARK_SAFE] = "safe for its centre of mass";
    s->key.words[MARK_BEFORE] = "centre of mass before";
    s->key.words[MARK_AFTER] = "centre of mass after";
    for (size_t i = 0; i < s->count; i++) {
        sf_stance_kind kind = s->views[i].plan.kind;
        rocks += kind == SF_STANCE_ROCK;
        if (kind == SF_STANCE_HANG) {
            s->key.words[MARK_STRING] = "suspension point";
        } else {
            s->key.words[MARK_SUPPORT] = rocks > 0 ? "touches the ground" : "support polygon";
        }
    }
}

// "before -12.6", where the figures are of one stance
static void say_before(const model *m, double sign, char words[32])
{
    words[0] = '\0';
    if (m->stances.count == 1) {
        snprintf(words, 32, ", before %.1f", sign * m->report.margin_before_rad * DEGREES);
    }
}

static void write_title(const cli_job *job, const model *m, size_t index, char words[TITLE_SIZE])
{
    const sf_stance *stance = sf_stand_stance(m->stand, index);
    sf_stance_options asked = sf_stance_get_options(stance);
    char way[STAND_DIRECTION_SIZE], before[32];
    sf_stance_verdict v;
    double up[3];
    turned_to_input(job, asked.up, up);
    stand_direction(up, way);
    words[0] = '\0';
    if (sf_stance_judge(stance, m->report.com_mm, &v) != SF_OK) {
        return;
    }
    if (asked.kind == SF_STANCE_STAND) {
        say_before(m, 1, before);
        snprintf(words, TITLE_SIZE, "With %s up it %s: a margin of %.1f degrees (%g asked%s)", way,
                 v.stands ? "stands" : "falls", v.margin_rad * DEGREES, asked.gamma_rad * DEGREES,
                 before);
    } else {
        say_before(m, -1, before);
        snprintf(words, TITLE_SIZE, "With %s up it %s: %.1f degrees off (%g allowed%s)", way,
                 asked.kind == SF_STANCE_HANG ? "hangs" : "rocks", -v.margin_rad * DEGREES,
                 asked.tolerance_rad * DEGREES, before);
    }
}

static void draw_title(const cli_job *job, const model *m, size_t index, const sheet *s,
                       canvas *picture)
{
    const view *v = &s->views[index];
    char words[TITLE_SIZE];
    int size = s->size * 9 / 8;
    write_title(job, m, index, words);
    while (size > 7 && canvas_text_width(size, words) > v->width - 2 * s->size) {
        size--;
    }
    canvas_text(picture, v->x + s->size, v->y + s->size * 7 / 4, size, TEXT_LEFT, ink, words);
}

// ---------------------------------------------------------------------------------------------
// All of it
// ---------------------------------------------------------------------------------------------

static int is_framed(const view *v, const plot *p)
{
    return p->y > v->y + 1;
}

static sf_status draw_plot(cli_job *job, const model *m, const sheet *s, const view *v,
                           const plot *p, canvas *picture)
{
    sf_status status = plot_paint(p, sf_stand_outer(m->stand), &job->task, picture);
    if (status == SF_OK && is_framed(v, p)) {
        axes_draw(p, s->size * 7 / 8, picture);
    }
    return status;
}

// Of what the part is a part.
static const char *name_part(const view *v)
{
    double reach = MARKS_REACH * v->whole.unit * v->whole.pixel_mm;
    return 0.5 * extent(v->whole.window_low, v->whole.window_high) < reach
               ? "what the marks on the left hide"
               : "what the frame on the left holds";
}

static sf_status draw_view(cli_job *job, const model *m, const sheet *s, size_t index,
                           canvas *picture)
{
    const view *v = &s->views[index];
    sf_status status = draw_plot(job, m, s, v, &v->whole, picture);
    if (status == SF_OK && v->has_part) {
        status = draw_plot(job, m, s, v, &v->part, picture);
    }
    if (status == SF_OK && v->has_part && is_framed(v, &v->part)) {
        canvas_text(picture, v->part.x + v->part.width, v->part.y - s->size * 5 / 8,
                    s->size * 7 / 8, TEXT_RIGHT, ink, name_part(v));
    }
    if (status == SF_OK && is_framed(v, &v->whole)) {
        draw_title(job, m, index, s, picture);
    }
    return status;
}

static sf_status draw(cli_job *job, const model *m, sheet *s, canvas *picture)
{
    double across = picture->width / 56.0, down = picture->height / 40.0;
    s->size = (int)fmax(8, fmin(across, down));
    s->unit = s->size / 20.0;
    s->count = m->stances.count < PLANS_MAX ? m->stances.count : PLANS_MAX;
    for (size_t i = 0; i < s->count; i++) {
        if (!plan_make(job, m, i, &s->views[i].plan)) {
            return SF_ERR_MEMORY;
        }
        measure(m, &s->views[i]);
    }
    choose_words(s);
    lay_out(job, s);
    for (size_t i = 0; i < s->count; i++) {
        sf_status status = draw_view(job, m, s, i, picture);
        if (status != SF_OK) {
            return status;
        }
    }
    if (s->views[0].y + s->views[0].height < (int)picture->height) {
        key_draw(&s->key, s->size, s->unit, picture);
    }
    return SF_OK;
}

exit_status balance_picture_draw(cli_job *job, const model *m, canvas *picture)
{
    sheet s;
    memset(&s, 0, sizeof s);
    sf_status status = SF_ERR_MEMORY;
    if (canvas_create(picture, job->options.pixels[0], job->options.pixels[1])) {
        status = draw(job, m, &s, picture);
    }
    for (size_t i = 0; i < s.count; i++) {
        plan_release(&s.views[i].plan);
    }
    return status == SF_OK ? EXIT_GOOD
                           : job_fail_call(job, status, NULL, "the picture", EXIT_RESOURCE);
}
