// SPDX-License-Identifier: MIT
// What the rooms' own code asks of a rule.

#ifndef SF_SUPPORT_RULE_H
#define SF_SUPPORT_RULE_H

#include <sf/support.h>

// One voxel of reach in the unit of sf_rule.
#define SFI_REACH_ONE ((uint64_t)1 << 24)

// cos(22.5 degrees) and sqrt(2) - 1 in 1/2^32, rounded down: the octagon's proportions.
#define SFI_OCTAGON_AXIS_Q32 0xec835e79u
#define SFI_OCTAGON_SQUARE_Q32 0x6a09e667u

// SF_OK when the rule gives an element for each step between `layer_count` slices, the first of
// which is layer `first`. After that sf_rule_element() cannot fail on them, so whoever is about to
// write into a grid asks here first.
sf_status sfi_rule_check(const sf_rule *rule, uint32_t first, uint32_t layer_count);

#endif
