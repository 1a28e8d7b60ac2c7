// SPDX-License-Identifier: MIT
// Fuzz target: calls of one family: cages, limits, samples, halftones, mixtures.

#include "family.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const headers[] = {
        "property", "cage",  "cage_build", "cage_history", "refine", "limit", "locate",
        "sample",   "tetra", "halftone",   "mixture",      "paint",  NULL};
    call_family(data, size, headers);
    return 0;
}
