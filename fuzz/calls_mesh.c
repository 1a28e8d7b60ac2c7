// SPDX-License-Identifier: MIT
// Fuzz target: calls of one family: meshes, voxels out of them and back, orientation.

#include "family.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const headers[] = {"mesh", "body", "bend", "orient", NULL};
    call_family(data, size, headers);
    return 0;
}
