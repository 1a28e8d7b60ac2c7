// SPDX-License-Identifier: MIT
// Fuzz target: calls of one family: rules, check, trim, preserve, grow, repair, paths, voids,
// certificates.

#include "family.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const headers[] = {"rule",   "support",     "finding", "preserve", "grow",
                                          "repair", "certificate", "voids",   "grid",     NULL};
    call_family(data, size, headers);
    return 0;
}
