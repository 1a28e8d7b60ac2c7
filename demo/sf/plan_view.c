// SPDX-License-Identifier: MIT
// A stance seen from above. The eye looks straight down; half-spaces are cut at the height at which
// the centre of mass lies now, which is what decides.
//
// The plan has the input's own numbers on its sides: where one axis of the input points up, the
// other two are x and y of the plan, both growing as one expects, to the right and ahead. Of a pose
// that is aslant, one that is level keeps its numbers; the other side counts along the ground.

#include "plan_view.h"

#include "turned.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LEVEL 1e-9 // a direction that rises by less is level

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double made[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        made[i] = a[j] * b[k] - a[k] * b[j];
    }
}

// ---------------------------------------------------------------------------------------------
// Axes
// ---------------------------------------------------------------------------------------------

// An axis of the input, laid onto the ground.
static void lay_down(int which, const double up[3], double laid[3])
{
    double length = sqrt(1 - up[which] * up[which]);
    for (int i = 0; i < 3; i++) {
        laid[i] = ((i == which) - up[which] * up[i]) / length;
    }
}

static void name_side(int which, const double side[3], char name[PLAN_NAME_SIZE])
{
    if (side[which] > 1 - LEVEL) {
        snprintf(name, PLAN_NAME_SIZE, "%c (mm)", "xyz"[which]);
    } else {
        snprintf(name, PLAN_NAME_SIZE, "along the ground, to +%c (mm)", "xyz"[which]);
    }
}

// With the axis i nearest to up, the next one points right and the one after that ahead; the other
// way round where it points down.
static void lay_axes(const cli_job *job, const double up_in_build[3], plan *p)
{
    double up[3], right[3], ahead[3];
    int i = 0;
    turned_to_input(job, up_in_build, up);
    for (int j = 1; j < 3; j++) {
        i = fabs(up[j]) > fabs(up[i]) ? j : i;
    }
    int a = (i + (up[i] > 0 ? 1 : 2)) % 3, b = 3 - i - a;
    if (fabs(up[b]) < fabs(up[a])) {
        lay_down(b, up, ahead);
        cross(ahead, up, right);
    } else {
        lay_down(a, up, right);
        cross(up, right, ahead);
    }
    name_side(a, right, p->names[0]);
    name_side(b, ahead, p->names[1]);
    turned_to_build(job, right, p->right);
    turned_to_build(job, ahead, p->ahead);
}

void plan_place(const plan *p, const double at[3], double xy[2])
{
    xy[0] = dot(p->right, at);
    xy[1] = dot(p->ahead, at);
}

// ---------------------------------------------------------------------------------------------
// Regions
// ---------------------------------------------------------------------------------------------

static double depth_of(const border *b, const double at[2])
{
    return b->a * at[0] + b->b * at[1] + b->c;
}

double plan_depth(const region *r, const double at[2])
{
    double least = INFINITY;
    for (size_t i = 0; i < r->border_count; i++) {
        least = fmin(least, depth_of(&r->borders[i], at));
    }
    return least;
}

void plan_take_in(const double at[2], double low[2], double high[2])
{
    for (int i = 0; i < 2; i++) {
        low[i] = fmin(low[i], at[i]);
        high[i] = fmax(high[i], at[i]);
    }
}

static void measure(region *r)
{
    for (int i = 0; i < 2; i++) {
        r->low[i] = INFINITY;
        r->high[i] = -INFINITY;
    }
    for (size_t i = 0; i < r->corner_count; i++) {
        plan_take_in(r->corners + 2 * i, r->low, r->high);
    }
}

static int take_support(const sf_stance *stance, plan *p)
{
    region *r = &p->support;
    (void)!sf_stance_polygon(stance, NULL, 0, &r->corner_count);
    size_t count = r->corner_count;
    double *places = malloc((3 * count + 1) * sizeof *places);
    r->corners = malloc((2 * count + 1) * sizeof *r->corners);
    r->borders = malloc((count + 1) * sizeof *r->borders);
    int good = places != NULL && r->corners != NULL && r->borders != NULL &&
               sf_stance_polygon(stance, places, count, &count) == SF_OK;
    for (size_t i = 0; good && i < count; i++) {
        plan_place(p, places + 3 * i, r->corners + 2 * i);
    }
    for (size_t i = 0; good && count > 2 && i < count; i++) {
        const double *from = r->corners + 2 * i, *to = r->corners + 2 * ((i + 1) % count);
        double x = to[0] - from[0], y = to[1] - from[1], length = sqrt(x * x + y * y);
        if (length > 0) {
            border made = {-y / length, x / length, 0};
            made.c = -made.a * from[0] - made.b * from[1];
            r->borders[r->border_count++] = made;
        }
    }
    free(places);
    return good;
}

// The half-spaces at a height. Returns whether a level one rules all of it out.
static int cut_halfspaces(const plan *p, const sf_halfspace *all, size_t count, const double up[3],
                          double height, region *r)
{
    int is_empty = 0;
    for (size_t i = 0; i < count; i++) {
        double xy[2], rest = dot(all[i].normal, up) * height - all[i].offset_mm;
        plan_place(p, all[i].normal, xy);
        double length = sqrt(xy[0] * xy[0] + xy[1] * xy[1]);
        if (length > LEVEL) {
            border made = {xy[0] / length, xy[1] / length, rest / length};
            r->borders[r->border_count++] = made;
        } else {
            is_empty = is_empty || rest < 0;
        }
    }
    return is_empty;
}

// The part of a convex polygon inside of a border.
static size_t clip(const border *b, const double *from, size_t count, double *to)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        const double *here = from + 2 * i, *next = from + 2 * ((i + 1) % count);
        double depth = depth_of(b, here), ahead = depth_of(b, next);
        if (depth >= 0) {
            memcpy(to + 2 * kept++, here, 2 * sizeof *to);
        }
        if ((depth < 0) != (ahead < 0)) {
            double t = depth / (depth - ahead);
            to[2 * kept] = here[0] + t * (next[0] - here[0]);
            to[2 * kept++ + 1] = here[1] + t * (next[1] - here[1]);
        }
    }
    return kept;
}

// Corners of the region within its borders, by clipping a square that is larger than it can be.
static void find_corners(region *r, double *spare, const double middle[2], double reach)
{
    static const int sides[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < 8; i++) {
        r->corners[i] = middle[i % 2] + reach * sides[i / 2][i % 2];
    }
    r->corner_count = 4;
    for (size_t i = 0; i < r->border_count; i++) {
        double *other = r->corners;
        r->corner_count = clip(&r->borders[i], other, r->corner_count, spare);
        r->corners = spare;
        spare = other;
    }
}

static int take_safe(const sf_stance *stance, const double up[3], double height, double reach,
                     plan *p)
{
    size_t count = 0;
    region *r = &p->safe;
    (void)!sf_stance_halfspaces(stance, NULL, 0, &count);
    size_t room = 2 * (2 * count + 8); // clipping adds a corner for each border at most
    sf_halfspace *all = malloc((count + 1) * sizeof *all);
    double *corners = malloc(2 * room * sizeof *corners);
    r->borders = malloc((count + 1) * sizeof *r->borders);
    r->corners = malloc(room * sizeof *r->corners);
    int good = all != NULL && corners != NULL && r->borders != NULL && r->corners != NULL &&
               sf_stance_halfspaces(stance, all, count, &count) == SF_OK;
    if (good && count > 0 && !cut_halfspaces(p, all, count, up, height, r)) {
        double *owned = r->corners;
        r->corners = corners;
        find_corners(r, corners + room, p->after, reach);
        memcpy(owned, r->corners, 2 * r->corner_count * sizeof *owned);
        r->corners = owned;
    }
    free(all);
    free(corners);
    return good;
}

int plan_make(const cli_job *job, const model *m, size_t index, plan *made)
{
    const sf_stance *stance = sf_stand_stance(m->stand, index);
    sf_stance_options asked = sf_stance_get_options(stance);
    memset(made, 0, sizeof *made);
    made->kind = asked.kind;
    lay_axes(job, asked.up, made);
    plan_place(made, m->report.com_before_mm, made->before);
    plan_place(made, m->report.com_mm, made->after);
    int good = take_support(stance, made) &&
               take_safe(stance, asked.up, dot(asked.up, m->report.com_mm), 4 * m->size_mm, made);
    measure(&made->support);
    measure(&made->safe);
    return good;
}

static void release(region *r)
{
    free(r->corners);
    free(r->borders);
    memset(r, 0, sizeof *r);
}

void plan_release(plan *p)
{
    release(&p->support);
    release(&p->safe);
}
