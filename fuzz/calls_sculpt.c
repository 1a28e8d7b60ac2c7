// SPDX-License-Identifier: MIT
// Fuzz target: calls of one family: tips, models, sessions.

#include "family.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const headers[] = {"sculpt", "session", NULL};
    call_family(data, size, headers);
    return 0;
}
