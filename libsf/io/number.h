// SPDX-License-Identifier: MIT
// Numbers as text, whatever the locale.

#ifndef SF_IO_NUMBER_H
#define SF_IO_NUMBER_H

#include <stddef.h>
#include <stdint.h>

// Room for any text that sfi_number_format() writes, its final zero included.
#define SFI_NUMBER_SIZE 32

// The double nearest to a decimal number (ties to even), for any number of digits. The whole text
// must be the number: sign, digits with an optional point, exponent with e or E; also inf, infinity
// and nan in any case. Returns 0 and leaves value alone when it is not.
int sfi_number_parse(const char *text, double *value);

// The whole number in text, with an optional sign, within 64 bits; returns 0 when it is not one.
int sfi_integer_parse(const char *text, int64_t *value);

// The fewest of 15, 16 or 17 digits that read back as this finite double, without zeros at the end;
// a zero of either sign is "0". The text is a number of JSON too. Returns its length.
size_t sfi_number_format(double value, char text[SFI_NUMBER_SIZE]);

#endif
