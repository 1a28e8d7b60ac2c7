// SPDX-License-Identifier: MIT
// Bed, rows: how far each voxel of the bed slice is from the closest matter of its row, squared.
//
// The first half of a distance transform; with bed_columns.comp it gives what sfi_slice_distance()
// of libsf/voxel/distance.c gives, which goes down columns first. Nothing is done where no path
// asked for it, or where it is known already.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 13) writeonly buffer row_square_block { uint row_square[]; };

READ(solid_at, printable_before)

uint closest(uint x, uint y)
{
    uint w = x / 32u, bit = x % 32u, best = NONE;
    for (uint i = w; i < counts.w; i++) {
        uint right = solid_at(i, y, bed) & (i == w ? NONE << bit : NONE);
        if (right != 0u) {
            best = i * 32u + uint(findLSB(right)) - x;
            break;
        }
    }
    for (uint i = w + 1u; i > 0u; i--) {
        uint left = solid_at(i - 1u, y, bed) & (i == w + 1u ? NONE >> (31u - bit) : NONE);
        if (left != 0u) {
            return min(best, x - (i - 1u) * 32u - uint(findMSB(left)));
        }
    }
    return best;
}

void main()
{
    if (ledger.is_bed_wanted == 0u || ledger.is_bed_known != 0u) {
        return;
    }
    uint n = counts.x * counts.y;
    for (uint i = gl_GlobalInvocationID.x; i < n; i += STRIDE) {
        uint g = closest(i % counts.x, i / counts.x);
        row_square[i] = g == NONE ? NONE : g * g;
    }
}
