// SPDX-License-Identifier: MIT
// What a glTF file says of its triangles, in plain arrays: the border between tinygltf and the
// rest.
//
// tinygltf is C++ and has its own idea of memory; nothing of it passes this header. gltf_model.cpp
// fills these arrays, and gltf_walk.c, which knows neither JSON nor C++, makes a mesh of them. No
// number in them has been looked at: whoever uses one checks it first.

#ifndef SF_IO_GLTF_MODEL_H
#define SF_IO_GLTF_MODEL_H

#include <sf/gltf.h>

#ifdef __cplusplus
extern "C" {
#endif

// The numbers that glTF takes from OpenGL.
enum { SFI_GLTF_BYTE = 5120, SFI_GLTF_UBYTE, SFI_GLTF_SHORT, SFI_GLTF_USHORT };
enum { SFI_GLTF_UINT = 5125, SFI_GLTF_FLOAT = 5126 };
enum { SFI_GLTF_TRIANGLES = 4, SFI_GLTF_STRIP, SFI_GLTF_FAN };

typedef struct sfi_gltf_buffer {
    const unsigned char *bytes;
    size_t size;
} sfi_gltf_buffer;

typedef struct sfi_gltf_view {
    int buffer;
    size_t offset, size, stride; // stride 0: element after element
} sfi_gltf_view;

typedef struct sfi_gltf_accessor {
    int view; // or -1: zeros
    size_t offset, count;
    int component, width; // width: 1 to 4 numbers of an element; 0: a matrix
    int is_normalized, is_sparse;
    size_t sparse_count; // elements that stand elsewhere
    int at_view, at_component, value_view;
    size_t at_offset, value_offset;
} sfi_gltf_accessor;

typedef struct sfi_gltf_primitive {
    int mode, indices, positions; // accessors, or -1
    int has_targets;              // shapes to blend to
} sfi_gltf_primitive;

typedef struct sfi_gltf_mesh {
    size_t first, count; // of its primitives
} sfi_gltf_mesh;

// How a node lies in its parent.
typedef enum sfi_gltf_placing {
    SFI_GLTF_PARTS,
    SFI_GLTF_MATRIX,
    SFI_GLTF_NO_PLACE
} sfi_gltf_placing;

typedef struct sfi_gltf_node {
    int mesh, skin;                      // or -1
    size_t first, count;                 // of its children
    sfi_gltf_placing placing;            // NO_PLACE: an array of a wrong length
    double matrix[16];                   // column after column
    double move[3], turn[4], stretch[3]; // translation, quaternion (x y z w), scale
} sfi_gltf_node;

typedef struct sfi_gltf_model {
    const sfi_gltf_buffer *buffers;
    const sfi_gltf_view *views;
    const sfi_gltf_accessor *accessors;
    const sfi_gltf_primitive *primitives;
    const sfi_gltf_mesh *meshes;
    const sfi_gltf_node *nodes;
    const int *children; // node numbers, of one node after the other
    const int *roots;    // of the scene that is shown
    size_t buffer_count, view_count, accessor_count, mesh_count, node_count, root_count;
    size_t skin_count, animation_count, extension_count; // extensions that are required
    const char *const *extensions;
    void *owner; // what the arrays lie in
} sfi_gltf_model;

// Where buffers outside of the file come from.
typedef struct sfi_gltf_files {
    const sf_folder *folder; // or NULL
    uint64_t left;           // bytes that may still be read
    sf_status failure;       // why none came, where that was not the name's fault
} sfi_gltf_files;

// Parse what sfi_gltf_guard() has let pass. The bytes may be freed afterwards.
sf_status sfi_gltf_parse(const unsigned char *bytes, size_t size, int is_binary,
                         sfi_gltf_files *files, sfi_gltf_model *model, sf_fault *fault);
void sfi_gltf_release(sfi_gltf_model *model);

// Whether JSON is small and flat enough to be handed to tinygltf. Buffers of a binary file share
// its bytes, `binary_size` of them, and each would be a copy.
sf_status sfi_gltf_guard(const unsigned char *json, size_t size, size_t binary_size,
                         sf_fault *fault);

// Append the triangles of the scene, z up, in mm. `file_size` bounds what repetition may make.
sf_status sfi_gltf_walk(const sfi_gltf_model *model, uint64_t file_size,
                        const sf_read_limits *limits, const sf_allocator *allocator, sf_mesh *mesh,
                        sf_gltf_report *report, sf_fault *fault);

// An accessor that was checked: its elements can be read without looking again.
typedef struct sfi_gltf_array {
    const unsigned char *bytes, *at, *values; // NULL where there are none
    size_t stride, count, sparse_count;
    int component, width, is_normalized, at_component;
} sfi_gltf_array;

// `what` is named in sentences. SF_OK only if every element lies within its buffer.
sf_status sfi_gltf_array_of(const sfi_gltf_model *model, int accessor, const char *what,
                            sfi_gltf_array *array, sf_fault *fault);

// The elements from the first to the last, sparse ones put in their places. `next_sparse` begins at
// 0 and goes along.
void sfi_gltf_numbers(const sfi_gltf_array *array, size_t element, size_t *next_sparse,
                      double number[4]);

// An element of an array of whole numbers that is not sparse.
uint32_t sfi_gltf_whole(const sfi_gltf_array *array, size_t element);

#ifdef __cplusplus
}
#endif

#endif
