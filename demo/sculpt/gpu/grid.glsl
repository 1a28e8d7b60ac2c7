// SPDX-License-Identifier: MIT
// Grids of bits, as all shaders see them.
//
// Voxel x of row y of layer z is bit x % 32 of word (z * ny + y) * row_words + x / 32. That is the
// order of <sf/voxel.h>, whose words are two of these; a row has an even number of them. Bits past
// the width are 0, always. What lies outside the grid is empty: coordinates are unsigned, so one
// less than 0 lies outside as well.

layout(location = 0) uniform uvec4 counts; // nx, ny, nz, words of a row
layout(location = 1) uniform uint bed;     // layer that rests on the bed

// A box of voxels, low corner within, high corner without; empty where it has x0 >= x1.
struct box {
    uint x0, y0, z0, x1, y1, z1;
};

const uint NONE = 0xffffffffu;

box empty_box()
{
    return box(NONE, NONE, NONE, 0u, 0u, 0u);
}

box join(box a, box b)
{
    return box(min(a.x0, b.x0), min(a.y0, b.y0), min(a.z0, b.z0), max(a.x1, b.x1),
               max(a.y1, b.y1), max(a.z1, b.z1));
}

uint place(uint w, uint y, uint z)
{
    return (z * counts.y + y) * counts.w + w;
}

bool is_in_grid(uint w, uint y, uint z)
{
    return w < counts.w && y < counts.y && z < counts.z;
}

// The words of a box, counted; word i of them is (word of the row, y, z).
uint words_in(box b)
{
    return b.x0 < b.x1 ? ((b.x1 + 31u) / 32u - b.x0 / 32u) * (b.y1 - b.y0) * (b.z1 - b.z0) : 0u;
}

uvec3 word_of(box b, uint i)
{
    uint wide = (b.x1 + 31u) / 32u - b.x0 / 32u, high = b.y1 - b.y0;
    return uvec3(b.x0 / 32u + i % wide, b.y0 + i / wide % high, b.z0 + i / (wide * high));
}

// Bits of word w that lie within the width.
uint width_mask(uint w)
{
    uint first = w * 32u;
    return first + 32u <= counts.x ? NONE : first < counts.x ? (1u << (counts.x - first)) - 1u : 0u;
}

// name(w, y, z) = a word of a grid that fills an array, 0 outside.
#define READ(name, array)                                                                          \
    uint name(uint w, uint y, uint z)                                                              \
    {                                                                                              \
        return is_in_grid(w, y, z) ? array[place(w, y, z)] : 0u;                                   \
    }

// name(w, y, z) = a word of what a layer carries by box3: its dilation by the 3 x 3 square.
#define DILATE(name, read)                                                                         \
    uint name(uint w, uint y, uint z)                                                              \
    {                                                                                              \
        uint all = 0u;                                                                             \
        for (uint i = 0u; i < 3u; i++) {                                                           \
            uint here = read(w, y + i - 1u, z);                                                    \
            all |= here | here << 1 | here >> 1 | read(w - 1u, y + i - 1u, z) >> 31 |              \
                   read(w + 1u, y + i - 1u, z) << 31;                                              \
        }                                                                                          \
        return all;                                                                                \
    }

// name(w, y, z) = a word of a layer's erosion by the same square.
#define ERODE(name, read)                                                                          \
    uint name(uint w, uint y, uint z)                                                              \
    {                                                                                              \
        uint all = NONE;                                                                           \
        for (uint i = 0u; i < 3u; i++) {                                                           \
            uint here = read(w, y + i - 1u, z);                                                    \
            all &= here & (here << 1 | read(w - 1u, y + i - 1u, z) >> 31) &                        \
                   (here >> 1 | read(w + 1u, y + i - 1u, z) << 31);                                \
        }                                                                                          \
        return all;                                                                                \
    }
