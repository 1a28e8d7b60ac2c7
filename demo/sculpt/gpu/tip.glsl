// SPDX-License-Identifier: MIT
// Tips and where they are put.
//
// A tip lies in a buffer of its own, row by row, once for each way that a stroke mirrors it. A put
// is a dab, mirrored or not. To put a tip at x moves its words by x bits, so that a row of n words
// falls on n + 1.

layout(std430, binding = 8) readonly buffer tip_block { uint tip[]; };

struct put {
    int x, y, z; // the voxel, which may lie beyond the grid
    int corner_x, corner_y, corner_z; // where the tip's first voxel comes to lie
    uint way;
    uint unused;
};

layout(std430, binding = 9) readonly buffer puts_block { put puts[]; };

layout(location = 5) uniform uvec4 tip_counts; // words of a row, rows, layers, words of one way
layout(location = 6) uniform uint put_count;

// Of piece i of a tip that is moved by `by`: a word of the grid and the bits that it covers there,
// 0 where that lies outside. There are (words of a row + 1) * rows * layers pieces.
uint tip_piece(uint way, ivec3 by, uint i, out uint at)
{
    uint j = i % (tip_counts.x + 1u), row = i / (tip_counts.x + 1u), shift = uint(by.x & 31);
    ivec3 to = ivec3((by.x >> 5) + int(j), by.y + int(row % tip_counts.y),
                     by.z + int(row / tip_counts.y));
    uint first = way * tip_counts.w + row * tip_counts.x;
    at = 0u;
    if (row >= tip_counts.y * tip_counts.z || !is_in_grid(uint(to.x), uint(to.y), uint(to.z))) {
        return 0u;
    }
    uint bits = j < tip_counts.x ? tip[first + j] << shift : 0u;
    bits |= j > 0u && shift > 0u ? tip[first + j - 1u] >> (32u - shift) : 0u;
    at = place(uint(to.x), uint(to.y), uint(to.z));
    return bits & width_mask(uint(to.x));
}
