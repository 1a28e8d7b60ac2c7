// SPDX-License-Identifier: MIT
// Whether a spline of three parameters turns space inside out.

#ifndef SF_GRADE_LIMIT_JACOBIAN_H
#define SF_GRADE_LIMIT_JACOBIAN_H

#include "grade/limit/spline.h"

// Bounds of the determinant of a spline's derivatives over its cell: the least and the greatest of
// its coefficients as a polynomial of degree 8 along each axis (Bernstein's).
void sfi_jacobian_bounds(const sfi_spline *spline, double *least, double *greatest);

#endif
