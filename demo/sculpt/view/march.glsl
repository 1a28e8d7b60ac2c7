// SPDX-License-Identifier: MIT
// A ray through voxels.
//
// A walk from voxel to voxel through words of bits, with one shortcut: bricks of 8 x 8 x 8 voxels of
// which none is solid are left in one step. Coordinates are voxels. Where the view is cut, the
// voxels beyond the cut are not there.
//
// Source: J. Amanatides, A. Woo, "A fast voxel traversal algorithm for ray tracing", 1987. On the
// processor it is view/pick.c.

layout(std430, binding = 0) readonly buffer drawn_block { uint drawn[]; };
layout(std430, binding = 1) readonly buffer printable_block { uint printable[]; };
layout(std430, binding = 2) readonly buffer materials_block { uint materials[]; };
layout(std430, binding = 3) readonly buffer bricks_block { uint bricks[]; };

layout(location = 0) uniform uvec4 counts;     // nx, ny, nz, words of a row
layout(location = 1) uniform uvec4 brick_counts;
layout(location = 2) uniform ivec3 low;  // first voxel that is there
layout(location = 3) uniform ivec3 high; // and past the last

struct hit {
    float t;      // how far along the ray; negative where it meets nothing
    ivec3 voxel;
    int face;     // 2 * axis, and 1 for the high side
    bool is_cut;  // it was met where the view is cut
    float ghost;  // how far a ghost is, before what was met; negative where there is none
    int ghost_face;
};

bool bit_of(uint word, int x)
{
    return (word >> (uint(x) & 31u) & 1u) != 0u;
}

uint place_of(ivec3 v)
{
    return (uint(v.z) * counts.y + uint(v.y)) * counts.w + (uint(v.x) >> 5);
}

bool is_there(ivec3 v)
{
    return all(greaterThanEqual(v, low)) && all(lessThan(v, high));
}

uint material_of(ivec3 v)
{
    uint at = place_of(v) * 32u + (uint(v.x) & 31u);
    return materials[at >> 2] >> (at & 3u) * 8u & 255u;
}

int least(vec3 a)
{
    return a.x < a.y ? (a.x < a.z ? 0 : 2) : (a.y < a.z ? 1 : 2);
}

bool is_brick_empty(ivec3 v)
{
    uvec3 b = uvec3(v >> 3);
    return bricks[(b.z * brick_counts.y + b.y) * brick_counts.x + b.x] == 0u;
}

int face_of(int axis, ivec3 steps)
{
    return 2 * axis + (steps[axis] < 0 ? 1 : 0);
}

hit march(vec3 from, vec3 way, bool with_ghosts)
{
    hit h = hit(-1.0, ivec3(0), 0, false, -1.0, 0);
    way = mix(way, vec3(1e-12), equal(way, vec3(0.0)));
    vec3 inverse = 1.0 / way;
    vec3 a = (vec3(low) - from) * inverse, b = (vec3(high) - from) * inverse;
    vec3 first = min(a, b), last = max(a, b);
    float t = max(max(first.x, first.y), max(first.z, 0.0));
    if (t >= min(last.x, min(last.y, last.z))) {
        return h;
    }
    ivec3 steps = ivec3(sign(way));
    int axis = t > 0.0 ? least(-first) : 2;
    bool is_entering = t > 0.0;
    ivec3 v = clamp(ivec3(floor(from + way * t)), low, high - 1);
    vec3 next = (vec3(v + max(steps, ivec3(0))) - from) * inverse;
    for (int i = 0; i < 8192; i++) {
        if (is_brick_empty(v)) {
            ivec3 edge = mix(v & ~7, (v | 7) + 1, greaterThan(steps, ivec3(0)));
            vec3 leave = (vec3(edge) - from) * inverse;
            axis = least(leave);
            t = leave[axis];
            ivec3 w = clamp(ivec3(floor(from + way * t)), v & ~7, v | 7);
            w[axis] = steps[axis] > 0 ? edge[axis] : edge[axis] - 1;
            v = w;
            next = (vec3(v + max(steps, ivec3(0))) - from) * inverse;
        } else {
            uint at = place_of(v);
            if (bit_of(printable[at], v.x)) {
                h.t = t;
                h.voxel = v;
                h.face = face_of(axis, steps);
                h.is_cut = is_entering;
                return h;
            }
            if (with_ghosts && h.ghost < 0.0 && bit_of(drawn[at], v.x)) {
                h.ghost = t;
                h.ghost_face = face_of(axis, steps);
            }
            axis = least(next);
            t = next[axis];
            v[axis] += steps[axis];
            next[axis] += abs(inverse[axis]);
        }
        is_entering = false;
        if (!is_there(v)) {
            return h;
        }
    }
    return h;
}
