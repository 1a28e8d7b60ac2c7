// SPDX-License-Identifier: MIT
// Signed integers of 128 bits, for signs of determinants that must not be wrong.
//
// On which side of a line or plane a point lies is a sum of products of differences. With integer
// coordinates and enough bits it is exact, and so the hulls that are built on it come out right
// however flat, thin or doubled their points are. No 128-bit integers of the compiler's are needed.
// Two's complement in two words; what does not fit is lost, so that bounds are the caller's.

#ifndef SF_BASE_EXACT_H
#define SF_BASE_EXACT_H

#include <stdint.h>

typedef struct sfi_exact {
    uint64_t low, high;
} sfi_exact;

static inline sfi_exact sfi_exact_add(sfi_exact a, sfi_exact b)
{
    sfi_exact sum = {a.low + b.low, a.high + b.high};
    sum.high += sum.low < a.low;
    return sum;
}

static inline sfi_exact sfi_exact_negate(sfi_exact a)
{
    sfi_exact negated = {~a.low + 1, ~a.high + (a.low == 0)};
    return negated;
}

static inline sfi_exact sfi_exact_subtract(sfi_exact a, sfi_exact b)
{
    return sfi_exact_add(a, sfi_exact_negate(b));
}

// a * b, of two words without sign.
static inline sfi_exact sfi_exact_widen(uint64_t a, uint64_t b)
{
    uint64_t a0 = (uint32_t)a, a1 = a >> 32, b0 = (uint32_t)b, b1 = b >> 32;
    uint64_t low = a0 * b0, middle = a1 * b0 + (low >> 32);
    uint64_t cross = a0 * b1 + (uint32_t)middle;
    sfi_exact product = {cross << 32 | (uint32_t)low, a1 * b1 + (middle >> 32) + (cross >> 32)};
    return product;
}

// a * b.
static inline sfi_exact sfi_exact_times(sfi_exact a, int64_t b)
{
    uint64_t magnitude = b < 0 ? 0 - (uint64_t)b : (uint64_t)b;
    sfi_exact product = sfi_exact_widen(a.low, magnitude);
    product.high += a.high * magnitude;
    return b < 0 ? sfi_exact_negate(product) : product;
}

static inline sfi_exact sfi_exact_of(int64_t a)
{
    sfi_exact value = {(uint64_t)a, a < 0 ? UINT64_MAX : 0};
    return value;
}

// The nearest double, or one beside it, of what is not negative.
static inline double sfi_exact_double(sfi_exact a)
{
    return (double)a.high * 18446744073709551616.0 + (double)a.low;
}

// -1, 0 or 1.
static inline int sfi_exact_sign(sfi_exact a)
{
    return a.high >> 63 != 0 ? -1 : (a.high | a.low) != 0;
}

// The largest power of two that keeps an extent within 2^bits when it is multiplied by it: what
// coordinates are scaled by before they are rounded to whole numbers. 1 for what is no extent.
static inline double sfi_exact_scale(double extent, int bits)
{
    double most = (double)(UINT64_C(1) << bits), scale = 1;
    if (!(extent > 1e-100 && extent < 1e100)) {
        return 1;
    }
    while (scale * extent > most) {
        scale /= 2;
    }
    while (scale * extent <= most / 2) {
        scale *= 2;
    }
    return scale;
}

// Sign of a * d - b * c; magnitudes up to 2^62.
static inline int sfi_exact_turn(int64_t a, int64_t b, int64_t c, int64_t d)
{
    return sfi_exact_sign(sfi_exact_subtract(sfi_exact_times(sfi_exact_of(a), d),
                                             sfi_exact_times(sfi_exact_of(b), c)));
}

#endif
