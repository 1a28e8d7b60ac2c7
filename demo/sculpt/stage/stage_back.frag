// SPDX-License-Identifier: MIT
// What is behind all.

#include "light.glsl"

in vec2 place;
layout(location = 0) out vec4 colour;

void main()
{
    colour = developed(background(place.y));
}
