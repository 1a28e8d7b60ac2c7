// SPDX-License-Identifier: MIT
// PNG in, by libspng: grey of one bit, or of more with half-way and above taken as white, because
// that is what picture editors save; or a palette, whose entry 0 is empty space; never interlaced.
//
// libspng's memory hooks have no place for a context, so it takes its few kilobytes from the C
// library. The same holds for zlib beneath it.

#include "io/picture.h"

#include "base/memory.h"
#include "base/status.h"

#ifdef SF_HAVE_SPNG

#include "io/png_stream.h"

#include <string.h>

static sf_status in_fault(const sfi_png_source *in, int error, const char *name, sf_fault *fault)
{
    if (in->status != SF_OK) {
        return sfi_picture_fault(fault, in->status, name, "reading failed");
    }
    if (error == SPNG_EMEM) {
        return SF_ERR_MEMORY;
    }
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                         "%s: this is no whole PNG picture (%s); write the stack again", name,
                         spng_strerror(error));
}

static sf_status read_head(spng_ctx *context, const sfi_png_source *in, const char *name,
                           sf_slice slice, int ids, struct spng_ihdr *head, sf_fault *fault)
{
    int error = spng_get_ihdr(context, head);
    if (error != 0) {
        return in_fault(in, error, name, fault);
    }
    if (head->width != slice.width || head->height != slice.height) {
        return sfi_picture_fault(fault, SF_ERR_FORMAT, name,
                                 "the picture has not the size that stack.json says");
    }
    int wanted = ids ? SPNG_COLOR_TYPE_INDEXED : SPNG_COLOR_TYPE_GRAYSCALE;
    if (head->color_type != wanted || head->bit_depth > 8 || head->interlace_method != 0) {
        return sfi_picture_fault(
            fault, SF_ERR_UNSUPPORTED, name,
            ids ? "only pictures with a palette, not interlaced, are layers of materials; save it "
                  "so"
                : "only grey pictures of 1 to 8 bits, not interlaced, are layers; save it so");
    }
    return SF_OK;
}

// Bytes of grey, 128 and above being white, to packed pixels in place.
static void pack_grey(unsigned char *row, uint32_t width)
{
    for (uint32_t x = 0; x < width; x += 8) {
        unsigned byte = 0;
        for (uint32_t i = x; i < x + 8; i++) {
            byte = byte << 1 | (i < width && row[i] >= 128);
        }
        row[x / 8] = (unsigned char)byte;
    }
}

// Palette entries of `depth` bits, all but 0 being solid, to packed pixels in place.
static void pack_ids(unsigned char *row, uint32_t width, unsigned depth)
{
    unsigned mask = (1u << depth) - 1, per_byte = 8 / depth;
    for (uint32_t x = 0; x < width; x += 8) {
        unsigned byte = 0;
        for (uint32_t i = x; i < x + 8; i++) {
            unsigned shift = 8 - depth * (1 + i % per_byte);
            byte = byte << 1 | (i < width && (row[i / per_byte] >> shift & mask) != 0);
        }
        row[x / 8] = (unsigned char)byte; // never ahead of what is read
    }
}

static sf_status read_rows(spng_ctx *context, const sfi_png_source *in, const char *name,
                           sf_slice slice, const struct spng_ihdr *head, unsigned char *row,
                           sf_fault *fault)
{
    int ids = head->color_type == SPNG_COLOR_TYPE_INDEXED;
    unsigned depth = ids || head->bit_depth == 1 ? head->bit_depth : 8;
    int error = spng_decode_image(context, NULL, 0, depth == 8 && !ids ? SPNG_FMT_G8 : SPNG_FMT_PNG,
                                  SPNG_DECODE_PROGRESSIVE);
    size_t size = ((size_t)slice.width * depth + 7) / 8;
    for (uint32_t y = slice.height; error == 0 && y-- > 0;) {
        error = spng_decode_row(context, row, size);
        if (error == 0 || error == SPNG_EOI) {
            if (ids) {
                pack_ids(row, slice.width, depth);
            } else if (depth == 8) {
                pack_grey(row, slice.width);
            }
            sfi_picture_unpack(slice, y, 0, row);
        }
    }
    return error == SPNG_EOI ? SF_OK : in_fault(in, error, name, fault);
}

static sf_status read_picture(sf_source source, const sf_allocator *allocator, const char *name,
                              sf_slice slice, int ids, int check_only, sf_fault *fault)
{
    sfi_png_source in = {source, SF_OK};
    struct spng_ihdr head;
    sf_allocator from = sfi_allocator_or_default(allocator);
    unsigned char *row = sfi_alloc_array(&from, slice.width, 1);
    spng_ctx *context = spng_ctx_new(0);
    sf_status status = SF_ERR_MEMORY;
    if (row != NULL && context != NULL) {
        int error = spng_set_image_limits(context, SF_EXTENT_MAX, SF_EXTENT_MAX);
        if (error == 0) {
            error = spng_set_chunk_limits(context, 1u << 20, 1u << 22);
        }
        if (error == 0) {
            error = spng_set_png_stream(context, sfi_png_fetch, &in);
        }
        status =
            error == 0 ? read_head(context, &in, name, slice, ids, &head, fault) : SF_ERR_INTERNAL;
        if (status == SF_OK && !check_only) {
            status = read_rows(context, &in, name, slice, &head, row, fault);
        }
    }
    spng_ctx_free(context);
    sfi_free_array(&from, row, slice.width, 1);
    return status;
}

sf_status sfi_png_read(sf_source source, const sf_allocator *allocator, const char *name,
                       sf_slice slice, int check_only, sf_fault *fault)
{
    return read_picture(source, allocator, name, slice, 0, check_only, fault);
}

sf_status sfi_png_read_ids(sf_source source, const sf_allocator *allocator, const char *name,
                           sf_slice slice, int check_only, sf_fault *fault)
{
    return read_picture(source, allocator, name, slice, 1, check_only, fault);
}

#else

sf_status sfi_png_read(sf_source source, const sf_allocator *allocator, const char *name,
                       sf_slice slice, int check_only, sf_fault *fault)
{
    (void)source;
    (void)allocator;
    (void)slice;
    (void)check_only;
    return sfi_picture_fault(fault, SF_ERR_UNSUPPORTED, name,
                             "this build reads no PNG; build it with libspng, or write the stack "
                             "as PBM");
}

sf_status sfi_png_read_ids(sf_source source, const sf_allocator *allocator, const char *name,
                           sf_slice slice, int check_only, sf_fault *fault)
{
    return sfi_png_read(source, allocator, name, slice, check_only, fault);
}

#endif
