// SPDX-License-Identifier: MIT
// Tones as they come in, checked and read.

#ifndef SF_GRADE_TONE_TONES_H
#define SF_GRADE_TONE_TONES_H

#include <sf/halftone.h>

#include "voxel/slice.h"

// Rows are worked on in stretches of this many voxels: a multiple of each mask's period.
enum { SFI_STRETCH = 1024, SFI_STRETCH_WORDS = SFI_STRETCH / 64 };
// Pieces that a slice falls into, whatever the number of threads.
enum { SFI_BANDS = 16 };

// Whether sizes, strides, slices and materials are what they must be; not the tones themselves.
sf_status sfi_tones_validate(const sf_tones *tones, const sf_materials *materials,
                             uint32_t material_count);

// Rows of a band: those from the first up to the second, of `height`.
static inline uint32_t sfi_band_row(uint32_t height, size_t band)
{
    return (uint32_t)((uint64_t)height * band / SFI_BANDS);
}

// Word i of what is solid in row y, nothing past the width.
static inline uint64_t sfi_tones_solid(const sf_tones *t, uint32_t y, size_t i)
{
    uint64_t inside = i + 1 < sfi_row_words(t->width) ? ~UINT64_C(0) : sfi_tail_mask(t->width);
    return t->solid.words != NULL ? sfi_slice_row(t->solid, y)[i] & inside : inside;
}

// A tone as a fraction: of material j at (x, y).
static inline double sfi_tone_at(const sf_tones *t, uint32_t j, uint32_t x, uint32_t y)
{
    const sf_tone_plane *plane = &t->planes[j];
    size_t at = (size_t)y * plane->stride + x;
    return t->type == SF_TONE_U8    ? ((const uint8_t *)plane->values)[at] / 255.0
           : t->type == SF_TONE_F32 ? (double)((const float *)plane->values)[at]
                                    : ((const double *)plane->values)[at];
}

// Add the tones of material j, voxels x to x + count of row y, to sums. Bytes are added as they
// are, to at most 255.
void sfi_tones_add(const sf_tones *t, uint32_t j, uint32_t x, uint32_t y, uint32_t count,
                   double *sums);
void sfi_tones_add_bytes(const sf_tones *t, uint32_t j, uint32_t x, uint32_t y, uint32_t count,
                         uint8_t *sums);

// Whether the tones of all solid voxels in some rows are at least 0 and add up to at most all.
int sfi_tones_good(const sf_tones *t, uint32_t material_count, uint32_t y0, uint32_t y1);

#endif
