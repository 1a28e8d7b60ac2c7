// SPDX-License-Identifier: MIT
// The pointer at the Grade desk: points are found in the picture, the brush's place by a ray.

#include <math.h>
#include <string.h>

#include "app/event.h"
#include "desk/ray.h"
#include "grade.h"

// How near a point the pointer must be, in pixels.
#define REACH_PX 10.0

void grade_count_selected(grade *g)
{
    g->state.selected_count = 0;
    for (size_t i = 0; i < g->state.cage.point_count; i++) {
        g->state.selected_count += g->selected[i] > 0;
    }
    g->base.is_stale = 1;
}

// The nearest point in the picture; of those as near the first.
static int find_point(const grade *g, const desk_pointer *p)
{
    int best = -1;
    double least = REACH_PX;
    for (size_t i = 0; i < g->state.cage.point_count && g->state.shows_cage; i++) {
        double px = ray_away_px(p, g->state.cage.positions + 3 * i);
        if (px < least) {
            least = px;
            best = (int)i;
        }
    }
    return best;
}

// Whether a place is on the side of the cut that is seen.
static int is_seen(const grade_state *s, double cut_mm, const double at_mm[3])
{
    double beyond = at_mm[s->cut_axis] - cut_mm;
    return !s->is_cut || (s->keeps_beyond ? beyond >= 0 : beyond <= 0);
}

// Where the ray crosses the cut, if that is in the solid.
static void meet_section(const grade *g, const desk_pointer *p, ray_hit *best)
{
    const grade_section *c = &g->section;
    double t = (c->at_mm - p->eye_mm[c->axis]) / p->along[c->axis], at[3];
    if (c->solid == NULL || !(t > 0) || !(t < best->t)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        at[i] = p->eye_mm[i] + t * p->along[i];
    }
    double u = floor((at[(c->axis + 1) % 3] - c->origin_mm[0]) / c->pitch_mm);
    double v = floor((at[(c->axis + 2) % 3] - c->origin_mm[1]) / c->pitch_mm);
    if (u >= 0 && v >= 0 && u < c->width && v < c->height &&
        c->solid[(size_t)v * c->width + (size_t)u]) {
        best->t = t;
        memcpy(best->at_mm, at, sizeof at);
    }
}

// The place on what is seen of the shape.
static int find_place(grade *g, const desk_pointer *p)
{
    const grade_surface *s = &g->surface;
    double cut = grade_cut_mm(g);
    ray_hit hit = ray_none();
    for (size_t f = 0; f < s->face_count; f++) {
        const uint32_t *c = s->corners + 4 * f;
        const double *at[4];
        ray_hit here = hit;
        for (int i = 0; i < 4; i++) {
            at[i] = s->points + 3 * (size_t)c[i];
        }
        ray_meet(p, at[0], at[1], at[2], f, &here);
        ray_meet(p, at[0], at[2], at[3], f, &here);
        hit = here.t < hit.t && is_seen(&g->state, cut, here.at_mm) ? here : hit;
    }
    if (g->state.is_cut) {
        meet_section(g, p, &hit);
    }
    g->state.has_place = isfinite(hit.t);
    memcpy(g->state.place_mm, hit.at_mm, sizeof hit.at_mm);
    g->base.is_stale = 1;
    return g->state.has_place;
}

void grade_hover(desk *d, const desk_pointer *p)
{
    grade *g = (grade *)d;
    if (g->state.tool == GRADE_BRUSH) {
        g->state.hovered = -1;
        (void)find_place(g, p);
        return;
    }
    int over = find_point(g, p);
    if (over != g->state.hovered || g->state.has_place) {
        g->state.hovered = over;
        g->state.has_place = 0;
        d->is_stale = 1;
    }
}

// ---------------------------------------------------------------------------------------------
// Select
// ---------------------------------------------------------------------------------------------

static void select(grade *g, int point, unsigned mods)
{
    if ((mods & MOD_SHIFT) == 0) {
        memset(g->selected, 0, g->state.cage.point_count * sizeof *g->selected);
    }
    if (point >= 0) {
        g->selected[point] = (mods & MOD_SHIFT) != 0 && g->selected[point] > 0 ? 0 : 1;
    }
    grade_count_selected(g);
}

// ---------------------------------------------------------------------------------------------
// Paint
// ---------------------------------------------------------------------------------------------

// Along what the pointer has passed. Points are painted once for each move, so strength adds up
// only for adding and smoothing, which is what they are for.
static void paint(grade *g, const double from[3])
{
    grade_state *s = &g->state;
    sf_paint_brush brush = s->brush;
    memcpy(brush.from_mm, from, sizeof brush.from_mm);
    memcpy(brush.to_mm, s->place_mm, sizeof brush.to_mm);
    memset(g->weights, 0, s->cage.point_count * sizeof *g->weights);
    size_t touched = 0, changed = 0;
    sf_status status = sf_paint_select(g->cage, &brush, g->weights, &touched);
    if (status == SF_OK) {
        status = sf_paint_values(g->cage, s->channel, g->weights, s->operation, s->amount, NULL,
                                 &changed);
    }
    if (status != SF_OK) {
        grade_say(g, sf_status_message(status));
        return;
    }
    grade_say(g, touched == 0 ? "The brush meets no point of the cage: make it larger." : "");
    if (changed > 0) {
        g->has_moved = 1;
        grade_follow(g, 0);
    }
}

// ---------------------------------------------------------------------------------------------
// Move
// ---------------------------------------------------------------------------------------------

static void grip(grade *g, const desk_pointer *p, int point)
{
    if (point < 0) {
        return;
    }
    if (!(g->selected[point] > 0)) {
        select(g, point, p->mods);
    }
    g->is_pressed = ray_at_depth(p, g->state.cage.positions + 3 * (size_t)point, g->grip_mm);
}

static void move(grade *g, const desk_pointer *p)
{
    double now[3], by[3];
    size_t changed = 0;
    if (!ray_at_depth(p, g->grip_mm, now)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        by[i] = now[i] - g->grip_mm[i];
    }
    if (sf_paint_move(g->cage, g->selected, by, NULL, &changed) == SF_OK && changed > 0) {
        memcpy(g->grip_mm, now, sizeof now);
        g->has_moved = 1;
        grade_follow(g, 1);
    }
}

// ---------------------------------------------------------------------------------------------
// Calls
// ---------------------------------------------------------------------------------------------

void grade_press(desk *d, const desk_pointer *p)
{
    grade *g = (grade *)d;
    g->is_pressed = g->has_moved = 0;
    switch (g->state.tool) {
    case GRADE_BRUSH:
        if (find_place(g, p)) {
            g->is_pressed = 1;
            paint(g, g->state.place_mm);
        }
        break;
    case GRADE_MOVE:
        grip(g, p, find_point(g, p));
        break;
    default:
        select(g, find_point(g, p), p->mods);
    }
}

void grade_drag(desk *d, const desk_pointer *p)
{
    grade *g = (grade *)d;
    double from[3];
    if (!g->is_pressed) {
        return;
    }
    if (g->state.tool == GRADE_MOVE) {
        move(g, p);
        return;
    }
    memcpy(from, g->state.place_mm, sizeof from);
    if (g->state.tool == GRADE_BRUSH && find_place(g, p)) {
        paint(g, from);
    }
}

void grade_release(desk *d)
{
    grade *g = (grade *)d;
    if (g->has_moved) {
        grade_record(g);
    }
    g->is_pressed = g->has_moved = 0;
}
