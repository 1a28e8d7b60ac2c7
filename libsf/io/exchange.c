// SPDX-License-Identifier: MIT
// Units and UUIDs of exchange files as text.

#include "io/exchange.h"

#include <stdio.h>
#include <string.h>

void sfi_exchange_unit(const int8_t si[7], char unit[SFI_UNIT_SIZE])
{
    static const char *const names[7] = {"m", "kg", "s", "A", "K", "mol", "cd"};
    static const int order[7] = {1, 0, 2, 3, 4, 5, 6}; // as people write them: kg first
    size_t used = 0;
    unit[0] = '\0';
    for (int i = 0; i < 7; i++) {
        int exponent = si[order[i]];
        if (exponent != 0) {
            used += (size_t)snprintf(unit + used, SFI_UNIT_SIZE - used, "%s%s", used > 0 ? " " : "",
                                     names[order[i]]);
        }
        if (exponent != 0 && exponent != 1) {
            used += (size_t)snprintf(unit + used, SFI_UNIT_SIZE - used, "^%d", exponent);
        }
    }
    if (used == 0) {
        memcpy(unit, "1", 2);
    }
}

void sfi_exchange_uuid(const uint8_t uuid[16], char text[SFI_UUID_SIZE])
{
    static const char digits[] = "0123456789abcdef";
    size_t at = 0;
    for (int i = 0; i < 16; i++) {
        if (i == 4 || i == 6 || i == 8 || i == 10) {
            text[at++] = '-';
        }
        text[at++] = digits[uuid[i] >> 4];
        text[at++] = digits[uuid[i] & 15];
    }
    text[at] = '\0';
}

static int digit_of(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

int sfi_exchange_uuid_parse(const char *text, uint8_t uuid[16])
{
    char again[SFI_UUID_SIZE];
    if (strlen(text) != SFI_UUID_SIZE - 1) {
        return 0;
    }
    for (int i = 0, at = 0; i < 16; i++, at += 2) {
        at += text[at] == '-';
        int high = digit_of(text[at]), low = digit_of(text[at + 1]);
        if (high < 0 || low < 0) {
            return 0;
        }
        uuid[i] = (uint8_t)(16 * high + low);
    }
    sfi_exchange_uuid(uuid, again);
    return strcmp(text, again) == 0;
}
