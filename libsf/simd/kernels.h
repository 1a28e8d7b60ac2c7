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

// A key of the path map is 16 * cost + code: the cost of a voxel, and in which of the nine voxels
// below the path goes on. A code is the sum of one for x and one for y, such that of equal costs
// the closest voxel has the least key, then the one of least y, then of least x. Above the largest
// cost, SFI_PATH_COST_MAX, is the key that means that there is no path; so does its code, 15.
#define SFI_PATH_LESS_Y 4u
#define SFI_PATH_LESS_X 5u
#define SFI_PATH_MORE_X 6u
#define SFI_PATH_MORE_Y 8u
#define SFI_PATH_NONE 0xffffu
#define SFI_PATH_COST_MAX 4095u

typedef enum sfi_path_shape {
    SFI_PATH_POINT = 0,
    SFI_PATH_PLUS = 1,
    SFI_PATH_BOX = 2
} sfi_path_shape;

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

    // Whether any bit is set in a rectangle of row_count >= 1 rows of count words each, of which
    // the first counts where `first` is set and the last where `last` is (a single word: where both
    // are). next: NULL, or another rectangle of as many rows and the same stride, which will be
    // asked about next: for its memory to be on the way by then.
    int (*any_in_rows)(const uint64_t *words, size_t stride, size_t row_count, size_t count,
                       uint64_t first, uint64_t last, const uint64_t *next);

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

    // One row of a path map, 64 * count voxels. below: the keys, with codes of 0 or SFI_PATH_NONE,
    // of rows y - 1, y and y + 1 of the layer below. Let m be the least, over the voxels of the
    // shape, of key + code, where sums end at SFI_PATH_NONE. Into codes goes the code of m, 16
    // voxels to a word, lowest first. Into keys goes 0 where the voxel is solid, else SFI_PATH_NONE
    // where it is shut or the cost of m is the largest, else the key of code 0 whose cost is one
    // more than m's. keys overlaps no row below; below[i][-1] and below[i][64 * count] are read.
    void (*path_row)(uint16_t *keys, uint64_t *codes, const uint16_t *const below[3],
                     sfi_path_shape shape, const uint64_t *solid, const uint64_t *shut,
                     size_t count);

    // Bit x of bits = whether tones[x] >= levels[x mod 64 * turn], for 64 * count voxels; turn is
    // at least 1. bits overlaps neither array, which need the alignment of their elements alone.
    void (*at_least_8)(uint64_t *bits, const uint8_t *tones, const uint8_t *levels, size_t turn,
                       size_t count);
    void (*at_least_32)(uint64_t *bits, const int32_t *tones, const int32_t *levels, size_t turn,
                        size_t count);
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
