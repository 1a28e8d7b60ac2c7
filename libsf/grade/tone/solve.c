// SPDX-License-Identifier: MIT
// Elimination with row pivots, for matrices so small that nothing cleverer pays. The order of
// operations is fixed, so results are the same bytes everywhere.

#include "grade/tone/solve.h"

#include <math.h>

static void swap_rows(double a[][SFI_SOLVE_MAX], double *b, int n, int i, int j)
{
    for (int k = 0; k < n; k++) {
        double kept = a[i][k];
        a[i][k] = a[j][k];
        a[j][k] = kept;
    }
    double kept = b[i];
    b[i] = b[j];
    b[j] = kept;
}

int sfi_solve(double a[][SFI_SOLVE_MAX], double *b, int n, double least)
{
    for (int c = 0; c < n; c++) {
        int pivot = c;
        for (int r = c + 1; r < n; r++) {
            pivot = fabs(a[r][c]) > fabs(a[pivot][c]) ? r : pivot;
        }
        if (!(fabs(a[pivot][c]) > least)) {
            return 0;
        }
        swap_rows(a, b, n, c, pivot);
        for (int r = c + 1; r < n; r++) {
            double factor = a[r][c] / a[c][c];
            for (int k = c; k < n; k++) {
                a[r][k] -= factor * a[c][k];
            }
            b[r] -= factor * b[c];
        }
    }
    for (int r = n - 1; r >= 0; r--) {
        for (int k = r + 1; k < n; k++) {
            b[r] -= a[r][k] * b[k];
        }
        b[r] /= a[r][r];
    }
    return 1;
}
