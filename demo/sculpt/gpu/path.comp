// SPDX-License-Identifier: MIT
// Path: the closest matter that can carry a voxel, one work group a put.
//
// The window that t steps down can reach is the (2t + 1)^2 square, clipped to the grid. The first
// layer whose window holds matter ends the search; of its voxels the closest in the plane is the
// landing, of equals the least y, then the least x. Where no layer down to the bed has any the path
// ends on the bed, and land.comp says where. Mirrors search_cone() and choose_end() of
// libsf/support/grow/path_finder.c with the windows of cone.c for box3, on what was printable before
// the stroke.
//
// Two slots for the least distance, used in turns: one is read after the barrier that the other's
// writers have yet to reach.
#include "grid.glsl"
#include "state.glsl"
#include "tip.glsl"
#include "paths.glsl"

layout(local_size_x = 64) in;

shared uint least[2], least_at;
uint best, best_at; // of this invocation

void offer(put p, uint x, uint y)
{
    uint off = off_square(p, x, y), at = y << 16 | x;
    if (off < best || (off == best && at < best_at)) {
        best = off;
        best_at = at;
    }
}

// Solid voxels of a word, of which only the closest on either side of the middle count.
void offer_word(put p, box b, uvec3 at)
{
    uint first = at.x * 32u, solid = printable_before[place(at.x, at.y, at.z)];
    solid &= first < b.x0 ? NONE << (b.x0 - first) : NONE;
    solid &= b.x1 - first < 32u ? (1u << (b.x1 - first)) - 1u : NONE;
    uint x = uint(p.x), below = x >= first + 32u ? NONE : x <= first ? 0u : (1u << (x - first)) - 1u;
    if ((solid & below) != 0u) {
        offer(p, first + uint(findMSB(solid & below)), at.y);
    }
    if ((solid & ~below) != 0u) {
        offer(p, first + uint(findLSB(solid & ~below)), at.y);
    }
}

void search(put p, uint slot, uint t)
{
    box b = window(p, t);
    uint n = words_in(b);
    best = best_at = NONE;
    for (uint i = gl_LocalInvocationIndex; i < n; i += 64u) {
        offer_word(p, b, word_of(b, i));
    }
    if (best != NONE) {
        atomicMin(least[slot], best);
    }
    memoryBarrierShared();
    barrier();
}

void finish(landing l)
{
    if (gl_LocalInvocationIndex == 0u) {
        landings[gl_WorkGroupID.x] = l;
        if (l.end == ON_BED) {
            ledger.is_bed_wanted = 1u;
        }
    }
}

void main()
{
    put p = puts[gl_WorkGroupID.x];
    if (gl_LocalInvocationIndex == 0u) {
        least[0] = least[1] = least_at = NONE;
    }
    memoryBarrierShared();
    barrier();
    uvec3 from = uvec3(p.x, p.y, p.z);
    if (from.x >= counts.x || from.y >= counts.y || from.z >= counts.z || from.z <= bed) {
        finish(landing(NO_PATH, 0u, 0u, 0u));
        return;
    }
    uint t = 1u, slot = 0u, end = ON_BED;
    for (; t <= from.z - bed; t++) {
        slot ^= 1u;
        search(p, slot, t);
        if (least[slot] != NONE) {
            end = ON_MATTER;
            break;
        }
    }
    if (end == ON_MATTER && best == least[slot]) {
        atomicMin(least_at, best_at);
    }
    memoryBarrierShared();
    barrier();
    finish(end == ON_MATTER ? landing(end, least_at & 65535u, least_at >> 16, t)
                            : landing(end, from.x, from.y, from.z - bed));
}
