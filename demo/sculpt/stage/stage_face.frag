// SPDX-License-Identifier: MIT
// Light on the triangles of a stage; the bed and what is bare are not lit.

#include "light.glsl"

layout(location = 0) uniform vec3 eye;
layout(location = 7) uniform int look; // 0: lit, 1: bare, 2: glass

in vec3 at;
in vec3 normal;
in vec4 ink;
layout(location = 0) out vec4 colour;

void main()
{
    vec3 view = normalize(at - eye), own = normalize(cross(dFdx(at), dFdy(at)));
    vec3 n = dot(normal, normal) > 0.0 ? normalize(normal) : own;
    n = dot(n, view) > 0.0 ? -n : n; // both sides are seen
    if (look == 1) {
        colour = vec4(ink.rgb, 1.0);
    } else {
        colour = developed(lit(ink.rgb, n, 1.0, 1.0, view));
    }
    if (look == 2) { // glass is thicker where it is seen from its edge
        float edge = 1.0 - abs(dot(n, view));
        colour.a = mix(ink.a, 1.0, 0.75 * edge * edge * edge);
    }
}
