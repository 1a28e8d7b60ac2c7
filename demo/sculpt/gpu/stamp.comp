// SPDX-License-Identifier: MIT
// Stamp: the union of a stroke's tips gains those of new dabs.
//
// One invocation a word of a tip that is put. Most of these are there already, because dabs lie a
// voxel apart; so a word is looked at before it is changed. Mirrors sfi_grid_stamp() of
// libsf/voxel/stamp.c.
#include "grid.glsl"
#include "state.glsl"
#include "tip.glsl"

layout(local_size_x = 64) in;

void main()
{
    put p = puts[gl_WorkGroupID.y];
    uint at, bits = tip_piece(p.way, ivec3(p.corner_x, p.corner_y, p.corner_z),
                              gl_GlobalInvocationID.x, at);
    if ((bits & ~tips[at]) != 0u) {
        atomicOr(tips[at], bits);
    }
}
