// SPDX-License-Identifier: MIT
// The kernel table: every operation on rows of bits that is worth a vector unit.
//
// One const table for each instruction set holds the same functions; select.c points at the best
// one that the processor has. simd/reference.c writes each of them one bit at a time and *is* the
// specification; all others equal it on every input (tests/simd). Work is handed over in whole rows
// or slices, never word by word.
//
// Common terms: bits are numbered as in <sf/voxel.h>; `count` is a number of words, at least 1;
// pointers are 8-byte aligned and may be equal where a contract says so, never partly overlapping.

#ifndef SF_SIMD_KERNELS_H
#define SF_SIMD_KERNELS_H

#include <sf/voxel.h>

typedef struct sfi_kernels {
    const char *name;

    // Number of set bits.
    uint64_t (*popcount)(const uint64_t *words, size_t count);

    // Adds to sums the number of set bits of a row, the sum of their places x, and of x * x.
    void (*row_sums)(const uint64_t *words, size_t count, uint64_t sums[3]);

    // dst = a op b; dst may be a or b.
    void (*and_words)(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count);
    void (*or_words)(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count);
    void (*xor_words)(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count);
    void (*subtract_words)(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count);

    // dst = OR of all rows, each XOR flip, which is 0 or all ones. row_count is even; a row may be
    // named twice. dst overlaps no row.
    void (*unite)(uint64_t *dst, const uint64_t *const *rows, size_t row_count, uint64_t flip,
                  size_t count);

    // dst bit x = src bit x - s, x or x + s, for 1 <= s <= 63; or that of a row, as above. Reads
    // src[-1] and src[count]: what lies outside is the caller's to put there. dst must overlap
    // neither src, these two words included, nor a row; row_count may be 0.
    void (*widen)(uint64_t *dst, const uint64_t *src, unsigned s, const uint64_t *const *rows,
                  size_t row_count, uint64_t flip, size_t count);

    // Bit x becomes the exclusive or of bits 0..x; returns the parity of all bits (0 or 1).
    unsigned (*prefix_xor)(uint64_t *words, size_t count);

    // One step of trimming: dst = src AND (below dilated by the 3x3 square, or by the plus).
    // Outside is empty. All three have one size; dst may be src; below overlaps neither. Padding is
    // ignored on entry and zero on return.
    void (*trim_box3)(sf_slice dst, sf_slice src, sf_slice below);
    void (*trim_plus3)(sf_slice dst, sf_slice src, sf_slice below);
} sfi_kernels;

// The table in use: the best that the processor has and sf_isa_limit() allows.
const sfi_kernels *sfi_kernels_get(void);

// The table of one instruction set, or NULL where the processor or the build lacks it.
const sfi_kernels *sfi_kernels_for(sf_isa isa);

// Tables by file; NULL where the processor lacks them.
const sfi_kernels *sfi_kernels_reference(void);
const sfi_kernels *sfi_kernels_word(void);
const sfi_kernels *sfi_kernels_sse2(void);
const sfi_kernels *sfi_kernels_avx2(void);
const sfi_kernels *sfi_kernels_avx512(void);
const sfi_kernels *sfi_kernels_neon(void);

// A row of nothing, as long as the widest slice: stands for the rows above and below a slice.
#define SFI_ROW_WORDS_MAX 1024
extern const uint64_t sfi_empty_row[SFI_ROW_WORDS_MAX];

// Words that `width` voxels take, and the mask of the voxels in the last of them.
static inline size_t sfi_row_words(uint32_t width)
{
    return ((size_t)width + 63) / 64;
}

static inline uint64_t sfi_tail_mask(uint32_t width)
{
    return ~UINT64_C(0) >> ((64 - width % 64) % 64);
}

#endif
