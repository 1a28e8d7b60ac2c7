// SPDX-License-Identifier: MIT
// What handles make of points, as a sum of fixed functions with coefficients.
//
// Handle j turns and scales by a matrix A_j about its centre c_j, and shifts by t_j:
//
//     v = sum over j of w_j(p) (A_j (p - c_j) + c_j + t_j).
//
// Each coordinate of v is a sum over the same 4 functions a handle,
//
//     phi = w_j (p - c_j)_x,  w_j (p - c_j)_y,  w_j (p - c_j)_z,  w_j,
//
// whose coefficients are points in space: the columns of A_j, then c_j + t_j. So v = sum phi_b y_b
// is linear in y, whatever turns; what depends on the shape is computed once, in terms of y. The
// points, their weights and the centres are an sf_blend.

#ifndef SF_BALANCE_BASIS_H
#define SF_BALANCE_BASIS_H

#include <sf/blend.h>

// Number of functions.
static inline size_t sfi_basis_size(const sf_blend *basis)
{
    return 4 * basis->handle_count;
}

// Their values at point i.
static inline void sfi_basis_at(const sf_blend *basis, size_t i, double *phi)
{
    const double *p = basis->rest_mm + 3 * i, *w = basis->weights + i * basis->handle_count;
    for (size_t j = 0; j < basis->handle_count; j++) {
        const double *c = basis->centers_mm + 3 * j;
        phi[4 * j] = w[j] * (p[0] - c[0]);
        phi[4 * j + 1] = w[j] * (p[1] - c[1]);
        phi[4 * j + 2] = w[j] * (p[2] - c[2]);
        phi[4 * j + 3] = w[j];
    }
}

#endif
