// SPDX-License-Identifier: MIT
// Fuzz target: any bytes, read as every mesh format.
//
// Whatever comes in, a mesh comes out that is valid, or a refusal with a sentence; and a mesh that
// came out, written as PLY and OBJ and read again, is the same mesh bit for bit.

#include "target.h"

static sf_mesh *read_as(const void *data, size_t size, sf_mesh_format format)
{
    sf_memory_cursor cursor = {data, size, 0};
    sf_mesh *mesh = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_status status = sf_mesh_read(sf_memory_source(&cursor), format, NULL, NULL, &mesh, &fault);
    must((status == SF_OK) == (mesh != NULL), "a mesh exactly on success");
    must(status == SF_OK || (fault.status == status && fault.message[0] != '\0'), "a sentence");
    return mesh;
}

static void round_trip(sf_mesh_view mesh, sf_mesh_format format)
{
    buffer b = {NULL, 0, 0};
    sf_sink sink = {put, &b};
    must(sf_mesh_write(mesh, format, sink) == SF_OK, "what was read can be written");
    sf_mesh *again = read_as(b.bytes, b.size, SF_MESH_FORMAT_AUTO);
    sf_mesh_view view = sf_mesh_get_view(again);
    must(view.vertex_count == mesh.vertex_count && view.triangle_count == mesh.triangle_count,
         "the counts come back");
    for (size_t i = 0; i < 3 * mesh.vertex_count; i++) {
        must(view.vertices[i] == mesh.vertices[i], "every coordinate comes back");
    }
    must(memcmp(view.triangles, mesh.triangles, 3 * mesh.triangle_count * sizeof(uint32_t)) == 0,
         "every corner comes back");
    sf_mesh_destroy(again);
    free(b.bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    for (sf_mesh_format format = SF_MESH_FORMAT_AUTO; format <= SF_MESH_FORMAT_OFF; format++) {
        sf_mesh *mesh = read_as(data, size, format);
        if (mesh != NULL) {
            sf_mesh_view view = sf_mesh_get_view(mesh);
            must(sf_mesh_validate(view, NULL) == SF_OK, "what was read is valid");
            round_trip(view, SF_MESH_FORMAT_PLY);
            round_trip(view, SF_MESH_FORMAT_OBJ);
            sf_mesh_destroy(mesh);
        }
    }
    return 0;
}
