// SPDX-License-Identifier: MIT
// Turning cells that are the wrong way out.
//
// The manual of VTK draws wedges with the first triangle seen from outside, its own shape functions
// and most programs with the first triangle seen from the second, and files come in both. A cell of
// the other kind shows at once: the three edges of every corner span a negative volume. It is
// turned by exchanging its two polygons (two corners, of a tetrahedron), which keeps it the same
// cell. A cell that is negative at some corners only is not of the other kind but damaged, and
// stays as it is, for whoever checks cages.

#include "io/cage_turn.h"

static const double *point(const double *positions, uint32_t index)
{
    return positions + 3 * (uint64_t)index;
}

// Six times the volume that the edges from `at` to a, b and c span.
static double spanned(const double *positions, uint32_t at, uint32_t a, uint32_t b, uint32_t c)
{
    const double *o = point(positions, at);
    double u[3], v[3], w[3];
    for (int i = 0; i < 3; i++) {
        u[i] = point(positions, a)[i] - o[i];
        v[i] = point(positions, b)[i] - o[i];
        w[i] = point(positions, c)[i] - o[i];
    }
    return u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) +
           u[2] * (v[0] * w[1] - v[1] * w[0]);
}

static int is_inverted(const uint32_t *corners, uint32_t count, const double *positions)
{
    if (count == 4) {
        return spanned(positions, corners[0], corners[1], corners[2], corners[3]) < 0;
    }
    uint32_t n = count / 2;
    for (uint32_t i = 0; i < n; i++) {
        uint32_t next = (i + 1) % n, before = (i + n - 1) % n;
        double lower =
            spanned(positions, corners[i], corners[next], corners[before], corners[n + i]);
        double upper =
            spanned(positions, corners[n + i], corners[n + before], corners[n + next], corners[i]);
        if (!(lower < 0 && upper < 0)) {
            return 0;
        }
    }
    return 1;
}

static void exchange(uint32_t *a, uint32_t *b)
{
    uint32_t kept = *a;
    *a = *b;
    *b = kept;
}

int sfi_cell_turn(uint32_t *corners, uint32_t count, const double *positions)
{
    if (!is_inverted(corners, count, positions)) {
        return 0;
    }
    if (count == 4) {
        exchange(&corners[1], &corners[2]);
        return 1;
    }
    for (uint32_t i = 0; i < count / 2; i++) {
        exchange(&corners[i], &corners[count / 2 + i]);
    }
    return 1;
}
