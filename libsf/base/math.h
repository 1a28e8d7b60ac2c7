// SPDX-License-Identifier: MIT
// Elementary functions that give the same bytes on every machine.

#ifndef SF_BASE_MATH_H
#define SF_BASE_MATH_H

// Tangent of an angle in (-pi/2, pi/2); NaN outside that interval. Within 2 ulp.
double sfi_tan(double x);

// Inverse tangent, in [-pi/2, pi/2]; NaN for NaN. Within 2 ulp.
double sfi_atan(double x);

// e to the power of x; infinite or 0 where that leaves the doubles, NaN for NaN. Within 2 ulp where
// the result is a normal number.
double sfi_exp(double x);

#endif
