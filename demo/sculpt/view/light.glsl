// SPDX-License-Identifier: MIT
// One light, a sky, and what is behind all.

const vec3 TO_LIGHT = normalize(vec3(0.45, -0.55, 0.9));

// What a place sends back: n its normal, of length 1; how open it is and how much of the light it
// gets, from 0 to 1; `view` the way from the eye to it, of length 1.
vec3 lit(vec3 ink, vec3 n, float open, float sun, vec3 view)
{
    vec3 sky = mix(vec3(0.30, 0.28, 0.27), vec3(0.62, 0.66, 0.72), 0.5 + 0.5 * n.z);
    float key = max(0.0, dot(n, TO_LIGHT)) * sun, fill = max(0.0, dot(n, -view)) * 0.16;
    float gloss = pow(max(0.0, dot(n, normalize(TO_LIGHT - view))), 40.0) * 0.10 * sun;
    return ink * (sky * 0.62 * open + vec3(1.0, 0.97, 0.92) * (0.72 * key) + fill * open) + gloss;
}

// height: -1 at the bottom of the picture, 1 at its top.
vec3 background(float height)
{
    return mix(vec3(0.80, 0.81, 0.83), vec3(0.93, 0.94, 0.95), 0.5 + 0.5 * height);
}

vec4 developed(vec3 ink)
{
    return vec4(pow(ink, vec3(1.0 / 1.06)), 1.0);
}
