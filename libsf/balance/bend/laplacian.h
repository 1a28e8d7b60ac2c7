// SPDX-License-Identifier: MIT
// How much a bent surface has lost its details, as a quadratic form in what bends it.

#ifndef SF_BALANCE_LAPLACIAN_H
#define SF_BALANCE_LAPLACIAN_H

#include "balance/bend/basis.h"
#include "balance/bend/incidence.h"

// Sum over the vertices of |T_i d_i - L_i|^2 as y . form y, with y the coefficients of the basis'
// functions, 3 numbers each; `form` is square, symmetric, of 3 * sfi_basis_size() rows. `norm`
// receives the sum of |d_i|^2, by which it is to be divided. The basis' points are the mesh's
// vertices. SF_ERR_MEMORY, SF_ERR_OVERFLOW or SF_ERR_CANCELLED leave both as they were.
sf_status sfi_laplacian_form(sf_mesh_view mesh, const sfi_incidence *incidence,
                             const sf_blend *basis, const sf_allocator *allocator, sf_task *task,
                             double *form, double *norm);

#endif
