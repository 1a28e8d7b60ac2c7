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
// is linear in y, whatever turns; what depends on the shape is computed once, in terms of y.

#ifndef SF_BALANCE_BASIS_H
#define SF_BALANCE_BASIS_H

#include <stddef.h>

typedef struct sfi_basis {
    const double *rest;    // x, y, z of each point before bending
    const double *weights; // handle_count of each point, which sum to 1
    const double *centres; // x, y, z of each handle
    size_t count, handle_count;
} sfi_basis;

// Number of functions.
static inline size_t sfi_basis_size(const sfi_basis *basis)
{
    return 4 * basis->handle_count;
}

// Their values at point i.
static inline void sfi_basis_at(const sfi_basis *basis, size_t i, double *phi)
{
    const double *p = basis->rest + 3 * i, *w = basis->weights + i * basis->handle_count;
    for (size_t j = 0; j < basis->handle_count; j++) {
        const double *c = basis->centres + 3 * j;
        phi[4 * j] = w[j] * (p[0] - c[0]);
        phi[4 * j + 1] = w[j] * (p[1] - c[1]);
        phi[4 * j + 2] = w[j] * (p[2] - c[2]);
        phi[4 * j + 3] = w[j];
    }
}

#endif
