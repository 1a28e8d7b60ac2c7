// SPDX-License-Identifier: MIT
// STL in, text and binary.
//
// What tells text from binary is not the word "solid", with which many binary files begin, but
// whether what follows it is text: a binary file has zeros in its counts and coordinates. The count
// in a binary header is believed when the file is at least that long; what follows is ignored, as
// all programs do. A count of 0 or 2^32 - 1 is what programs write that did not know it when they
// began: then facets are read to the end. A file that is shorter than its count is cut short and
// refused, because half a part looks like a whole one.
//
// Text is read by its vertices: "vertex x y z" three times is a facet, whatever the words around
// it. It must end with endsolid, for the same reason.
//
// Source: 3D Systems, "StereoLithography Interface Specification", 1989, as programs follow it.

#include "io/readers.h"

#include "base/status.h"

#include <string.h>

#define HEADER_BYTES 80
#define FACET_BYTES 50

static uint32_t get_u32(const unsigned char *bytes)
{
    return (uint32_t)bytes[0] | (uint32_t)bytes[1] << 8 | (uint32_t)bytes[2] << 16 |
           (uint32_t)bytes[3] << 24;
}

static float get_float(const unsigned char *bytes)
{
    uint32_t bits = get_u32(bytes);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static char lower(int c)
{
    return (char)(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
}

static int is_word(const char *token, const char *word)
{
    for (; *token != '\0' && lower(*token) == *word; token++, word++) {
    }
    return *token == '\0' && *word == '\0';
}

int sfi_stl_is_text(sfi_cursor *cursor)
{
    static const char solid[] = "solid";
    size_t have, start = 0, matched = 0;
    const unsigned char *bytes = sfi_cursor_peek(cursor, SFI_CURSOR_PEEK, &have);
    while (start < have &&
           (bytes[start] == ' ' || (bytes[start] >= '\t' && bytes[start] <= '\r'))) {
        start++;
    }
    while (matched < 5 && start + matched < have &&
           lower(bytes[start + matched]) == solid[matched]) {
        matched++;
    }
    return matched == 5 && sfi_cursor_at_text(cursor);
}

static sf_status add_facet(sfi_mesh_reader *reader, double corner[3][3])
{
    for (int i = 0; i < 3; i++) {
        uint32_t vertex = (uint32_t)sf_mesh_get_view(reader->mesh).vertex_count;
        SF_TRY(sfi_reader_vertex(reader, corner[i]));
        SF_TRY(sfi_reader_corner(reader, vertex));
    }
    return sfi_reader_polygon(reader);
}

static sf_status read_text(sfi_mesh_reader *reader)
{
    char token[SFI_TOKEN_SIZE];
    double corner[3][3];
    int corners = 0, ended = 0;
    sfi_cursor_token(reader->cursor, token, 1);
    sfi_cursor_skip_line(reader->cursor); // solid NAME: a name may hold any word
    while (sfi_cursor_token(reader->cursor, token, 1) > 0) {
        if (is_word(token, "vertex")) {
            for (int axis = 0; axis < 3; axis++) {
                SF_TRY(sfi_reader_number(reader, &corner[corners][axis], 0));
            }
            if (++corners == 3) {
                SF_TRY(add_facet(reader, corner));
                corners = 0;
            }
            sfi_cursor_skip_line(reader->cursor);
        } else if (is_word(token, "solid") || is_word(token, "endsolid") || is_word(token, "end")) {
            ended = !is_word(token, "solid");
            sfi_cursor_skip_line(reader->cursor);
        } else if (is_word(token, "endfacet") && corners != 0) {
            return sfi_cursor_fault(reader->cursor, reader->fault,
                                    "a facet ends with fewer than three vertices; correct it");
        }
    }
    if (corners != 0 || !ended) {
        return sfi_cursor_fault(reader->cursor, reader->fault,
                                "the file ends without endsolid; it is cut short, so copy or "
                                "export it again");
    }
    return SF_OK;
}

static sf_status read_binary(sfi_mesh_reader *reader)
{
    unsigned char header[HEADER_BYTES + 4], facet[FACET_BYTES];
    reader->cursor->line = 0; // there are no lines: faults name a byte
    if (sfi_cursor_read(reader->cursor, header, sizeof header) < sizeof header) {
        return sfi_cursor_fault(reader->cursor, reader->fault,
                                "the file is too short for an STL file; it is cut short or no STL");
    }
    uint32_t count = get_u32(header + HEADER_BYTES);
    int unknown = count == 0 || count == UINT32_MAX;
    for (uint64_t i = 0; unknown || i < count; i++) {
        size_t got = sfi_cursor_read(reader->cursor, facet, sizeof facet);
        if (got == 0 && unknown) {
            break;
        }
        if (got < sizeof facet) {
            if (reader->cursor->failure != SF_OK) {
                return sfi_cursor_fault(reader->cursor, reader->fault, "");
            }
            return sfi_fault_set(reader->fault, SF_ERR_FORMAT, 0, sfi_cursor_offset(reader->cursor),
                                 "the file ends after %llu of %llu facets; it is cut short, so "
                                 "copy or export it again",
                                 (unsigned long long)i,
                                 (unsigned long long)(unknown ? i + 1 : count));
        }
        double corner[3][3];
        for (int k = 0; k < 9; k++) {
            corner[k / 3][k % 3] = (double)get_float(facet + 12 + 4 * k);
        }
        SF_TRY(add_facet(reader, corner));
    }
    return SF_OK;
}

sf_status sfi_stl_read(sfi_mesh_reader *reader)
{
    return sfi_stl_is_text(reader->cursor) ? read_text(reader) : read_binary(reader);
}
