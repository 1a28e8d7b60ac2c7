// SPDX-License-Identifier: MIT
// Wavefront OBJ in: vertices and faces, everything else passed over.
//
// "v x y z ..." and "f a b c ..." with corners a, a/t, a//n or a/t/n, counted from 1 or, negative,
// backwards from the vertex read last. A backslash at the end of a line continues it. Faces of more
// than three corners become a fan about the first, which is right for convex ones.

#include "io/readers.h"

#include "base/status.h"
#include "io/number.h"

#include <string.h>

// The next token of a line that may be continued; 0 at its end.
static size_t next_token(sfi_cursor *cursor, char token[SFI_TOKEN_SIZE])
{
    size_t length;
    while ((length = sfi_cursor_token(cursor, token, 0)) == 1 && token[0] == '\\' &&
           sfi_cursor_look(cursor) == '\n') {
        sfi_cursor_next(cursor);
    }
    if (length > 1 && token[length - 1] == '\\' && sfi_cursor_look(cursor) == '\n') {
        token[length - 1] = '\0';
        length--;
        sfi_cursor_next(cursor);
    }
    return length;
}

static sf_status read_vertex(sfi_mesh_reader *reader)
{
    double xyz[3];
    for (int axis = 0; axis < 3; axis++) {
        char token[SFI_TOKEN_SIZE];
        next_token(reader->cursor, token);
        if (!sfi_number_parse(token, &xyz[axis])) {
            return sfi_cursor_fault_token(reader->cursor, reader->fault, "a coordinate", token);
        }
    }
    return sfi_reader_vertex(reader, xyz);
}

// "12/3/4" or "-1" to an index counted from 0.
static sf_status resolve(sfi_mesh_reader *reader, char *token, uint32_t *index)
{
    char *slash = strchr(token, '/');
    int64_t number, vertices = (int64_t)sf_mesh_get_view(reader->mesh).vertex_count;
    if (slash != NULL) {
        *slash = '\0';
    }
    if (!sfi_integer_parse(token, &number)) {
        return sfi_cursor_fault_token(reader->cursor, reader->fault, "a vertex number", token);
    }
    int64_t from_zero = number > 0 ? number - 1 : vertices + number;
    if (number == 0 || number < -vertices || from_zero >= vertices) {
        return sfi_fault_set(
            reader->fault, SF_ERR_FORMAT, reader->cursor->line, sfi_cursor_offset(reader->cursor),
            "a face names vertex %lld, but %lld are there so far; correct the face",
            (long long)number, (long long)vertices);
    }
    *index = (uint32_t)from_zero;
    return SF_OK;
}

static sf_status read_face(sfi_mesh_reader *reader)
{
    char token[SFI_TOKEN_SIZE];
    while (next_token(reader->cursor, token) > 0 && token[0] != '#') {
        uint32_t index = 0;
        SF_TRY(resolve(reader, token, &index));
        SF_TRY(sfi_reader_corner(reader, index));
    }
    return sfi_reader_polygon(reader);
}

sf_status sfi_obj_read(sfi_mesh_reader *reader)
{
    char token[SFI_TOKEN_SIZE];
    while (sfi_cursor_token(reader->cursor, token, 1) > 0) {
        if (strcmp(token, "v") == 0) {
            SF_TRY(read_vertex(reader));
        } else if (strcmp(token, "f") == 0 || strcmp(token, "fo") == 0) {
            SF_TRY(read_face(reader));
        }
        sfi_cursor_skip_line(reader->cursor);
    }
    return SF_OK;
}
