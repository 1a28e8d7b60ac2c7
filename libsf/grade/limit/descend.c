// SPDX-License-Identifier: MIT
// Down from ring to ring, until one is regular.
//
// At random places that takes little more than one step. Close to an irregular edge or point it
// takes as many as the place's parameters have leading zeros, or ones; on it there is no end.
// There, after DEPTH steps, the piece is so small that what lies between the limits of its corners
// is filled in linearly. With many cells around an edge pieces shrink to 0.65 of their size or so
// with a step: 48 of them leave less than 1e-8 of it, and a deviation in the order of its square.

#include "grade/limit/descend.h"

#include "grade/limit/spline.h"

#include <string.h>

enum { DEPTH = 48, SLOPE_DEPTH = 20 };

// The limit of a corner of the first cell.
static void corner_limit(const sfi_kind *kind, uint32_t place, uint32_t width, const double *values,
                         double *value)
{
    uint32_t points = kind->ring.points;
    const double *weights = kind->corners + (size_t)points * place;
    const double *base = values + (size_t)place * width; // corners are the first points
    for (uint32_t c = 0; c < width; c++) {
        double sum = 0;
        for (uint32_t i = 0; i < points; i++) {
            sum += weights[i] * (values[(size_t)i * width + c] - base[c]);
        }
        value[c] = base[c] + sum;
    }
}

// The share of a corner at u; along `skipped`, if that is an axis, the derivative of it.
static double share(uint32_t dimension, const double *u, uint32_t place, uint32_t skipped)
{
    double weight = 1;
    for (uint32_t axis = 0; axis < dimension; axis++) {
        uint32_t high = place >> axis & 1;
        double here = axis == skipped ? 1 : u[axis];
        weight *= high ? here : axis == skipped ? -1 : 1 - here;
    }
    return weight;
}

// Between the limits of the corners, linearly along each axis.
static void blend_corners(const sfi_kind *kind, uint32_t width, const double *values,
                          const double *u, double *value, double *derivatives)
{
    uint32_t dimension = kind->ring.dimension;
    double corners[SFI_RING_CORNERS][SFI_SPLINE_WIDTH];
    for (uint32_t place = 0; place < 1u << dimension; place++) {
        corner_limit(kind, place, width, values, corners[place]);
    }
    for (uint32_t c = 0; c < width; c++) {
        double sums[4] = {0, 0, 0, 0}; // by each axis, then the value
        for (uint32_t place = 1; place < 1u << dimension; place++) {
            double rise = corners[place][c] - corners[0][c];
            for (uint32_t axis = 0; axis < 3; axis++) {
                sums[axis] += axis < dimension ? share(dimension, u, place, axis) * rise : 0;
            }
            sums[3] += share(dimension, u, place, dimension) * rise;
        }
        value[c] = corners[0][c] + sums[3];
        if (derivatives != NULL) {
            memcpy(derivatives + c * dimension, sums, dimension * sizeof *sums);
        }
    }
}

static void multiply(double *numbers, uint32_t count, double factor)
{
    for (uint32_t i = 0; i < count; i++) {
        numbers[i] *= factor;
    }
}

void sfi_limit_at(const sfi_atlas *atlas, uint32_t kind, uint32_t width, const double *values,
                  const double *u, double *scratch, double *value, double *derivatives)
{
    uint32_t dimension = atlas->dimension;
    double at[3], scale = 1;
    double *next = scratch, *other = scratch + (size_t)atlas->most_points * width;
    memcpy(at, u, dimension * sizeof *at);
    for (int depth = 0; !atlas->kinds[kind].is_regular && depth < DEPTH; depth++) {
        if (depth == SLOPE_DEPTH && derivatives != NULL) {
            blend_corners(&atlas->kinds[kind], width, values, at, value, derivatives);
            multiply(derivatives, dimension * width, scale);
            derivatives = NULL; // they are done
        }
        uint32_t place = 0;
        for (uint32_t axis = 0; axis < dimension; axis++) {
            uint32_t high = at[axis] >= 0.5;
            place |= high << axis;
            at[axis] = 2 * at[axis] - high;
        }
        sfi_matrix_apply(&atlas->kinds[kind].steps[place], width, values, next, NULL);
        kind = atlas->kinds[kind].children[place];
        scale *= 2;
        values = next;
        next = other;
        other = (double *)values;
    }
    if (atlas->kinds[kind].is_regular) {
        sfi_spline spline;
        sfi_spline_gather(&atlas->kinds[kind].net, dimension, width, values, &spline);
        sfi_spline_at(&spline, at, value, derivatives);
    } else {
        blend_corners(&atlas->kinds[kind], width, values, at, value, NULL);
    }
    if (derivatives != NULL) {
        multiply(derivatives, dimension * width, scale);
    }
}
