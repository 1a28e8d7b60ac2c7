// SPDX-License-Identifier: MIT
// What the ray of each pixel meets, left for shading.

#include "march.glsl"

layout(location = 4) uniform vec3 eye; // and what follows: view_frame in voxels
layout(location = 5) uniform vec3 forward;
layout(location = 6) uniform vec3 right;
layout(location = 7) uniform vec3 up;
layout(location = 8) uniform int with_ghosts;
layout(location = 9) uniform int bed;

in vec2 place; // in the picture, -1 to 1

layout(location = 0) out vec2 distances; // of what is met and of a ghost; negative: none
layout(location = 1) out uvec4 kinds;    // material, face and flags, face of the ghost, 1 where met

const uint IS_CUT = 8u, LEANS = 16u;

void main()
{
    vec3 way = forward + place.x * right + place.y * up;
    hit h = march(eye, way, with_ghosts != 0);
    distances = vec2(h.t, h.ghost);
    kinds = uvec4(0u, 0u, uint(h.ghost_face), 0u);
    if (h.t >= 0.0) {
        ivec3 below = h.voxel - ivec3(0, 0, 1);
        // It leans where nothing is straight below, and it does not lie on the bed.
        bool leans = h.voxel.z > bed && !bit_of(printable[place_of(below)], below.x);
        kinds = uvec4(material_of(h.voxel), uint(h.face) | (h.is_cut ? IS_CUT : 0u) |
                      (leans ? LEANS : 0u), uint(h.ghost_face), 1u);
    }
}
