// SPDX-License-Identifier: MIT
// Fingerprints of grids: the bits of all rows, in order, through SHA-256.
//
// The bytes are those of the pictures that a stack of the grid has, so another program can take the
// fingerprint of a stack without putting anything in order first: the topmost row is that of the
// largest y, and the leftmost voxel is the highest bit of a byte.

#include "support/certificate/fingerprint.h"

#include "base/sha256.h"
#include "base/status.h"
#include "voxel/slice.h"

#define CHUNK_WORDS 64

// The eight bits of a byte in the other order.
static uint8_t mirrored(uint64_t byte)
{
    byte = (byte & 0xf0) >> 4 | (byte & 0x0f) << 4;
    byte = (byte & 0xcc) >> 2 | (byte & 0x33) << 2;
    return (uint8_t)((byte & 0xaa) >> 1 | (byte & 0x55) << 1);
}

// Up to CHUNK_WORDS words of a row from word `first` on.
static void add_words(sfi_sha256 *hash, const uint64_t *row, uint32_t width, size_t first)
{
    uint8_t bytes[CHUNK_WORDS * 8];
    size_t words = sfi_row_words(width), size = 0;
    size_t row_bytes = ((size_t)width + 7) / 8 - first * 8;
    for (size_t i = first; i < words && i < first + CHUNK_WORDS; i++) {
        uint64_t word = i + 1 < words ? row[i] : row[i] & sfi_tail_mask(width);
        for (unsigned b = 0; b < 8; b++) {
            bytes[size++] = mirrored(word >> 8 * b & 0xff);
        }
    }
    sfi_sha256_add(hash, bytes, size < row_bytes ? size : row_bytes);
}

static void add_slice(sfi_sha256 *hash, sf_slice slice)
{
    for (uint32_t y = slice.height; y-- > 0;) {
        for (size_t i = 0; i < sfi_row_words(slice.width); i += CHUNK_WORDS) {
            add_words(hash, sfi_slice_row(slice, y), slice.width, i);
        }
    }
}

sf_status sfi_grid_sha256(const sf_grid *grid, sfi_progress *progress, uint64_t done,
                          uint64_t total, uint8_t digest[SF_SHA256_SIZE])
{
    sf_lattice lattice = sf_grid_lattice(grid);
    sfi_sha256 hash;
    sfi_sha256_begin(&hash);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        if (sf_task_is_cancelled(progress->task)) {
            return SF_ERR_CANCELLED;
        }
        add_slice(&hash, sf_grid_slice(grid, k));
        sfi_progress_report(progress, done + k + 1, total);
    }
    sfi_sha256_end(&hash, digest);
    return SF_OK;
}

sf_status sf_grid_sha256(const sf_grid *grid, sf_task *task, uint8_t digest[SF_SHA256_SIZE])
{
    if (grid == NULL || digest == NULL) {
        return SF_ERR_ARGUMENT;
    }
    sfi_progress progress = sfi_progress_begin(task);
    return sfi_grid_sha256(grid, &progress, 0, sf_grid_lattice(grid).nz, digest);
}
