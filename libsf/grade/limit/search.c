// SPDX-License-Identifier: MIT
// The inverse of the shape: from a point in space to parameters.
//
// Over a regular cell Newton's method gets there from the middle in three or four steps, unless the
// cell is badly bent or the point lies outside of it. Cells that are irregular are cut, as for
// evaluation, and of the pieces those looked into whose control points could reach the point: the
// shape lies within their box. If need be regular ones are cut, too: then the search ends for sure,
// at a piece that is smaller than what is asked for. Along edges where a block is smooth, where the
// shape's derivatives span nothing any more and Newton's method crawls, that is what finds it.

#include "grade/limit/search.h"

#include "grade/limit/boxes.h"
#include "grade/limit/spline.h"

#include <math.h>
#include <string.h>

enum { RING_DEPTH = 48, SPLINE_DEPTH = 26, NEWTON_STEPS = 10 };

// A part of the piece: where its parameters begin in it, and how long they are.
typedef struct part {
    double origin[3], size;
    int depth;
} part;

// Values of rings, one for each depth; then splines, one for each depth and axis.
size_t sfi_search_scratch(const sfi_atlas *atlas)
{
    return 3 * (size_t)atlas->most_points * RING_DEPTH +
           3 * SPLINE_DEPTH * (sizeof(sfi_spline) / sizeof(double));
}

static sfi_spline *spline_at(const sfi_search *s, int depth, uint32_t axis)
{
    double *splines = s->scratch + 3 * (size_t)s->atlas->most_points * RING_DEPTH;
    return (sfi_spline *)(void *)splines + 3 * depth + axis;
}

static double distance2(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return x * x + y * y + z * z;
}

// Take a place if it is nearer than the best so far. Returns 1 when it is close enough.
static int offer(sfi_search *s, const part *p, const double u[3], const double at[3])
{
    double d2 = distance2(at, s->point);
    if (d2 <= s->reach2) {
        s->reach2 = d2;
        s->found = 1;
        for (uint32_t axis = 0; axis < 3; axis++) {
            s->u[axis] = p->origin[axis] + p->size * u[axis];
        }
    }
    return d2 <= s->close * s->close;
}

// The step of Newton's method, by Cramer's rule; damped where the derivatives span little.
static void newton_step(const double j[9], const double r[3], double du[3])
{
    double cofactors[9] = {
        j[4] * j[8] - j[5] * j[7], j[5] * j[6] - j[3] * j[8], j[3] * j[7] - j[4] * j[6],
        j[7] * j[2] - j[8] * j[1], j[8] * j[0] - j[6] * j[2], j[6] * j[1] - j[7] * j[0],
        j[1] * j[5] - j[2] * j[4], j[2] * j[3] - j[0] * j[5], j[0] * j[4] - j[1] * j[3]};
    double det = j[0] * cofactors[0] + j[1] * cofactors[1] + j[2] * cofactors[2];
    for (uint32_t i = 0; i < 3; i++) {
        double sum = cofactors[i] * r[0] + cofactors[3 + i] * r[1] + cofactors[6 + i] * r[2];
        double step = fabs(det) > 0 ? sum / det : 0;
        du[i] = step > 0.5 ? 0.5 : step < -0.5 ? -0.5 : step;
    }
}

// From the middle of a regular part towards the point, without leaving the part. Once there, one
// step more: it costs little, and takes what is left to its square.
static int newton(sfi_search *s, const sfi_spline *spline, const part *p)
{
    double u[3] = {0.5, 0.5, 0.5}, at[3], j[9];
    int is_there = 0;
    for (int i = 0; i < NEWTON_STEPS; i++) {
        double r[3], du[3], moved = 0;
        sfi_spline_at(spline, u, at, j);
        if (offer(s, p, u, at) && is_there++) {
            break;
        }
        for (uint32_t axis = 0; axis < 3; axis++) {
            r[axis] = s->point[axis] - at[axis];
        }
        newton_step(j, r, du);
        for (uint32_t axis = 0; axis < 3; axis++) {
            double next = u[axis] + du[axis];
            next = next < 0 ? 0 : next > 1 ? 1 : next;
            moved += fabs(next - u[axis]);
            u[axis] = next;
        }
        if (moved < 1e-15) {
            break;
        }
    }
    return is_there;
}

static sfi_box spline_box(const sfi_spline *spline)
{
    sfi_box box = sfi_box_around(spline->rest, 64);
    for (uint32_t axis = 0; axis < 3; axis++) {
        box.low[axis] += spline->base[axis];
        box.high[axis] += spline->base[axis];
    }
    return box;
}

static part half_of(const part *p, uint32_t axis, uint32_t high)
{
    part half = *p;
    half.origin[axis] += high ? p->size / 2 : 0;
    return half;
}

static int search_spline(sfi_search *s, const sfi_spline *spline, const part *p);

// The eight parts of a regular part, of which those are looked into that could reach the point.
static int search_halves(sfi_search *s, const sfi_spline *spline, const part *p, uint32_t axis)
{
    if (axis == 3) {
        part smaller = *p;
        smaller.size /= 2;
        smaller.depth++;
        return search_spline(s, spline, &smaller);
    }
    for (uint32_t high = 0; high < 2; high++) {
        sfi_spline *half = spline_at(s, p->depth, axis);
        part there = half_of(p, axis, high);
        sfi_spline_halve(spline, axis, high, half);
        sfi_box box = spline_box(half);
        if (sfi_box_distance2(&box, s->point) <= s->reach2 &&
            search_halves(s, half, &there, axis + 1)) {
            return 1;
        }
    }
    return 0;
}

static int search_spline(sfi_search *s, const sfi_spline *spline, const part *p)
{
    sfi_box box = spline_box(spline);
    if (sfi_box_distance2(&box, s->point) > s->reach2) {
        return 0;
    }
    if (s->left == 0) {
        return 1;
    }
    s->left--;
    if (newton(s, spline, p)) {
        return 1;
    }
    return s->split && p->depth < SPLINE_DEPTH && search_halves(s, spline, p, 0);
}

// A part so small that it is one point.
static int search_speck(sfi_search *s, const sfi_box *box, const part *p)
{
    static const double middle[3] = {0.5, 0.5, 0.5};
    double at[3];
    for (uint32_t axis = 0; axis < 3; axis++) {
        at[axis] = (box->low[axis] + box->high[axis]) / 2;
    }
    return offer(s, p, middle, at);
}

static int search_ring(sfi_search *s, uint32_t kind, const double *values, const part *p)
{
    const sfi_kind *k = &s->atlas->kinds[kind];
    sfi_box box = sfi_box_around(values, k->ring.points);
    if (sfi_box_distance2(&box, s->point) > s->reach2) {
        return 0;
    }
    if (s->left == 0) {
        return 1;
    }
    s->left--;
    if (k->is_regular) {
        sfi_spline spline;
        sfi_spline_gather(&k->net, 3, 3, values, &spline);
        return search_spline(s, &spline, p);
    }
    if (p->depth == RING_DEPTH || distance2(box.low, box.high) <= s->close * s->close) {
        return search_speck(s, &box, p);
    }
    double *ring = s->scratch + 3 * (size_t)s->atlas->most_points * (size_t)p->depth;
    for (uint32_t place = 0; place < 8; place++) {
        part piece = {{0, 0, 0}, p->size / 2, p->depth + 1};
        for (uint32_t axis = 0; axis < 3; axis++) {
            piece.origin[axis] = p->origin[axis] + (place >> axis & 1 ? p->size / 2 : 0);
        }
        sfi_matrix_apply(&k->steps[place], 3, values, ring, NULL);
        if (search_ring(s, k->children[place], ring, &piece)) {
            return 1;
        }
    }
    return 0;
}

int sfi_search_piece(sfi_search *search, uint32_t kind, const double *values)
{
    static const part whole = {{0, 0, 0}, 1, 0};
    return search_ring(search, kind, values, &whole);
}
