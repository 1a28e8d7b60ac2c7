// SPDX-License-Identifier: MIT
// A property spread harmonically over tetrahedra.
//
// Over a tetrahedron the property is linear, and what flows is its gradient. With g_i the gradient
// of the function that is 1 at corner i and 0 at the others, and V the volume, the energy is V/2
// sum u_i u_j g_i.g_j, so that the off-diagonal weight of an edge is w_ij = V g_i.g_j, which for
// face normals n (twice the area, inwards) is n_i.n_j / (36 V); the diagonal is minus their sum.
// The six weights of each tetrahedron are kept, and the force on the points is gathered from them:
// f_i = sum_j w_ij (u_i - u_j). Free points are where it is zero, found by conjugate gradients with
// the diagonal before them. All sums run in the order of the tetrahedra, so the bytes are the same
// everywhere.

#include "base/memory.h"
#include "base/status.h"
#include "grade/tetra/tets.h"

#include <math.h>
#include <string.h>

enum { ITERATIONS_MAX = 20000 };
// What of the largest force at the start may be left.
#define SETTLED 1e-11

static const int edges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

typedef struct solving {
    sf_tets_view v;
    const uint8_t *fixed;
    double *weights; // six of each tetrahedron
    double *diagonal, *force, *along, *flow;
} solving;

// ---------------------------------------------------------------------------------------------
// Weights
// ---------------------------------------------------------------------------------------------

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        c[i] = a[j] * b[k] - a[k] * b[j];
    }
}

// Normals of the faces across from the corners, of twice their areas, inwards; and six volumes.
static double normals_of(const sf_tets_view *v, size_t tet, double normals[4][3])
{
    const double *p[4];
    double e[3][3], six = 0;
    for (int i = 0; i < 4; i++) {
        p[i] = v->positions + 3 * (size_t)v->corners[4 * tet + (size_t)i];
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            e[i][k] = p[i + 1][k] - p[0][k];
        }
    }
    cross(e[1], e[2], normals[1]);
    cross(e[2], e[0], normals[2]);
    cross(e[0], e[1], normals[3]);
    for (int k = 0; k < 3; k++) {
        six += e[0][k] * normals[1][k];
        normals[0][k] = -(normals[1][k] + normals[2][k] + normals[3][k]);
    }
    return fabs(six);
}

// n_i.n_j / (36 V) with 6 V = six: over 6 six. Those of flat tetrahedra, which carry nothing, are
// 0.
static void make_weights(solving *s)
{
    for (size_t t = 0; t < s->v.tet_count; t++) {
        double normals[4][3], *w = s->weights + 6 * t;
        double six = normals_of(&s->v, t, normals);
        for (int e = 0; e < 6; e++) {
            const double *a = normals[edges[e][0]], *b = normals[edges[e][1]];
            double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            w[e] = six > 0 ? -dot / (6 * six) : 0;
            w[e] = fabs(w[e]) <= 1e100 ? w[e] : 0;
            for (int i = 0; i < 2; i++) {
                s->diagonal[s->v.corners[4 * t + (size_t)edges[e][i]]] += w[e];
            }
        }
    }
}

// The force that values exert, on free points; 0 on the others.
static void gather(const solving *s, const double *values, double *force)
{
    memset(force, 0, s->v.point_count * sizeof *force);
    for (size_t t = 0; t < s->v.tet_count; t++) {
        const uint32_t *corner = s->v.corners + 4 * t;
        const double *w = s->weights + 6 * t;
        for (int e = 0; e < 6; e++) {
            uint32_t a = corner[edges[e][0]], b = corner[edges[e][1]];
            double flow = w[e] * (values[a] - values[b]);
            force[a] += flow;
            force[b] -= flow;
        }
    }
    for (size_t i = 0; i < s->v.point_count; i++) {
        force[i] = s->fixed[i] ? 0 : force[i];
    }
}

// ---------------------------------------------------------------------------------------------
// Conjugate gradients
// ---------------------------------------------------------------------------------------------

static double prepared(const solving *s, size_t i)
{
    return s->diagonal[i] > 0 ? s->force[i] / s->diagonal[i] : 0;
}

// The sum of force times prepared force, and the largest force.
static double measure(const solving *s, double *largest)
{
    double sum = 0;
    *largest = 0;
    for (size_t i = 0; i < s->v.point_count; i++) {
        sum += s->force[i] * prepared(s, i);
        *largest = fabs(s->force[i]) > *largest ? fabs(s->force[i]) : *largest;
    }
    return sum;
}

// One step along `along`; returns 0 where there is nowhere to go.
static int step(const solving *s, double *values, double sum)
{
    double slope = 0;
    gather(s, s->along, s->flow);
    for (size_t i = 0; i < s->v.point_count; i++) {
        slope += s->along[i] * s->flow[i];
    }
    if (!(slope > 0)) {
        return 0;
    }
    for (size_t i = 0; i < s->v.point_count; i++) {
        values[i] -= sum / slope * s->along[i];
        s->force[i] -= sum / slope * s->flow[i];
    }
    return 1;
}

static sf_status settle(const solving *s, double *values, sf_task *task, sf_spread_report *report)
{
    double start, now, sum, before;
    gather(s, values, s->force);
    sum = measure(s, &start);
    now = start;
    for (size_t i = 0; i < s->v.point_count; i++) {
        s->along[i] = prepared(s, i);
    }
    while (now > SETTLED * start && report->iterations < ITERATIONS_MAX) {
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        report->iterations++;
        if (!step(s, values, sum)) {
            break;
        }
        before = sum;
        sum = measure(s, &now);
        for (size_t i = 0; i < s->v.point_count; i++) {
            s->along[i] = prepared(s, i) + sum / before * s->along[i];
        }
    }
    report->residual = start > 0 ? now / start : 0;
    return report->residual <= 1e-6 ? SF_OK : SF_ERR_INFEASIBLE;
}

// ---------------------------------------------------------------------------------------------
// All of it
// ---------------------------------------------------------------------------------------------

// The least and the greatest value that is fixed.
static void range_of(const solving *s, const double *values, double range[2])
{
    int is_first = 1;
    for (size_t i = 0; i < s->v.point_count; i++) {
        if (s->fixed[i]) {
            range[0] = is_first || values[i] < range[0] ? values[i] : range[0];
            range[1] = is_first || values[i] > range[1] ? values[i] : range[1];
            is_first = 0;
        }
    }
}

static void hold_free(const solving *s, double *values, const double range[2])
{
    for (size_t i = 0; i < s->v.point_count; i++) {
        if (!s->fixed[i]) {
            values[i] = values[i] < range[0]   ? range[0]
                        : values[i] > range[1] ? range[1]
                                               : values[i];
        }
    }
}

static sf_status spread(solving *s, sf_tets *tets, size_t channel, double *values, sf_task *task,
                        sf_spread_report *report)
{
    double range[2] = {0, 0};
    memset(s->diagonal, 0, s->v.point_count * sizeof *s->diagonal);
    memcpy(values, s->v.channels[channel].values, s->v.point_count * sizeof *values);
    make_weights(s);
    range_of(s, values, range);
    hold_free(s, values, range);
    SF_TRY(settle(s, values, task, report));
    hold_free(s, values, range);
    return sf_tets_set_values(tets, channel, 0, s->v.point_count, values);
}

static size_t count_fixed(const sf_tets_view *v, const uint8_t *fixed)
{
    size_t count = 0;
    for (size_t i = 0; i < v->point_count; i++) {
        count += fixed[i] != 0;
    }
    return count;
}

sf_status sf_tets_spread(sf_tets *tets, size_t channel, const uint8_t *fixed,
                         const sf_allocator *allocator, sf_task *task, sf_spread_report *report)
{
    sf_allocator from = sfi_allocator_or_default(allocator);
    solving s = {sf_tets_get_view(tets), fixed, NULL, NULL, NULL, NULL, NULL};
    sf_spread_report done = {0, 0, 0};
    size_t points = s.v.point_count;
    if (tets == NULL || fixed == NULL || channel >= s.v.channel_count) {
        return SF_ERR_ARGUMENT;
    }
    if (tets->positions == NULL || s.v.channels[channel].indices != NULL) {
        return SF_ERR_UNSUPPORTED;
    }
    done.fixed = count_fixed(&s.v, fixed);
    if (done.fixed == 0) {
        return SF_ERR_ARGUMENT;
    }
    s.weights = sfi_alloc_array(&from, s.v.tet_count, 6 * sizeof(double));
    double *block = sfi_alloc_array(&from, points, 5 * sizeof(double)), *at = block;
    sf_status status = SF_ERR_MEMORY;
    if (s.weights != NULL && block != NULL) {
        s.diagonal = sfi_cut(&at, points);
        s.force = sfi_cut(&at, points);
        s.along = sfi_cut(&at, points);
        s.flow = sfi_cut(&at, points);
        status = spread(&s, tets, channel, sfi_cut(&at, points), task, &done);
    }
    sfi_free_array(&from, block, points, 5 * sizeof(double));
    sfi_free_array(&from, s.weights, s.v.tet_count, 6 * sizeof(double));
    if (status == SF_OK && report != NULL) {
        *report = done;
    }
    return status;
}
