// SPDX-License-Identifier: MIT
// Brace: what tips still lack when their paths are there, straight below them.
//
// With T1 the trim of what is drawn with the paths, from the top layer of the tips U down to the
// bed: let F = T1_k + U_k, A = U_{k+1} + X_{k+1} what must stand on it, and
//
//     rest = A \ dilate(F)
//     X_k  = (erode(A + T1_{k+1}) and dilate(rest) and A) \ F, and what of rest it lacks, straight
//            below
//
// so that a brace narrows downwards at the rule's angle, and ends where something carries it. X lies
// below U, within its columns. One work group sweeps down, as in preserve.comp. The box of what
// changes becomes the one around X. Mirrors sfi_brace() of libsf/sculpt/brace.c.
#define SHARED coherent
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 256) in;
layout(std430, binding = 11) coherent buffer braced_block { uint braced[]; };
layout(std430, binding = 12) coherent buffer rest_block { uint rest[]; };
layout(std430, binding = 13) coherent buffer lacking_block { uint lacking[]; };
layout(location = 2) uniform uvec3 low; // the box around the tips
layout(location = 3) uniform uvec3 high;

box columns; // of the tips, at the layer at hand

bool is_within(uint w, uint y)
{
    return w >= columns.x0 / 32u && w < (columns.x1 + 31u) / 32u && y >= columns.y0 &&
           y < columns.y1;
}

READ(printable_at, printable)
READ(tips_at, tips)

uint braced_at(uint w, uint y, uint z)
{
    return is_within(w, y) && z < high.z ? braced[place(w, y, z)] : 0u;
}

uint rest_at(uint w, uint y, uint z)
{
    return is_within(w, y) ? rest[y * counts.w + w] : 0u;
}

// F, A and A + T1 of a layer.
uint firm(uint w, uint y, uint z)
{
    return printable_at(w, y, z) | tips_at(w, y, z);
}

uint wanted(uint w, uint y, uint z)
{
    return tips_at(w, y, z) | braced_at(w, y, z);
}

uint standing(uint w, uint y, uint z)
{
    return wanted(w, y, z) | printable_at(w, y, z);
}

DILATE(carried, firm)
DILATE(carried_by_core, braced_at)
DILATE(around_rest, rest_at)
ERODE(core, standing)

shared uint hangs[3];
shared uint low_x, low_y, low_z, high_x, high_y, high_z;

void wait()
{
    memoryBarrierShared();
    memoryBarrierBuffer();
    barrier();
}

void note(uvec3 at, uint bits)
{
    atomicMin(low_x, at.x * 32u + uint(findLSB(bits)));
    atomicMax(high_x, at.x * 32u + uint(findMSB(bits)) + 1u);
    atomicMin(low_y, at.y);
    atomicMax(high_y, at.y + 1u);
    atomicMin(low_z, at.z);
    atomicMax(high_z, at.z + 1u);
}

void find_rest(uvec3 at)
{
    uint hanging = wanted(at.x, at.y, at.z + 1u);
    hanging = hanging != 0u ? hanging & ~carried(at.x, at.y, at.z) : 0u;
    rest[at.y * counts.w + at.x] = hanging;
    if (hanging != 0u) {
        hangs[at.z % 3u] = 1u;
    }
}

void put_core(uvec3 at)
{
    uint bits = around_rest(at.x, at.y, at.z);
    if (bits != 0u) {
        bits &= wanted(at.x, at.y, at.z + 1u) & core(at.x, at.y, at.z + 1u) &
                ~firm(at.x, at.y, at.z);
    }
    braced[place(at.x, at.y, at.z)] = bits;
}

void find_lacking(uvec3 at)
{
    uint bits = rest[at.y * counts.w + at.x];
    lacking[at.y * counts.w + at.x] = bits != 0u ? bits & ~carried_by_core(at.x, at.y, at.z) : 0u;
}

void put_straight(uvec3 at)
{
    uint i = place(at.x, at.y, at.z), bits = braced[i] | lacking[at.y * counts.w + at.x];
    braced[i] = bits;
    if (bits != 0u) {
        note(at, bits);
    }
}

// Layer z of X, where layer z + 1 is known. What it writes last is read after the first wait of the
// next layer, but for words that an invocation wrote itself. The flag only saves work.
void sweep_layer(uint z)
{
    uint me = gl_LocalInvocationIndex, n = words_in(columns);
    for (uint i = me; i < n; i += 256u) {
        find_rest(word_of(columns, i));
    }
    if (me == 0u) {
        hangs[(z + 2u) % 3u] = 0u; // of the next layer
    }
    wait();
    bool any = hangs[z % 3u] != 0u;
    for (uint i = me; i < n; i += 256u) {
        uvec3 at = word_of(columns, i);
        if (any) {
            put_core(at);
        } else {
            braced[place(at.x, at.y, at.z)] = 0u;
        }
    }
    wait();
    for (uint i = me; any && i < n; i += 256u) {
        find_lacking(word_of(columns, i));
    }
    wait();
    for (uint i = me; any && i < n; i += 256u) {
        put_straight(word_of(columns, i));
    }
}

void main()
{
    uint me = gl_LocalInvocationIndex;
    if (me == 0u) {
        hangs[0] = hangs[1] = hangs[2] = 0u;
        low_x = low_y = low_z = NONE;
        high_x = high_y = high_z = 0u;
    }
    wait();
    for (uint z = high.z; low.x < high.x && z > bed; z--) {
        columns = box(low.x, low.y, z - 1u, high.x, high.y, z);
        sweep_layer(z - 1u);
    }
    wait();
    if (me == 0u) {
        ledger.edit = low_x < high_x ? box(low_x, low_y, low_z, high_x, high_y, high_z)
                                     : empty_box();
    }
}
