// SPDX-License-Identifier: MIT
// Land: where a path ends that found no matter, and the voxels of every path.
//
// On the bed the best voxel of the window is the one closest to the bed's matter, of equals the one
// closest to the voxel, then the least y, then the least x; where the bed slice is empty, straight
// below. Mirrors sfi_bed_choose() of libsf/support/grow/bed.c, without its tiles.
//
// The chain is built from its end: of the last steps that leave the rest within the window of one
// step less, the one closest to the straight line, of equals the shorter in y. Mirrors
// sfi_cone_chain() and choose_step() of libsf/support/grow/cone.c for box3, where a window is a
// square. The box of what changes grows by the tip along the chain.
#include "grid.glsl"
#include "state.glsl"
#include "tip.glsl"
#include "paths.glsl"

layout(local_size_x = 64) in;

shared uint least, least_off, least_at;

// The bed's best voxel within the window of t steps, by all invocations.
uvec2 choose(put p, uint t)
{
    box b = window(p, t);
    uint wide = b.x1 - b.x0, n = wide * (b.y1 - b.y0);
    uint first = NONE, off = NONE, at = NONE;
    for (uint i = gl_LocalInvocationIndex; i < n; i += 64u) {
        uint x = b.x0 + i % wide, y = b.y0 + i / wide, here = square[y * counts.x + x];
        uint here_off = off_square(p, x, y), here_at = y << 16 | x;
        if (here < first || (here == first && (here_off < off ||
                                               (here_off == off && here_at < at)))) {
            first = here;
            off = here_off;
            at = here_at;
        }
    }
    atomicMin(least, first);
    memoryBarrierShared();
    barrier();
    if (first == least) {
        atomicMin(least_off, off);
    }
    memoryBarrierShared();
    barrier();
    if (first == least && off == least_off) {
        atomicMin(least_at, at);
    }
    memoryBarrierShared();
    barrier();
    return uvec2(least_at & 65535u, least_at >> 16);
}

uint stray(uint step, uint d, uint depth)
{
    uint off = apart(step * depth, d);
    return off * off;
}

// The last of `depth` steps that make d.
uvec2 choose_step(uvec2 d, uint depth)
{
    uvec2 best_step = uvec2(0u);
    uint least_stray = NONE;
    for (uint sy = 0u; sy <= min(d.y, 1u); sy++) {
        if (d.y - sy > depth - 1u) {
            continue;
        }
        uint fewest = d.x > depth - 1u ? d.x - (depth - 1u) : 0u, most = min(d.x, 1u);
        uint sx = clamp((2u * d.x + depth - 1u) / (2u * depth), fewest, most);
        uint here = stray(sx, d.x, depth) + stray(sy, d.y, depth);
        if (here < least_stray) {
            least_stray = here;
            best_step = uvec2(sx, sy);
        }
    }
    return best_step;
}

// Note a voxel of a path, and the box of the tip there.
void add_voxel(put p, uint i, uint x, uint y)
{
    chains[gl_WorkGroupID.x * counts.z + i] = y << 16 | x;
    ivec3 low = ivec3(x, y, uint(p.z) - 1u - i) +
                ivec3(p.corner_x - p.x, p.corner_y - p.y, p.corner_z - p.z);
    ivec3 high = min(low + ivec3(tip_counts.x * 32u, tip_counts.y, tip_counts.z), ivec3(counts));
    low = max(low, ivec3(0));
    if (low.x < high.x && low.y < high.y && low.z < high.z) {
        atomicMin(ledger.edit.x0, uint(low.x));
        atomicMin(ledger.edit.y0, uint(low.y));
        atomicMin(ledger.edit.z0, uint(low.z));
        atomicMax(ledger.edit.x1, uint(high.x));
        atomicMax(ledger.edit.y1, uint(high.y));
        atomicMax(ledger.edit.z1, uint(high.z));
    }
    uint z = uint(p.z) - 1u - i;
    atomicMin(ledger.edit.x0, x);
    atomicMin(ledger.edit.y0, y);
    atomicMin(ledger.edit.z0, z);
    atomicMax(ledger.edit.x1, x + 1u);
    atomicMax(ledger.edit.y1, y + 1u);
    atomicMax(ledger.edit.z1, z + 1u);
}

void build_chain(put p, landing l)
{
    uint n = chain_length(l);
    uvec2 d = uvec2(apart(l.x, uint(p.x)), apart(l.y, uint(p.y)));
    ivec2 way = ivec2(l.x > uint(p.x) ? 1 : -1, l.y > uint(p.y) ? 1 : -1);
    if (n == l.depth && n > 0u) {
        add_voxel(p, n - 1u, l.x, l.y);
    }
    for (uint depth = l.depth; depth > 1u; depth--) {
        d -= choose_step(d, depth);
        add_voxel(p, depth - 2u, uint(p.x + way.x * int(d.x)), uint(p.y + way.y * int(d.y)));
    }
    atomicAdd(ledger.path_voxels, n);
}

void main()
{
    put p = puts[gl_WorkGroupID.x];
    landing l = landings[gl_WorkGroupID.x];
    if (gl_LocalInvocationIndex == 0u) {
        least = least_off = least_at = NONE;
    }
    memoryBarrierShared();
    barrier();
    if (l.end == ON_BED && square[l.y * counts.x + l.x] != NONE) {
        uvec2 to = choose(p, l.depth);
        l.x = to.x;
        l.y = to.y;
    }
    if (gl_LocalInvocationIndex == 0u) {
        landings[gl_WorkGroupID.x] = l;
        if (l.end != NO_PATH) {
            build_chain(p, l);
        }
        if (l.end == ON_BED) {
            ledger.is_bed_known = 1u;
        }
    }
}
