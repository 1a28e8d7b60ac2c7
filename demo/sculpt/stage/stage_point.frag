// SPDX-License-Identifier: MIT
// A disc with a dark rim.

in vec4 ink;
in vec2 off;
in float reach;
layout(location = 0) out vec4 colour;

void main()
{
    float r = length(off), inside = 1.0 - smoothstep(reach - 0.5, reach + 0.5, r);
    float rim = smoothstep(0.72 * reach - 0.5, 0.72 * reach + 0.5, r);
    colour = vec4(mix(ink.rgb, vec3(0.12, 0.13, 0.15), 0.8 * rim), ink.a * inside);
}
