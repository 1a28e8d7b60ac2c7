// SPDX-License-Identifier: MIT
// Fuzz target: calls of one family: files, folders, stacks, sources and sinks that break.

#include "family.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const headers[] = {"io", "layers", "cage_io", "exchange", "session", NULL};
    call_family(data, size, headers);
    return 0;
}
