// SPDX-License-Identifier: MIT
// Paint: what is drawn within the tips takes a material. Mirrors sfi_brush_paint() of
// libsf/sculpt/brush_set.c.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(location = 3) uniform uint material; // in all four bytes

void main()
{
    box e = ledger.edit;
    uint n = words_in(e);
    for (uint k = gl_GlobalInvocationID.x; k < n; k += STRIDE) {
        uvec3 at = word_of(e, k);
        uint i = place(at.x, at.y, at.z), bits = drawn[i] & tips[i];
        for (uint q = 0u; q < 8u && bits != 0u; q++) {
            uint painted = bytes_of(bits);
            if (painted != 0u) {
                materials[i * 8u + q] = (materials[i * 8u + q] & ~painted) | (material & painted);
            }
            bits >>= 4;
        }
    }
}
