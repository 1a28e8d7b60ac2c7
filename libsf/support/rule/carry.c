// SPDX-License-Identifier: MIT
// Carry: one step of any rule, from what is alive in a layer to what is alive in the next.
//
// With S a slice, B the front below (alive voxels, and their slack under slack), E the exempt
// voxels:
//
//     A = { v in S : something alive below reaches v } and S with E     the voxels alive on their
//     own T = A and the gaps of S that bridges between ends in A keep
//
// "Reaches" is the element of the step for box3, octagon and disk: A is S with the dilation of B.
// Under slack it is a code greater than 0 (slack.c). Exempt and bridged voxels are alive with a
// code of 1: they carry what stands on them, and nothing beyond.
//
// The step is monotone in S, in B and in E, which is what trim, complete and every mask question
// rest on. Everything in the library that asks what may rest on what asks here, so that a rule is a
// rule in all of it.
//
// Freestanding but for sfi_*_create(): integers, no memory but the caller's.

#include "support/rule/carry.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"
#include "support/rule/codes.h"
#include "support/rule/rule.h"
#include "voxel/slice.h"

// ---------------------------------------------------------------------------------------------
// Memory
// ---------------------------------------------------------------------------------------------

static int slice_size(uint32_t width, uint32_t height, size_t *size)
{
    return sfi_size_mul(sf_slice_stride(width) * sizeof(uint64_t), height, size);
}

int sfi_carrier_size(const sf_rule *rule, uint32_t width, uint32_t height, size_t *size)
{
    size_t one;
    if (!slice_size(width, height, &one)) {
        return 0;
    }
    if (!sfi_bridge_any(&rule->bridge)) {
        *size = 0;
        return 1;
    }
    return sfi_size_mul(one, 3, size);
}

int sfi_front_size(const sf_rule *rule, uint32_t width, uint32_t height, size_t *size)
{
    size_t bits, codes = 0;
    return slice_size(width, height, &bits) &&
           (rule->kind != SF_RULE_SLACK || sfi_size_mul(sfi_slack_stride(width), height, &codes)) &&
           sfi_size_add(bits, codes, size);
}

// A slice in memory, which is moved past it.
static sf_slice place_slice(uint32_t width, uint32_t height, unsigned char **memory)
{
    sf_slice slice = {(uint64_t *)(void *)*memory, width, height, sf_slice_stride(width)};
    *memory += slice.stride * height * sizeof(uint64_t);
    return slice;
}

sfi_carrier sfi_carrier_place(const sf_rule *rule, uint32_t width, uint32_t height, void *memory)
{
    unsigned char *at = memory;
    sfi_carrier carrier = {*rule, width, height, SFI_NO_SLICE, SFI_NO_SLICE, SFI_NO_SLICE};
    if (sfi_bridge_any(&rule->bridge)) {
        carrier.own = place_slice(width, height, &at);
        carrier.anchored = place_slice(width, height, &at);
        carrier.gaps = place_slice(width, height, &at);
    }
    return carrier;
}

sfi_front sfi_front_place(const sf_rule *rule, uint32_t width, uint32_t height, void *memory)
{
    unsigned char *at = memory;
    sfi_front front = {place_slice(width, height, &at), NULL};
    size_t bytes = front.alive.stride * height * sizeof(uint64_t);
    if (rule->kind == SF_RULE_SLACK) {
        front.slack = at;
        bytes += sfi_slack_stride(width) * height;
    }
    for (size_t i = 0; i < bytes / sizeof(uint64_t); i++) {
        front.alive.words[i] = 0;
    }
    return front;
}

// ---------------------------------------------------------------------------------------------
// Steps
// ---------------------------------------------------------------------------------------------

static uint8_t *codes_of(sfi_front front, uint32_t y)
{
    return front.slack + y * sfi_slack_stride(front.alive.width);
}

// The codes of one word of voxels: `least` at least where alive, else 0.
static void raise_codes(uint8_t *codes, uint64_t alive, uint8_t least)
{
    for (unsigned b = 0; b < 64; b += 8) {
        uint8_t mask[8];
        sfi_store_bytes(mask, sfi_spread_bits(alive >> b));
        for (unsigned i = 0; i < 8; i++) {
            uint8_t code = codes[b + i] > least ? codes[b + i] : least;
            codes[b + i] = (uint8_t)(code & mask[i]);
        }
    }
}

// Codes of dead or empty voxels become 0, and those of living ones at least `least`.
static void settle_codes(sfi_front front, uint8_t least)
{
    for (uint32_t y = 0; front.slack != NULL && y < front.alive.height; y++) {
        const uint64_t *row = sfi_slice_row(front.alive, y);
        for (size_t i = 0; i < sfi_row_words(front.alive.width); i++) {
            raise_codes(codes_of(front, y) + i * 64, row[i], least);
        }
    }
}

// Codes of living voxels become `code`, and all others 0, whatever they were.
static void set_codes(sfi_front front, uint8_t code)
{
    for (uint32_t y = 0; front.slack != NULL && y < front.alive.height; y++) {
        const uint64_t *row = sfi_slice_row(front.alive, y);
        uint8_t *codes = codes_of(front, y);
        for (size_t x = 0; x < sfi_row_words(front.alive.width) * 64; x += 8) {
            uint64_t mask = sfi_spread_bits(row[x / 64] >> (x % 64));
            sfi_store_bytes(codes + x, mask & code * UINT64_C(0x0101010101010101));
        }
    }
}

sf_status sfi_carry_bed(const sfi_carrier *carrier, sf_slice solid, sfi_front front)
{
    SF_TRY(sf_slice_copy(front.alive, solid));
    set_codes(front, (uint8_t)(carrier->rule.slack_cap + 1));
    return SF_OK;
}

sf_status sfi_carry_anyway(const sfi_carrier *carrier, sf_slice solid, sfi_front front)
{
    (void)carrier;
    SF_TRY(sf_slice_copy(front.alive, solid));
    settle_codes(front, 1);
    return SF_OK;
}

// Make the solid voxels that are exempt alive.
static void add_exempt(sf_slice solid, sf_slice exempt, sf_slice alive)
{
    size_t words = sfi_row_words(solid.width);
    for (uint32_t y = 0; y < solid.height; y++) {
        const uint64_t *in = sfi_slice_row(solid, y), *free = sfi_slice_row(exempt, y);
        uint64_t *out = sfi_slice_row(alive, y);
        for (size_t i = 0; i < words; i++) {
            out[i] |= in[i] & free[i];
        }
        out[words - 1] &= sfi_tail_mask(solid.width);
    }
}

// front = A, with codes under slack.
static sf_status carry_own(const sfi_carrier *carrier, uint32_t k, const sfi_front *below,
                           sf_slice solid, sf_slice exempt, sfi_front front)
{
    sf_element element;
    SF_TRY(sf_rule_element(&carrier->rule, k - 1, &element));
    if (carrier->rule.kind == SF_RULE_SLACK) {
        sfi_slack_step(&carrier->rule, k - 1, &element, below, solid, exempt, front);
        return SF_OK;
    }
    SF_TRY(sf_slice_and_dilate(front.alive, solid, below->alive, &element));
    if (exempt.words != NULL) {
        add_exempt(solid, exempt, front.alive);
    }
    return SF_OK;
}

sf_status sfi_carry(const sfi_carrier *carrier, uint32_t k, const sfi_front *below, sf_slice solid,
                    sf_slice exempt, sfi_front front, sf_slice own)
{
    if (!sfi_bridge_any(&carrier->rule.bridge)) {
        SF_TRY(carry_own(carrier, k, below, solid, exempt, front));
        return own.words == NULL ? SF_OK : sf_slice_copy(own, front.alive);
    }
    // A goes to scratch: gaps are found in S, which front.alive may be.
    sfi_front alone = {carrier->own, front.slack};
    SF_TRY(carry_own(carrier, k, below, solid, exempt, alone));
    sfi_bridge_gaps(&carrier->rule.bridge, solid, alone.alive, carrier->anchored, carrier->gaps);
    SF_TRY(sf_slice_or(front.alive, alone.alive, carrier->gaps));
    settle_codes(front, 1);
    return own.words == NULL ? SF_OK : sf_slice_copy(own, alone.alive);
}

// Below the bed: nothing is alive but what is exempt, and that has no slack.
static sf_status carry_exempt(sf_slice solid, sf_slice exempt, sfi_front front)
{
    if (exempt.words != NULL) {
        SF_TRY(sf_slice_and(front.alive, solid, exempt));
    } else {
        sfi_slice_clear(front.alive);
    }
    set_codes(front, 1);
    return SF_OK;
}

sf_status sfi_carry_layer(const sfi_carrier *carrier, uint32_t k, uint32_t bed,
                          const sfi_front *below, sf_slice solid, sf_slice exempt, sfi_front front,
                          sf_slice own)
{
    if (k > bed) {
        return sfi_carry(carrier, k, below, solid, exempt, front, own);
    }
    SF_TRY(k == bed ? sfi_carry_bed(carrier, solid, front) : carry_exempt(solid, exempt, front));
    return own.words == NULL ? SF_OK : sf_slice_copy(own, front.alive);
}
