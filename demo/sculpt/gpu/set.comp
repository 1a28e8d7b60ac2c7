// SPDX-License-Identifier: MIT
// Set: what is drawn, out of what was drawn before the stroke and its tips.
//
//     add               D = D0 + U
//     remove            D = D0 \ U
//     keep (preserve)   D = D0 \ (U \ T)
//     grow              D = D0 + U + W         W: tips along paths, and the paths
//     brace             D = D0 + U + W + X     X: what U still lacked
//
// A voxel that was drawn keeps its material, a new one takes the brush's. Mirrors set() of
// libsf/sculpt/brush_set.c, follow() of brush_preserve.c and what brush_grow.c does to D.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 10) readonly buffer grown_block { uint grown[]; };
layout(std430, binding = 11) readonly buffer braced_block { uint braced[]; };
layout(location = 2) uniform uint mode;
layout(location = 3) uniform uint material; // in all four bytes

const uint ADD = 0u, REMOVE = 1u, KEEP = 2u, GROW = 3u, BRACE = 4u;

uint word(uint i)
{
    uint was = drawn_before[i];
    switch (mode) {
    case ADD: return was | tips[i];
    case REMOVE: return was & ~tips[i];
    case KEEP: return was & (~tips[i] | printable[i]);
    case GROW: return was | tips[i] | grown[i];
    default: return was | tips[i] | grown[i] | braced[i];
    }
}

void main()
{
    box e = ledger.edit;
    uint n = words_in(e);
    for (uint k = gl_GlobalInvocationID.x; k < n; k += STRIDE) {
        uvec3 at = word_of(e, k);
        uint i = place(at.x, at.y, at.z), fresh = word(i), was = drawn_before[i];
        if (fresh == drawn[i]) {
            continue; // and materials are what they should be
        }
        drawn[i] = fresh;
        for (uint q = 0u; q < 8u; q++) {
            uint old = bytes_of(was & fresh), added = bytes_of(fresh & ~was);
            materials[i * 8u + q] = (materials_before[i * 8u + q] & old) | (material & added);
            was >>= 4;
            fresh >>= 4;
        }
    }
}
