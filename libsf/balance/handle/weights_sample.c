// SPDX-License-Identifier: MIT
// Weights at points: between the corners of a cell they are interpolated along x, y and z in turn.
//
// Interpolation keeps what holds at the corners: weights lie in [0, 1], sum to 1, and are exactly 1
// in the whole cell of a handle. Outside the domain a point has the weights of the closest one in
// it, so that they do not change along the axes on which the point was moved.

#include "balance/handle/weights.h"

#include "base/status.h"
#include "base/task.h"

#include <math.h>

enum { STRETCH = 4096 };

sf_weights_facts sf_weights_describe(const sf_weights *weights)
{
    sf_weights_facts none = {0};
    return weights != NULL ? weights->facts : none;
}

const double *sf_weights_centers(const sf_weights *weights)
{
    return weights != NULL ? weights->centers : NULL;
}

// Along one axis; exact where both are the same.
static inline double between(double low, double high, double part)
{
    return low + part * (high - low);
}

void sfi_weights_at(const sf_weights *weights, const sfi_spot *spot, double *w, double *gradient)
{
    const sfi_domain *d = &weights->domain;
    const double *corner[8];
    double part[3], slope[3];
    for (size_t axis = 0; axis < 3; axis++) {
        const double *plane = d->planes[axis] + d->place[3 * (size_t)spot->cell + axis];
        double edge = plane[1] - plane[0];
        part[axis] = (spot->at[axis] - plane[0]) / edge;
        slope[axis] = spot->moved[axis] ? 0 : 1 / edge;
    }
    for (size_t c = 0; c < 8; c++) {
        corner[c] = weights->values + weights->count * d->corners[8 * (size_t)spot->cell + c];
    }
    for (size_t j = 0; j < weights->count; j++) {
        double x[4], rise[4];
        for (size_t row = 0; row < 4; row++) {
            double low = corner[2 * row][j], high = corner[2 * row + 1][j];
            x[row] = between(low, high, part[0]);
            rise[row] = high - low;
        }
        double y[2] = {between(x[0], x[1], part[1]), between(x[2], x[3], part[1])};
        double z = between(y[0], y[1], part[2]);
        w[j] = z < 0 ? 0 : z > 1 ? 1 : z;
        if (gradient != NULL) {
            double *g = gradient + 3 * j;
            g[0] = slope[0] * between(between(rise[0], rise[1], part[1]),
                                      between(rise[2], rise[3], part[1]), part[2]);
            g[1] = slope[1] * between(x[1] - x[0], x[3] - x[2], part[2]);
            g[2] = slope[2] * (y[1] - y[0]);
        }
    }
}

static int is_point(const double p[3])
{
    return isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]);
}

sf_status sf_weights_at(const sf_weights *weights, const double p_mm[3], double *w,
                        double *gradient)
{
    if (weights == NULL || p_mm == NULL || w == NULL || !is_point(p_mm)) {
        return SF_ERR_ARGUMENT;
    }
    sfi_spot spot = sfi_domain_find(&weights->domain, p_mm);
    sfi_weights_at(weights, &spot, w, gradient);
    return SF_OK;
}

typedef struct points {
    const sf_weights *weights;
    const double *xyz;
    size_t count;
    double *w;
} points;

static void sample_stretch(void *context, size_t index)
{
    const points *p = context;
    size_t end = p->count - index * STRETCH > STRETCH ? (index + 1) * STRETCH : p->count;
    for (size_t i = index * STRETCH; i < end; i++) {
        sfi_spot spot = sfi_domain_find(&p->weights->domain, p->xyz + 3 * i);
        sfi_weights_at(p->weights, &spot, p->w + p->weights->count * i, NULL);
    }
}

sf_status sf_weights_sample(const sf_weights *weights, const double *xyz_mm, size_t count,
                            sf_task *task, double *w)
{
    points p = {weights, xyz_mm, count, w};
    if (weights == NULL || (count > 0 && (xyz_mm == NULL || w == NULL))) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < count; i++) {
        if (!is_point(xyz_mm + 3 * i)) {
            return SF_ERR_ARGUMENT;
        }
    }
    if (sf_task_is_cancelled(task)) {
        return SF_ERR_CANCELLED;
    }
    sfi_task_for(task, count / STRETCH + (count % STRETCH != 0), sample_stretch, &p);
    return SF_OK;
}
