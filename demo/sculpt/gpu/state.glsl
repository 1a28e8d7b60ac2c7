// SPDX-License-Identifier: MIT
// What a model holds on the GPU: two states and the union of a stroke's tips.
//
// `now` is what the model is, `before` what it was when the stroke began. They differ only within
// ledger.touched; with no stroke under way they are the same, and `tips` is empty. Materials are
// bytes, four in a word, 32 for each word of bits, and 0 where nothing is drawn.
//
// A shader that writes and reads a buffer in turns, with barriers between, defines SHARED as
// coherent before it includes this.

#ifndef SHARED
#define SHARED
#endif

layout(std430, binding = 0) SHARED buffer drawn_block { uint drawn[]; };
layout(std430, binding = 1) SHARED buffer printable_block { uint printable[]; };
layout(std430, binding = 2) SHARED buffer materials_block { uint materials[]; };
layout(std430, binding = 3) buffer drawn_before_block { uint drawn_before[]; };
layout(std430, binding = 4) buffer printable_before_block { uint printable_before[]; };
layout(std430, binding = 5) buffer materials_before_block { uint materials_before[]; };
layout(std430, binding = 6) buffer tips_block { uint tips[]; };

// What only the GPU knows. The host mirrors this in ledger.h.
struct history_step {
    uint start, count; // in the history: first word, and records
};

const uint STEPS = 4096u; // places for steps; a power of two
const uint RECORD = 11u;  // words of a record

layout(std430, binding = 7) SHARED buffer ledger_block {
    box edit;    // where this call changes D
    box touched; // what the stroke changed so far lies in it
    box changed; // what the last call changed lies in it
    // Of the stroke, in voxels, as in sf_sculpt_change.
    uint added_voxels, removed_voxels, lost_voxels, kept_back_voxels, path_voxels;
    // History: steps first <= i < end are there, those from `here` on undone.
    uint first, here, end, forgotten, capacity;
    uint changed_words; // of the stroke that ends
    uint cursor;        // records of it that are written
    uint start;         // where they go, or NONE
    uint apply_start, apply_count; // the step that is undone or done again
    uint is_bed_wanted, is_bed_known; // distances on the bed
    history_step steps[STEPS];
} ledger;

// Four bits as four bytes of ones.
uint bytes_of(uint bits)
{
    return ((bits & 1u) | (bits & 2u) << 7 | (bits & 4u) << 14 | (bits & 8u) << 21) * 255u;
}

// From one word to the next of an invocation, where words are spread over all of them.
#define STRIDE (gl_NumWorkGroups.x * gl_WorkGroupSize.x)
