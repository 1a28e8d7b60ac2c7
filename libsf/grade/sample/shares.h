// SPDX-License-Identifier: MIT
// The shares of a tetrahedron's corners at places: its barycentric coordinates.

#ifndef SF_GRADE_SAMPLE_SHARES_H
#define SF_GRADE_SAMPLE_SHARES_H

#include <sf/tetra.h>

// As linear functions: at x, y, z of the first corner's frame.
typedef struct sfi_shares {
    double origin[3];
    double slopes[4][3];
    double at[4]; // at the origin
} sfi_shares;

// The shares of a tetrahedron. Returns 0 for a flat one.
int sfi_shares_find(const sf_tets_view *v, size_t tet, sfi_shares *s);

// The box around a tetrahedron.
void sfi_tet_box(const sf_tets_view *v, size_t tet, double low[3], double high[3]);

#endif
