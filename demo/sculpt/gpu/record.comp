// SPDX-License-Identifier: MIT
// Record: what a stroke changed goes into the history, and the state before becomes the state now.
//
// A record is the place of a word of bits, and the exclusive or of both states there: of D, of T, of
// eight words of materials. So one rule undoes a step and does it again; and since each word has one
// record their order does not matter, which on a GPU is another each time. The union of the tips,
// and what add-grow added, are emptied on the way. Mirrors sfi_delta_write() of
// libsf/sculpt/delta.c, sfi_sculpt_copy() of state.c and clear() of stroke.c.
//
// Where a stroke is given up the state before is copied back instead.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 10) buffer grown_block { uint grown[]; };
layout(std430, binding = 12) writeonly buffer history_block { uint history[]; };
layout(location = 2) uniform uint is_given_up;

void copy_back(uint i)
{
    drawn[i] = drawn_before[i];
    printable[i] = printable_before[i];
    for (uint q = i * 8u; q < i * 8u + 8u; q++) {
        materials[q] = materials_before[q];
    }
}

bool is_changed(uint i)
{
    bool differs = drawn[i] != drawn_before[i] || printable[i] != printable_before[i];
    for (uint q = i * 8u; q < i * 8u + 8u && !differs; q++) {
        differs = materials[q] != materials_before[q];
    }
    return differs;
}

void write_record(uint i)
{
    uint at = ledger.start + atomicAdd(ledger.cursor, 1u) * RECORD;
    history[at] = i;
    history[at + 1u] = drawn[i] ^ drawn_before[i];
    history[at + 2u] = printable[i] ^ printable_before[i];
    for (uint q = 0u; q < 8u; q++) {
        history[at + 3u + q] = materials[i * 8u + q] ^ materials_before[i * 8u + q];
    }
}

void commit(uint i, uint z)
{
    if (ledger.start != NONE) {
        write_record(i);
    }
    if (z == bed && printable[i] != printable_before[i]) {
        ledger.is_bed_known = 0u;
    }
    drawn_before[i] = drawn[i];
    printable_before[i] = printable[i];
    for (uint q = i * 8u; q < i * 8u + 8u; q++) {
        materials_before[q] = materials[q];
    }
}

void main()
{
    box b = ledger.touched;
    uint n = words_in(b);
    for (uint k = gl_GlobalInvocationID.x; k < n; k += STRIDE) {
        uvec3 at = word_of(b, k);
        uint i = place(at.x, at.y, at.z);
        tips[i] = 0u;
        grown[i] = 0u;
        if (!is_changed(i)) {
            continue;
        }
        if (is_given_up != 0u) {
            copy_back(i);
        } else {
            commit(i, at.z);
        }
    }
}
