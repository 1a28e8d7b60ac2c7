// SPDX-License-Identifier: MIT
// A decimal number of up to 800 digits, and the exact ways between it and a double.

#ifndef SF_IO_DECIMAL_H
#define SF_IO_DECIMAL_H

#include <stdint.h>

#define SFI_DECIMAL_DIGITS 800

// 0.d0 d1 d2 ... times 10^point; no zero digit first or last; zero has no digits.
typedef struct sfi_decimal {
    int count;
    int point;
    int more; // digits that are not zero were dropped
    uint8_t digit[SFI_DECIMAL_DIGITS];
} sfi_decimal;

// Drop zeros at the end.
void sfi_decimal_trim(sfi_decimal *d);

// The double nearest to d, ties to even; infinite beyond the largest. Uses d up.
double sfi_decimal_nearest(sfi_decimal *d);

// d = value, exactly; value is finite and > 0.
void sfi_decimal_from(double value, sfi_decimal *d);

// Round d to at most `count` digits, half up.
void sfi_decimal_round(sfi_decimal *d, int count);

// A finite double > 0 as an integer below 2^53 times 2^exponent.
uint64_t sfi_double_mantissa(double value, int *exponent);

#endif
