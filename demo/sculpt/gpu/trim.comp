// SPDX-License-Identifier: MIT
// Trim: one layer of the printable part of all that is drawn, over the layer below.
//
//     T_k = 0 below the bed,   T_bed = D_bed,   T_{k+1} = D_{k+1} and dilate(T_k)
//
// The host sweeps up, a dispatch for each layer, as in the paper: within a layer no voxel waits for
// another. Mirrors trim_slice() of libsf/support/trim/trim.c.
//
// Source: T. Reiner, S. Lefebvre, "Interactive Modeling of Support-free Shapes for Fabrication",
// Eurographics 2016, section 3.2 (the sweep by dispatches).
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(location = 2) uniform uint layer;

READ(printable_at, printable)
DILATE(carried, printable_at)

void main()
{
    uint n = counts.w * counts.y;
    for (uint i = gl_GlobalInvocationID.x; i < n; i += STRIDE) {
        uint w = i % counts.w, y = i / counts.w, at = place(w, y, layer), solid = drawn[at];
        solid = layer < bed ? 0u : layer == bed ? solid : solid & carried(w, y, layer - 1u);
        printable[at] = solid;
    }
}
