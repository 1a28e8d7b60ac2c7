// SPDX-License-Identifier: MIT
// A stance seen from above. The eye looks straight down; half-spaces are cut at the height at which
// the centre of mass lies now, which is what decides.

#include "plan_view.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Of the build axes, the one that is most level points right.
static void lay_axes(const double up[3], plan *p)
{
    int level = 0;
    for (int i = 1; i < 3; i++) {
        level = fabs(up[i]) < fabs(up[level]) - 1e-9 ? i : level;
    }
    double along = up[level], length = sqrt(1 - along * along);
    for (int i = 0; i < 3; i++) {
        p->right[i] = ((i == level) - along * up[i]) / length;
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        p->ahead[i] = up[j] * p->right[k] - up[k] * p->right[j];
    }
}

void plan_place(const plan *p, const double at[3], double xy[2])
{
    xy[0] = dot(p->right, at);
    xy[1] = dot(p->ahead, at);
}

static int take_polygon(const sf_stance *stance, plan *p)
{
    (void)!sf_stance_polygon(stance, NULL, 0, &p->corner_count);
    size_t count = p->corner_count;
    double *places = malloc((3 * count + 1) * sizeof *places);
    p->corners = malloc((2 * count + 1) * sizeof *p->corners);
    p->edges = malloc((count + 1) * sizeof *p->edges);
    int good = places != NULL && p->corners != NULL && p->edges != NULL &&
               sf_stance_polygon(stance, places, count, &count) == SF_OK;
    for (size_t i = 0; good && i < count; i++) {
        plan_place(p, places + 3 * i, p->corners + 2 * i);
    }
    for (size_t i = 0; good && count > 2 && i < count; i++) {
        const double *from = p->corners + 2 * i, *to = p->corners + 2 * ((i + 1) % count);
        double x = to[0] - from[0], y = to[1] - from[1], length = sqrt(x * x + y * y);
        if (length > 0) {
            border made = {-y / length, x / length, 0};
            made.c = -made.a * from[0] - made.b * from[1];
            p->edges[p->edge_count++] = made;
        }
    }
    free(places);
    return good;
}

static int take_safe(const sf_stance *stance, const double up[3], double height, plan *p)
{
    size_t count = 0;
    (void)!sf_stance_halfspaces(stance, NULL, 0, &count);
    sf_halfspace *all = malloc((count + 1) * sizeof *all);
    p->safes = malloc((count + 1) * sizeof *p->safes);
    int good = all != NULL && p->safes != NULL &&
               sf_stance_halfspaces(stance, all, count, &count) == SF_OK;
    for (size_t i = 0; good && i < count; i++) {
        double xy[2], rest = dot(all[i].normal, up) * height - all[i].offset_mm;
        plan_place(p, all[i].normal, xy);
        double length = sqrt(xy[0] * xy[0] + xy[1] * xy[1]);
        if (length > 1e-9) {
            border made = {xy[0] / length, xy[1] / length, rest / length};
            p->safes[p->safe_count++] = made;
        } else {
            p->is_never_safe = p->is_never_safe || rest < 0;
        }
    }
    free(all);
    return good;
}

int plan_make(const model *m, size_t index, plan *made)
{
    const sf_stance *stance = sf_stand_stance(m->stand, index);
    sf_stance_options asked = sf_stance_get_options(stance);
    memset(made, 0, sizeof *made);
    lay_axes(asked.up, made);
    plan_place(made, m->report.com_before_mm, made->before);
    plan_place(made, m->report.com_mm, made->after);
    return take_polygon(stance, made) &&
           take_safe(stance, asked.up, dot(asked.up, m->report.com_mm), made);
}

double plan_depth(const border *borders, size_t count, const double at[2])
{
    double least = INFINITY;
    for (size_t i = 0; i < count; i++) {
        double depth = borders[i].a * at[0] + borders[i].b * at[1] + borders[i].c;
        least = depth < least ? depth : least;
    }
    return least;
}

void plan_release(plan *p)
{
    free(p->corners);
    free(p->edges);
    free(p->safes);
    memset(p, 0, sizeof *p);
}
