// SPDX-License-Identifier: MIT
// Brace: what tips still lack when their paths are there, leaning towards what stands.
//
// With T1 the trim of what is drawn with the paths, from the top layer of the tips U down to the
// bed: let F = T1_k + U_k, A = U_{k+1} + X_{k+1} what must stand on it, and
//
//     rest = A \ dilate(F)
//     X_k  = carriers of rest, each a step nearer to F than what it carries; and straight below
//            what has no F to come nearer to
//
// Distances are told by fronts that go out from F, ring after ring, within the rectangle around the
// tips and a tip's width more; modulo 3 they are three bits a voxel. Then the cover of preserve.comp
// is made, for each of the three. One work group sweeps down. The box of what changes becomes the
// one around X. Mirrors sfi_brace() of libsf/sculpt/brace.c and sfi_lean_down() of lean.c.
//
// A front is read with its neighbours and the next one is written elsewhere; rings are read and
// written by whoever has the word, so a ring costs one wait.
#define SHARED coherent
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 256) in;
layout(std430, binding = 11) coherent buffer braced_block { uint braced[]; };
layout(std430, binding = 12) coherent buffer rest_block { uint rest[]; };
layout(std430, binding = 13) coherent buffer slices_block { uint slices[]; }; // five of them
layout(location = 2) uniform uvec3 low; // the rectangle, in the layers of the tips
layout(location = 3) uniform uvec3 high;

const uint FRONT = 0u, RINGS = 2u; // two fronts, by turns, of which one is `taken` later; three rings

const ivec2 offsets[9] = ivec2[9](ivec2(0, 0), ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1),
                                  ivec2(0, -1), ivec2(1, 1), ivec2(-1, 1), ivec2(1, -1),
                                  ivec2(-1, -1));

box columns; // the rectangle, at the layer at hand
uint front;  // which of the fronts is read

bool is_within(uint w, uint y)
{
    return w >= columns.x0 / 32u && w < (columns.x1 + 31u) / 32u && y >= columns.y0 &&
           y < columns.y1;
}

// Bits of word w that lie within the rectangle.
uint column_mask(uint w)
{
    uint first = w * 32u, mask = NONE;
    mask &= columns.x0 > first ? NONE << (columns.x0 - first) : NONE;
    return columns.x1 < first + 32u ? mask & ~(NONE << (columns.x1 - first)) : mask;
}

READ(printable_at, printable)
READ(tips_at, tips)

uint slot(uint slice, uint w, uint y)
{
    return (slice * counts.y + y) * counts.w + w;
}

uint braced_at(uint w, uint y, uint z)
{
    return is_within(w, y) && z < high.z ? braced[place(w, y, z)] : 0u;
}

uint rest_at(uint w, uint y)
{
    return is_within(w, y) ? rest[y * counts.w + w] : 0u;
}

uint front_at(uint w, uint y, uint z)
{
    return is_within(w, y) ? slices[slot(FRONT + front, w, y)] : 0u;
}

// F and A of a layer.
uint firm(uint w, uint y, uint z)
{
    return printable_at(w, y, z) | tips_at(w, y, z);
}

uint wanted(uint w, uint y, uint z)
{
    return tips_at(w, y, z) | braced_at(w, y, z);
}

DILATE(carried, firm)
DILATE(around_front, front_at)

// What is told by all: whether anything hangs, is new, is not reached; by turns, as in
// preserve.comp: one is written, one read, one emptied.
shared uint hangs[3], grows[3], lacks[3];
shared uint low_x, low_y, low_z, high_x, high_y, high_z;
uint turn;

void wait()
{
    memoryBarrierShared();
    memoryBarrierBuffer();
    barrier();
}

void next_turn()
{
    turn = (turn + 1u) % 3u;
    if (gl_LocalInvocationIndex == 0u) {
        uint after = (turn + 1u) % 3u;
        hangs[after] = grows[after] = lacks[after] = 0u;
    }
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

// What hangs; and F as the first front, and the ring at distance 0.
void find_rest(uvec3 at)
{
    uint hanging = wanted(at.x, at.y, at.z + 1u), i = at.y * counts.w + at.x;
    hanging = hanging != 0u ? hanging & ~carried(at.x, at.y, at.z) : 0u;
    uint stands = firm(at.x, at.y, at.z) & column_mask(at.x);
    rest[i] = hanging;
    braced[place(at.x, at.y, at.z)] = 0u;
    slices[slot(FRONT, at.x, at.y)] = stands;
    slices[slot(RINGS, at.x, at.y)] = stands;
    slices[slot(RINGS + 1u, at.x, at.y)] = 0u;
    slices[slot(RINGS + 2u, at.x, at.y)] = 0u;
    if (hanging != 0u) {
        hangs[turn] = 1u;
    }
}

// The front at distance d, of the one before it.
void go_out(uvec3 at, uint d)
{
    uint reached = slices[slot(RINGS, at.x, at.y)] | slices[slot(RINGS + 1u, at.x, at.y)] |
                   slices[slot(RINGS + 2u, at.x, at.y)];
    uint fresh = around_front(at.x, at.y, at.z) & column_mask(at.x) & ~reached;
    slices[slot(FRONT + 1u - front, at.x, at.y)] = fresh;
    if (fresh != 0u) {
        slices[slot(RINGS + d % 3u, at.x, at.y)] |= fresh;
        grows[turn] = 1u;
    }
    if ((rest[at.y * counts.w + at.x] & ~(reached | fresh)) != 0u) {
        lacks[turn] = 1u;
    }
}

uint rest_of(uint ring, uint w, uint y)
{
    return rest_at(w, y) & (is_within(w, y) ? slices[slot(RINGS + ring, w, y)] : 0u);
}

// A word of the carriers at an offset from what hangs at a distance of `ring` modulo 3.
void take(uvec3 at, uint ring, ivec2 offset)
{
    uint from = at.y - uint(offset.y), here = rest_of(ring, at.x, from);
    here = offset.x > 0   ? here << 1 | rest_of(ring, at.x - 1u, from) >> 31
           : offset.x < 0 ? here >> 1 | rest_of(ring, at.x + 1u, from) << 31
                          : here;
    uint fresh = here & slices[slot(RINGS + (ring + 2u) % 3u, at.x, at.y)];
    slices[slot(FRONT + front, at.x, at.y)] = fresh;
    if (fresh != 0u) {
        braced[place(at.x, at.y, at.z)] |= fresh;
    }
}

void serve(uvec3 at)
{
    uint i = at.y * counts.w + at.x, left = rest[i];
    if (left != 0u) {
        left &= ~around_front(at.x, at.y, at.z);
        rest[i] = left;
        if (left != 0u) {
            hangs[turn] = 1u;
        }
    }
}

void put_straight(uvec3 at)
{
    uint i = place(at.x, at.y, at.z), bits = braced[i] | rest[at.y * counts.w + at.x];
    braced[i] = bits;
    if (bits != 0u) {
        note(at, bits);
    }
}

void find_rings(uint n)
{
    uint me = gl_LocalInvocationIndex;
    front = 0u;
    for (uint d = 1u;; d++) {
        next_turn();
        for (uint i = me; i < n; i += 256u) {
            go_out(word_of(columns, i), d);
        }
        wait();
        front = 1u - front;
        if (grows[turn] == 0u || lacks[turn] == 0u) {
            return;
        }
    }
}

void cover(uint n)
{
    uint me = gl_LocalInvocationIndex;
    bool any = true;
    for (uint o = 0u; o < 27u && any; o++) {
        for (uint i = me; i < n; i += 256u) {
            take(word_of(columns, i), o / 9u, offsets[o % 9u]);
        }
        wait();
        next_turn();
        for (uint i = me; i < n; i += 256u) {
            serve(word_of(columns, i));
        }
        wait();
        any = hangs[turn] != 0u;
    }
}

// Layer z of X, where layer z + 1 is known.
void sweep_layer()
{
    uint me = gl_LocalInvocationIndex, n = words_in(columns);
    next_turn();
    for (uint i = me; i < n; i += 256u) {
        find_rest(word_of(columns, i));
    }
    wait();
    if (hangs[turn] == 0u) {
        return;
    }
    find_rings(n);
    cover(n);
    for (uint i = me; i < n; i += 256u) {
        put_straight(word_of(columns, i));
    }
    wait();
}

void main()
{
    uint me = gl_LocalInvocationIndex;
    turn = 0u;
    front = 0u;
    if (me == 0u) {
        for (uint i = 0u; i < 3u; i++) {
            hangs[i] = grows[i] = lacks[i] = 0u;
        }
        low_x = low_y = low_z = NONE;
        high_x = high_y = high_z = 0u;
    }
    wait();
    for (uint z = high.z; low.x < high.x && z > bed; z--) {
        columns = box(low.x, low.y, z - 1u, high.x, high.y, z);
        sweep_layer();
    }
    if (me == 0u) {
        ledger.edit = low_x < high_x ? box(low_x, low_y, low_z, high_x, high_y, high_z)
                                     : empty_box();
    }
}
