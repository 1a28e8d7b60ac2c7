// SPDX-License-Identifier: MIT
// PNG out, by libspng.
//
// One bit of grey a pixel for slices, a palette for layers of materials, eight bits of red, green
// and blue for pictures; row by row, so that no more than a row is held. Rows of slices and layers
// are not filtered: filters work on bytes, and on packed bits they only disturb the compressor.
//
// libspng's memory hooks have no place for a context, so it takes its few kilobytes from the C
// library. The same holds for zlib beneath it.

#include "io/picture.h"

#include "base/status.h"

#ifdef SF_HAVE_SPNG

#include "io/png_stream.h"

#include <string.h>

int sf_stack_has_png(void)
{
    return 1;
}

static int begin_writing(spng_ctx *context, sfi_png_sink *out, uint32_t width, uint32_t height,
                         int rgb)
{
    struct spng_ihdr head;
    memset(&head, 0, sizeof head);
    head.width = width;
    head.height = height;
    head.bit_depth = rgb ? 8 : 1;
    head.color_type = rgb ? SPNG_COLOR_TYPE_TRUECOLOR : SPNG_COLOR_TYPE_GRAYSCALE;
    int error = spng_set_png_stream(context, sfi_png_hand_on, out);
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
    sfi_png_sink out = {sink, SF_OK};
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
    return sfi_png_written(&out, error);
}

sf_status sf_png_write_rgb(const uint8_t *pixels, uint32_t width, uint32_t height, sf_sink sink)
{
    if (pixels == NULL || sink.write == NULL || width == 0 || height == 0 ||
        width > SF_EXTENT_MAX || height > SF_EXTENT_MAX) {
        return SF_ERR_ARGUMENT;
    }
    sfi_png_sink out = {sink, SF_OK};
    spng_ctx *context = spng_ctx_new(SPNG_CTX_ENCODER);
    if (context == NULL) {
        return SF_ERR_MEMORY;
    }
    int error = begin_writing(context, &out, width, height, 1);
    for (uint32_t y = 0; error == 0 && y < height; y++) {
        error = spng_encode_row(context, pixels + (size_t)y * 3 * width, (size_t)3 * width);
    }
    spng_ctx_free(context);
    return sfi_png_written(&out, error);
}

sf_status sfi_png_write_grey16(const uint16_t *values, uint32_t width, uint32_t height,
                               sf_sink sink)
{
    struct spng_ihdr head;
    sfi_png_sink out = {sink, SF_OK};
    spng_ctx *context = spng_ctx_new(SPNG_CTX_ENCODER);
    if (context == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(&head, 0, sizeof head);
    head.width = width;
    head.height = height;
    head.bit_depth = 16;
    head.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
    int error = spng_set_png_stream(context, sfi_png_hand_on, &out);
    if (error == 0) {
        error = spng_set_ihdr(context, &head);
    }
    if (error == 0) {
        error = spng_encode_image(context, NULL, 0, SPNG_FMT_PNG,
                                  SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE);
    }
    for (uint32_t y = height; error == 0 && y-- > 0;) {
        error = spng_encode_row(context, values + (size_t)y * width, (size_t)2 * width);
    }
    spng_ctx_free(context);
    return sfi_png_written(&out, error);
}

// ---------------------------------------------------------------------------------------------
// Palettes
// ---------------------------------------------------------------------------------------------

static unsigned depth_of(uint32_t colours)
{
    return colours <= 2 ? 1 : colours <= 4 ? 2 : colours <= 16 ? 4 : 8;
}

static void pack_ids(const uint8_t *ids, uint32_t width, unsigned depth, unsigned char *packed)
{
    unsigned per_byte = 8 / depth;
    for (uint32_t x = 0; x < width; x += per_byte) {
        unsigned byte = 0;
        for (uint32_t i = x; i < x + per_byte; i++) {
            byte = byte << depth | (i < width ? ids[i] : 0u);
        }
        packed[x / per_byte] = (unsigned char)byte;
    }
}

static int set_palette(spng_ctx *context, const sfi_palette *palette)
{
    struct spng_plte colours;
    struct spng_trns clear;
    memset(&colours, 0, sizeof colours);
    memset(&clear, 0, sizeof clear);
    colours.n_entries = palette->count;
    for (uint32_t i = 0; i < palette->count; i++) {
        colours.entries[i].red = palette->colours[i][0];
        colours.entries[i].green = palette->colours[i][1];
        colours.entries[i].blue = palette->colours[i][2];
    }
    clear.n_type3_entries = 1; // the first, which is empty space
    int error = spng_set_plte(context, &colours);
    return error != 0 ? error : spng_set_trns(context, &clear);
}

sf_status sfi_png_write_ids(const uint8_t *ids, size_t stride, uint32_t width, uint32_t height,
                            const sfi_palette *palette, sf_sink sink)
{
    unsigned char packed[SF_EXTENT_MAX];
    unsigned depth = depth_of(palette->count);
    sfi_png_sink out = {sink, SF_OK};
    spng_ctx *context = spng_ctx_new(SPNG_CTX_ENCODER);
    if (context == NULL) {
        return SF_ERR_MEMORY;
    }
    int error = spng_set_png_stream(context, sfi_png_hand_on, &out);
    if (error == 0) {
        struct spng_ihdr head;
        memset(&head, 0, sizeof head);
        head.width = width;
        head.height = height;
        head.bit_depth = (uint8_t)depth;
        head.color_type = SPNG_COLOR_TYPE_INDEXED;
        error = spng_set_ihdr(context, &head);
    }
    if (error == 0) {
        error = set_palette(context, palette);
    }
    if (error == 0) {
        error = spng_set_option(context, SPNG_FILTER_CHOICE, SPNG_DISABLE_FILTERING);
    }
    if (error == 0) {
        error = spng_encode_image(context, NULL, 0, SPNG_FMT_PNG,
                                  SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE);
    }
    for (uint32_t y = height; error == 0 && y-- > 0;) {
        pack_ids(ids + stride * y, width, depth, packed);
        error = spng_encode_row(context, packed, ((size_t)width * depth + 7) / 8);
    }
    spng_ctx_free(context);
    return sfi_png_written(&out, error);
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

sf_status sfi_png_write_grey16(const uint16_t *values, uint32_t width, uint32_t height,
                               sf_sink sink)
{
    (void)values;
    (void)width;
    (void)height;
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

sf_status sfi_png_write_ids(const uint8_t *ids, size_t stride, uint32_t width, uint32_t height,
                            const sfi_palette *palette, sf_sink sink)
{
    (void)ids;
    (void)stride;
    (void)width;
    (void)height;
    (void)palette;
    (void)sink;
    return SF_ERR_UNSUPPORTED;
}

#endif
