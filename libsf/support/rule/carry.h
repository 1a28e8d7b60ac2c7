// SPDX-License-Identifier: MIT
// The step from one layer to the next, for every rule: what of a slice is alive, given what is
// alive below it. Check, trim and all operators are made of this step.

#ifndef SF_SUPPORT_CARRY_H
#define SF_SUPPORT_CARRY_H

#include <sf/rule.h>

// What is alive in one layer. Under slack each voxel has a code, a byte, that says how much farther
// matter above it may reach: 0 for a dead voxel, 1 + slack in units for a living one. The codes of
// row y begin at slack + y * sfi_slack_stride(width). Under other rules slack is NULL.
typedef struct sfi_front {
    sf_slice alive;
    uint8_t *slack;
} sfi_front;

// A rule at work on slices of one size, with the scratch that its steps need.
typedef struct sfi_carrier {
    sf_rule rule;
    uint32_t width, height;
    sf_slice own, anchored, gaps; // bridges: A, A*, and what is bridged
} sfi_carrier;

// A slice without words: where no exempt voxels are given, where nobody asks for a result.
#define SFI_NO_SLICE ((sf_slice){NULL, 0, 0, 0})

// Bytes from one row of codes to the next. Those past the row's last word are nobody's: never read.
static inline size_t sfi_slack_stride(uint32_t width)
{
    return sf_slice_stride(width) * 64;
}

// Bytes of memory that a carrier's scratch and a front take, each a multiple of 64; 0 where none is
// needed. Return 0 when they do not fit a size_t. The rule must have passed sfi_rule_check().
int sfi_carrier_size(const sf_rule *rule, uint32_t width, uint32_t height, size_t *size);
int sfi_front_size(const sf_rule *rule, uint32_t width, uint32_t height, size_t *size);

// Put them into memory of that size on a 64-byte boundary (a carrier of size 0 takes NULL); a front
// is empty after that.
sfi_carrier sfi_carrier_place(const sf_rule *rule, uint32_t width, uint32_t height, void *memory);
sfi_front sfi_front_place(const sf_rule *rule, uint32_t width, uint32_t height, void *memory);

// The same with memory from an allocator. SF_ERR_MEMORY, SF_ERR_OVERFLOW. Destroying what was never
// created (all zero) does nothing.
sf_status sfi_carrier_create(const sf_rule *rule, uint32_t width, uint32_t height,
                             const sf_allocator *allocator, sfi_carrier *carrier);
void sfi_carrier_destroy(sfi_carrier *carrier, const sf_allocator *allocator);
sf_status sfi_front_create(const sf_rule *rule, uint32_t width, uint32_t height,
                           const sf_allocator *allocator, sfi_front *front);
void sfi_front_destroy(sfi_front *front, const sf_rule *rule, const sf_allocator *allocator);

// The front of a slice that rests on the bed: all of it is alive, with all the slack there is,
// whatever was in the front before. front.alive may be solid.
sf_status sfi_carry_bed(const sfi_carrier *carrier, sf_slice solid, sfi_front front);

// One step: front = what of `solid`, layer k > 0, is alive on `below`, the front of layer k - 1.
//
// Voxels of `exempt` (or SFI_NO_SLICE) that are solid are alive whatever lies below, with no slack
// of their own. Into `own` (or SFI_NO_SLICE) goes what of solid is alive without bridges. All have
// one size. front.alive may be solid where no exempt voxels are given; nothing else may overlap.
// Fails only for a rule that does not serve the step.
sf_status sfi_carry(const sfi_carrier *carrier, uint32_t k, const sfi_front *below, sf_slice solid,
                    sf_slice exempt, sfi_front front, sf_slice own);

// Any layer of a sweep from layer 0 up: layer `bed` rests on the bed, those above it on `below`,
// and of those below it only what is exempt is alive, with no slack. Else as sfi_carry(); `below`
// is not read up to the bed.
sf_status sfi_carry_layer(const sfi_carrier *carrier, uint32_t k, uint32_t bed,
                          const sfi_front *below, sf_slice solid, sf_slice exempt, sfi_front front,
                          sf_slice own);

// Make all of `solid` alive, in a front that is made: what was not has no slack. For a check, which
// names a fault once and then goes on as if the voxel had been carried. front.alive may be solid.
sf_status sfi_carry_anyway(const sfi_carrier *carrier, sf_slice solid, sfi_front front);

// ---------------------------------------------------------------------------------------------
// Its parts
// ---------------------------------------------------------------------------------------------

// Slack, in units: what a step from layer k gives, and what reaching over (dx, dy) voxels costs.
uint32_t sfi_slack_gain(const sf_rule *rule, uint32_t k);
uint32_t sfi_slack_cost(const sf_rule *rule, uint32_t dx, uint32_t dy);

// A rule that is an element for each step and carries nothing that `rule` does not: the rule
// without its bridges, or under slack a disk of what every step gains. Steps within that disk use
// up no reach, so that chains of them stand on whatever is alive.
sf_rule sfi_rule_plain(const sf_rule *rule, uint32_t layer_count);

// One step under slack from layer k, without bridges: front = what of `solid` is reached from
// below, whose codes are given, or exempt (or SFI_NO_SLICE). front.alive may be solid.
void sfi_slack_step(const sf_rule *rule, uint32_t k, const sf_element *element,
                    const sfi_front *below, sf_slice solid, sf_slice exempt, sfi_front front);

// Whether a rule bridges anything.
static inline int sfi_bridge_any(const sf_bridge *b)
{
    return (b->span_x | b->span_y | b->span_diagonal) != 0;
}

// How far, in voxels along x or y, a bridge with its anchors reaches at most; 0 without bridges.
uint32_t sfi_bridge_margin(const sf_bridge *b);

// Whether a rule is nothing but an element for each step, so that a layer's bits are all there is
// to know of it.
static inline int sfi_rule_is_element(const sf_rule *rule)
{
    return rule->kind != SF_RULE_SLACK && !sfi_bridge_any(&rule->bridge);
}

// gaps = the voxels of solid outside `own` that bridges between ends in `own` keep. `anchored` is
// scratch. Own lies within solid.
void sfi_bridge_gaps(const sf_bridge *bridge, sf_slice solid, sf_slice own, sf_slice anchored,
                     sf_slice gaps);

#endif
