// SPDX-License-Identifier: MIT
// Points of a stage: each a square that faces the viewer. Six vertices a point.

#include "stage_frame.glsl"

struct Point {
    float x, y, z, radius;
    uint rgba;
};

layout(std430, binding = 0) readonly buffer Points { Point points[]; };
layout(location = 6) uniform float magnified; // pixels to one

out vec4 ink;
out vec2 off;    // from the middle, pixels
out float reach; // the disc's radius, pixels

void main()
{
    const vec2 corners[6] = vec2[6](vec2(-1, -1), vec2(1, -1), vec2(-1, 1),
                                        vec2(-1, 1), vec2(1, -1), vec2(1, 1));
    Point p = points[gl_VertexID / 6];
    reach = p.radius * magnified;
    off = corners[gl_VertexID % 6] * (reach + 2.0);
    ink = unpackUnorm4x8(p.rgba);
    gl_Position = clip_of(vec3(p.x, p.y, p.z));
    gl_Position.xy += 2.0 * off / size * gl_Position.w;
}
