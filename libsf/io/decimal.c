// SPDX-License-Identifier: MIT
// Exact decimals: shifting by powers of two, digit by digit.
//
// A decimal that is multiplied and divided by powers of two stays a decimal, so any number can be
// brought exactly into the range where its integer part is a double's mantissa; what is left behind
// the point decides the rounding. Slow, plain and bounded: digits past the 800th can only matter as
// "something more", which one flag remembers, because no tie between doubles has more than 768.

#include "io/decimal.h"

#include <math.h>
#include <string.h>

// Beyond these decimal exponents everything is zero or infinite.
#define EXPONENT_MOST 400

void sfi_decimal_trim(sfi_decimal *d)
{
    while (d->count > 0 && d->digit[d->count - 1] == 0) {
        d->count--;
    }
    if (d->count == 0) {
        d->point = 0;
    }
}

static void put_digit(sfi_decimal *d, int index, unsigned digit)
{
    if (index < SFI_DECIMAL_DIGITS) {
        d->digit[index] = (uint8_t)digit;
    } else {
        d->more |= digit != 0;
    }
}

// Divide by 2^k, 1 <= k <= 56.
static void halve(sfi_decimal *d, int k)
{
    int read = 0, write = 0;
    uint64_t n = 0, mask = (UINT64_C(1) << k) - 1;
    while (n >> k == 0) {
        if (read >= d->count && n == 0) {
            d->count = d->point = 0;
            return;
        }
        n = 10 * n + (read < d->count ? d->digit[read] : 0);
        read++;
    }
    d->point -= read - 1;
    for (; read < d->count || n != 0; read++) {
        put_digit(d, write++, (unsigned)(n >> k));
        n = (n & mask) * 10 + (read < d->count ? d->digit[read] : 0);
    }
    d->count = write < SFI_DECIMAL_DIGITS ? write : SFI_DECIMAL_DIGITS;
    sfi_decimal_trim(d);
}

// Multiply by 2^k, 1 <= k <= 56.
static void twice(sfi_decimal *d, int k)
{
    uint8_t high[24];
    uint64_t carry = 0;
    for (int i = d->count - 1; i >= 0; i--) {
        carry += (uint64_t)d->digit[i] << k;
        d->digit[i] = (uint8_t)(carry % 10);
        carry /= 10;
    }
    int extra = 0;
    for (; carry != 0; carry /= 10) {
        high[extra++] = (uint8_t)(carry % 10);
    }
    int kept = d->count + extra < SFI_DECIMAL_DIGITS ? d->count : SFI_DECIMAL_DIGITS - extra;
    for (int i = kept; i < d->count; i++) {
        d->more |= d->digit[i] != 0;
    }
    memmove(d->digit + extra, d->digit, (size_t)kept);
    for (int i = 0; i < extra; i++) {
        d->digit[i] = high[extra - 1 - i];
    }
    d->count = kept + extra;
    d->point += extra;
    sfi_decimal_trim(d);
}

// The integer part of d < 2^60.
static uint64_t whole(const sfi_decimal *d)
{
    uint64_t n = 0;
    for (int i = 0; i < d->point; i++) {
        n = 10 * n + (i < d->count ? d->digit[i] : 0);
    }
    return n;
}

// The integer nearest to d < 2^60, ties to even.
static uint64_t rounded(const sfi_decimal *d)
{
    uint64_t n = whole(d);
    if (d->point < 0 || d->point >= d->count) {
        return n;
    }
    int next = d->digit[d->point];
    int tie = next == 5 && d->point + 1 == d->count && !d->more;
    return n + (uint64_t)(tie ? n & 1 : next >= 5);
}

// By scaling d into [2^52, 2^53).
double sfi_decimal_nearest(sfi_decimal *d)
{
    if (d->count == 0 || d->point < -EXPONENT_MOST) {
        return 0.0;
    }
    if (d->point > EXPONENT_MOST) {
        return (double)INFINITY;
    }
    int exponent = 0; // the number is d * 2^exponent
    while (d->point > 16) {
        halve(d, 50);
        exponent += 50;
    }
    while (d->point < 16) {
        int k = d->point < -16 ? 50 : 16 - d->point;
        twice(d, k);
        exponent -= k;
    }
    // Now 10^15 <= d < 10^16, about 2^50..2^54: settle on 53 bits, or fewer below the normal range.
    while (whole(d) >= UINT64_C(1) << 53 || exponent < -1074) {
        halve(d, 1);
        exponent++;
        if (d->count == 0) {
            return 0.0;
        }
    }
    while (whole(d) < UINT64_C(1) << 52 && exponent > -1074) {
        twice(d, 1);
        exponent--;
    }
    uint64_t n = rounded(d);
    if (n >= UINT64_C(1) << 53) { // rounding carried over
        n >>= 1;
        exponent++;
    }
    return ldexp((double)n, exponent);
}

void sfi_decimal_round(sfi_decimal *d, int count)
{
    if (d->count <= count) {
        return;
    }
    int up = d->digit[count] >= 5;
    d->count = count;
    while (up && d->count > 0) {
        if (d->digit[d->count - 1] < 9) {
            d->digit[d->count - 1]++;
            up = 0;
        } else {
            d->count--;
        }
    }
    if (up) {
        d->digit[0] = 1;
        d->count = 1;
        d->point++;
    }
}

uint64_t sfi_double_mantissa(double value, int *exponent)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    int biased = (int)(bits >> 52 & 0x7ff);
    uint64_t fraction = bits & ((UINT64_C(1) << 52) - 1);
    *exponent = biased == 0 ? -1074 : biased - 1075;
    return biased == 0 ? fraction : fraction | UINT64_C(1) << 52;
}

void sfi_decimal_from(double value, sfi_decimal *d)
{
    int exponent;
    uint64_t n = sfi_double_mantissa(value, &exponent);
    d->count = d->more = 0;
    uint8_t reversed[20];
    for (; n != 0; n /= 10) {
        reversed[d->count++] = (uint8_t)(n % 10);
    }
    for (int i = 0; i < d->count; i++) {
        d->digit[i] = reversed[d->count - 1 - i];
    }
    d->point = d->count;
    sfi_decimal_trim(d);
    for (; exponent > 0; exponent -= exponent < 50 ? exponent : 50) {
        twice(d, exponent < 50 ? exponent : 50);
    }
    for (; exponent<0; exponent += exponent> - 50 ? -exponent : 50) {
        halve(d, exponent > -50 ? -exponent : 50);
    }
}
