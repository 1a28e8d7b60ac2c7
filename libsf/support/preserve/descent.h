// SPDX-License-Identifier: MIT
// The sweep down of complete, between its two halves: what a layer asks for, and who gives it.

#ifndef SF_SUPPORT_DESCENT_H
#define SF_SUPPORT_DESCENT_H

#include "support/preserve/complete.h"
#include "support/preserve/cover.h"
#include "support/preserve/history.h"

// Slices of the sweep. Y of the layer at hand is WANT, of the next NEXT; the others are for work.
enum {
    SFI_DESCENT_WANT,
    SFI_DESCENT_NEXT,
    SFI_DESCENT_ALIVE,
    SFI_DESCENT_OWN,
    SFI_DESCENT_PENDING,
    SFI_DESCENT_FREE,
    SFI_DESCENT_MUST,
    SFI_DESCENT_ENDS,
    SFI_DESCENT_ANCHORED,
    SFI_DESCENT_GAPS,
    SFI_DESCENT_ADDED,
    SFI_DESCENT_COUNT
};

// The sweep down.
typedef struct sfi_descent {
    const sfi_completion *task;
    sf_lattice lattice;
    sf_allocator allocator;
    int is_slack, has_bridges;
    sfi_carrier carrier;
    sfi_cover cover;
    uint64_t *words;
    sf_slice s[SFI_DESCENT_COUNT]; // s[SFI_DESCENT_WANT] is Y of the layer at hand,
                                   // s[SFI_DESCENT_NEXT] of the next
    // Under slack: fields of V and of F, and codes of the layer's demands, the next layer's and two
    // for work.
    sfi_history all, kept;
    uint8_t *codes, *need, *next_need, *reached, *below;
} sfi_descent;

// Codes of voxels in `s` become at least 1.
void sfi_demand_raise(const sfi_descent *d, uint8_t *codes, sf_slice s);

// s = voxels of `among` whose demand is at most what reaches them; where nothing is said of that,
// those without a demand. s may be `among`.
void sfi_demand_select(const sfi_descent *d, sf_slice among, const uint8_t *reached, sf_slice s);

// Y of layer k - 1, and its demands: F there, and carriers of what is pending. `below` is the front
// of that layer of V.
sf_status sfi_descent_choose(sfi_descent *d, uint32_t k, const sfi_front *below);

#endif
