// SPDX-License-Identifier: MIT
// PNG pictures as rows of greys; SF_ERR_UNSUPPORTED in a build without libspng.

#ifndef SF_IO_PNG_GREY_H
#define SF_IO_PNG_GREY_H

#include <sf/io.h>

typedef struct sfi_png_head {
    uint32_t width, height;
    int has_greys; // more than black and white, as far as the head says
} sfi_png_head;

// Read the head of a picture.
sf_status sfi_png_look(sf_source source, const char *name, sfi_png_head *head, sf_fault *fault);

// Takes row y of a picture, y upward, a byte each pixel; they come from the top.
typedef void (*sfi_png_row)(void *user, uint32_t y, const uint8_t *greys);

// Read a picture of a known size. On failure some rows may have been handed on.
sf_status sfi_png_read_rows(sf_source source, const sf_allocator *allocator, const char *name,
                            uint32_t width, uint32_t height, sfi_png_row hand_on, void *user,
                            sf_fault *fault);

// Write a picture of 8 bits of grey; row 0 is the lowest.
sf_status sfi_png_write_grey(const uint8_t *pixels, size_t row_bytes, uint32_t width,
                             uint32_t height, sf_sink sink);

#endif
