// SPDX-License-Identifier: MIT
// Apply: a step of the history is undone, or done again, which is the same. Mirrors
// sfi_delta_apply() of libsf/sculpt/delta.c.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 12) readonly buffer history_block { uint history[]; };

void note(uint i)
{
    uint w = i % counts.w, y = i / counts.w % counts.y, z = i / (counts.w * counts.y);
    atomicMin(ledger.changed.x0, w * 32u);
    atomicMin(ledger.changed.y0, y);
    atomicMin(ledger.changed.z0, z);
    atomicMax(ledger.changed.x1, min(w * 32u + 32u, counts.x));
    atomicMax(ledger.changed.y1, y + 1u);
    atomicMax(ledger.changed.z1, z + 1u);
    if (z == bed) {
        ledger.is_bed_known = 0u;
    }
}

void main()
{
    for (uint k = gl_GlobalInvocationID.x; k < ledger.apply_count; k += STRIDE) {
        uint from = ledger.apply_start + k * RECORD, i = history[from];
        drawn[i] = drawn_before[i] = drawn[i] ^ history[from + 1u];
        printable[i] = printable_before[i] = printable[i] ^ history[from + 2u];
        for (uint q = 0u; q < 8u; q++) {
            uint four = materials[i * 8u + q] ^ history[from + 3u + q];
            materials[i * 8u + q] = materials_before[i * 8u + q] = four;
        }
        note(i);
    }
}
