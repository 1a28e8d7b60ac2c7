// SPDX-License-Identifier: MIT
// What the Balance desk shows: the hull, through which the cavity is seen, its ground with the
// support polygon and the safe region at the height of the centre of mass, that centre with a plumb
// line, the edge over which it would fall, and handles with the way that they have come.

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "balance.h"

typedef uint8_t ink[4];

static const ink hull_ink = {214, 201, 178, 88}, solid_ink = {214, 201, 178, 255};
static const ink cavity_ink = {196, 106, 66, 255};
static const ink grid_ink = {158, 160, 166, 255}, polygon_ink = {60, 66, 78, 255};
static const ink safe_ink = {46, 140, 70, 255}, falls_ink = {208, 50, 40, 255};
static const ink string_ink = {60, 66, 78, 255}, way_ink = {222, 178, 82, 255};
static const ink handle_ink = {86, 122, 162, 255}, locked_ink = {222, 178, 82, 255};
static const ink hovered_ink = {255, 236, 170, 255};

// A stage that is being filled.
typedef struct filling {
    const balance *b;
    stage *stage;
    int good;
} filling;

// ---------------------------------------------------------------------------------------------
// Parts
// ---------------------------------------------------------------------------------------------

static stage_vertex vertex(const double at[3], const ink colour)
{
    stage_vertex v = {{(float)at[0], (float)at[1], (float)at[2]}, {0, 0, 0, 0}};
    memcpy(v.rgba, colour, sizeof v.rgba);
    return v;
}

static void add_line(filling *f, stage_kind kind, const double a[3], const double b[3],
                     const ink colour)
{
    const stage_vertex ends[2] = {vertex(a, colour), vertex(b, colour)};
    f->good = f->good && stage_add(f->stage, kind, ends, NULL, 2);
}

static void add_point(filling *f, const double at[3], float radius_px, const ink colour)
{
    stage_point p = {{(float)at[0], (float)at[1], (float)at[2]}, radius_px, {0, 0, 0, 0}};
    memcpy(p.rgba, colour, sizeof p.rgba);
    f->good = f->good && stage_add_point(f->stage, &p);
}

static void add_ring(filling *f, const double *xyz, size_t count, const ink colour)
{
    for (size_t i = 0; i < count && count > 1; i++) {
        add_line(f, STAGE_LINE_OVER, xyz + 3 * i, xyz + 3 * ((i + 1) % count), colour);
    }
}

static void add_mesh(filling *f, sf_mesh_view m, stage_kind kind, const ink colour)
{
    size_t count = 3 * m.triangle_count;
    stage_vertex *all = count > 0 ? malloc(count * sizeof *all) : NULL;
    f->good = f->good && (count == 0 || all != NULL);
    for (size_t i = 0; all != NULL && i < count; i++) {
        all[i] = vertex(m.vertices + 3 * (size_t)m.triangles[i], colour);
    }
    f->good = f->good && stage_add(f->stage, kind, all, NULL, all != NULL ? count : 0);
    free(all);
}

// ---------------------------------------------------------------------------------------------
// The ground
// ---------------------------------------------------------------------------------------------

static double dot(const double a[3], const double b[3])
{
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
}

// Two directions across another, of length 1.
static void find_across(const double up[3], double x[3], double y[3])
{
    int least = fabs(up[0]) < 0.9 ? 0 : 1;
    double length = 0;
    for (int i = 0; i < 3; i++) {
        x[i] = (i == least) - up[least] * up[i];
        length += x[i] * x[i];
    }
    for (int i = 0; i < 3; i++) {
        x[i] /= sqrt(length);
    }
    for (int i = 0; i < 3; i++) {
        y[i] = up[(i + 1) % 3] * x[(i + 2) % 3] - up[(i + 2) % 3] * x[(i + 1) % 3];
    }
}

// Lines each 10 mm, below the shape and around; or each 100 mm, and so on, where it is large.
static void add_ground(filling *f, const sf_stance *stance)
{
    sf_stance_options o = sf_stance_get_options(stance);
    double x[3], y[3], middle[3], size = f->b->state.size_mm, step = 10;
    double ground = sf_stance_ground(stance);
    find_across(o.up, x, y);
    while (size / step > 24) {
        step *= 10;
    }
    int lines = (int)ceil(size / step) + 1;
    double away = ground - dot(o.up, f->b->state.com_mm) - 1e-3 * size;
    double u = floor(dot(f->b->state.com_mm, x) / step + 0.5) * step - dot(f->b->state.com_mm, x);
    double v = floor(dot(f->b->state.com_mm, y) / step + 0.5) * step - dot(f->b->state.com_mm, y);
    for (int i = 0; i < 3; i++) {
        middle[i] = f->b->state.com_mm[i] + away * o.up[i] + u * x[i] + v * y[i];
    }
    for (int axis = 0; axis < 2; axis++) {
        const double *along = axis == 0 ? x : y, *aside = axis == 0 ? y : x;
        for (int n = -lines; n <= lines; n++) {
            double a[3], b[3];
            for (int i = 0; i < 3; i++) {
                a[i] = middle[i] + n * step * aside[i] - lines * step * along[i];
                b[i] = middle[i] + n * step * aside[i] + lines * step * along[i];
            }
            add_line(f, STAGE_LINE, a, b, grid_ink);
        }
    }
}

// Cut a polygon in a plane by a half-space; `to` has room for one corner more.
static size_t cut(const double *from, size_t count, const sf_halfspace *h, double *to)
{
    size_t made = 0;
    for (size_t i = 0; i < count; i++) {
        const double *a = from + 3 * i, *b = from + 3 * ((i + 1) % count);
        double p = dot(h->normal, a) - h->offset_mm, q = dot(h->normal, b) - h->offset_mm;
        if (p >= 0) {
            memcpy(to + 3 * made++, a, 3 * sizeof *to);
        }
        if ((p < 0) != (q < 0)) {
            for (int k = 0; k < 3; k++) {
                to[3 * made + (size_t)k] = a[k] + p / (p - q) * (b[k] - a[k]);
            }
            made++;
        }
    }
    return made;
}

// The safe region at the height of the centre of mass, dropped onto the ground.
static void add_safe(filling *f, const sf_stance *stance, const double *polygon, size_t count)
{
    size_t planes = 0;
    double up[3];
    sf_stance_options o = sf_stance_get_options(stance);
    double rise = dot(o.up, f->b->state.com_mm) - sf_stance_ground(stance);
    (void)!sf_stance_halfspaces(stance, NULL, 0, &planes);
    size_t room = 3 * (count + planes + 1);
    sf_halfspace *all = malloc((planes + 1) * sizeof *all);
    double *a = malloc(room * sizeof *a), *b = malloc(room * sizeof *b);
    f->good = f->good && all != NULL && a != NULL && b != NULL;
    memcpy(up, o.up, sizeof up);
    if (f->good && sf_stance_halfspaces(stance, all, planes, &planes) == SF_OK) {
        for (size_t i = 0; i < 3 * count; i++) {
            a[i] = polygon[i] + rise * up[i % 3];
        }
        for (size_t k = 0; k < planes; k++) {
            double *was = a;
            count = cut(a, count, &all[k], b);
            a = b;
            b = was;
        }
        for (size_t i = 0; i < 3 * count; i++) {
            a[i] -= rise * up[i % 3];
        }
        add_ring(f, a, count, safe_ink);
    }
    free(all);
    free(a);
    free(b);
}

static void add_standing(filling *f, const sf_stance *stance, const sf_stance_verdict *v)
{
    size_t count = 0;
    (void)!sf_stance_polygon(stance, NULL, 0, &count);
    double *polygon = malloc(3 * (count + 1) * sizeof *polygon);
    f->good = f->good && polygon != NULL;
    if (f->good && sf_stance_polygon(stance, polygon, count, &count) == SF_OK) {
        add_ring(f, polygon, count, polygon_ink);
        add_safe(f, stance, polygon, count);
        if (!v->safe) {
            add_line(f, STAGE_LINE_OVER, v->edge_mm[0], v->edge_mm[1], falls_ink);
        }
        for (size_t i = 0; i < count; i++) {
            add_point(f, polygon + 3 * i, 2.5f, polygon_ink);
        }
    }
    free(polygon);
}

// ---------------------------------------------------------------------------------------------
// Weight and handles
// ---------------------------------------------------------------------------------------------

static void add_string(filling *f, const sf_stance_options *o)
{
    double end[3];
    for (int i = 0; i < 3; i++) {
        end[i] = o->point_mm[i] + 0.4 * f->b->state.size_mm * o->up[i];
    }
    add_line(f, STAGE_LINE_OVER, o->point_mm, end, string_ink);
    add_point(f, o->point_mm, 4, string_ink);
}

static void add_stance(filling *f, size_t i)
{
    const balance *b = f->b;
    const sf_stance *now = sf_stand_stance(b->state.has_report ? b->stand : NULL, i);
    const sf_stance *stance = now != NULL ? now : b->stances[i];
    const double *com = b->state.com_mm;
    if (stance == NULL) {
        return;
    }
    sf_stance_options o = sf_stance_get_options(stance);
    double foot[3], height = dot(o.up, com) - sf_stance_ground(stance);
    const uint8_t *colour = b->state.verdicts[i].safe ? safe_ink : falls_ink;
    for (int k = 0; k < 3; k++) {
        foot[k] = com[k] - height * o.up[k];
    }
    if (o.kind == SF_STANCE_HANG) {
        add_string(f, &o);
        add_line(f, STAGE_LINE_OVER, com, o.point_mm, colour);
    } else {
        add_ground(f, stance);
        add_standing(f, stance, &b->state.verdicts[i]);
        add_line(f, STAGE_LINE_OVER, com, foot, colour);
        add_point(f, foot, 3, colour);
    }
}

static void add_handles(filling *f)
{
    const balance_state *s = &f->b->state;
    for (size_t i = 0; i < s->plan.handle_count && s->plan.bends; i++) {
        double at[3];
        const balance_handle *h = &s->plan.handles[i];
        const uint8_t *colour = h->locked ? locked_ink : handle_ink;
        balance_handle_place(f->b, i, at);
        add_line(f, STAGE_LINE_OVER, h->at_mm, at, way_ink);
        colour = (int)i == s->hovered ? hovered_ink : colour;
        add_point(f, at, (int)i == s->selected ? 8.5f : 6, colour);
    }
}

int balance_show(desk *d, stage *s)
{
    filling f = {(const balance *)d, s, 1};
    const balance_state *now = &f.b->state;
    sf_mesh_view cavity = balance_cavity(f.b);
    add_mesh(&f, cavity, STAGE_SOLID, cavity_ink);
    if (now->shows_glass) {
        add_mesh(&f, balance_outer(f.b), STAGE_GLASS, hull_ink);
    } else {
        add_mesh(&f, balance_outer(f.b), STAGE_SOLID, solid_ink);
    }
    for (size_t i = 0; i < now->plan.stance_count; i++) {
        add_stance(&f, i);
    }
    add_handles(&f);
    add_point(&f, now->com_mm, 7, now->safe ? safe_ink : falls_ink);
    return f.good;
}
