// SPDX-License-Identifier: MIT
// Nearest point of a simplex, by its faces.
//
// The nearest point lies within some face, where it is the nearest point of the plane through that
// face's corners; and any face whose plane has its nearest point inside offers a point of the
// simplex. So the least of these is it: least squares with weights that are not negative, of which
// six corners leave 63 cases. Faces are tried from the largest down, and the whole simplex, where
// most points lie, settles the matter at once: no face is nearer than the plane around it.
//
// With edges e_i = q_i - q_0 from a corner, the plane's nearest point solves E^T E w = E^T (p -
// q_0), which is singular just where the face's corners lie in less than their plane; then a
// smaller face holds the same point.
//
// Source: C. L. Lawson, R. J. Hanson, "Solving Least Squares Problems", 1974, chapter 23, for what
// is solved; at this size looking at all faces is shorter than their way through some.

#include "grade/tone/nearest.h"

#include <string.h>

// A weight that rounding makes negative is none.
#define ROUNDING 1e-12

static double dot(const double *a, const double *b, int n)
{
    double sum = 0.0;
    for (int i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

static int bits_of(unsigned face)
{
    int count = 0;
    for (; face != 0; face &= face - 1) {
        count++;
    }
    return count;
}

// Corner numbers of a face; returns how many.
static int list_corners(unsigned face, int count, int *corners)
{
    int used = 0;
    for (int i = 0; i < count; i++) {
        if ((face >> i & 1) != 0) {
            corners[used++] = i;
        }
    }
    return used;
}

// Weights of the face's corners for the point of its plane nearest to p: 0 where there is none to
// be had or it lies outside the face.
static int plane_weights(const sfi_corners *c, const double *p, const int *corners, int count,
                         double *weights)
{
    double edges[SFI_SOLVE_MAX][SFI_SOLVE_MAX], to_p[SFI_SOLVE_MAX];
    double gram[SFI_SOLVE_MAX][SFI_SOLVE_MAX], w[SFI_SOLVE_MAX], largest = 0.0, sum = 0.0;
    const double *origin = c->at[corners[0]];
    int n = count - 1;
    for (int d = 0; d < c->dimensions; d++) {
        to_p[d] = p[d] - origin[d];
        for (int i = 0; i < n; i++) {
            edges[i][d] = c->at[corners[i + 1]][d] - origin[d];
        }
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            gram[i][j] = dot(edges[i], edges[j], c->dimensions);
        }
        w[i] = dot(edges[i], to_p, c->dimensions);
        largest = gram[i][i] > largest ? gram[i][i] : largest;
    }
    if (n > 0 && !sfi_solve(gram, w, n, ROUNDING * largest)) {
        return 0;
    }
    for (int i = 0; i < n; i++) {
        if (!(w[i] >= -ROUNDING)) {
            return 0;
        }
        weights[i + 1] = w[i] > 0.0 ? w[i] : 0.0;
        sum += weights[i + 1];
    }
    if (!(sum <= 1.0 + ROUNDING)) {
        return 0;
    }
    weights[0] = sum < 1.0 ? 1.0 - sum : 0.0;
    for (int i = 0; sum > 1.0 && i <= n; i++) {
        weights[i] /= sum;
    }
    return 1;
}

static double distance_of(const sfi_corners *c, const double *p, const double *weights)
{
    double sum = 0.0;
    for (int d = 0; d < c->dimensions; d++) {
        double at = 0.0;
        for (int i = 0; i < c->count; i++) {
            at += weights[i] * c->at[i][d];
        }
        sum += (at - p[d]) * (at - p[d]);
    }
    return sum;
}

double sfi_nearest(const sfi_corners *corners, const double *p, double *weights)
{
    double best = -1.0;
    unsigned all = (1u << corners->count) - 1;
    for (int size = corners->count; size > 0; size--) {
        for (unsigned face = 1; face <= all; face++) {
            double of_face[SFI_SOLVE_MAX], of_all[SFI_SOLVE_MAX] = {0};
            int at[SFI_SOLVE_MAX];
            if (bits_of(face) != size) {
                continue;
            }
            list_corners(face, corners->count, at);
            if (!plane_weights(corners, p, at, size, of_face)) {
                continue;
            }
            for (int i = 0; i < size; i++) {
                of_all[at[i]] = of_face[i];
            }
            double distance = distance_of(corners, p, of_all);
            if (best < 0.0 || distance < best) {
                best = distance;
                memcpy(weights, of_all, (unsigned)corners->count * sizeof *weights);
            }
            if (size == corners->count) {
                return best;
            }
        }
    }
    return best;
}
