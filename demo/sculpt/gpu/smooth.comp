// SPDX-License-Identifier: MIT
// Smooth: one pass. What most of its neighbours are, a voxel becomes.
//
// Within the tips a voxel is solid just when at least 14 of the 27 around it were, itself among
// them; elsewhere all is as before the stroke. A voxel that becomes solid takes the material that
// most of the solid ones around it had, of equals the lowest. Passes go from one pair of buffers to
// another and back, and only words with tips are written, since others are read from the state
// before the stroke. One that was solid before the stroke and is after it keeps what it had,
// whatever it was between.
//
// 32 voxels are counted at once: full adders add the 27 words up in bits of weight 1 to 16.
// Mirrors mostly_solid(), vote() and settle() of libsf/sculpt/brush_smooth.c.
#include "grid.glsl"
#include "state.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 10) readonly buffer from_block { uint from[]; };
layout(std430, binding = 11) readonly buffer from_materials_block { uint from_materials[]; };
layout(std430, binding = 12) buffer to_block { uint to[]; };
layout(std430, binding = 13) buffer to_materials_block { uint to_materials[]; };
layout(location = 2) uniform uint is_last; // pass

uint was(uint w, uint y, uint z)
{
    if (!is_in_grid(w, y, z)) {
        return 0u;
    }
    uint i = place(w, y, z), u = tips[i];
    return u != 0u ? (drawn_before[i] & ~u) | (from[i] & u) : drawn_before[i];
}

// The nine rows around a word: the word and a bit on either side, 34 bits in two.
uint middle[9], sides[9]; // sides: bit 0 before the word's first, bit 1 after its last

void look(uvec3 at)
{
    for (uint r = 0u; r < 9u; r++) {
        uint y = at.y + r % 3u - 1u, z = at.z + r / 3u - 1u;
        middle[r] = was(at.x, y, z);
        sides[r] = was(at.x - 1u, y, z) >> 31 | (was(at.x + 1u, y, z) & 1u) << 1;
    }
}

// Adds a word to a number for each bit.
void count(inout uint sums[5], uint word)
{
    for (uint b = 0u; b < 5u; b++) {
        uint carry = sums[b] & word;
        sums[b] ^= word;
        word = carry;
    }
}

uint mostly_solid()
{
    uint sums[5] = uint[5](0u, 0u, 0u, 0u, 0u);
    for (uint r = 0u; r < 9u; r++) {
        count(sums, middle[r]);
        count(sums, middle[r] << 1 | (sides[r] & 1u));
        count(sums, middle[r] >> 1 | sides[r] >> 1 << 31);
    }
    return sums[4] | (sums[3] & sums[2] & sums[1]); // 16 or more; 14 or 15
}

uint material_at(uint x, uint y, uint z)
{
    uint i = place(x / 32u, y, z), bit = x % 32u;
    uint word = i * 8u + bit / 4u;
    uint four = (tips[i] >> bit & 1u) != 0u ? from_materials[word] : materials_before[word];
    return four >> bit % 4u * 8u & 255u;
}

// Materials around voxel `bit` of the word, 0 where nothing is solid; the least and the most.
uint seen[27];

void gather(uvec3 at, uint bit, out uint least, out uint most)
{
    least = NONE;
    most = 0u;
    for (uint r = 0u; r < 9u; r++) {
        for (uint dx = 0u; dx < 3u; dx++) {
            uint b = bit + dx - 1u, material = 0u;
            uint solid = b == NONE ? sides[r] : b == 32u ? sides[r] >> 1 : middle[r] >> b;
            if ((solid & 1u) != 0u) {
                material = material_at(at.x * 32u + b, at.y + r % 3u - 1u, at.z + r / 3u - 1u);
                least = min(least, material);
                most = max(most, material);
            }
            seen[r * 3u + dx] = material;
        }
    }
}

uint vote(uvec3 at, uint bit)
{
    uint best, highest, most = 0u;
    gather(at, bit, best, highest);
    if (best == highest) {
        return best;
    }
    for (uint i = 0u; i < 27u; i++) {
        uint votes = 0u;
        for (uint j = 0u; j < 27u; j++) {
            votes += seen[j] == seen[i] ? 1u : 0u;
        }
        votes = seen[i] != 0u ? votes : 0u;
        if (votes > most || (votes == most && votes > 0u && seen[i] < best)) {
            most = votes;
            best = seen[i];
        }
    }
    return best;
}

void write_materials(uvec3 at, uint i, uint stays, uint fresh)
{
    uint votes[8] = uint[8](0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), same = (stays | fresh) & drawn_before[i];
    same = is_last != 0u ? same : 0u;
    for (uint left = fresh & ~same; left != 0u; left &= left - 1u) {
        uint bit = uint(findLSB(left));
        votes[bit / 4u] |= vote(at, bit) << bit % 4u * 8u;
    }
    for (uint q = 0u; q < 8u; q++) {
        uint before = materials_before[i * 8u + q], u = bytes_of(tips[i] >> q * 4u);
        uint old = (from_materials[i * 8u + q] & u) | (before & ~u);
        to_materials[i * 8u + q] = (old & bytes_of((stays & ~same) >> q * 4u)) |
                                   (before & bytes_of(same >> q * 4u)) | votes[q];
    }
}

void main()
{
    box e = ledger.edit;
    uint n = words_in(e);
    for (uint k = gl_GlobalInvocationID.x; k < n; k += STRIDE) {
        uvec3 at = word_of(e, k);
        uint i = place(at.x, at.y, at.z), u = tips[i];
        if (u == 0u) {
            continue;
        }
        look(at);
        uint old = middle[4], solid = (old & ~u) | (mostly_solid() & u);
        write_materials(at, i, solid & old, solid & ~old);
        to[i] = solid;
    }
}
