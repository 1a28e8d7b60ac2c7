// SPDX-License-Identifier: MIT
// The shares of a tetrahedron's corners at places.
//
// The slope of a corner's share is the cross product of the two edges of the side across from it,
// over the volume: the edges are those from the first corner, so that what is small is subtracted
// before it is multiplied.

#include "grade/sample/shares.h"

#include <math.h>
#include <string.h>

int sfi_shares_find(const sf_tets_view *v, size_t tet, sfi_shares *s)
{
    const uint32_t *c = v->corners + 4 * tet;
    double e[3][3];
    memcpy(s->origin, v->positions + 3 * (size_t)c[0], sizeof s->origin);
    for (uint32_t i = 0; i < 3; i++) {
        for (uint32_t axis = 0; axis < 3; axis++) {
            e[i][axis] = v->positions[3 * (size_t)c[i + 1] + axis] - s->origin[axis];
        }
    }
    double det = 0;
    for (uint32_t i = 0; i < 3; i++) {
        const double *a = e[(i + 1) % 3], *b = e[(i + 2) % 3];
        for (uint32_t axis = 0; axis < 3; axis++) {
            uint32_t u = (axis + 1) % 3, w = (axis + 2) % 3;
            s->slopes[i + 1][axis] = a[u] * b[w] - a[w] * b[u];
        }
    }
    for (uint32_t axis = 0; axis < 3; axis++) {
        det += e[0][axis] * s->slopes[1][axis];
    }
    if (!(fabs(det) > 0)) {
        return 0;
    }
    s->at[0] = 1;
    s->at[1] = s->at[2] = s->at[3] = 0;
    for (uint32_t axis = 0; axis < 3; axis++) {
        for (uint32_t i = 1; i < 4; i++) {
            s->slopes[i][axis] /= det;
        }
        s->slopes[0][axis] = -s->slopes[1][axis] - s->slopes[2][axis] - s->slopes[3][axis];
    }
    return 1;
}

void sfi_tet_box(const sf_tets_view *v, size_t tet, double low[3], double high[3])
{
    for (uint32_t axis = 0; axis < 3; axis++) {
        low[axis] = INFINITY;
        high[axis] = -INFINITY;
    }
    for (uint32_t i = 0; i < 4; i++) {
        const double *p = v->positions + 3 * (size_t)v->corners[4 * tet + i];
        for (uint32_t axis = 0; axis < 3; axis++) {
            low[axis] = p[axis] < low[axis] ? p[axis] : low[axis];
            high[axis] = p[axis] > high[axis] ? p[axis] : high[axis];
        }
    }
}
