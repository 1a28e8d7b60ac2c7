// SPDX-License-Identifier: MIT
// A mesh as binary glTF, with colours.
//
// The file is a head, a chunk of JSON that is the same but for some numbers, and a chunk of arrays:
// corners, positions, colours. Positions are floats in mm, as many bits as STL keeps; the node
// above them turns (x, y, z) to 0.001 (x, z, -y), metres with y up. So no coordinate is rounded
// twice, and reading, which multiplies by 1000 first, gives the same floats.
//
// Colours of vertices are light in glTF, not what a screen is told: of sRGB's value v the light is
// v / 12.92 near black, else ((v + 0.055) / 1.055)^2.4, in 16 bits so that dark ones stay apart.

#include <sf/gltf.h>

#include "base/status.h"
#include "io/emitter.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { JSON_MAX = 2048 };

typedef struct layout {
    uint64_t corners, positions, colors, bytes; // sizes in the chunk of arrays, and all of it
    float low[3], high[3];
} layout;

// ---------------------------------------------------------------------------------------------
// Colours
// ---------------------------------------------------------------------------------------------

// x^2.4 for x in (0, 1]: x^2 times the fifth root of x^2, which Newton's steps near from above.
static double power(double x)
{
    double square = x * x, root = 1;
    for (int i = 0; i < 60; i++) {
        double fourth = root * root * root * root;
        root -= (root * fourth - square) / (5 * fourth);
    }
    return square * root;
}

static void make_light(uint16_t light[256])
{
    for (int i = 0; i < 256; i++) {
        double v = i / 255.0;
        double linear = v <= 0.04045 ? v / 12.92 : power((v + 0.055) / 1.055);
        light[i] = (uint16_t)floor(65535 * linear + 0.5);
    }
}

static void emit_u16(sfi_emitter *out, uint16_t value)
{
    unsigned char bytes[2] = {(unsigned char)(value & 255), (unsigned char)(value >> 8)};
    sfi_emit_bytes(out, bytes, 2);
}

static void emit_colors(sfi_emitter *out, const uint8_t *colors, size_t count)
{
    uint16_t light[256];
    make_light(light);
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < 3; k++) {
            emit_u16(out, light[colors[3 * i + k]]);
        }
        emit_u16(out, UINT16_MAX); // opaque; an element's size is a multiple of four
    }
}

// ---------------------------------------------------------------------------------------------
// JSON
// ---------------------------------------------------------------------------------------------

typedef struct text {
    char bytes[JSON_MAX];
    size_t size;
} text;

static sf_status append(void *user, const void *data, size_t size)
{
    text *t = user;
    if (size > sizeof t->bytes - t->size) {
        return SF_ERR_OVERFLOW;
    }
    memcpy(t->bytes + t->size, data, size);
    t->size += size;
    return SF_OK;
}

static void emit_view(sfi_emitter *out, const char *before, uint64_t offset, uint64_t size,
                      const char *target)
{
    sfi_emit_text(out, before);
    sfi_emit_text(out, "{\"buffer\":0,\"byteOffset\":");
    sfi_emit_whole(out, offset);
    sfi_emit_text(out, ",\"byteLength\":");
    sfi_emit_whole(out, size);
    sfi_emit_text(out, ",\"target\":");
    sfi_emit_text(out, target);
    sfi_emit_text(out, "}");
}

static void emit_accessor(sfi_emitter *out, const char *before, uint64_t count, const char *kind)
{
    sfi_emit_text(out, before);
    sfi_emit_text(out, "\"count\":");
    sfi_emit_whole(out, count);
    sfi_emit_text(out, kind);
}

static void emit_bounds(sfi_emitter *out, const char *name, const float xyz[3])
{
    sfi_emit_text(out, name);
    for (int i = 0; i < 3; i++) {
        sfi_emit_text(out, i == 0 ? "[" : ",");
        sfi_emit_number(out, (double)xyz[i]);
    }
    sfi_emit_text(out, "]");
}

static void emit_json(sfi_emitter *out, sf_mesh_view mesh, int has_colors, const layout *l)
{
    sfi_emit_text(out, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"libsf\"},\"scene\":0,"
                       "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"matrix\":"
                       "[0.001,0,0,0,0,0,-0.001,0,0,0.001,0,0,0,0,0,1]}],\"meshes\":[{"
                       "\"primitives\":[{\"attributes\":{\"POSITION\":1");
    sfi_emit_text(out, has_colors ? ",\"COLOR_0\":2" : "");
    sfi_emit_text(out, "},\"indices\":0,\"material\":0}]}],\"materials\":[{\"doubleSided\":true,"
                       "\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0.9}}],"
                       "\"buffers\":[{\"byteLength\":");
    sfi_emit_whole(out, l->bytes);
    sfi_emit_text(out, "}],\"bufferViews\":[");
    emit_view(out, "", 0, l->corners, "34963");
    emit_view(out, ",", l->corners, l->positions, "34962");
    if (has_colors) {
        emit_view(out, ",", l->corners + l->positions, l->colors, "34962");
    }
    emit_accessor(out, "],\"accessors\":[{\"bufferView\":0,", 3 * (uint64_t)mesh.triangle_count,
                  ",\"componentType\":5125,\"type\":\"SCALAR\"}");
    emit_accessor(out, ",{\"bufferView\":1,", mesh.vertex_count,
                  ",\"componentType\":5126,\"type\":\"VEC3\"");
    emit_bounds(out, ",\"min\":", l->low);
    emit_bounds(out, ",\"max\":", l->high);
    sfi_emit_text(out, "}");
    if (has_colors) {
        emit_accessor(out, ",{\"bufferView\":2,", mesh.vertex_count,
                      ",\"componentType\":5123,\"normalized\":true,\"type\":\"VEC4\"}");
    }
    sfi_emit_text(out, "]}");
}

// ---------------------------------------------------------------------------------------------
// All of it
// ---------------------------------------------------------------------------------------------

static sf_status lay_out(sf_mesh_view mesh, int has_colors, layout *l)
{
    SF_TRY(sf_mesh_validate(mesh, NULL));
    if (mesh.triangle_count == 0) {
        return SF_ERR_ARGUMENT;
    }
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        if (fabs(mesh.vertices[i]) > (double)FLT_MAX) {
            return SF_ERR_OVERFLOW;
        }
        float value = (float)mesh.vertices[i];
        l->low[i % 3] = i < 3 || value < l->low[i % 3] ? value : l->low[i % 3];
        l->high[i % 3] = i < 3 || value > l->high[i % 3] ? value : l->high[i % 3];
    }
    const uint64_t most = UINT32_MAX - 2 * JSON_MAX; // of a file
    if (mesh.triangle_count > most / 12 || mesh.vertex_count > most / 20) {
        return SF_ERR_OVERFLOW;
    }
    l->corners = 12 * (uint64_t)mesh.triangle_count;
    l->positions = 12 * (uint64_t)mesh.vertex_count;
    l->colors = has_colors ? 8 * (uint64_t)mesh.vertex_count : 0;
    l->bytes = l->corners + l->positions + l->colors;
    return l->bytes > most ? SF_ERR_OVERFLOW : SF_OK;
}

sf_status sf_gltf_write(sf_mesh_view mesh, const uint8_t *colors, sf_sink sink)
{
    layout l;
    text json = {{0}, 0};
    sfi_emitter out;
    sf_sink to_json = {append, &json};
    memset(&l, 0, sizeof l);
    if (sink.write == NULL) {
        return SF_ERR_ARGUMENT;
    }
    SF_TRY(lay_out(mesh, colors != NULL, &l));
    sfi_emitter_begin(&out, to_json);
    emit_json(&out, mesh, colors != NULL, &l);
    SF_TRY(sfi_emitter_end(&out));
    while (json.size % 4 != 0) {
        json.bytes[json.size++] = ' ';
    }
    sfi_emitter_begin(&out, sink);
    sfi_emit_text(&out, "glTF");
    sfi_emit_u32(&out, 2);
    sfi_emit_u32(&out, (uint32_t)(28 + json.size + l.bytes));
    sfi_emit_u32(&out, (uint32_t)json.size);
    sfi_emit_text(&out, "JSON");
    sfi_emit_bytes(&out, json.bytes, json.size);
    sfi_emit_u32(&out, (uint32_t)l.bytes);
    sfi_emit_bytes(&out, "BIN", 4);
    for (size_t i = 0; i < 3 * mesh.triangle_count; i++) {
        sfi_emit_u32(&out, mesh.triangles[i]);
    }
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        sfi_emit_float(&out, (float)mesh.vertices[i]);
    }
    if (colors != NULL) {
        emit_colors(&out, colors, mesh.vertex_count);
    }
    return sfi_emitter_end(&out);
}
