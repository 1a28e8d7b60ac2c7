// SPDX-License-Identifier: MIT
// Tangent, its inverse and the exponential, out of the four operations that IEEE 754 rounds
// correctly.
//
// Every C library rounds tan() and atan() its own way, and a rule made from an angle must be the
// same integers on every machine. So these are built from + - * / alone, in a fixed order; the
// build forbids contraction into fused multiply-adds. They are made for accuracy, not for speed: a
// sum of solid angles asks for one arc tangent at its end (mesh/angle.c), a rule for one tangent.
//
// Constants that are no double come as a pair: the nearest double and the nearest double to what
// is left (106 bits in all). The pairs were computed with rational arithmetic from Machin's
// formula and from the series of atan(1/2).
//
// Source: J. H. Lambert's continued fraction for the tangent (1761) and Gregory's series for its
// inverse (1671); the error figures are measured in tests/unit/base/math.c.

#include "base/math.h"

#include <float.h>
#include <math.h>

// What follows holds for IEEE doubles alone, and everything that comes out of it with them.
#if defined(__FAST_MATH__)
#error "fast-math changes results; build without -ffast-math and -Ofast"
#endif
// Each type must be computed as itself: not doubles in 80 bits, and not floats as doubles either.
#if FLT_EVAL_METHOD != 0
#error "on 32-bit x86 build with -msse2 -mfpmath=sse, on s390x with -fexcess-precision=fast"
#endif

#define HALF_PI_HIGH 0x1.921fb54442d18p+0
#define HALF_PI_LOW 0x1.1a62633145c07p-54
#define QUARTER_PI_HIGH 0x1.921fb54442d18p-1
#define QUARTER_PI_LOW 0x1.1a62633145c07p-55
#define ATAN_HALF_HIGH 0x1.dac670561bb4fp-2
#define ATAN_HALF_LOW 0x1.a2b7f222f65e2p-56
#define ATAN_TWO_HIGH 0x1.1b6e192ebbe44p+0
#define ATAN_TWO_LOW 0x1.b1b466a88828ep-54
// The upper part of log 2 ends in 21 zeros, so that its product with an exponent is exact.
#define LOG_TWO_HIGH 0x1.62e42feep-1
#define LOG_TWO_LOW 0x1.a39ef35793c76p-33
#define LOG_TWO_INVERSE 0x1.71547652b82fep+0

// tan(x) = x / (1 - xx / (3 - xx / (5 - ...))). Returns the 3 - ... of that, so that the caller can
// choose how to round what is left. For xx <= (pi/4)^2 what is cut off lies below 2^-60.
static double tangent_fraction(double xx)
{
    double value = 21.0;
    for (int odd = 19; odd >= 3; odd -= 2) {
        value = odd - xx / value;
    }
    return value;
}

// Below pi/4: x + x r / (1 - r) with r = xx / (3 - ...) <= 0.22, where the second term, and with it
// its error, is small. Above: the cotangent of the complement y, 1/y - y / (3 - ...); y is exact to
// 106 bits because pi/2 - x is exact there (Sterbenz), and its low part enters to first order.
double sfi_tan(double x)
{
    double a = x < 0.0 ? -x : x;
    if (!(a < HALF_PI_HIGH)) {
        return NAN;
    }
    double result;
    if (a <= QUARTER_PI_HIGH) {
        double r = a * a / tangent_fraction(a * a);
        result = a + a * (r / (1.0 - r));
    } else {
        double exact = HALF_PI_HIGH - a;
        double y = exact + HALF_PI_LOW;
        double low = (exact - y) + HALF_PI_LOW;
        double inverse = 1.0 / y;
        result = inverse - (low * inverse * inverse + y / tangent_fraction(y * y));
    }
    return x < 0.0 ? -result : result;
}

// t (1 - tt/3 + tt tt/5 - ...) for |t| <= 1/4, as t plus the rest: fourteen terms leave 2^-60.
static double atan_rest(double t)
{
    double tt = t * t;
    double sum = 0.0;
    for (int odd = 29; odd >= 3; odd -= 2) {
        sum = (odd % 4 == 3 ? -1.0 : 1.0) / odd + tt * sum;
    }
    return t * (tt * sum);
}

// atan(a) = atan(c) + atan((a - c) / (1 + a c)) with c out of 0, 1/2, 1, 2, infinity, so that the
// last argument is at most 1/4.
double sfi_atan(double x)
{
    double a = x < 0.0 ? -x : x;
    double t, high, low;
    if (!(a == a)) {
        return x;
    }
    if (a < 0.25) {
        return x + atan_rest(x);
    }
    if (a < 0.75) {
        t = (a - 0.5) / (1.0 + 0.5 * a);
        high = ATAN_HALF_HIGH;
        low = ATAN_HALF_LOW;
    } else if (a < 1.5) {
        t = (a - 1.0) / (1.0 + a);
        high = QUARTER_PI_HIGH;
        low = QUARTER_PI_LOW;
    } else if (a < 4.0) {
        t = (a - 2.0) / (1.0 + 2.0 * a);
        high = ATAN_TWO_HIGH;
        low = ATAN_TWO_LOW;
    } else {
        t = -1.0 / a;
        high = HALF_PI_HIGH;
        low = HALF_PI_LOW;
    }
    double result = high + (t + (atan_rest(t) + low));
    return x < 0.0 ? -result : result;
}

// e^x = 2^k e^r with |r| <= log(2) / 2, where the series, summed from its small end, is cut off
// below 2^-58. The constants and the order are fixed, so the bytes are.
double sfi_exp(double x)
{
    if (!(x == x)) {
        return x;
    }
    if (x > 710.0) {
        return HUGE_VAL;
    }
    if (x < -746.0) {
        return 0.0;
    }
    double k = floor(x * LOG_TWO_INVERSE + 0.5);
    double r = (x - k * LOG_TWO_HIGH) - k * LOG_TWO_LOW;
    double sum = 1.0;
    for (int n = 14; n >= 2; n--) {
        sum = 1.0 + r * sum / n;
    }
    return ldexp(1.0 + r * sum, (int)k);
}
