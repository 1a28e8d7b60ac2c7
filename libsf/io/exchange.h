// SPDX-License-Identifier: MIT
// Names and words that the writer and the reader of exchange files share.

#ifndef SF_IO_EXCHANGE_H
#define SF_IO_EXCHANGE_H

#include <sf/exchange.h>

#define SFI_EXCHANGE_FORMAT "libsf-exchange"
#define SFI_EXCHANGE_VERSION 1

// "kg m^-3" and the like; "1" for a bare number. Room for all seven.
enum { SFI_UNIT_SIZE = 80, SFI_UUID_SIZE = 37 };
void sfi_exchange_unit(const int8_t si[7], char unit[SFI_UNIT_SIZE]);

// As text in lower case, and back; returns 0 where it is none.
void sfi_exchange_uuid(const uint8_t uuid[16], char text[SFI_UUID_SIZE]);
int sfi_exchange_uuid_parse(const char *text, uint8_t uuid[16]);

#endif
