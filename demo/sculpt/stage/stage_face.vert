// SPDX-License-Identifier: MIT
// Triangles of a stage.

#include "stage_frame.glsl"

layout(std430, binding = 0) readonly buffer Vertices { Vertex vertices[]; };
layout(std430, binding = 1) readonly buffer Normals { float normals[]; };
layout(location = 6) uniform int has_normals;

out vec3 at;
out vec3 normal; // of any length; none where the triangle's own will do
out vec4 ink;

void main()
{
    Vertex v = vertices[gl_VertexID];
    at = vec3(v.x, v.y, v.z);
    normal = vec3(0.0);
    if (has_normals != 0) {
        int i = 3 * gl_VertexID;
        normal = vec3(normals[i], normals[i + 1], normals[i + 2]);
    }
    ink = unpackUnorm4x8(v.rgba);
    gl_Position = clip_of(at);
}
