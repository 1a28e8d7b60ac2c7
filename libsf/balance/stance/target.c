// SPDX-License-Identifier: MIT
// Where a centre of mass may lie, and where it should go.
//
// The safe set of a stance is an intersection of half-spaces n . c >= o. At the height of the
// centre of mass c, across up, it is a polygon: with x the displacement in the plane, a the part of
// n in the plane and b = o - n . c, all x with a . x >= b. The polygon is found by clipping a
// square around c, one half-plane after the other, so the target is the point of a few edges that
// is nearest to 0. (I. E. Sutherland, G. W. Hodgman, "Reentrant Polygon Clipping", 1974.)
//
// Slack t inside all half-spaces: the polygon of b + t. The largest t for which there is one is
// found by halving; below 0 it is the least violation, so that there is a target even where nothing
// is safe at this height. The tolerance of the clip keeps polygons that are a line or a point, as
// those of a string are.

#include "balance/stance/target.h"

#include <float.h>
#include <math.h>
#include <string.h>

#define HALVINGS 60
#define TOLERANCE 1e-12 // of the reach
#define PLATEAU 1e-9 // of the reach: places of so nearly the same slack are as good as each other

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void sfi_base_across(const sfi_base *base, double across[2][3])
{
    const double *u = base->up;
    int least = 0;
    for (int i = 1; i < 3; i++) {
        least = fabs(u[i]) < fabs(u[least]) ? i : least;
    }
    // The axis that is farthest from up, less its part along up.
    double length = 0;
    for (int i = 0; i < 3; i++) {
        across[0][i] = (i == least) - u[least] * u[i];
        length += across[0][i] * across[0][i];
    }
    length = sqrt(length);
    for (int i = 0; i < 3; i++) {
        across[0][i] /= length;
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        across[1][i] = u[j] * across[0][k] - u[k] * across[0][j];
    }
}

double sfi_bases_slack(const sfi_base *bases, size_t count, const double com_mm[3])
{
    double least = DBL_MAX;
    for (size_t i = 0; i < count; i++) {
        for (size_t j = 0; j < bases[i].count; j++) {
            const sf_halfspace *h = &bases[i].halfspaces[j];
            double slack = dot(h->normal, com_mm) - h->offset_mm;
            least = slack < least ? slack : least;
        }
    }
    return least == DBL_MAX ? 0 : least;
}

// ---------------------------------------------------------------------------------------------
// The polygon of what is safe
// ---------------------------------------------------------------------------------------------

typedef struct point {
    double x, y;
} point;

// Half-planes a . x >= b, and two polygons of as many corners and four more.
typedef struct section {
    size_t count;
    point *a;
    double *b;
    point *corners, *spare;
    size_t corner_count;
    double reach;
} section;

size_t sfi_base_scratch(size_t halfspace_count)
{
    return 7 * halfspace_count + 32;
}

static section cut_through(const sfi_base *base, const double com_mm[3], double reach,
                           double *scratch)
{
    double across[2][3];
    section s = {base->count, (point *)scratch, NULL, NULL, NULL, 0, reach};
    s.b = scratch + 2 * base->count;
    s.corners = (point *)(s.b + base->count);
    s.spare = s.corners + base->count + 8;
    sfi_base_across(base, across);
    for (size_t i = 0; i < base->count; i++) {
        const sf_halfspace *h = &base->halfspaces[i];
        s.a[i].x = dot(h->normal, across[0]);
        s.a[i].y = dot(h->normal, across[1]);
        s.b[i] = h->offset_mm - dot(h->normal, com_mm);
    }
    return s;
}

// Keep what lies inside one half-plane; a corner on its border lies inside.
static void clip(section *s, point a, double b)
{
    size_t count = 0;
    for (size_t i = 0; i < s->corner_count; i++) {
        point p = s->corners[i], q = s->corners[(i + 1) % s->corner_count];
        double dp = a.x * p.x + a.y * p.y - b + TOLERANCE * s->reach;
        double dq = a.x * q.x + a.y * q.y - b + TOLERANCE * s->reach;
        if (dp >= 0) {
            s->spare[count++] = p;
        }
        if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
            double t = dp / (dp - dq);
            point on = {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
            s->spare[count++] = on;
        }
    }
    point *swap = s->corners;
    s->corners = s->spare;
    s->spare = swap;
    s->corner_count = count;
}

// The polygon of all that has at least so much slack. Half-planes without a direction in the plane
// are not minded: nothing in it mends them. Each clip of a convex polygon adds one corner at most.
static void make_polygon(section *s, double slack)
{
    const double r = s->reach;
    const point square[4] = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    memcpy(s->corners, square, sizeof square);
    s->corner_count = 4;
    for (size_t i = 0; i < s->count && s->corner_count > 0; i++) {
        if (fabs(s->a[i].x) + fabs(s->a[i].y) > TOLERANCE) {
            clip(s, s->a[i], s->b[i] + slack);
        }
    }
}

// The point of the polygon's edges that is nearest to 0.
static point nearest_on_edges(const section *s)
{
    point best = {0, 0};
    double least = DBL_MAX;
    for (size_t i = 0; i < s->corner_count; i++) {
        point p = s->corners[i], q = s->corners[(i + 1) % s->corner_count];
        double dx = q.x - p.x, dy = q.y - p.y, length = dx * dx + dy * dy;
        double t = length > 0 ? -(p.x * dx + p.y * dy) / length : 0;
        t = t > 0 ? t < 1 ? t : 1 : 0;
        point on = {p.x + t * dx, p.y + t * dy};
        double distance = on.x * on.x + on.y * on.y;
        if (distance < least) {
            least = distance;
            best = on;
        }
    }
    return best;
}

// Whether 0 itself has so much slack.
static int holds_here(const section *s, double slack)
{
    for (size_t i = 0; i < s->count; i++) {
        if (fabs(s->a[i].x) + fabs(s->a[i].y) > TOLERANCE && s->b[i] + slack > 0) {
            return 0;
        }
    }
    return 1;
}

static int has_slack(section *s, double slack)
{
    make_polygon(s, slack);
    return s->corner_count > 0;
}

static point deepest(section *s)
{
    double low = s->reach, high = s->reach; // slack that can be had; slack that cannot
    for (size_t i = 0; i < s->count; i++) {
        low = -s->b[i] < low ? -s->b[i] : low; // 0 itself has that much
    }
    if (has_slack(s, high)) {
        low = high; // open to one side
    }
    for (int i = 0; i < HALVINGS && low < high; i++) {
        double middle = 0.5 * (low + high);
        *(has_slack(s, middle) ? &low : &high) = middle;
    }
    low -= PLATEAU * s->reach;
    point here = {0, 0};
    return holds_here(s, low) || !has_slack(s, low) ? here : nearest_on_edges(s);
}

sfi_offset sfi_base_target(const sfi_base *base, const double com_mm[3], sfi_target which,
                           double reach_mm, double *scratch)
{
    section s = cut_through(base, com_mm, reach_mm, scratch);
    point to = {0, 0};
    if (which == SFI_TARGET_DEEPEST) {
        to = deepest(&s);
    } else if (!holds_here(&s, 0)) {
        make_polygon(&s, 0);
        to = s.corner_count > 0 ? nearest_on_edges(&s) : deepest(&s);
    }
    sfi_offset offset = {{to.x, to.y}};
    return offset;
}
