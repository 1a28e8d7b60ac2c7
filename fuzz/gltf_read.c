// SPDX-License-Identifier: MIT
// Fuzz target: any bytes as JSON or as binary glTF, with a folder that has whatever is asked of it.
//
// A mesh comes out that is valid, or a refusal with a sentence; the folder is asked for plain names
// only; and what came out, written as glTF and read again, is the same floats. Bytes that do not
// begin like glTF are put behind a head that fits them: first the JSON, to the last closing brace,
// then the arrays; so that a fuzzer need not get lengths right.

#include "target.h"

#include <sf/gltf.h>

static sf_memory_cursor shelf;

static sf_status open_shelf(void *user, const char *name, sf_source *source)
{
    (void)user;
    must(name[0] != '\0' && strpbrk(name, "/\\:") == NULL && strcmp(name, "..") != 0,
         "only plain names are asked for");
    shelf.position = 0;
    *source = sf_memory_source(&shelf);
    return SF_OK;
}

static void close_shelf(void *user, sf_source source)
{
    (void)user;
    (void)source;
}

static sf_mesh *read_bytes(const void *data, size_t size)
{
    sf_memory_cursor cursor = {data, size, 0};
    sf_folder folder = {open_shelf, close_shelf, NULL, NULL, NULL};
    sf_gltf_options options = sf_gltf_options_default();
    sf_gltf_report report;
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    options.folder = &folder;
    options.limits.triangles_max = options.limits.vertices_max = 1 << 20;
    shelf.data = data, shelf.size = size;
    sf_status status =
        sf_gltf_read(sf_memory_source(&cursor), &options, NULL, &mesh, &report, &fault);
    must((status == SF_OK) == (mesh != NULL), "a mesh exactly on success");
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    must(status != SF_ERR_INTERNAL, "nothing unknown is thrown");
    return mesh;
}

static void round_trip(sf_mesh_view mesh)
{
    buffer b = {NULL, 0, 0};
    sf_sink sink = {put, &b};
    sf_status status = sf_gltf_write(mesh, NULL, sink);
    must(status == SF_OK || status == SF_ERR_OVERFLOW, "what was read can be written");
    if (status == SF_OK) {
        sf_mesh *again = read_bytes(b.bytes, b.size);
        sf_mesh_view view = sf_mesh_get_view(again);
        must(view.vertex_count == mesh.vertex_count && view.triangle_count == mesh.triangle_count,
             "the counts come back");
        for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
            must(view.vertices[i] == (double)(float)mesh.vertices[i], "every float comes back");
        }
        sf_mesh_destroy(again);
    }
    free(b.bytes);
}

static void word(unsigned char *at, size_t value)
{
    for (int i = 0; i < 4; i++) {
        at[i] = (unsigned char)(value >> 8 * i);
    }
}

// Head, JSON of `split` bytes, arrays of the rest.
static unsigned char *wrap(const uint8_t *data, size_t size, size_t split, size_t *wrapped)
{
    size_t json = (split + 3) / 4 * 4, arrays = (size - split + 3) / 4 * 4;
    unsigned char *glb = calloc(1, 28 + json + arrays);
    *wrapped = 20 + json + (arrays > 0 ? 8 + arrays : 0);
    memcpy(glb, "glTF", 4);
    word(glb + 4, 2);
    word(glb + 8, *wrapped);
    word(glb + 12, json);
    memcpy(glb + 16, "JSON", 4);
    memset(glb + 20, ' ', json);
    memcpy(glb + 20, data, split);
    word(glb + 20 + json, arrays);
    memcpy(glb + 24 + json, "BIN", 4);
    memcpy(glb + 28 + json, data + split, size - split);
    return glb;
}

static void read_one(const void *data, size_t size)
{
    sf_mesh *mesh = read_bytes(data, size);
    if (mesh != NULL) {
        must(sf_mesh_validate(sf_mesh_get_view(mesh), NULL) == SF_OK, "what was read is valid");
        round_trip(sf_mesh_get_view(mesh));
    }
    sf_mesh_destroy(mesh);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t split = size, wrapped;
    if (size >= 4 && memcmp(data, "glTF", 4) == 0) {
        read_one(data, size);
        return 0;
    }
    while (split > 0 && data[split - 1] != '}') {
        split--;
    }
    unsigned char *glb = wrap(data, size, split, &wrapped);
    read_one(glb, wrapped);
    free(glb);
    read_one(data, size);
    return 0;
}
