// SPDX-License-Identifier: MIT
// PNG in and out, by libspng.
//
// Out: one bit of grey a pixel for slices, eight bits of red, green and blue for pictures, row by
// row, so that no more than a row is held. Rows of slices are not filtered: filters work on bytes,
// and on packed bits they only disturb the compressor. In: grey of one bit, or of more with
// half-way and above taken as white, because that is what picture editors save; never interlaced.
//
// libspng's memory hooks have no place for a context, so it takes its few kilobytes from the C
// library. The same holds for zlib beneath it.

#include "io/picture.h"

#include "base/memory.h"
#include "base/status.h"

#ifdef SF_HAVE_SPNG

#include <spng.h>
#include <string.h>

int sf_stack_has_png(void)
{
    return 1;
}

// --- out -----------------------------------------------------------------------------------------

typedef struct png_sink {
    sf_sink sink;
    sf_status status;
} png_sink;

static int hand_on(spng_ctx *context, void *user, void *data, size_t size)
{
    png_sink *out = user;
    (void)context;
    if (out->status == SF_OK) {
        out->status = out->sink.write(out->sink.user, data, size);
    }
    return out->status == SF_OK ? 0 : SPNG_IO_ERROR;
}

// What a failure of libspng means: what the sink said, or memory, the only other thing it runs out
// of.
static sf_status out_status(const png_sink *out, int error)
{
    if (out->status != SF_OK) {
        return out->status;
    }
    return error == SPNG_EMEM ? SF_ERR_MEMORY : SF_ERR_INTERNAL;
}

static int begin_writing(spng_ctx *context, png_sink *out, uint32_t width, uint32_t height, int rgb)
{
    struct spng_ihdr head;
    memset(&head, 0, sizeof head);
    head.width = width;
    head.height = height;
    head.bit_depth = rgb ? 8 : 1;
    head.color_type = rgb ? SPNG_COLOR_TYPE_TRUECOLOR : SPNG_COLOR_TYPE_GRAYSCALE;
    int error = spng_set_png_stream(context, hand_on, out);
    if (error == 0) {
        error = spng_set_ihdr(context, &head);
    }
    if (error == 0 && !rgb) {
        error = spng_set_option(context, SPNG_FILTER_CHOICE, SPNG_DISABLE_FILTERING);
    }
    if (error == 0) {
        error = spng_encode_image(context, NULL, 0, SPNG_FMT_PNG,
                                  SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE);
    }
    return error;
}

sf_status sfi_png_write(sf_slice slice, sf_sink sink)
{
    unsigned char packed[SFI_PICTURE_ROW_BYTES];
    png_sink out = {sink, SF_OK};
    spng_ctx *context = spng_ctx_new(SPNG_CTX_ENCODER);
    if (context == NULL) {
        return SF_ERR_MEMORY;
    }
    int error = begin_writing(context, &out, slice.width, slice.height, 0);
    for (uint32_t y = slice.height; error == 0 && y-- > 0;) {
        sfi_picture_pack(slice, y, 0, packed);
        error = spng_encode_row(context, packed, (slice.width + 7) / 8);
    }
    spng_ctx_free(context);
    return error == SPNG_EOI ? SF_OK : out_status(&out, error);
}

sf_status sf_png_write_rgb(const uint8_t *pixels, uint32_t width, uint32_t height, sf_sink sink)
{
    if (pixels == NULL || sink.write == NULL || width == 0 || height == 0 ||
        width > SF_EXTENT_MAX || height > SF_EXTENT_MAX) {
        return SF_ERR_ARGUMENT;
    }
    png_sink out = {sink, SF_OK};
    spng_ctx *context = spng_ctx_new(SPNG_CTX_ENCODER);
    if (context == NULL) {
        return SF_ERR_MEMORY;
    }
    int error = begin_writing(context, &out, width, height, 1);
    for (uint32_t y = 0; error == 0 && y < height; y++) {
        error = spng_encode_row(context, pixels + (size_t)y * 3 * width, (size_t)3 * width);
    }
    spng_ctx_free(context);
    return error == SPNG_EOI ? SF_OK : out_status(&out, error);
}

// --- in ------------------------------------------------------------------------------------------

typedef struct png_source {
    sf_source source;
    sf_status status;
} png_source;

static int fetch(spng_ctx *context, void *user, void *data, size_t size)
{
    png_source *in = user;
    (void)context;
    for (size_t done = 0, got = 0; done < size; done += got) {
        in->status =
            in->source.read(in->source.user, (unsigned char *)data + done, size - done, &got);
        if (in->status == SF_OK && got > size - done) {
            in->status = SF_ERR_IO; // the source has broken its promise
        }
        if (in->status != SF_OK) {
            return SPNG_IO_ERROR;
        }
        if (got == 0) {
            return SPNG_IO_EOF;
        }
    }
    return 0;
}

static sf_status in_fault(const png_source *in, int error, const char *name, sf_fault *fault)
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

static sf_status read_head(spng_ctx *context, const png_source *in, const char *name,
                           sf_slice slice, struct spng_ihdr *head, sf_fault *fault)
{
    int error = spng_get_ihdr(context, head);
    if (error != 0) {
        return in_fault(in, error, name, fault);
    }
    if (head->width != slice.width || head->height != slice.height) {
        return sfi_picture_fault(fault, SF_ERR_FORMAT, name,
                                 "the picture has not the size that stack.json says");
    }
    if (head->color_type != SPNG_COLOR_TYPE_GRAYSCALE || head->bit_depth > 8 ||
        head->interlace_method != 0) {
        return sfi_picture_fault(
            fault, SF_ERR_UNSUPPORTED, name,
            "only grey pictures of 1 to 8 bits, not interlaced, are layers; save "
            "it so");
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

static sf_status read_rows(spng_ctx *context, const png_source *in, const char *name,
                           sf_slice slice, int one_bit, unsigned char *row, sf_fault *fault)
{
    int error = spng_decode_image(context, NULL, 0, one_bit ? SPNG_FMT_PNG : SPNG_FMT_G8,
                                  SPNG_DECODE_PROGRESSIVE);
    size_t size = one_bit ? (slice.width + 7) / 8 : slice.width;
    for (uint32_t y = slice.height; error == 0 && y-- > 0;) {
        error = spng_decode_row(context, row, size);
        if (error == 0 || error == SPNG_EOI) {
            if (!one_bit) {
                pack_grey(row, slice.width);
            }
            sfi_picture_unpack(slice, y, 0, row);
        }
    }
    return error == SPNG_EOI ? SF_OK : in_fault(in, error, name, fault);
}

sf_status sfi_png_read(sf_source source, const sf_allocator *allocator, const char *name,
                       sf_slice slice, int check_only, sf_fault *fault)
{
    png_source in = {source, SF_OK};
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
            error = spng_set_png_stream(context, fetch, &in);
        }
        status = error == 0 ? read_head(context, &in, name, slice, &head, fault) : SF_ERR_INTERNAL;
        if (status == SF_OK && !check_only) {
            status = read_rows(context, &in, name, slice, head.bit_depth == 1, row, fault);
        }
    }
    spng_ctx_free(context);
    sfi_free_array(&from, row, slice.width, 1);
    return status;
}

#else

int sf_stack_has_png(void)
{
    return 0;
}

sf_status sfi_png_write(sf_slice slice, sf_sink sink)
{
    (void)slice;
    (void)sink;
    return SF_ERR_UNSUPPORTED;
}

sf_status sf_png_write_rgb(const uint8_t *pixels, uint32_t width, uint32_t height, sf_sink sink)
{
    (void)pixels;
    (void)width;
    (void)height;
    (void)sink;
    return SF_ERR_UNSUPPORTED;
}

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

#endif
