// SPDX-License-Identifier: MIT
// Emit: the tip at every voxel of every path, and the path itself.
//
// An invocation takes one piece of the tip all along a path, since a piece mostly falls on what the
// one above it covered. Mirrors stamp() of libsf/support/grow/emit.c; the trim that it asks for is
// the walk that follows.
#include "grid.glsl"
#include "state.glsl"
#include "tip.glsl"
#include "paths.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 10) buffer grown_block { uint grown[]; };

void add(uint at, uint bits)
{
    if ((bits & ~grown[at]) != 0u) {
        atomicOr(grown[at], bits);
    }
}

void main()
{
    uint path = gl_WorkGroupID.y, piece = gl_GlobalInvocationID.x;
    put p = puts[path];
    uint n = chain_length(landings[path]);
    for (uint i = 0u; i < n; i++) {
        uint voxel = chains[path * counts.z + i], at;
        ivec3 v = ivec3(voxel & 65535u, voxel >> 16, p.z - 1 - int(i));
        ivec3 by = v + ivec3(p.corner_x - p.x, p.corner_y - p.y, p.corner_z - p.z);
        uint bits = tip_piece(p.way, by, piece, at);
        if (bits != 0u) {
            add(at, bits);
        }
        if (piece == 0u) {
            add(place(uint(v.x) / 32u, uint(v.y), uint(v.z)), 1u << (uint(v.x) % 32u));
        }
    }
}
