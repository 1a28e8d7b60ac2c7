// SPDX-License-Identifier: MIT
// Settle: a stroke ends. What is drawn becomes what is printable, unless ghosts are kept, and what
// the stroke did is counted.
//
// Mirrors drop_ghosts() of libsf/sculpt/stroke.c and sfi_sculpt_count() of state.c. The words that
// differ from the state before are counted too, which is what a step of the history takes.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(location = 2) uniform uint keeps_ghosts;
layout(location = 3) uniform uint kept_back_kind; // 0 none, 1 what is not printable, 2 what is

// added, removed, lost, kept back, words
uint sums[5] = uint[5](0u, 0u, 0u, 0u, 0u);

void drop_ghosts(uint i)
{
    uint solid = printable[i], gone = drawn[i] & ~solid;
    drawn[i] = solid;
    for (uint q = 0u; q < 8u && gone != 0u; q++) {
        uint bytes = bytes_of(gone >> q * 4u);
        if (bytes != 0u) {
            materials[i * 8u + q] &= ~bytes;
        }
    }
}

void sum_up(uint i)
{
    uint now = printable[i], before = printable_before[i], u = tips[i];
    sums[0] += bitCount(now & ~before);
    sums[1] += bitCount(before & ~now & u);
    sums[2] += bitCount(before & ~now & ~u);
    sums[3] += bitCount(kept_back_kind == 0u   ? 0u
                        : kept_back_kind == 1u ? u & ~now
                                               : u & now);
    bool differs = drawn[i] != drawn_before[i] || now != before;
    for (uint q = 0u; q < 8u && !differs; q++) {
        differs = materials[i * 8u + q] != materials_before[i * 8u + q];
    }
    sums[4] += differs ? 1u : 0u;
}

void main()
{
    box b = ledger.touched;
    uint n = words_in(b);
    for (uint k = gl_GlobalInvocationID.x; k < n; k += STRIDE) {
        uvec3 at = word_of(b, k);
        uint i = place(at.x, at.y, at.z);
        if (keeps_ghosts == 0u) {
            drop_ghosts(i);
        }
        sum_up(i);
    }
    if (sums[0] != 0u) {
        atomicAdd(ledger.added_voxels, sums[0]);
    }
    if (sums[1] != 0u) {
        atomicAdd(ledger.removed_voxels, sums[1]);
    }
    if (sums[2] != 0u) {
        atomicAdd(ledger.lost_voxels, sums[2]);
    }
    if (sums[3] != 0u) {
        atomicAdd(ledger.kept_back_voxels, sums[3]);
    }
    if (sums[4] != 0u) {
        atomicAdd(ledger.changed_words, sums[4]);
    }
}
