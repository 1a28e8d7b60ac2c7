// SPDX-License-Identifier: MIT
// Paths: what the shaders of add-grow tell each other.
//
// For each put a path: how it ends, where it lands, how deep that lies below the voxel; then its
// voxels from the top, x and y in 16 bits each, voxel i in layer z - 1 - i.

struct landing {
    uint end, x, y, depth;
};

const uint NO_PATH = 0u, ON_MATTER = 1u, ON_BED = 2u;

layout(std430, binding = 12) buffer landings_block { landing landings[]; };
layout(std430, binding = 13) buffer chains_block { uint chains[]; }; // nz for each put
layout(std430, binding = 14) buffer square_block { uint square[]; }; // distances on the bed

uint chain_length(landing l)
{
    return l.end == NO_PATH ? 0u : l.end == ON_BED ? l.depth : l.depth - 1u;
}

uint apart(uint a, uint b)
{
    return a > b ? a - b : b - a;
}

uint off_square(put p, uint x, uint y)
{
    uint dx = apart(x, uint(p.x)), dy = apart(y, uint(p.y));
    return dx * dx + dy * dy;
}

// The columns and rows that t steps down can reach, within the grid.
box window(put p, uint t)
{
    uint x = uint(p.x), y = uint(p.y), z = uint(p.z) - t;
    return box(x - min(x, t), y - min(y, t), z, min(x + t + 1u, counts.x),
               min(y + t + 1u, counts.y), z + 1u);
}
