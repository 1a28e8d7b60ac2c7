// SPDX-License-Identifier: MIT
// Linear systems of a handful of unknowns.

#ifndef SF_GRADE_TONE_SOLVE_H
#define SF_GRADE_TONE_SOLVE_H

enum { SFI_SOLVE_MAX = 8 };

// Solve a x = b for n unknowns, in place: a is lost, b becomes x. Elimination with row pivots.
// Returns 0 where a pivot is not above `least` in size.
int sfi_solve(double a[][SFI_SOLVE_MAX], double *b, int n, double least);

#endif
