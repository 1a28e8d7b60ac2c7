// SPDX-License-Identifier: MIT
// Small glTF files made in memory: a cube in the ways in which its numbers may be written.
//
// The cube stands in glTF's axes, y up, in metres, from (0, 0, 0) to (0.001, 0.002, 0.003); so what
// is read must reach from (0, -3, 0) to (1, 0, 2) mm and have a volume of 6 mm3, outside outwards.

#ifndef SF_TEST_GLTF_FILES_H
#define SF_TEST_GLTF_FILES_H

#include <sf/gltf.h>

#include "files.h"

// Corners (x: bit 0, y: bit 1, z: bit 2) and triangles, counter-clockwise seen from outside.
static const unsigned char box_triangles[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6,
                                                0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,
                                                0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
static const double box_size[3] = {0.001, 0.002, 0.003};

static inline double box_number(int corner, int axis)
{
    return (corner >> axis & 1) * box_size[axis];
}

// The arrays of most files: 36 corners of `index_size` bytes, then 8 positions of three floats.
static inline void put_box(file *f, int index_size)
{
    f->size = 0;
    for (int i = 0; i < 36; i++) {
        put_bits(f, box_triangles[i], index_size, 0);
    }
    for (int i = 0; i < 24; i++) {
        put_float(f, box_number(i / 3, i % 3), 0);
    }
}

// A binary file of JSON and arrays.
static inline void make_glb(file *f, const char *json, const file *arrays)
{
    size_t length = strlen(json), padded = (length + 3) / 4 * 4;
    size_t bytes = (arrays->size + 3) / 4 * 4;
    f->size = 0;
    put(f, "glTF", 4);
    put_bits(f, 2, 4, 0);
    put_bits(f, 20 + padded + (bytes > 0 ? 8 + bytes : 0), 4, 0);
    put_bits(f, padded, 4, 0);
    put(f, "JSON", 4);
    put(f, json, length);
    put(f, "   ", padded - length);
    if (bytes > 0) {
        put_bits(f, bytes, 4, 0);
        put(f, "BIN", 4);
        put(f, arrays->bytes, arrays->size);
        put(f, "\0\0\0", bytes - arrays->size);
    }
}

#define GLTF_HEAD "{\"asset\":{\"version\":\"2.0\"},"
#define GLTF_SCENE "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
#define GLTF_NODE "\"nodes\":[{\"mesh\":0}],"
#define GLTF_MESH "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":1},\"indices\":0}]}],"
#define GLTF_VIEWS                                                                                 \
    "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},"                                           \
    "{\"buffer\":0,\"byteOffset\":36,\"byteLength\":96}],"
#define GLTF_LISTS                                                                                 \
    "\"accessors\":[{\"bufferView\":0,\"componentType\":5121,\"count\":36,\"type\":\"SCALAR\"},"   \
    "{\"bufferView\":1,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"}],"
#define GLTF_BUFFER "\"buffers\":[{\"byteLength\":132}]}"
#define GLTF_PLAIN GLTF_HEAD GLTF_SCENE GLTF_NODE GLTF_MESH GLTF_VIEWS GLTF_LISTS GLTF_BUFFER

// The plain cube, with something else between its parts.
static inline void make_plain_glb(file *f, const char *json)
{
    file arrays;
    put_box(&arrays, 1);
    make_glb(f, json, &arrays);
}

static inline sf_status read_gltf(const void *data, size_t size, const sf_gltf_options *options,
                                  const sf_allocator *allocator, sf_mesh **mesh,
                                  sf_gltf_report *report, sf_fault *fault)
{
    sf_memory_cursor cursor = {data, size, 0};
    return sf_gltf_read(sf_memory_source(&cursor), options, allocator, mesh, report, fault);
}

#endif
