// SPDX-License-Identifier: MIT
// Between rows of a slice and rows of a picture, and PBM.
//
// A slice has its leftmost voxel in the lowest bit of a word, pictures in the highest bit of a
// byte: each byte is reversed. PBM has 1 for black, so there the bits are inverted too.
//
// Source: J. Poskanzer, B. Henderson, pbm(5), raw format P4.

#include "io/picture.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/cursor.h"
#include "io/emitter.h"
#include "io/number.h"
#include "simd/kernels.h"

#include <string.h>

static unsigned char reverse(unsigned byte)
{
    byte = (byte & 0x55) << 1 | (byte >> 1 & 0x55);
    byte = (byte & 0x33) << 2 | (byte >> 2 & 0x33);
    return (unsigned char)(byte << 4 | byte >> 4);
}

void sfi_picture_pack(sf_slice slice, uint32_t y, int invert, unsigned char *packed)
{
    const uint64_t *row = slice.words + (size_t)y * slice.stride;
    size_t count = (slice.width + 7) / 8;
    for (size_t i = 0; i < count; i++) {
        unsigned byte = (unsigned)(row[i / 8] >> (i % 8 * 8)) & 0xff;
        packed[i] = reverse(invert ? byte ^ 0xff : byte);
    }
    if (slice.width % 8 != 0) {
        packed[count - 1] &= (unsigned char)(0xff << (8 - slice.width % 8));
    }
}

void sfi_picture_unpack(sf_slice slice, uint32_t y, int invert, const unsigned char *packed)
{
    uint64_t *row = slice.words + (size_t)y * slice.stride;
    size_t count = (slice.width + 7) / 8;
    memset(row, 0, sfi_row_words(slice.width) * sizeof *row);
    for (size_t i = 0; i < count; i++) {
        unsigned byte = invert ? packed[i] ^ 0xffu : packed[i];
        if (i + 1 == count && slice.width % 8 != 0) {
            byte &= 0xffu << (8 - slice.width % 8);
        }
        row[i / 8] |= (uint64_t)reverse(byte & 0xff) << (i % 8 * 8);
    }
}

sf_status sfi_picture_fault(sf_fault *fault, sf_status status, const char *name,
                            const char *sentence)
{
    return sfi_fault_set(fault, status, 0, 0, "%s: %s", name, sentence);
}

// --- PBM -----------------------------------------------------------------------------------------

static sf_status pbm_write(sf_slice slice, sf_sink sink)
{
    unsigned char packed[SFI_PICTURE_ROW_BYTES];
    sfi_emitter out;
    sfi_emitter_begin(&out, sink);
    sfi_emit_text(&out, "P4\n");
    sfi_emit_whole(&out, slice.width);
    sfi_emit_text(&out, " ");
    sfi_emit_whole(&out, slice.height);
    sfi_emit_text(&out, "\n");
    for (uint32_t y = slice.height; y-- > 0;) {
        sfi_picture_pack(slice, y, 1, packed);
        sfi_emit_bytes(&out, packed, (slice.width + 7) / 8);
    }
    return sfi_emitter_end(&out);
}

static sf_status pbm_fault(const sfi_cursor *cursor, const char *name, const char *sentence,
                           sf_fault *fault)
{
    return cursor->failure != SF_OK
               ? sfi_picture_fault(fault, cursor->failure, name, "reading failed")
               : sfi_picture_fault(fault, SF_ERR_FORMAT, name, sentence);
}

// A word of the head; comments run from # to the end of the line.
static void pbm_word(sfi_cursor *cursor, char token[SFI_TOKEN_SIZE])
{
    while (sfi_cursor_token(cursor, token, 1) > 0 && token[0] == '#') {
        sfi_cursor_skip_line(cursor);
    }
}

static sf_status read_pbm(sfi_cursor *cursor, const char *name, sf_slice slice, int check_only,
                          sf_fault *fault)
{
    char token[SFI_TOKEN_SIZE];
    unsigned char packed[SFI_PICTURE_ROW_BYTES];
    int64_t width, height;
    pbm_word(cursor, token);
    if (strcmp(token, "P4") != 0) {
        return pbm_fault(cursor, name, "this is no PBM picture of kind P4", fault);
    }
    pbm_word(cursor, token);
    int good = sfi_integer_parse(token, &width);
    pbm_word(cursor, token);
    good = good && sfi_integer_parse(token, &height);
    if (!good || width != slice.width || height != slice.height) {
        return pbm_fault(cursor, name, "the picture has not the size that stack.json says", fault);
    }
    sfi_cursor_next(cursor); // the one blank before the pixels
    size_t size = (slice.width + 7) / 8;
    for (uint32_t y = slice.height; !check_only && y-- > 0;) {
        if (sfi_cursor_read(cursor, packed, size) < size) {
            return pbm_fault(cursor, name, "the picture is cut short; write the stack again",
                             fault);
        }
        sfi_picture_unpack(slice, y, 1, packed);
    }
    return SF_OK;
}

static sf_status pbm_read(sf_source source, const sf_allocator *allocator, const char *name,
                          sf_slice slice, int check_only, sf_fault *fault)
{
    sfi_cursor cursor;
    sf_status status = sfi_cursor_begin(&cursor, source, UINT64_MAX, allocator);
    if (status == SF_OK) {
        status = read_pbm(&cursor, name, slice, check_only, fault);
    }
    sfi_cursor_end(&cursor);
    return status;
}

// --- either --------------------------------------------------------------------------------------

sf_status sfi_picture_write(sfi_picture_kind kind, sf_slice slice, sf_sink sink)
{
    return kind == SFI_PICTURE_PNG ? sfi_png_write(slice, sink) : pbm_write(slice, sink);
}

sf_status sfi_picture_read(sfi_picture_kind kind, sf_source source, const sf_allocator *allocator,
                           const char *name, sf_slice slice, int check_only, sf_fault *fault)
{
    return (kind == SFI_PICTURE_PNG ? sfi_png_read
            : kind == SFI_PICTURE_IDS
                ? sfi_png_read_ids
                : pbm_read)(source, allocator, name, slice, check_only, fault);
}
