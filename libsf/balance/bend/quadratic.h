// SPDX-License-Identifier: MIT
// Small convex quadratic programs.

#ifndef SF_BALANCE_QUADRATIC_H
#define SF_BALANCE_QUADRATIC_H

#include <sf/base.h>

// Minimise x . H x / 2 + g . x subject to row . x >= bound for each row.
typedef struct sfi_quadratic {
    size_t size;            // unknowns
    const double *hessian;  // size x size, symmetric, positive definite
    const double *gradient; // size
    size_t row_count;
    const double *rows;   // row_count x size
    const double *bounds; // row_count
} sfi_quadratic;

// Fills x and, unless NULL, the multiplier of each row (>= 0, and 0 where the row is slack).
// SF_ERR_INFEASIBLE: no x meets all rows; x and multipliers are as they were. SF_ERR_ARGUMENT: H is
// not positive definite. SF_ERR_MEMORY.
sf_status sfi_quadratic_solve(const sfi_quadratic *program, const sf_allocator *allocator,
                              double *x, double *multipliers);

#endif
