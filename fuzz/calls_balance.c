// SPDX-License-Identifier: MIT
// Fuzz target: calls of one family: stances, weights, blends, walls, cavities, solids that stand.

#include "family.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const headers[] = {"stance",  "handles",  "weights", "blend", "carve",
                                          "density", "printing", "stand",   "body",  NULL};
    call_family(data, size, headers);
    return 0;
}
