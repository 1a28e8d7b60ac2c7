// SPDX-License-Identifier: MIT
// The mask that is part of the library: 64 KiB of constants.
//
// builtin.inc holds the ranks of sf_mask_create() with its default options, a row of the block a
// line. `unit-grade-builtin --write` prints it, and without --write compares every rank; so the
// file cannot fall behind the code.

#include "grade/tone/mask.h"

static const uint16_t ranks[32 * 32 * 32] = {
#include "grade/tone/builtin.inc"
};

static const sf_mask builtin = {.n = {32, 32, 32}, .small = ranks};

const sf_mask *sf_mask_builtin(void)
{
    return &builtin;
}
