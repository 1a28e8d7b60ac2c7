// SPDX-License-Identifier: MIT
// Reading glTF: bytes in, what may be parsed and what may not, a mesh out.
//
// The file is read whole, because tinygltf wants it so; memory grows as bytes come. A binary file's
// head is checked here, and its JSON held against bounds (gltf_guard.c); tinygltf parses
// (gltf_model.cpp); what it found is checked and placed (gltf_walk.c). The mesh is the last to be
// made and the only thing that leaves.

#include "io/gltf_model.h"
#include "io/readers.h"

#include "base/memory.h"
#include "base/status.h"

#include <string.h>

int sf_gltf_is_served(void)
{
#ifdef SF_HAVE_TINYGLTF
    return 1;
#else
    return 0;
#endif
}

sf_gltf_options sf_gltf_options_default(void)
{
    sf_gltf_options options = {sizeof options, sf_read_limits_default(), NULL};
    return options;
}

// ---------------------------------------------------------------------------------------------
// Bytes
// ---------------------------------------------------------------------------------------------

typedef struct bytes {
    void *data;
    size_t size, capacity;
} bytes;

static sf_status read_bytes(sfi_cursor *cursor, bytes *b, sf_fault *fault)
{
    size_t got = 1;
    while (got > 0) {
        if (!sfi_grow_array(&cursor->allocator, &b->data, &b->capacity, b->size + SFI_CURSOR_BYTES,
                            1)) {
            return SF_ERR_MEMORY;
        }
        got = sfi_cursor_read(cursor, (unsigned char *)b->data + b->size, SFI_CURSOR_BYTES);
        b->size += got;
    }
    return cursor->failure == SF_OK ? SF_OK : sfi_cursor_fault(cursor, fault, "");
}

static uint32_t word_at(const unsigned char *data, size_t at)
{
    return (uint32_t)data[at] | (uint32_t)data[at + 1] << 8 | (uint32_t)data[at + 2] << 16 |
           (uint32_t)data[at + 3] << 24;
}

int sfi_gltf_begins(const unsigned char *data, size_t have)
{
    return have >= 4 && memcmp(data, "glTF", 4) == 0;
}

// The head of a binary file: magic, version, length; then chunks, of which the first is JSON.
static sf_status check_binary(const unsigned char *data, size_t size, sf_fault *fault)
{
    const char *why = NULL;
    if (size >= 8 && word_at(data, 4) != 2) {
        return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 4,
                             "the file is of glTF version %lu, and only version 2 is read",
                             (unsigned long)word_at(data, 4));
    }
    if (size < 20 || word_at(data, 8) > size) {
        why = "the file is shorter than its head says; it is cut short";
    } else if (word_at(data, 8) < 20 || word_at(data, 12) > word_at(data, 8) - 20 ||
               word_at(data, 16) != 0x4e4f534au) {
        why = "the file's first chunk is no JSON of its length; export it again";
    } else {
        return sfi_gltf_guard(data + 20, word_at(data, 12), word_at(data, 8) - 20, fault);
    }
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, size < 12 ? size : 12, "%s", why);
}

static sf_status check_bytes(const unsigned char *data, size_t size, sf_fault *fault)
{
    if (size > INT32_MAX) { // tinygltf counts in 32 bits
        return sfi_fault_set(fault, SF_ERR_OVERFLOW, 0, 0,
                             "the file has 2 GiB or more; save the part as PLY");
    }
    return sfi_gltf_begins(data, size) ? check_binary(data, size, fault)
                                       : sfi_gltf_guard(data, size, 0, fault);
}

// ---------------------------------------------------------------------------------------------
// Extensions
// ---------------------------------------------------------------------------------------------

// Those that leave the triangles as they are, or are served.
static int is_served(const char *name)
{
    static const char *const harmless[] = {"KHR_mesh_quantization", "KHR_texture_transform",
                                           "KHR_texture_basisu",    "KHR_lights_punctual",
                                           "KHR_xmp_json_ld",       "EXT_texture_webp"};
    static const char materials[] = "KHR_materials_";
    for (size_t i = 0; i < sizeof harmless / sizeof harmless[0]; i++) {
        if (strcmp(name, harmless[i]) == 0) {
            return 1;
        }
    }
    return strncmp(name, materials, sizeof materials - 1) == 0;
}

// What is shown of a file's own words: letters, digits and underscores.
static void tame(const char *name, char tamed[64])
{
    size_t i = 0;
    for (; i < 63 && name[i] != '\0'; i++) {
        char c = name[i];
        int plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        tamed[i] = (char)(plain ? c : '_');
    }
    tamed[i] = '\0';
}

static sf_status check_extensions(const sfi_gltf_model *model, sf_fault *fault)
{
    char name[64];
    for (size_t i = 0; i < model->extension_count; i++) {
        if (!is_served(model->extensions[i])) {
            tame(model->extensions[i], name);
            return sfi_fault_set(fault, SF_ERR_UNSUPPORTED, 0, 0,
                                 "the file requires the extension %s, which is not served; export "
                                 "it without (compressed meshes uncompressed)",
                                 name);
        }
    }
    return SF_OK;
}

// ---------------------------------------------------------------------------------------------
// All of it
// ---------------------------------------------------------------------------------------------

static sf_status make_mesh(const bytes *b, const sf_gltf_options *options,
                           const sf_allocator *allocator, sf_mesh *mesh, sf_gltf_report *report,
                           sf_fault *fault)
{
    sfi_gltf_model model;
    sfi_gltf_files files = {options->folder, options->limits.bytes_max - b->size, SF_OK};
    memset(&model, 0, sizeof model);
    SF_TRY(check_bytes(b->data, b->size, fault));
    SF_TRY(
        sfi_gltf_parse(b->data, b->size, sfi_gltf_begins(b->data, b->size), &files, &model, fault));
    uint64_t read = options->limits.bytes_max - files.left;
    sf_status status = check_extensions(&model, fault);
    if (status == SF_OK) {
        status = sfi_gltf_walk(&model, read, &options->limits, allocator, mesh, report, fault);
    }
    report->animations = model.animation_count;
    sfi_gltf_release(&model);
    return status;
}

static sf_status read_mesh(sfi_cursor *cursor, const sf_gltf_options *options, sf_mesh *mesh,
                           sf_gltf_report *report, sf_fault *fault)
{
    bytes b = {NULL, 0, 0};
    sf_gltf_report found = {0, 0, 0, 0, 0, 0};
    sf_status status = read_bytes(cursor, &b, fault);
    if (status == SF_OK) {
        status = make_mesh(&b, options, &cursor->allocator, mesh, &found, fault);
    }
    sfi_free_array(&cursor->allocator, b.data, b.capacity, 1);
    if (status == SF_OK && report != NULL) {
        *report = found;
    }
    return status;
}

sf_status sfi_gltf_read(sfi_mesh_reader *reader)
{
    sf_gltf_options options = {sizeof options, reader->limits, NULL};
    return read_mesh(reader->cursor, &options, reader->mesh, NULL, reader->fault);
}

sf_status sf_gltf_read(sf_source source, const sf_gltf_options *options,
                       const sf_allocator *allocator, sf_mesh **mesh, sf_gltf_report *report,
                       sf_fault *fault)
{
    sfi_cursor cursor;
    sf_mesh *made = NULL;
    sf_gltf_options how = sf_gltf_options_default();
    if (options != NULL) {
        memcpy(&how, options,
               options->struct_size < sizeof how ? options->struct_size : sizeof how);
    }
    if (mesh == NULL || source.read == NULL ||
        (how.folder != NULL && (how.folder->open == NULL || how.folder->close == NULL))) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "no source, no place for the mesh, or a folder that cannot be read");
    }
    sf_status status = sfi_cursor_begin(&cursor, source, how.limits.bytes_max, allocator);
    if (status == SF_OK) {
        status = sf_mesh_create(allocator, &made);
    }
    if (status == SF_OK) {
        status = read_mesh(&cursor, &how, made, report, fault);
    }
    if (status == SF_ERR_MEMORY) {
        sfi_fault_set(fault, status, 0, 0, "there is not enough memory for this mesh");
    }
    sfi_cursor_end(&cursor);
    if (status != SF_OK) {
        sf_mesh_destroy(made);
        return status;
    }
    *mesh = made;
    return SF_OK;
}
