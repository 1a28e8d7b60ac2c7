// SPDX-License-Identifier: MIT
// Uniform cubic B-splines of two and three parameters.
//
// Coefficients are kept less those of one point, and that is added at the end: a property that is
// constant over a cell then is exactly that, whatever the weights round to.

#include "grade/limit/spline.h"

#include <string.h>

// The weights of the four points along an axis, and of their derivative.
static void weigh(double u, double weights[4], double slopes[4])
{
    double v = 1 - u, uu = u * u, vv = v * v;
    weights[0] = vv * v / 6;
    weights[1] = (3 * uu * u - 6 * uu + 4) / 6;
    weights[2] = (3 * vv * v - 6 * vv + 4) / 6;
    weights[3] = uu * u / 6;
    slopes[0] = -vv / 2;
    slopes[1] = (3 * uu - 4 * u) / 2;
    slopes[2] = (4 * v - 3 * vv) / 2;
    slopes[3] = uu / 2;
}

// Layer `at` of an axis is missing: it lies as far from the next one as that from the one behind.
static void extend(sfi_spline *s, uint32_t axis, uint32_t high)
{
    uint32_t step = 1u << 2 * axis, count = s->dimension == 3 ? 64 : 16;
    for (uint32_t i = 0; i < count; i++) {
        if ((i >> 2 * axis & 3) == (high ? 3u : 0u)) {
            uint32_t near = high ? i - step : i + step, far = high ? near - step : near + step;
            for (uint32_t c = 0; c < s->width; c++) {
                s->rest[i * s->width + c] =
                    2 * s->rest[near * s->width + c] - s->rest[far * s->width + c];
            }
        }
    }
}

void sfi_spline_gather(const sfi_net *net, uint32_t dimension, uint32_t width, const double *values,
                       sfi_spline *spline)
{
    uint32_t count = dimension == 3 ? 64 : 16;
    spline->dimension = dimension;
    spline->width = width;
    memcpy(spline->base, values, width * sizeof *values); // of the cell's first corner
    for (uint32_t i = 0; i < count; i++) {
        uint32_t point = net->at[i] != SFI_NONE ? net->at[i] : 0;
        for (uint32_t c = 0; c < width; c++) {
            spline->rest[i * width + c] = values[(size_t)point * width + c] - spline->base[c];
        }
    }
    for (uint32_t axis = 0; axis < dimension; axis++) {
        for (uint32_t high = 0; high < 2; high++) {
            if (net->outside >> (2 * axis + high) & 1) {
                extend(spline, axis, high);
            }
        }
    }
}

// Sum four lines of `width` numbers, `stride` apart.
static void sum4(const double *from, uint32_t stride, uint32_t width, const double weights[4],
                 double *to)
{
    for (uint32_t c = 0; c < width; c++) {
        to[c] = weights[0] * from[c] + weights[1] * from[stride + c] +
                weights[2] * from[2 * stride + c] + weights[3] * from[3 * stride + c];
    }
}

// Along the last axis first: it leaves the most to add at once.
static void sum_axes(const sfi_spline *s, const double (*weights)[4], double *value)
{
    double flat[16 * SFI_SPLINE_WIDTH], line[4 * SFI_SPLINE_WIDTH];
    uint32_t w = s->width;
    const double *plane = s->rest;
    if (s->dimension == 3) {
        sum4(s->rest, 16 * w, 16 * w, weights[2], flat);
        plane = flat;
    }
    sum4(plane, 4 * w, 4 * w, weights[1], line);
    sum4(line, w, w, weights[0], value);
}

void sfi_spline_at(const sfi_spline *spline, const double *u, double *value, double *derivatives)
{
    double weights[3][4], slopes[3][4], slope[SFI_SPLINE_WIDTH];
    for (uint32_t axis = 0; axis < spline->dimension; axis++) {
        weigh(u[axis], weights[axis], slopes[axis]);
    }
    sum_axes(spline, (const double(*)[4])weights, value);
    for (uint32_t c = 0; c < spline->width; c++) {
        value[c] += spline->base[c];
    }
    for (uint32_t axis = 0; derivatives != NULL && axis < spline->dimension; axis++) {
        double mixed[3][4];
        memcpy(mixed, weights, sizeof mixed);
        memcpy(mixed[axis], slopes[axis], sizeof mixed[axis]);
        sum_axes(spline, (const double(*)[4])mixed, slope);
        for (uint32_t c = 0; c < spline->width; c++) {
            derivatives[c * spline->dimension + axis] = slope[c];
        }
    }
}

void sfi_spline_halve(const sfi_spline *from, uint32_t axis, uint32_t high, sfi_spline *to)
{
    uint32_t step = 1u << 2 * axis;
    *to = *from;
    for (uint32_t i = 0; i < 64; i++) {
        if ((i >> 2 * axis & 3) != 0) {
            continue;
        }
        for (uint32_t c = 0; c < 3; c++) {
            double p[4], q[5];
            for (uint32_t k = 0; k < 4; k++) {
                p[k] = from->rest[3 * (i + k * step) + c];
            }
            q[0] = (p[0] + p[1]) / 2;
            q[1] = (p[0] + 6 * p[1] + p[2]) / 8;
            q[2] = (p[1] + p[2]) / 2;
            q[3] = (p[1] + 6 * p[2] + p[3]) / 8;
            q[4] = (p[2] + p[3]) / 2;
            for (uint32_t k = 0; k < 4; k++) {
                to->rest[3 * (i + k * step) + c] = q[k + high];
            }
        }
    }
}
