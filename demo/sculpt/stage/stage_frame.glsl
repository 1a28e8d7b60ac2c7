// SPDX-License-Identifier: MIT
// From mm to the picture.

layout(location = 0) uniform vec3 eye; // and what follows: view_frame, mm
layout(location = 1) uniform vec3 forward;
layout(location = 2) uniform vec3 right;
layout(location = 3) uniform vec3 up;
layout(location = 4) uniform vec2 depths; // what is nearer than the first is cut, farther too
layout(location = 5) uniform vec2 size;   // of the picture, pixels

struct Vertex {
    float x, y, z;
    uint rgba;
};

vec4 clip_of(vec3 at)
{
    vec3 to = at - eye;
    float z = dot(to, forward), n = depths.x, f = depths.y;
    return vec4(dot(to, right) / dot(right, right), dot(to, up) / dot(up, up),
                (z * (f + n) - 2.0 * f * n) / (f - n), z);
}
