// SPDX-License-Identifier: MIT
// Lines of a stage: each a rectangle that is some pixels wide. Six vertices a line.

#include "stage_frame.glsl"

layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(location = 6) uniform float width; // pixels

out vec4 ink;

void main()
{
    const int ends[6] = int[6](0, 0, 1, 1, 0, 1), sides[6] = int[6](-1, 1, -1, -1, 1, 1);
    int i = gl_VertexID / 6, corner = gl_VertexID % 6;
    vec4 both[2];
    for (int k = 0; k < 2; k++) {
        Vertex v = vertices[2 * i + k];
        both[k] = clip_of(vec3(v.x, v.y, v.z));
    }
    for (int k = 0; k < 2; k++) { // what lies behind the eye comes to just before it
        if (both[k].w < depths.x && both[1 - k].w > depths.x) {
            float t = (depths.x - both[k].w) / (both[1 - k].w - both[k].w);
            both[k] = mix(both[k], both[1 - k], t);
        }
    }
    vec2 a = both[0].xy / both[0].w * size, b = both[1].xy / both[1].w * size;
    vec2 along = b - a, across = vec2(-along.y, along.x) / max(length(along), 1e-6);
    vec4 here = both[ends[corner]];
    ink = unpackUnorm4x8(vertices[2 * i + ends[corner]].rgba);
    here.xy += float(sides[corner]) * width * across / size * here.w;
    here.z -= 2e-4 * here.w; // over the faces that it lies on
    gl_Position = here;
}
