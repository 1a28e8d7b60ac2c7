// SPDX-License-Identifier: MIT
// Bed, columns: how far each voxel of the bed slice is from its closest matter, squared.
//
//     square(x, y) = min over i of (y - i)^2 + row_square(x, i)
//
// looked for outwards from y, until (y - i)^2 alone is no less. NONE where the slice is empty. The
// second half of what sfi_slice_distance() of libsf/voxel/distance.c does.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 13) readonly buffer row_square_block { uint row_square[]; };
layout(std430, binding = 14) writeonly buffer square_block { uint square[]; };

// d^2 + a row's square, or NONE.
uint sum(uint x, uint y, uint d)
{
    uint row = y < counts.y ? row_square[y * counts.x + x] : NONE;
    return row == NONE ? NONE : row + d * d;
}

void main()
{
    if (ledger.is_bed_wanted == 0u || ledger.is_bed_known != 0u) {
        return;
    }
    uint n = counts.x * counts.y;
    for (uint i = gl_GlobalInvocationID.x; i < n; i += STRIDE) {
        uint x = i % counts.x, y = i / counts.x, best = NONE;
        for (uint d = 0u; d < counts.y && d * d < best; d++) {
            best = min(best, min(sum(x, y - d, d), sum(x, y + d, d)));
        }
        square[i] = best;
    }
}
