// SPDX-License-Identifier: MIT
// Closure: the least set that is closed under "what it rests on", exactly.
//
// Each place has one that it rests on, or is a root; so places form a forest, and a set may be kept
// just when it holds with each place its `next`. With w the weights,
//
//     f(v) = w(v) + sum over those that rest on v of min(0, f)      from the top down
//
// is the least that v and what then may stay above it can weigh. From the bottom up, v is kept
// where f(v) < 0 and its next is kept; what is forced is kept with all below it, and adds nothing
// to the choice of what is below, which is forced as well. That is the least weight of all closed
// sets with the forced ones: each tree above a kept place is decided by itself.
//
// Numbers rise from the bottom up, so two sweeps over an array do it.
//
// Source: closed sets of least weight are J.-C. Picard's (Management Science 22, 1976), who needs
// flows for them; on a forest two sweeps do.

#include "balance/forest/places.h"

void sfi_closure_least(uint32_t count, const uint32_t *next, const int32_t *weight, int64_t *gain,
                       uint8_t *state)
{
    for (uint32_t i = 0; i < count; i++) {
        gain[i] = weight[i];
    }
    for (uint32_t i = count; i-- > 0;) {
        if (next[i] == SFI_PLACE_ROOT) {
            continue;
        }
        state[next[i]] |= state[i] & SFI_PLACE_FORCED;
        gain[next[i]] += gain[i] < 0 ? gain[i] : 0;
    }
    for (uint32_t i = 0; i < count; i++) {
        int stands = next[i] == SFI_PLACE_ROOT || (state[next[i]] & SFI_PLACE_KEPT) != 0;
        int keep = (state[i] & SFI_PLACE_FORCED) != 0 || (gain[i] < 0 && stands);
        state[i] = (uint8_t)((state[i] & SFI_PLACE_FORCED) | (keep ? SFI_PLACE_KEPT : 0));
    }
}
