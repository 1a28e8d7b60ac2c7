// SPDX-License-Identifier: MIT
// Fuzz target: calls of one family: slices, elements, runs, lattices, grids.

#include "family.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const headers[] = {"base", "slice", "grid", NULL};
    call_family(data, size, headers);
    return 0;
}
