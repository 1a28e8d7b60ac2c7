// SPDX-License-Identifier: MIT
// Fuzz target: any functions of the library, in any order, with any arguments.
//
// What each call promises is held by world.c: documented statuses only, what fails changes nothing
// and says why, what is read stays, memory comes back, half of the runs with an allocator that
// refuses now and then.

#include "family.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    call_family(data, size, NULL);
    return 0;
}
