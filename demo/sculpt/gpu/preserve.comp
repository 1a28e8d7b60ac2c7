// SPDX-License-Identifier: MIT
// Preserve: the tips go, but for what of them carries something that stays.
//
// With V the printable part before the stroke and U the union of its tips, from the top layer of U
// to its lowest:
//
//     C = V_k and U_k          what may go
//     F = V_k \ U_k            what stays anyway
//     R = V'_{k+1} and dilate(C), without dilate(F)     what hangs on C alone
//     X = cover(R, C)          by priority
//     V'_k = F + X
//
// The cover goes by nine offsets, straight below, the edge neighbours, the corners: all voxels of R
// with a carrier at the offset take it, and all that these carry hang no more. One work group does
// the sweep, because each layer waits for the one above and each offset for the one before it.
// Mirrors sweep_layer() of libsf/support/preserve/preserve_fast.c and serve() of priority.c, and
// their order of offsets.
//
// R reaches a voxel beyond the tips. Both it and what is taken at an offset are one layer large,
// and are read only where the layer at hand has written them.
#define SHARED coherent
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 256) in;
layout(std430, binding = 12) coherent buffer rest_block { uint rest[]; };
layout(std430, binding = 13) coherent buffer taken_block { uint taken[]; };

const ivec2 offsets[9] = ivec2[9](ivec2(0, 0), ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1),
                                  ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1),
                                  ivec2(-1, -1));

box tip_box, rest_box; // of the layer at hand

uint may_go(uint w, uint y, uint z)
{
    return is_in_grid(w, y, z) ? printable_before[place(w, y, z)] & tips[place(w, y, z)] : 0u;
}

uint stays(uint w, uint y, uint z)
{
    return is_in_grid(w, y, z) ? printable_before[place(w, y, z)] & ~tips[place(w, y, z)] : 0u;
}

bool is_within(box b, uint w, uint y)
{
    return w >= b.x0 / 32u && w < (b.x1 + 31u) / 32u && y >= b.y0 && y < b.y1;
}

uint rest_at(uint w, uint y)
{
    return is_within(rest_box, w, y) ? rest[y * counts.w + w] : 0u;
}

uint taken_at(uint w, uint y, uint z)
{
    return is_within(tip_box, w, y) ? taken[y * counts.w + w] : 0u;
}

DILATE(carried_by_going, may_go)
DILATE(carried_by_staying, stays)
DILATE(carried_by_taken, taken_at)

// Whether anything hangs, by turns: one is written, one read, one emptied.
shared uint hangs[3];
uint turn;

// A word of what hangs on the tips alone in layer z + 1; and what of layer z stays anyway.
void find_rest(uint w, uint y, uint z)
{
    uint above = z + 1u < counts.z ? printable[place(w, y, z + 1u)] : 0u;
    if (above != 0u && z >= bed) {
        above &= carried_by_going(w, y, z) & ~carried_by_staying(w, y, z);
    }
    above = z >= bed ? above : 0u;
    rest[y * counts.w + w] = above;
    if (above != 0u) {
        hangs[turn] = 1u;
    }
    if (is_within(tip_box, w, y)) {
        printable[place(w, y, z)] = stays(w, y, z);
    }
}

// A word of the carriers at an offset from what hangs.
void take(uint w, uint y, uint z, ivec2 offset)
{
    uint from = y - uint(offset.y), here = rest_at(w, from);
    here = offset.x > 0   ? here << 1 | rest_at(w - 1u, from) >> 31
           : offset.x < 0 ? here >> 1 | rest_at(w + 1u, from) << 31
                          : here;
    uint fresh = here & may_go(w, y, z);
    taken[y * counts.w + w] = fresh;
    if (fresh != 0u) {
        printable[place(w, y, z)] |= fresh;
    }
}

void serve(uint w, uint y, uint z)
{
    uint left = rest[y * counts.w + w];
    if (left != 0u) {
        left &= ~carried_by_taken(w, y, z);
        rest[y * counts.w + w] = left;
        if (left != 0u) {
            hangs[turn] = 1u;
        }
    }
}

void wait()
{
    memoryBarrierShared();
    memoryBarrierBuffer();
    barrier();
}

// Begins a turn: the flag after this one's is emptied.
void next_turn()
{
    turn = (turn + 1u) % 3u;
    if (gl_LocalInvocationIndex == 0u) {
        hangs[(turn + 1u) % 3u] = 0u;
    }
}

void sweep_layer(uint z)
{
    uint me = gl_LocalInvocationIndex, n = words_in(rest_box), m = words_in(tip_box);
    next_turn();
    for (uint i = me; i < n; i += 256u) {
        uvec3 at = word_of(rest_box, i);
        find_rest(at.x, at.y, z);
    }
    wait();
    for (uint o = 0u; o < 9u && hangs[turn] != 0u; o++) {
        for (uint i = me; i < m; i += 256u) {
            uvec3 at = word_of(tip_box, i);
            take(at.x, at.y, z, offsets[o]);
        }
        wait();
        next_turn();
        for (uint i = me; i < n; i += 256u) {
            uvec3 at = word_of(rest_box, i);
            serve(at.x, at.y, z);
        }
        wait();
    }
}

void main()
{
    box e = ledger.edit;
    turn = 0u;
    if (gl_LocalInvocationIndex < 3u) {
        hangs[gl_LocalInvocationIndex] = 0u;
    }
    wait();
    for (uint z = e.z1; e.x0 < e.x1 && z > e.z0; z--) {
        tip_box = box(e.x0, e.y0, z - 1u, e.x1, e.y1, z);
        rest_box = box(max(e.x0, 1u) - 1u, max(e.y0, 1u) - 1u, z - 1u, min(e.x1 + 1u, counts.x),
                       min(e.y1 + 1u, counts.y), z);
        sweep_layer(z - 1u);
    }
}
