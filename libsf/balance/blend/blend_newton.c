// SPDX-License-Identifier: MIT
// The rest point of one bent point, by Newton's method.
//
// The weights are interpolated, so that their gradients jump from cell to cell; a step is therefore
// taken only as far as it brings the blend closer, by halves. Where the derivative has no inverse,
// the step goes down the square of the distance instead.

#include "balance/blend/blend_newton.h"

#include "balance/blend/blend_jacobian.h"

#include <math.h>

enum { STEPS = 24, HALVINGS = 12 };

static double distance(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt((x * x + y * y) + z * z);
}

// Where a rest point goes, without the derivative.
static void bend(const sfi_unbend *u, const double at[3], double bent[3])
{
    double w[SF_HANDLE_MAX];
    sfi_map mix;
    sfi_spot spot = sfi_domain_find(&u->weights->domain, at);
    sfi_weights_at(u->weights, &spot, w, NULL);
    sfi_maps_mix(u->maps, w, u->weights->count, &mix);
    sfi_map_turn(mix.matrix, at, bent);
    for (int n = 0; n < 3; n++) {
        bent[n] += mix.shift[n];
    }
}

sfi_rest sfi_unbend_try(const sfi_unbend *unbend, const double bent[3], const double at[3])
{
    sfi_rest rest = {{at[0], at[1], at[2]}, 0};
    double found[3];
    bend(unbend, at, found);
    rest.residual = distance(found, bent);
    return rest;
}

// x with m x = b. Returns 0 where m has no inverse that means anything.
static int solve3(const double m[9], const double b[3], double x[3])
{
    double size = 0, det = sfi_determinant(m);
    for (int n = 0; n < 9; n++) {
        size = fabs(m[n]) > size ? fabs(m[n]) : size;
    }
    if (!(fabs(det) > 1e-10 * size * size * size)) {
        return 0;
    }
    for (int n = 0; n < 3; n++) {
        double c[9];
        for (int k = 0; k < 9; k++) {
            c[k] = k % 3 == n ? b[k / 3] : m[k];
        }
        x[n] = sfi_determinant(c) / det;
    }
    return 1;
}

// The step from a rest point that should bring it to `bent`.
static int find_step(const sfi_unbend *u, const double bent[3], const double at[3], double step[3])
{
    double found[3], jacobian[9], by[3], square = 0;
    sfi_spot spot = sfi_domain_find(&u->weights->domain, at);
    sfi_jacobian(u->weights, u->maps, &spot, at, found, jacobian);
    for (int n = 0; n < 3; n++) {
        by[n] = bent[n] - found[n];
    }
    if (solve3(jacobian, by, step)) {
        return 1;
    }
    for (int n = 0; n < 9; n++) {
        square += jacobian[n] * jacobian[n];
    }
    for (int n = 0; n < 3; n++) {
        step[n] =
            square > 0
                ? ((jacobian[n] * by[0] + jacobian[3 + n] * by[1]) + jacobian[6 + n] * by[2]) /
                      square
                : 0;
    }
    return square > 0;
}

sfi_rest sfi_unbend_newton(const sfi_unbend *unbend, const double bent[3], sfi_rest from)
{
    for (int round = 0; round < STEPS && !(from.residual <= unbend->tolerance); round++) {
        double step[3], length = 1;
        if (!find_step(unbend, bent, from.at, step)) {
            break;
        }
        sfi_rest next = from;
        for (int halving = 0; halving < HALVINGS; halving++, length *= 0.5) {
            double at[3];
            for (int n = 0; n < 3; n++) {
                at[n] = from.at[n] + length * step[n];
            }
            if (isfinite(at[0]) && isfinite(at[1]) && isfinite(at[2])) {
                next = sfi_unbend_try(unbend, bent, at);
            }
            if (next.residual < (1 - 0.1 * length) * from.residual) {
                break;
            }
        }
        if (!(next.residual < from.residual)) {
            break;
        }
        from = next;
    }
    return from;
}

void sfi_unbend_follow(const sfi_unbend *unbend, const sfi_rest *rest, const double by[3],
                       double at[3])
{
    double found[3], jacobian[9], step[3];
    sfi_spot spot = sfi_domain_find(&unbend->weights->domain, rest->at);
    sfi_jacobian(unbend->weights, unbend->maps, &spot, rest->at, found, jacobian);
    int good = solve3(jacobian, by, step);
    for (int n = 0; n < 3; n++) {
        at[n] = rest->at[n] + (good ? step[n] : 0);
    }
}
