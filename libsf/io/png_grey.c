// SPDX-License-Identifier: MIT
// PNG as the layers of printers: rows of greys, of whatever kind the picture is, and back.
//
// Grey of up to 8 bits is taken as it is. Anything else, as editors and converters save it, is made
// red, green, blue and alpha by libspng, and then grey: as bright as it looks, and black where it
// is transparent. Row 0 of what comes out is the lowest, which a picture has last.
//
// libspng's memory hooks have no place for a context, so it takes its few kilobytes from the C
// library. The same holds for zlib beneath it.

#include "io/png_grey.h"

#include "base/memory.h"
#include "base/status.h"
#include "io/picture.h"

#ifdef SF_HAVE_SPNG

#include "io/png_stream.h"

#include <string.h>

static sf_status refuse(const sfi_png_source *in, int error, const char *name, sf_fault *fault)
{
    if (in->status == SF_ERR_MEMORY || error == SPNG_EMEM) {
        return SF_ERR_MEMORY;
    }
    if (in->status != SF_OK && in->status != SF_ERR_FORMAT) {
        return sfi_picture_fault(fault, in->status, name, "reading failed");
    }
    return sfi_fault_set(fault, SF_ERR_FORMAT, 0, 0,
                         "%.100s: this is no whole PNG picture (%s); export the job again", name,
                         in->status == SF_OK ? spng_strerror(error) : "it is damaged");
}

static sf_status open_picture(spng_ctx *context, sfi_png_source *in, const char *name,
                              struct spng_ihdr *head, sf_fault *fault)
{
    if (spng_set_image_limits(context, SF_EXTENT_MAX, SF_EXTENT_MAX) != 0 ||
        spng_set_chunk_limits(context, 1u << 20, 1u << 22) != 0 ||
        spng_set_png_stream(context, sfi_png_fetch, in) != 0) {
        return SF_ERR_INTERNAL;
    }
    int error = spng_get_ihdr(context, head);
    if (error != 0) {
        return refuse(in, error, name, fault);
    }
    if (head->interlace_method != 0) {
        return sfi_picture_fault(fault, SF_ERR_UNSUPPORTED, name,
                                 "interlaced pictures are not read; save it without");
    }
    return SF_OK;
}

sf_status sfi_png_look(sf_source source, const char *name, sfi_png_head *found, sf_fault *fault)
{
    sfi_png_source in = {source, SF_OK};
    struct spng_ihdr head;
    spng_ctx *context = spng_ctx_new(0);
    if (context == NULL) {
        return SF_ERR_MEMORY;
    }
    sf_status status = open_picture(context, &in, name, &head, fault);
    spng_ctx_free(context);
    if (status == SF_OK) {
        sfi_png_head made = {head.width, head.height,
                             head.color_type != SPNG_COLOR_TYPE_GRAYSCALE || head.bit_depth > 1};
        *found = made;
    }
    return status;
}

// Four bytes a pixel to one, in place.
static void to_grey(uint8_t *row, uint32_t width)
{
    for (uint32_t x = 0; x < width; x++) {
        const uint8_t *p = row + (size_t)4 * x;
        unsigned grey = (54u * p[0] + 183u * p[1] + 19u * p[2] + 128u) / 256;
        row[x] = (uint8_t)((grey * p[3] + 127) / 255);
    }
}

static sf_status read_rows(spng_ctx *context, const sfi_png_source *in, const char *name,
                           const struct spng_ihdr *head, uint8_t *row, sfi_png_row hand_on,
                           void *user, sf_fault *fault)
{
    int is_grey = head->color_type == SPNG_COLOR_TYPE_GRAYSCALE && head->bit_depth <= 8;
    int error = spng_decode_image(context, NULL, 0, is_grey ? SPNG_FMT_G8 : SPNG_FMT_RGBA8,
                                  (is_grey ? 0 : SPNG_DECODE_TRNS) | SPNG_DECODE_PROGRESSIVE);
    for (uint32_t y = head->height; error == 0 && y-- > 0;) {
        error = spng_decode_row(context, row, (size_t)head->width * (is_grey ? 1 : 4));
        if (error == 0 || error == SPNG_EOI) {
            if (!is_grey) {
                to_grey(row, head->width);
            }
            hand_on(user, y, row);
        }
    }
    return error == SPNG_EOI ? SF_OK : refuse(in, error, name, fault);
}

sf_status sfi_png_read_rows(sf_source source, const sf_allocator *allocator, const char *name,
                            uint32_t width, uint32_t height, sfi_png_row hand_on, void *user,
                            sf_fault *fault)
{
    sfi_png_source in = {source, SF_OK};
    struct spng_ihdr head;
    uint8_t *row = sfi_alloc_array(allocator, width, 4);
    spng_ctx *context = spng_ctx_new(0);
    sf_status status = SF_ERR_MEMORY;
    if (row != NULL && context != NULL) {
        status = open_picture(context, &in, name, &head, fault);
    }
    if (status == SF_OK && (head.width != width || head.height != height)) {
        status = sfi_picture_fault(fault, SF_ERR_FORMAT, name,
                                   "the picture has not the size of the others");
    }
    if (status == SF_OK) {
        status = read_rows(context, &in, name, &head, row, hand_on, user, fault);
    }
    spng_ctx_free(context);
    sfi_free_array(allocator, row, width, 4);
    return status;
}

// ---------------------------------------------------------------------------------------------
// Writing
// ---------------------------------------------------------------------------------------------

sf_status sfi_png_write_grey(const uint8_t *pixels, size_t row_bytes, uint32_t width,
                             uint32_t height, sf_sink sink)
{
    sfi_png_sink out = {sink, SF_OK};
    struct spng_ihdr head;
    spng_ctx *context = spng_ctx_new(SPNG_CTX_ENCODER);
    if (context == NULL) {
        return SF_ERR_MEMORY;
    }
    memset(&head, 0, sizeof head);
    head.width = width;
    head.height = height;
    head.bit_depth = 8;
    head.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
    int error = spng_set_png_stream(context, sfi_png_hand_on, &out);
    error = error == 0 ? spng_set_ihdr(context, &head) : error;
    if (error == 0) {
        error = spng_encode_image(context, NULL, 0, SPNG_FMT_PNG,
                                  SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE);
    }
    for (uint32_t y = height; error == 0 && y-- > 0;) {
        error = spng_encode_row(context, pixels + y * row_bytes, width);
    }
    spng_ctx_free(context);
    return sfi_png_written(&out, error);
}

#else

sf_status sfi_png_look(sf_source source, const char *name, sfi_png_head *head, sf_fault *fault)
{
    (void)source;
    (void)head;
    return sfi_picture_fault(fault, SF_ERR_UNSUPPORTED, name,
                             "this build reads no PNG; build it with libspng");
}

sf_status sfi_png_read_rows(sf_source source, const sf_allocator *allocator, const char *name,
                            uint32_t width, uint32_t height, sfi_png_row hand_on, void *user,
                            sf_fault *fault)
{
    (void)allocator;
    (void)width;
    (void)height;
    (void)hand_on;
    (void)user;
    return sfi_png_look(source, name, NULL, fault);
}

sf_status sfi_png_write_grey(const uint8_t *pixels, size_t row_bytes, uint32_t width,
                             uint32_t height, sf_sink sink)
{
    (void)pixels;
    (void)row_bytes;
    (void)width;
    (void)height;
    (void)sink;
    return SF_ERR_UNSUPPORTED;
}

#endif
