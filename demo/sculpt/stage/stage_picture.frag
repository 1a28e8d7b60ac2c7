// SPDX-License-Identifier: MIT
// The picture of a stage, pixel for pixel, with a rim.

layout(location = 0) uniform ivec2 corner; // of it: pixels of the frame, from the upper left
layout(location = 1) uniform ivec2 frame;
layout(location = 2) uniform int magnified;
layout(binding = 0) uniform sampler2D picture;

layout(location = 0) out vec4 colour;

void main()
{
    ivec2 at = ivec2(gl_FragCoord.x, float(frame.y) - gl_FragCoord.y) - corner;
    ivec2 size = textureSize(picture, 0) * magnified;
    if (any(lessThan(at, ivec2(-3))) || any(greaterThanEqual(at, size + 3))) {
        discard;
    }
    bool is_rim = any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size));
    colour = is_rim ? vec4(0.13, 0.14, 0.16, 1.0) : vec4(texelFetch(picture, at / magnified, 0).rgb, 1.0);
}
