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

// What slack counts in: units in a pitch, the cap of what a voxel has to spare, whose code, 1 more,
// is a byte; and how far, in voxels, a step then reaches at most.
#define SFI_SLACK_UNITS_MIN 4u
#define SFI_SLACK_CAP_MAX 254u
#define SFI_SLACK_REACH_MAX 63u

// Layers that a rule's table must serve. A single layer takes no step and needs none.
uint32_t sfi_table_layers(const sf_lattice *lattice);

// All that a step of these reaches under slack can be carried by; the rule's units are asked for.
sf_status sfi_slack_element(const sf_rule *rule, uint64_t x_q24, uint64_t y_q24,
                            sf_element *element);

// Box3 and octagon: how many pluses and squares the steps below layer k add up to, and how many of
// them are squares. The rule must serve these steps.
void sfi_rule_sums(const sf_rule *rule, uint32_t k, uint64_t *all, uint64_t *squares);

// SF_OK when the rule gives an element for each step between `layer_count` slices, the first of
// which is layer `first`. After that sf_rule_element() cannot fail on them, so whoever is about to
// write into a grid asks here first.
sf_status sfi_rule_check(const sf_rule *rule, uint32_t first, uint32_t layer_count);

#endif
