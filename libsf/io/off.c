// SPDX-License-Identifier: MIT
// Object File Format in: "OFF", counts, vertices, faces, in text.
//
// Texture coordinates, colours and normals (ST, C and N before OFF) stand behind the coordinates of
// their vertex and are passed over with the rest of the line; so are the colours of faces, and
// comments. Files in which the counts stand right behind the word OFF, without a blank, are common
// enough in data sets to be read too. Four dimensions, homogeneous coordinates and binary are
// refused.
//
// Source: Geomview manual, section "OFF Files".

#include "io/readers.h"

#include "base/status.h"
#include "io/number.h"

#include <string.h>

// Length of the keyword that the text begins with ([ST][C][N]OFF), 0 when it begins with none.
static size_t keyword(const char *text, size_t have)
{
    static const char *const part[] = {"ST", "C", "N", "OFF"};
    size_t length = 0;
    for (size_t i = 0; i < 4; i++) {
        size_t size = strlen(part[i]);
        if (have - length >= size && memcmp(text + length, part[i], size) == 0) {
            length += size;
        } else if (i == 3) {
            return 0;
        }
    }
    return length;
}

int sfi_off_begins(const unsigned char *bytes, size_t have)
{
    return keyword((const char *)bytes, have) > 0;
}

// The next token that is no comment.
static size_t next_token(sfi_cursor *cursor, char token[SFI_TOKEN_SIZE])
{
    size_t length = sfi_cursor_token(cursor, token, 1);
    while (length > 0 && token[0] == '#') {
        sfi_cursor_skip_line(cursor);
        length = sfi_cursor_token(cursor, token, 1);
    }
    return length;
}

static sf_status parse_count(sfi_mesh_reader *reader, const char *expected, const char *token,
                             int64_t *count)
{
    if (!sfi_integer_parse(token, count) || *count < 0 || *count > UINT32_MAX) {
        return sfi_cursor_fault_token(reader->cursor, reader->fault, expected, token);
    }
    return SF_OK;
}

static sf_status read_count(sfi_mesh_reader *reader, const char *expected, int64_t *count)
{
    char token[SFI_TOKEN_SIZE];
    next_token(reader->cursor, token);
    return parse_count(reader, expected, token, count);
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
    SF_TRY(sfi_reader_vertex(reader, xyz));
    sfi_cursor_skip_line(reader->cursor);
    return SF_OK;
}

static sf_status read_face(sfi_mesh_reader *reader)
{
    int64_t count, index;
    SF_TRY(read_count(reader, "the number of corners of a face", &count));
    for (int64_t i = 0; i < count; i++) {
        SF_TRY(read_count(reader, "a vertex number", &index));
        SF_TRY(sfi_reader_corner(reader, (uint32_t)index));
    }
    SF_TRY(sfi_reader_polygon(reader));
    sfi_cursor_skip_line(reader->cursor);
    return SF_OK;
}

sf_status sfi_off_read(sfi_mesh_reader *reader)
{
    char token[SFI_TOKEN_SIZE];
    int64_t vertices, faces, edges;
    size_t length = next_token(reader->cursor, token), word = keyword(token, length);
    if (word == 0) {
        return sfi_cursor_fault_token(reader->cursor, reader->fault,
                                      "the word OFF, COFF or NOFF (text, three dimensions)", token);
    }
    if (word == length) {
        SF_TRY(read_count(reader, "the number of vertices", &vertices));
    } else {
        SF_TRY(parse_count(reader, "the number of vertices", token + word, &vertices));
    }
    SF_TRY(read_count(reader, "the number of faces", &faces));
    SF_TRY(read_count(reader, "the number of edges", &edges));
    for (int64_t i = 0; i < vertices; i++) {
        SF_TRY(read_vertex(reader));
    }
    for (int64_t i = 0; i < faces; i++) {
        SF_TRY(read_face(reader));
    }
    return SF_OK;
}
