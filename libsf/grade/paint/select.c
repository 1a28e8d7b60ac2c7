// SPDX-License-Identifier: MIT
// Selections: how much each point of a cage is meant.

#include "grade/paint/weights.h"

#include "base/math.h"
#include "base/status.h"

#include <math.h>

sf_paint_brush sf_paint_brush_default(void)
{
    sf_paint_brush brush = {sizeof brush,      {0, 0, 0},   {0, 0, 0}, 1, 1,
                            SF_FALLOFF_SMOOTH, SF_PAINT_ALL};
    return brush;
}

static int is_brush(const sf_paint_brush *b)
{
    for (int axis = 0; axis < 3; axis++) {
        if (!(fabs(b->from_mm[axis]) <= SFI_CAGE_REACH && fabs(b->to_mm[axis]) <= SFI_CAGE_REACH)) {
            return 0;
        }
    }
    return b->struct_size == sizeof *b && b->radius_mm > 0 && b->strength > 0 && b->strength <= 1 &&
           (unsigned)b->falloff <= SF_FALLOFF_GAUSSIAN &&
           (b->where == SF_PAINT_ALL || b->where == SF_PAINT_OUTSIDE ||
            b->where == SF_PAINT_INSIDE);
}

int sfi_weights_are_good(const double *weights, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (!(weights[i] >= 0 && weights[i] <= 1)) {
            return 0;
        }
    }
    return 1;
}

// The distance of a point from the line that the middle is drawn along.
static double distance(const sf_paint_brush *b, const double *p)
{
    double along[3], to[3], dot = 0, square = 0, sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        along[axis] = b->to_mm[axis] - b->from_mm[axis];
        to[axis] = p[axis] - b->from_mm[axis];
        dot += along[axis] * to[axis];
        square += along[axis] * along[axis];
    }
    double t = square > 0 ? dot / square : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    for (int axis = 0; axis < 3; axis++) {
        double d = to[axis] - t * along[axis];
        sum += d * d;
    }
    return sqrt(sum);
}

// At t, 0 to 1. A Gaussian has no rim; what it has left at three standard deviations is taken off,
// so that nothing jumps there.
static double fall(sf_falloff falloff, double t)
{
    switch (falloff) {
    case SF_FALLOFF_CONSTANT:
        return 1;
    case SF_FALLOFF_LINEAR:
        return 1 - t;
    case SF_FALLOFF_SMOOTH:
        return 1 - t * t * (3 - 2 * t);
    default:
        return (sfi_exp(-4.5 * t * t) - sfi_exp(-4.5)) / (1 - sfi_exp(-4.5));
    }
}

static double weigh(const sf_paint_brush *b, const double *p)
{
    double t = distance(b, p) / b->radius_mm;
    return t <= 1 ? b->strength * fall(b->falloff, t) : 0;
}

sf_status sf_paint_select(const sf_cage *cage, const sf_paint_brush *brush, double *weights,
                          size_t *touched)
{
    if (cage == NULL || brush == NULL || weights == NULL || !is_brush(brush) ||
        !sfi_weights_are_good(weights, cage->points)) {
        return SF_ERR_ARGUMENT;
    }
    size_t count = 0;
    for (uint32_t i = 0; i < cage->points; i++) {
        int outside = cage->complex.point_outside[i];
        if ((brush->where == SF_PAINT_OUTSIDE && !outside) ||
            (brush->where == SF_PAINT_INSIDE && outside)) {
            continue;
        }
        double weight = weigh(brush, cage->positions + 3 * (size_t)i);
        count += weight > 0;
        weights[i] = weight > weights[i] ? weight : weights[i];
    }
    if (touched != NULL) {
        *touched = count;
    }
    return SF_OK;
}
