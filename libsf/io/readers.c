// SPDX-License-Identifier: MIT
// Reading a mesh: which format it is, and what all formats share.

#include "io/readers.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/number.h"

#include <float.h>
#include <math.h>
#include <string.h>

sf_read_limits sf_read_limits_default(void)
{
    sf_read_limits limits = {sizeof limits, UINT64_C(8) << 30, 1000000000u, UINT32_MAX};
    return limits;
}

sf_status sfi_reader_vertex(sfi_mesh_reader *reader, const double xyz[3])
{
    if (!(fabs(xyz[0]) <= DBL_MAX && fabs(xyz[1]) <= DBL_MAX && fabs(xyz[2]) <= DBL_MAX)) {
        return sfi_cursor_fault(reader->cursor, reader->fault,
                                "a vertex has a coordinate that is infinite or not a number; "
                                "correct it or export the file again");
    }
    size_t count = sf_mesh_get_view(reader->mesh).vertex_count;
    if (count >= reader->limits.vertices_max) {
        return sfi_fault_set(reader->fault, SF_ERR_OVERFLOW, reader->cursor->line,
                             sfi_cursor_offset(reader->cursor),
                             "the file has more than %zu vertices; raise vertices_max", count);
    }
    return sf_mesh_add_vertices(reader->mesh, xyz, 1);
}

static sf_status too_many_triangles(const sfi_mesh_reader *reader)
{
    return sfi_fault_set(
        reader->fault, SF_ERR_OVERFLOW, reader->cursor->line, sfi_cursor_offset(reader->cursor),
        "the file has more than %zu triangles; raise triangles_max", reader->limits.triangles_max);
}

sf_status sfi_reader_corner(sfi_mesh_reader *reader, uint32_t vertex)
{
    size_t vertices = sf_mesh_get_view(reader->mesh).vertex_count;
    if (vertex >= vertices) {
        return sfi_fault_set(reader->fault, SF_ERR_FORMAT, reader->cursor->line,
                             sfi_cursor_offset(reader->cursor),
                             "a face names vertex %lu, counted from 0, but only %zu are there",
                             (unsigned long)vertex, vertices);
    }
    if (reader->corner_count > 2 && reader->corner_count - 2 >= reader->limits.triangles_max) {
        return too_many_triangles(reader);
    }
    if (!sfi_grow_array(&reader->cursor->allocator, &reader->corners, &reader->corner_capacity,
                        reader->corner_count + 1, sizeof(uint32_t))) {
        return SF_ERR_MEMORY;
    }
    ((uint32_t *)reader->corners)[reader->corner_count++] = vertex;
    return SF_OK;
}

sf_status sfi_reader_polygon(sfi_mesh_reader *reader)
{
    const uint32_t *corner = reader->corners;
    size_t count = reader->corner_count, most = reader->limits.triangles_max;
    if (count < 3) {
        return sfi_cursor_fault(reader->cursor, reader->fault,
                                "a face has fewer than three corners; remove it");
    }
    if (count - 2 > most || sf_mesh_get_view(reader->mesh).triangle_count > most - (count - 2)) {
        return too_many_triangles(reader);
    }
    for (size_t i = 2; i < count; i++) {
        uint32_t triangle[3] = {corner[0], corner[i - 1], corner[i]};
        SF_TRY(sf_mesh_add_triangles(reader->mesh, triangle, 1));
    }
    reader->corner_count = 0;
    return SF_OK;
}

sf_status sfi_reader_number(sfi_mesh_reader *reader, double *value, int lines)
{
    char token[SFI_TOKEN_SIZE];
    sfi_cursor_token(reader->cursor, token, lines);
    if (!sfi_number_parse(token, value)) {
        return sfi_cursor_fault_token(reader->cursor, reader->fault, "a number", token);
    }
    return SF_OK;
}

static int starts_with(const unsigned char *bytes, size_t have, const char *word)
{
    size_t length = strlen(word);
    return have >= length && memcmp(bytes, word, length) == 0;
}

static int contains(const unsigned char *bytes, size_t have, const char *word)
{
    size_t length = strlen(word);
    for (size_t i = 0; i + length <= have; i++) {
        if (memcmp(bytes + i, word, length) == 0) {
            return 1;
        }
    }
    return 0;
}

// Judge by the bytes. OBJ has no magic: it is text that begins like one, or soon has a vertex. What
// is no text is binary STL.
static sf_mesh_format sniff(sfi_cursor *cursor)
{
    size_t have;
    const unsigned char *bytes = sfi_cursor_peek(cursor, SFI_CURSOR_PEEK, &have);
    if (starts_with(bytes, have, "ply\n") || starts_with(bytes, have, "ply\r")) {
        return SF_MESH_FORMAT_PLY;
    }
    if (starts_with(bytes, have, "PK\003\004")) {
        return SF_MESH_FORMAT_THREEMF;
    }
    if (sfi_off_begins(bytes, have)) {
        return SF_MESH_FORMAT_OFF;
    }
    if (sfi_gltf_begins(bytes, have)) {
        return SF_MESH_FORMAT_GLTF;
    }
    if (sfi_stl_is_text(cursor) || !sfi_cursor_at_text(cursor)) {
        return SF_MESH_FORMAT_STL;
    }
    static const char *const first[] = {"v ", "#", "mtllib ", "o ", "g ", "\nv ", "\nv\t", "\rv "};
    for (size_t i = 0; i < sizeof first / sizeof first[0]; i++) {
        if (first[i][0] < ' ' ? contains(bytes, have, first[i])
                              : starts_with(bytes, have, first[i])) {
            return SF_MESH_FORMAT_OBJ;
        }
    }
    return SF_MESH_FORMAT_AUTO;
}

// Formats that people have and this library does not read. Anything may stand in a binary STL's
// header, so a file that calls itself one is not looked at.
static const char *foreign(sfi_cursor *cursor)
{
    static const char *const known[][2] = {
        {"ISO-10303-21", "this is STEP, which has no triangles; export the part as STL or OBJ"},
        {"\211PNG", "this is a picture; a stack of pictures is named by its folder"},
    };
    size_t have;
    const unsigned char *bytes = sfi_cursor_peek(cursor, SFI_CURSOR_PEEK, &have);
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (starts_with(bytes, have, known[i][0])) {
            return known[i][1];
        }
    }
    return NULL;
}

static sf_status read_as(sfi_mesh_reader *reader, sf_mesh_format format)
{
    switch (format) {
    case SF_MESH_FORMAT_STL:
        return sfi_stl_read(reader);
    case SF_MESH_FORMAT_OBJ:
        return sfi_obj_read(reader);
    case SF_MESH_FORMAT_PLY:
        return sfi_ply_read(reader);
    case SF_MESH_FORMAT_OFF:
        return sfi_off_read(reader);
    case SF_MESH_FORMAT_THREEMF:
        return sfi_threemf_read_mesh(reader);
    case SF_MESH_FORMAT_GLTF:
        return sfi_gltf_read(reader);
    case SF_MESH_FORMAT_AUTO:
        break;
    }
    return sfi_cursor_fault_whole(
        reader->cursor, reader->fault,
        "this is no STL, OBJ, PLY, OFF or 3MF file; save the part as one of these");
}

static sf_status read_all(sfi_mesh_reader *reader, sf_mesh_format format)
{
    sfi_cursor_skip_mark(reader->cursor);
    if (format == SF_MESH_FORMAT_AUTO) {
        const char *why = foreign(reader->cursor);
        if (why != NULL) {
            return sfi_cursor_fault_whole(reader->cursor, reader->fault, why);
        }
        format = sniff(reader->cursor);
    }
    SF_TRY(read_as(reader, format));
    if (reader->cursor->failure != SF_OK) {
        return sfi_cursor_fault(reader->cursor, reader->fault, "");
    }
    if (sf_mesh_get_view(reader->mesh).triangle_count == 0) {
        return sfi_cursor_fault_whole(reader->cursor, reader->fault,
                                      "the file holds no triangles; check what was exported");
    }
    return SF_OK;
}

sf_status sf_mesh_read(sf_source source, sf_mesh_format format, const sf_read_limits *limits,
                       const sf_allocator *allocator, sf_mesh **mesh, sf_fault *fault)
{
    if (mesh == NULL || source.read == NULL || (unsigned)format > SF_MESH_FORMAT_GLTF) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "no source, no place for the mesh");
    }
    sfi_cursor cursor;
    sf_mesh *made = NULL;
    sf_read_limits within = sf_read_limits_default();
    if (limits != NULL) { // an older caller knows fewer fields, a newer one more
        size_t known = limits->struct_size < sizeof within ? limits->struct_size : sizeof within;
        memcpy(&within, limits, known);
    }
    sf_status status = sfi_cursor_begin(&cursor, source, within.bytes_max, allocator);
    if (status == SF_OK) {
        status = sf_mesh_create(allocator, &made);
    }
    if (status == SF_OK) {
        sfi_mesh_reader reader = {&cursor, made, within, fault, NULL, 0, 0};
        status = read_all(&reader, format);
        sfi_free_array(&cursor.allocator, reader.corners, reader.corner_capacity, sizeof(uint32_t));
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
