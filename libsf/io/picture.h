// SPDX-License-Identifier: MIT
// Pictures of one slice: the top row is the largest y, white is solid, or all but entry 0.
//
// Two formats behind one pair of functions: PNG of one bit a pixel where libspng is there, PBM (P4)
// everywhere. Rows are packed eight pixels a byte, the leftmost in the highest bit, in both.

#ifndef SF_IO_PICTURE_H
#define SF_IO_PICTURE_H

#include <sf/io.h>

#define SFI_PICTURE_ROW_BYTES ((SF_EXTENT_MAX + 7) / 8)

typedef enum sfi_picture_kind {
    SFI_PICTURE_PBM = 0,
    SFI_PICTURE_PNG = 1,
    SFI_PICTURE_IDS = 2 // a PNG with a palette, whose entry 0 is empty
} sfi_picture_kind;

sf_status sfi_picture_write(sfi_picture_kind kind, sf_slice slice, sf_sink sink);

// Read a picture into a slice of its size; `check_only` reads its head and leaves the slice alone
// (its words may be NULL). `name` is for the fault's sentence.
sf_status sfi_picture_read(sfi_picture_kind kind, sf_source source, const sf_allocator *allocator,
                           const char *name, sf_slice slice, int check_only, sf_fault *fault);

// Row y of a slice as packed pixels, and back; `invert` where white is 0. Bits past the width are
// 0.
void sfi_picture_pack(sf_slice slice, uint32_t y, int invert, unsigned char *packed);
void sfi_picture_unpack(sf_slice slice, uint32_t y, int invert, const unsigned char *packed);

// A fault that begins with the picture's name.
sf_status sfi_picture_fault(sf_fault *fault, sf_status status, const char *name,
                            const char *sentence);

// Colours of the ids in a picture; the first is empty space.
typedef struct sfi_palette {
    uint32_t count; // at most 256
    uint8_t colours[256][3];
} sfi_palette;

// PNG; SF_ERR_UNSUPPORTED in a build without libspng.
sf_status sfi_png_write_ids(const uint8_t *ids, size_t stride, uint32_t width, uint32_t height,
                            const sfi_palette *palette, sf_sink sink);
sf_status sfi_png_write(sf_slice slice, sf_sink sink);

// 16 bits of grey a pixel; row 0 of the values is the lowest.
sf_status sfi_png_write_grey16(const uint16_t *values, uint32_t width, uint32_t height,
                               sf_sink sink);
sf_status sfi_png_read(sf_source source, const sf_allocator *allocator, const char *name,
                       sf_slice slice, int check_only, sf_fault *fault);
sf_status sfi_png_read_ids(sf_source source, const sf_allocator *allocator, const char *name,
                           sf_slice slice, int check_only, sf_fault *fault);

#endif
