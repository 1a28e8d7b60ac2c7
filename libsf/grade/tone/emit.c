// SPDX-License-Identifier: MIT
// Keep-outs, bit slices, bytes and counts, a stretch of a row at a time.
//
// A keep-out replaces a material by another after the halftone, and not in the tones: what the
// mask decided elsewhere stays, and the volume that moved is there to be counted.

#include "grade/tone/emit.h"

#include "simd/kernels.h"

#include <string.h>

static void keep_out(const sf_keep_out *k, uint32_t y, size_t i, size_t count,
                     uint64_t words[][SFI_STRETCH_WORDS])
{
    const uint64_t *where = sfi_slice_row(k->where, y) + i;
    for (size_t w = 0; w < count; w++) {
        uint64_t moved = words[k->material][w] & where[w];
        words[k->material][w] ^= moved;
        words[k->instead][w] |= moved;
    }
}

// Voxels x to x + count of a row; x is a multiple of 64.
static void emit_bytes(uint8_t *ids, uint32_t material_count, uint32_t count,
                       uint64_t words[][SFI_STRETCH_WORDS])
{
    memset(ids, 0, count);
    for (uint32_t j = 0; j < material_count; j++) {
        for (uint32_t x = 0; x < count; x += 64) {
            uint64_t word = words[j][x / 64];
            uint32_t end = count - x < 64 ? count - x : 64;
            for (uint32_t b = 0; word != 0 && b < end; b++) {
                ids[x + b] = (uint8_t)(ids[x + b] | (uint8_t)((word >> b & 1) * (j + 1)));
            }
        }
    }
}

void sfi_emit(const sf_tones *tones, const sf_materials *materials, uint32_t material_count,
              uint32_t y, size_t i, size_t count, uint64_t words[][SFI_STRETCH_WORDS],
              uint64_t *counts)
{
    const sfi_kernels *kernels = sfi_kernels_get();
    for (size_t k = 0; k < tones->keep_out_count; k++) {
        keep_out(&tones->keep_outs[k], y, i, count, words);
    }
    for (uint32_t j = 0; j < material_count; j++) {
        if (materials->slices != NULL && materials->slices[j].words != NULL) {
            memcpy(sfi_slice_row(materials->slices[j], y) + i, words[j], 8 * count);
        }
        counts[j] += kernels->popcount(words[j], count);
    }
    if (materials->ids != NULL) {
        uint32_t x = (uint32_t)(64 * i), left = tones->width - x;
        emit_bytes(materials->ids + (size_t)y * materials->ids_stride + x, material_count,
                   left < 64 * count ? left : (uint32_t)(64 * count), words);
    }
}
