// SPDX-License-Identifier: MIT
// Which bricks of 8 x 8 x 8 voxels hold anything, for those within a box of bricks.

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

layout(std430, binding = 0) readonly buffer drawn_block { uint drawn[]; };
layout(std430, binding = 1) readonly buffer printable_block { uint printable[]; };
layout(std430, binding = 3) buffer bricks_block { uint bricks[]; };

layout(location = 0) uniform uvec4 counts; // nx, ny, nz, words of a row
layout(location = 1) uniform uvec4 brick_counts;
layout(location = 2) uniform uvec3 first; // brick
layout(location = 3) uniform uvec3 past;

void main()
{
    uvec3 b = first + gl_GlobalInvocationID;
    if (any(greaterThanEqual(b, past))) {
        return;
    }
    uint all = 0u, end_y = min(b.y * 8u + 8u, counts.y), end_z = min(b.z * 8u + 8u, counts.z);
    for (uint z = b.z * 8u; z < end_z; z++) {
        for (uint y = b.y * 8u; y < end_y; y++) {
            uint at = (z * counts.y + y) * counts.w + b.x / 4u;
            all |= (drawn[at] | printable[at]) >> b.x % 4u * 8u & 255u;
        }
    }
    bricks[(b.z * brick_counts.y + b.y) * brick_counts.x + b.x] = all != 0u ? 1u : 0u;
}
