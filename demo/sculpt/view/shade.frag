// SPDX-License-Identifier: MIT
// Light on what the rays met.
//
// Faces of voxels know six normals. In the picture they are averaged with those of what lies near,
// some voxels around and not farther away than that in depth; so edges stay and stairs go. Corners
// are darker by what stands above them near by. One light casts shadows, by a ray of its own.
//
// Source of the darkening: M. McGuire, B. Osman, M. Bukowski, P. Hennessy, "The Alchemy
// Screen-Space Ambient Obscurance Algorithm", High-Performance Graphics 2011.

#include "march.glsl"
#include "light.glsl"

layout(location = 4) uniform vec3 eye; // and what follows: view_frame in voxels
layout(location = 5) uniform vec3 forward;
layout(location = 6) uniform vec3 right;
layout(location = 7) uniform vec3 up;
layout(location = 8) uniform vec3 pitch;  // of a voxel, mm
layout(location = 9) uniform int bed;
layout(location = 10) uniform ivec4 shows; // ghosts, overhangs, ground, shadows
layout(location = 11) uniform ivec4 cursor_shows; // a cursor, a box, a plane, its axis
layout(location = 12) uniform vec3 cursor;        // voxels
layout(location = 13) uniform vec3 reach;         // voxels
layout(location = 15) uniform vec3 palette[8];

layout(binding = 0) uniform sampler2D distances;
layout(binding = 1) uniform usampler2D kinds;

in vec2 place;
layout(location = 0) out vec4 colour;

const uint IS_CUT = 8u, LEANS = 16u, FACE = 7u;
const vec3 INK_LEANING = vec3(0.95, 0.42, 0.12), INK_GHOST = vec3(0.35, 0.55, 0.95);
const vec3 INK_CURSOR = vec3(1.0, 0.78, 0.2);

vec3 normal_of(uint face)
{
    vec3 n = vec3(0.0);
    n[face >> 1] = (face & 1u) != 0u ? 1.0 : -1.0;
    return n;
}

vec3 way_of(vec2 at)
{
    return forward + at.x * right + at.y * up;
}

// What pixel p met, in voxels.
vec3 met_at(ivec2 p, ivec2 size, float t)
{
    return eye + t * way_of((vec2(p) + 0.5) / vec2(size) * 2.0 - 1.0);
}

// How many pixels a voxel is wide at a distance.
float voxel_px(float t, ivec2 size)
{
    return float(size.y) / (2.0 * t * length(up));
}

// Taps lie on a spiral, which falls in step with no lattice of voxels.
vec3 smooth_normal(ivec2 here, ivec2 size, float t, vec3 at, vec3 own)
{
    float spread = clamp(4.5 * voxel_px(t, size), 3.0, 60.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 72; i++) {
        float angle = 2.39996323 * float(i), out_to = spread * sqrt((float(i) + 0.5) / 72.0);
        ivec2 p = here + ivec2(round(out_to * vec2(cos(angle), sin(angle))));
        if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, size))) {
            continue;
        }
        uvec4 k = texelFetch(kinds, p, 0);
        if (k.w == 0u || (k.y & IS_CUT) != 0u) {
            continue;
        }
        float away = length(met_at(p, size, texelFetch(distances, p, 0).x) - at);
        sum += normal_of(k.y & FACE) * exp(-away * away / 12.0);
    }
    return normalize(sum + 0.05 * own);
}

// How open it is above a place: 1 where nothing stands near.
float openness(ivec2 here, ivec2 size, float t, vec3 at, vec3 normal)
{
    const float radius = 9.0;
    float sum = 0.0, spread = radius * voxel_px(t, size);
    float turn = fract(52.9829189 * fract(dot(vec2(here), vec2(0.06711056, 0.00583715))));
    for (int i = 0; i < 14; i++) {
        float part = (float(i) + 0.5) / 14.0, angle = 6.2831853 * (part * 5.0 + turn);
        ivec2 p = here + ivec2(round(spread * part * vec2(cos(angle), sin(angle))));
        if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, size))) {
            continue;
        }
        float d = texelFetch(distances, p, 0).x;
        if (d < 0.0) {
            continue;
        }
        vec3 to = met_at(p, size, d) - at;
        float square = dot(to, to);
        if (square < radius * radius * 4.0) {
            sum += max(0.0, dot(to, normal) - 1.3) / (square + 2.0);
        }
    }
    return clamp(1.0 - 0.62 * sum, 0.25, 1.0);
}

bool is_lit(vec3 at, vec3 normal)
{
    vec3 to = TO_LIGHT / pitch;
    return shows.w == 0 || march(at + 2.0 * normal + 0.01 * to, to / length(to), false).t < 0.0;
}

// How much of a line each `every` mm a place has, lines a pixel wide.
float lines(vec2 at_mm, float every, float pixel_mm)
{
    vec2 off = abs(fract(at_mm / every + 0.5) - 0.5) * every;
    vec2 near = 1.0 - smoothstep(vec2(0.5 * pixel_mm), vec2(1.5 * pixel_mm), off);
    return max(near.x, near.y);
}

// The bed, where it is seen from above: *t is how far the ray has come.
vec3 on_ground(vec3 behind, vec3 way, ivec2 size, inout float t)
{
    float s = (float(bed) - eye.z) / way.z;
    vec3 at = eye + s * way;
    if (shows.z == 0 || way.z >= 0.0 || !(s > 0.0) || (t >= 0.0 && s > t) || at.x < 0.0 ||
        at.y < 0.0 || at.x > float(counts.x) || at.y > float(counts.y)) {
        return behind;
    }
    t = s;
    float pixel = pitch.x / voxel_px(s, size);
    vec2 mm = at.xy * pitch.xy;
    float sun = is_lit(at, vec3(0.0, 0.0, 1.0)) ? 1.0 : 0.62;
    vec3 ink = vec3(0.86, 0.86, 0.85) * sun;
    ink = mix(ink, vec3(0.62, 0.63, 0.65) * sun, 0.5 * lines(mm, 10.0, pixel));
    return mix(ink, vec3(0.45, 0.46, 0.48) * sun, 0.7 * lines(mm, 50.0, pixel));
}

vec3 surface(ivec2 here, ivec2 size, float t, vec3 way, uvec4 k)
{
    vec3 own = normal_of(k.y & FACE), at = eye + t * way, view = normalize(way * pitch);
    vec3 ink = palette[(k.x + 7u) % 8u];
    if ((k.y & IS_CUT) != 0u) { // inside matter: flat, with a grain that tells it from a face
        float grain = mod(gl_FragCoord.x + gl_FragCoord.y, 9.0) < 1.5 ? 0.8 : 1.0;
        return ink * 0.82 * grain;
    }
    vec3 normal = smooth_normal(here, size, t, at, own);
    if (shows.y != 0 && (k.y & LEANS) != 0u && normal.z < 0.2) {
        ink = mix(ink, INK_LEANING, 0.75);
    }
    float facing = dot(normal, TO_LIGHT / pitch);
    float sun = facing > 0.0 && is_lit(at, normal) ? 1.0 : 0.0;
    vec3 n = normalize(normal * pitch.yzx * pitch.zxy); // normals of what is stretched
    return lit(ink, n, openness(here, size, t, at, normal), mix(0.12, 1.0, sun), view);
}

// The brush: its rim on the surface, its outline around it.
vec3 with_cursor(vec3 behind, vec3 way, float t, ivec2 size)
{
    if (cursor_shows.x == 0) {
        return behind;
    }
    vec3 r = max(reach, vec3(0.5)), q = (eye - cursor) / r, w = way / r;
    float s = -dot(q, w) / dot(w, w), pixel = 1.0 / voxel_px(max(s, 1e-3), size);
    float off = length(q + s * w) - 1.0, thin = 1.5 * pixel / min(r.x, min(r.y, r.z));
    vec3 on = (eye + t * way - cursor) / r;
    float inside = cursor_shows.y != 0 ? max(abs(on.x), max(abs(on.y), abs(on.z))) : length(on);
    if (t >= 0.0 && inside < 1.0) {
        behind = mix(behind, INK_CURSOR, inside > 1.0 - 2.0 * thin ? 0.9 : 0.16);
    }
    if (cursor_shows.y == 0 && s > 0.0 && abs(off) < thin) {
        behind = mix(behind, INK_CURSOR, t < 0.0 || t > s - length(r) ? 0.85 : 0.3);
    }
    return behind;
}

vec3 with_plane(vec3 behind, vec3 way, float t, ivec2 size)
{
    int axis = cursor_shows.w;
    float s = (cursor[axis] - eye[axis]) / way[axis];
    if (cursor_shows.z == 0 || !(s > 0.0)) {
        return behind;
    }
    vec3 at = eye + s * way;
    if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(counts.xyz)))) {
        return behind;
    }
    vec3 mm = at * pitch;
    vec2 flat_mm = axis == 0 ? mm.yz : axis == 1 ? mm.xz : mm.xy;
    float line = lines(flat_mm, 10.0, pitch.x / voxel_px(s, size));
    float veil = t >= 0.0 && t < s ? 0.25 : 1.0;
    return mix(behind, INK_CURSOR, veil * (0.06 + 0.3 * line));
}

void main()
{
    ivec2 here = ivec2(gl_FragCoord.xy), size = textureSize(distances, 0);
    vec2 d = texelFetch(distances, here, 0).xy;
    uvec4 k = texelFetch(kinds, here, 0);
    vec3 way = way_of(place), ink = background(place.y);
    float t = k.w != 0u ? d.x : -1.0;
    if (t >= 0.0) {
        ink = surface(here, size, t, way, k);
    }
    ink = on_ground(ink, way, size, t);
    if (shows.x != 0 && d.y >= 0.0 && (t < 0.0 || d.y < t)) {
        float facing = 0.55 + 0.45 * abs(dot(normal_of(k.z & FACE), TO_LIGHT));
        ink = mix(ink, INK_GHOST * facing, 0.34);
    }
    ink = with_plane(ink, way, t, size);
    ink = with_cursor(ink, way, t, size);
    colour = developed(ink);
}
