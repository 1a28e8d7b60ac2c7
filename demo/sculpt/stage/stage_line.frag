// SPDX-License-Identifier: MIT
// A line has its colour.

in vec4 ink;
layout(location = 0) out vec4 colour;

void main()
{
    colour = ink;
}
