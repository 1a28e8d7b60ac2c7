// SPDX-License-Identifier: MIT
// Weights at points: between the corners of a cell they are interpolated along x, y and z in turn.
//
// Interpolation keeps what holds at the corners: weights lie in [0, 1], sum to 1, and are 1 in the
// whole cell of a handle. Outside the domain a point has the weights of the closest one in it, so
// that they do not change along the axes on which the point was moved.

#include "balance/weights.h"

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

// Shares of the eight corners, and with `slope` their derivatives along each axis.
static void share_corners(const sfi_domain *d, const sfi_spot *spot, double share[8],
                          double (*slope)[8])
{
    double up[3], down[3], edge[3];
    for (int axis = 0; axis < 3; axis++) {
        const double *plane = d->planes[axis] + d->place[3 * (size_t)spot->cell + (size_t)axis];
        edge[axis] = plane[1] - plane[0];
        up[axis] = (spot->at[axis] - plane[0]) / edge[axis];
        down[axis] = 1 - up[axis];
    }
    for (int c = 0; c < 8; c++) {
        double x = (c & 1) != 0 ? up[0] : down[0], y = (c & 2) != 0 ? up[1] : down[1],
               z = (c & 4) != 0 ? up[2] : down[2];
        share[c] = x * y * z;
        if (slope != NULL) {
            slope[0][c] = spot->moved[0] ? 0 : ((c & 1) != 0 ? y * z : -y * z) / edge[0];
            slope[1][c] = spot->moved[1] ? 0 : ((c & 2) != 0 ? x * z : -x * z) / edge[1];
            slope[2][c] = spot->moved[2] ? 0 : ((c & 4) != 0 ? x * y : -x * y) / edge[2];
        }
    }
}

void sfi_weights_at(const sf_weights *weights, const sfi_spot *spot, double *w, double *gradient)
{
    double share[8], slope[3][8];
    const double *corner[8];
    share_corners(&weights->domain, spot, share, gradient != NULL ? slope : NULL);
    for (size_t c = 0; c < 8; c++) {
        corner[c] =
            weights->values + weights->count * weights->domain.corners[8 * (size_t)spot->cell + c];
    }
    for (size_t j = 0; j < weights->count; j++) {
        double low = 0, high = 0;
        for (size_t c = 0; c < 4; c++) {
            low += share[c] * corner[c][j];
            high += share[4 + c] * corner[4 + c][j];
        }
        w[j] = low + high;
        for (size_t axis = 0; gradient != NULL && axis < 3; axis++) {
            low = high = 0;
            for (size_t c = 0; c < 4; c++) {
                low += slope[axis][c] * corner[c][j];
                high += slope[axis][4 + c] * corner[4 + c][j];
            }
            gradient[3 * j + axis] = low + high;
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
