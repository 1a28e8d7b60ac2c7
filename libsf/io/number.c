// SPDX-License-Identifier: MIT
// Decimal numbers in and out, correctly rounded, without a locale.
//
// Most numbers in files have few digits and a small exponent: then digits and power of ten are both
// exact doubles, and one product or quotient rounds correctly (W. Clinger, "How to Read Floating
// Point Numbers Accurately", 1990). Up to 19 digits and 10^19 either way, one product or quotient
// of integers in 128 bits does, with its remainder. Everything else goes through an exact decimal.
//
// Out, the same 128 bits give 15 to 17 digits of most numbers, and the exact decimal those of the
// rest. The fewest that read back as the same double are written.

#include "io/number.h"

#include "io/decimal.h"

#include <float.h>
#include <math.h>
#include <string.h>

// Ten to the powers that 64 bits hold.
static const uint64_t tens[] = {UINT64_C(1),
                                UINT64_C(10),
                                UINT64_C(100),
                                UINT64_C(1000),
                                UINT64_C(10000),
                                UINT64_C(100000),
                                UINT64_C(1000000),
                                UINT64_C(10000000),
                                UINT64_C(100000000),
                                UINT64_C(1000000000),
                                UINT64_C(10000000000),
                                UINT64_C(100000000000),
                                UINT64_C(1000000000000),
                                UINT64_C(10000000000000),
                                UINT64_C(100000000000000),
                                UINT64_C(1000000000000000),
                                UINT64_C(10000000000000000),
                                UINT64_C(100000000000000000),
                                UINT64_C(1000000000000000000),
                                UINT64_C(10000000000000000000)};

// a * b as high * 2^64 + low.
static void multiply(uint64_t a, uint64_t b, uint64_t *high, uint64_t *low)
{
    uint64_t a0 = a & UINT32_MAX, a1 = a >> 32, b0 = b & UINT32_MAX, b1 = b >> 32;
    uint64_t middle = a1 * b0 + (a0 * b0 >> 32), other = a0 * b1 + (middle & UINT32_MAX);
    *low = a * b;
    *high = a1 * b1 + (middle >> 32) + (other >> 32);
}

// --- in ------------------------------------------------------------------------------------------

static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static int same_word(const char *text, const char *word)
{
    for (; *text != '\0' && lower(*text) == *word; text++, word++) {
    }
    return *text == '\0' && *word == '\0';
}

static int is_digit(char c)
{
    return c >= '0' && c <= '9';
}

// Digits and point into d; returns what follows them, or NULL when there are none.
static const char *scan_digits(const char *text, sfi_decimal *d)
{
    int any = 0, after_point = 0, leading = 1;
    for (;; text++) {
        if (*text == '.' && !after_point) {
            after_point = 1;
            continue;
        }
        if (!is_digit(*text)) {
            break;
        }
        any = 1;
        leading = leading && *text == '0';
        if (leading) {
            d->point -= after_point && d->point > -100000;
        } else {
            if (d->count < SFI_DECIMAL_DIGITS) {
                d->digit[d->count++] = (uint8_t)(*text - '0');
            } else {
                d->more |= *text != '0';
            }
            d->point += !after_point && d->point < 100000;
        }
    }
    return any ? text : NULL;
}

// An exponent, clamped; returns what follows, or NULL when it has no digits.
static const char *scan_exponent(const char *text, int *exponent)
{
    int negative = *text == '-', value = 0;
    text += *text == '-' || *text == '+';
    if (!is_digit(*text)) {
        return NULL;
    }
    for (; is_digit(*text); text++) {
        value = value < 100000 ? 10 * value + (*text - '0') : value;
    }
    *exponent = negative ? -value : value;
    return text;
}

// The double nearest to (q + a bit more, if `more`) * 2^exponent, ties to even; q > 0, and where
// there is more, q >= 2^62. Within the normal range only.
static double round_bits(uint64_t q, int more, int exponent)
{
    for (; q >> 63 == 0; exponent--) {
        q <<= 1;
    }
    uint64_t kept = q >> 11, rest = q & 0x7ff;
    kept += rest > 0x400 || (rest == 0x400 && (more || (kept & 1)));
    return ldexp((double)kept, exponent + 11);
}

// n * 10^power, 0 <= power <= 19, n > 0.
static double times_ten(uint64_t n, int power)
{
    uint64_t high, low;
    int shift = 0;
    multiply(n, tens[power], &high, &low);
    if (high == 0) {
        return round_bits(low, 0, 0);
    }
    for (; high >> 63 == 0; shift++) {
        high = high << 1 | low >> 63;
        low <<= 1;
    }
    return round_bits(high, low != 0, 64 - shift);
}

// n / 10^power, 0 <= power <= 19, n > 0: 64 bits of quotient, one after the other.
static double over_ten(uint64_t n, int power)
{
    uint64_t d = tens[power], quotient = 0;
    int exponent = -63;
    for (; n >> 63 == 0; exponent--) {
        n <<= 1;
    }
    for (; d >> 63 == 0; exponent++) {
        d <<= 1;
    }
    int carry = 0;
    for (int bit = 0; bit < 64; bit++) {
        int fits = carry || n >= d;
        quotient = quotient << 1 | (uint64_t)fits;
        n -= fits ? d : 0;
        carry = (int)(n >> 63);
        n <<= 1;
    }
    return round_bits(quotient, n != 0 || carry, exponent);
}

// n * 10^power where that is quick; returns 0 where it is not.
static int scale(uint64_t n, int power, double *value)
{
    if (n == 0) {
        *value = 0.0;
        return 1;
    }
    if (power < -19 || power > 19) {
        return 0;
    }
#if FLT_EVAL_METHOD == 0          // elsewhere doubles are rounded twice
    if (n <= UINT64_C(1) << 53) { // all tens up to 10^22 are doubles
        *value = power < 0 ? (double)n / (double)tens[-power] : (double)n * (double)tens[power];
        return 1;
    }
#endif
    *value = power < 0 ? over_ten(n, -power) : times_ten(n, power);
    return 1;
}

// A number of up to 19 digits; returns 0 where it has more, or is none.
static int parse_quick(const char *text, double *value)
{
    uint64_t n = 0;
    int digits = 0, power = 0, exponent = 0, any = 0, after_point = 0;
    for (;; text++) {
        if (*text == '.' && !after_point) {
            after_point = 1;
            continue;
        }
        if (!is_digit(*text)) {
            break;
        }
        if (digits == 19 || power < -10000) {
            return 0;
        }
        any = 1;
        n = 10 * n + (uint64_t)(*text - '0');
        digits += n != 0;
        power -= after_point;
    }
    if (any && lower(*text) == 'e') {
        text = scan_exponent(text + 1, &exponent);
    }
    return any && text != NULL && *text == '\0' && scale(n, power + exponent, value);
}

static int parse_slow(const char *text, double *value)
{
    sfi_decimal d;
    int exponent = 0;
    d.count = d.point = d.more = 0;
    text = scan_digits(text, &d);
    if (text != NULL && lower(*text) == 'e') {
        text = scan_exponent(text + 1, &exponent);
    }
    if (text == NULL || *text != '\0') {
        return 0;
    }
    sfi_decimal_trim(&d);
    d.point += d.count > 0 ? exponent : 0;
    *value = sfi_decimal_nearest(&d);
    return 1;
}

int sfi_number_parse(const char *text, double *value)
{
    int negative = *text == '-';
    text += *text == '-' || *text == '+';
    double result;
    if (!parse_quick(text, &result)) {
        if (same_word(text, "inf") || same_word(text, "infinity")) {
            result = (double)INFINITY;
        } else if (same_word(text, "nan")) {
            result = (double)NAN;
        } else if (!parse_slow(text, &result)) {
            return 0;
        }
    }
    *value = negative ? -result : result;
    return 1;
}

int sfi_integer_parse(const char *text, int64_t *value)
{
    int negative = *text == '-';
    text += *text == '-' || *text == '+';
    if (!is_digit(*text)) {
        return 0;
    }
    int64_t n = 0;
    for (; is_digit(*text); text++) {
        int digit = *text - '0';
        if (n > (INT64_MAX - digit) / 10) {
            return 0;
        }
        n = 10 * n + digit;
    }
    if (*text != '\0') {
        return 0;
    }
    *value = negative ? -n : n;
    return 1;
}

// --- out -----------------------------------------------------------------------------------------

// `count` digits and a decimal exponent (0.d0d1... * 10^point) as text, in the shorter of two
// forms.
static size_t write_digits(int negative, const uint8_t *digit, int count, int point, char *text)
{
    char *out = text;
    while (count > 1 && digit[count - 1] == 0) {
        count--;
    }
    if (negative) {
        *out++ = '-';
    }
    if (point > 17 || point < -4) {
        *out++ = (char)('0' + digit[0]);
        if (count > 1) {
            *out++ = '.';
        }
        for (int i = 1; i < count; i++) {
            *out++ = (char)('0' + digit[i]);
        }
        int exponent = point - 1;
        *out++ = 'e';
        *out++ = exponent < 0 ? '-' : '+';
        exponent = exponent < 0 ? -exponent : exponent;
        if (exponent >= 100) {
            *out++ = (char)('0' + exponent / 100);
        }
        *out++ = (char)('0' + exponent / 10 % 10);
        *out++ = (char)('0' + exponent % 10);
    } else {
        for (int i = point < 1 ? point - 1 : 0; i < count || i < point; i++) {
            if (i == point && point > 0) {
                *out++ = '.';
            }
            *out++ = (char)('0' + (i >= 0 && i < count ? digit[i] : 0));
            if (i == point - 1 && point < 1) {
                *out++ = '.';
            }
        }
    }
    *out = '\0';
    return (size_t)(out - text);
}

// The integer nearest to m * 2^exponent * 10^power, half up; returns 0 where 128 bits do not do.
static int scaled(uint64_t m, int exponent, int power, uint64_t *n)
{
    uint64_t high, low;
    int shift = -exponent;
    if (power < 0 || power > 19 || shift < 1 || shift > 117) {
        return 0;
    }
    multiply(m, tens[power], &high, &low);
    uint64_t half_low = shift <= 64 ? UINT64_C(1) << (shift - 1) : 0;
    uint64_t half_high = shift > 64 ? UINT64_C(1) << (shift - 65) : 0;
    low += half_low;
    high += half_high + (low < half_low);
    if (shift < 64) {
        *n = high << (64 - shift) | low >> shift;
        return high >> shift == 0;
    }
    *n = high >> (shift - 64);
    return 1;
}

// Where the first digit of a number stands: 10^(point-1) <= value < 10^point, but for the rounding
// of these powers, from 10^-3 on; -3 for all that is smaller.
static int first_place(double value)
{
    static const double place[] = {1e-3, 1e-2, 1e-1, 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,
                                   1e7,  1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16};
    int i = 0;
    while (i < 20 && place[i] <= value) {
        i++;
    }
    return i - 3;
}

// The first `count` digits of value > 0, rounded, and their point.
static void round_digits(double value, int count, uint8_t digit[17], int *point)
{
    int exponent;
    uint64_t n, m = sfi_double_mantissa(value, &exponent);
    *point = first_place(value);
    if (*point == -3 || !scaled(m, exponent, count - *point, &n) || n < tens[count - 1] ||
        n > tens[count]) {
        sfi_decimal d;
        sfi_decimal_from(value, &d);
        sfi_decimal_round(&d, count);
        memset(digit, 0, 17);
        memcpy(digit, d.digit, (size_t)d.count);
        *point = d.point;
        return;
    }
    if (n == tens[count]) { // rounding carried over
        n = tens[count - 1];
        ++*point;
    }
    for (int i = count - 1; i >= 0; i--) {
        digit[i] = (uint8_t)(n % 10);
        n /= 10;
    }
}

size_t sfi_number_format(double value, char text[SFI_NUMBER_SIZE])
{
    size_t length = 0;
    if (value == 0.0) {
        memcpy(text, "0", 2);
        return 1;
    }
    for (int count = 15; count <= 17; count++) {
        uint8_t digit[17];
        int point;
        double back;
        round_digits(fabs(value), count, digit, &point);
        length = write_digits(value < 0.0, digit, count, point, text);
        if (sfi_number_parse(text, &back) && back == value) {
            break;
        }
    }
    return length;
}
