// SPDX-License-Identifier: MIT
// The kernels one bit at a time. Slow on purpose: this file is the specification of the others, so
// every line here should be evidently right.

#include "simd/kernels.h"

static int get(const uint64_t *words, size_t x)
{
    return (int)(words[x / 64] >> (x % 64) & 1);
}

static void put(uint64_t *words, size_t x, int value)
{
    uint64_t bit = UINT64_C(1) << (x % 64);
    words[x / 64] = value ? words[x / 64] | bit : words[x / 64] & ~bit;
}

static void row_sums(const uint64_t *words, size_t count, uint64_t sums[3])
{
    for (uint64_t x = 0; x < 64 * (uint64_t)count; x++) {
        uint64_t bit = words[x / 64] >> (x % 64) & 1;
        sums[0] += bit;
        sums[1] += bit * x;
        sums[2] += bit * x * x;
    }
}

static uint64_t popcount(const uint64_t *words, size_t count)
{
    uint64_t sum = 0;
    for (size_t x = 0; x < 64 * count; x++) {
        sum += (uint64_t)get(words, x);
    }
    return sum;
}

static void and_words(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count)
{
    for (size_t x = 0; x < 64 * count; x++) {
        put(dst, x, get(a, x) && get(b, x));
    }
}

static void or_words(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count)
{
    for (size_t x = 0; x < 64 * count; x++) {
        put(dst, x, get(a, x) || get(b, x));
    }
}

static void xor_words(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count)
{
    for (size_t x = 0; x < 64 * count; x++) {
        put(dst, x, get(a, x) != get(b, x));
    }
}

static void subtract_words(uint64_t *dst, const uint64_t *a, const uint64_t *b, size_t count)
{
    for (size_t x = 0; x < 64 * count; x++) {
        put(dst, x, get(a, x) && !get(b, x));
    }
}

static int any_in_rows(const uint64_t *words, size_t stride, size_t row_count, size_t count,
                       uint64_t first, uint64_t last, const uint64_t *next)
{
    int any = 0;
    (void)next;
    for (size_t y = 0; y < row_count; y++) {
        for (size_t x = 0; x < 64 * count; x++) {
            int counts = (x >= 64 || get(&first, x)) && (x / 64 + 1 < count || get(&last, x % 64));
            any |= counts && get(words + y * stride, x);
        }
    }
    return any;
}

static int any_row(const uint64_t *const *rows, size_t row_count, uint64_t flip, size_t x)
{
    int any = 0;
    for (size_t r = 0; r < row_count; r++) {
        any |= get(rows[r], x) != (flip != 0);
    }
    return any;
}

static void unite(uint64_t *dst, const uint64_t *const *rows, size_t row_count, uint64_t flip,
                  size_t count)
{
    for (size_t x = 0; x < 64 * count; x++) {
        put(dst, x, any_row(rows, row_count, flip, x));
    }
}

static void widen(uint64_t *dst, const uint64_t *src, unsigned s, const uint64_t *const *rows,
                  size_t row_count, uint64_t flip, size_t count)
{
    const uint64_t *from = src - 1; // one word further left, so that no index is negative
    for (size_t x = 0; x < 64 * count; x++) {
        put(dst, x,
            get(from, 64 + x - s) || get(from, 64 + x) || get(from, 64 + x + s) ||
                any_row(rows, row_count, flip, x));
    }
}

static unsigned prefix_xor(uint64_t *words, size_t count)
{
    int parity = 0;
    for (size_t x = 0; x < 64 * count; x++) {
        parity ^= get(words, x);
        put(words, x, parity);
    }
    return (unsigned)parity;
}

// Voxel (x, y) of a slice; empty outside.
static int voxel(sf_slice slice, long x, long y)
{
    if (x < 0 || y < 0 || x >= (long)slice.width || y >= (long)slice.height) {
        return 0;
    }
    return get(slice.words + (size_t)y * slice.stride, (size_t)x);
}

static void trim(sf_slice dst, sf_slice src, sf_slice below, int corners)
{
    for (long y = 0; y < (long)src.height; y++) {
        uint64_t *row = dst.words + (size_t)y * dst.stride;
        for (long x = 0; x < (long)src.width; x++) {
            int held = 0;
            for (long dy = -1; dy <= 1; dy++) {
                for (long dx = -1; dx <= 1; dx++) {
                    held |= (corners || dx == 0 || dy == 0) && voxel(below, x + dx, y + dy);
                }
            }
            put(row, (size_t)x, voxel(src, x, y) && held);
        }
        for (size_t x = src.width; x < 64 * sfi_row_words(src.width); x++) {
            put(row, x, 0);
        }
    }
}

static void trim_box3(sf_slice dst, sf_slice src, sf_slice below)
{
    trim(dst, src, below, 1);
}

static void trim_plus3(sf_slice dst, sf_slice src, sf_slice below)
{
    trim(dst, src, below, 0);
}

// The least key and code over a shape around place x.
static unsigned least_key(const uint16_t *const below[3], sfi_path_shape shape, ptrdiff_t x)
{
    static const unsigned of_x[3] = {SFI_PATH_LESS_X, 0, SFI_PATH_MORE_X};
    static const unsigned of_y[3] = {SFI_PATH_LESS_Y, 0, SFI_PATH_MORE_Y};
    unsigned least = SFI_PATH_NONE;
    for (int dy = -1; dy <= 1; dy++) {
        for (int dx = -1; dx <= 1; dx++) {
            if ((dx != 0) + (dy != 0) <= (int)shape) {
                unsigned key = below[dy + 1][x + dx] + of_x[dx + 1] + of_y[dy + 1];
                least = key < least ? key : least;
            }
        }
    }
    return least;
}

static void path_row(uint16_t *keys, uint64_t *codes, const uint16_t *const below[3],
                     sfi_path_shape shape, const uint64_t *solid, const uint64_t *shut,
                     size_t count)
{
    for (size_t x = 0; x < 64 * count; x++) {
        unsigned least = least_key(below, shape, (ptrdiff_t)x);
        unsigned next = (least / 16 + 1) * 16;
        uint64_t places = UINT64_C(15) << (x % 16 * 4);
        codes[x / 16] = (codes[x / 16] & ~places) | (uint64_t)(least % 16) << (x % 16 * 4);
        next = next < SFI_PATH_NONE && !get(shut, x) ? next : SFI_PATH_NONE;
        keys[x] = (uint16_t)(get(solid, x) ? 0 : next);
    }
}

static void at_least_8(uint64_t *bits, const uint8_t *tones, const uint8_t *levels, size_t turn,
                       size_t count)
{
    for (size_t x = 0; x < 64 * count; x++) {
        uint64_t before = x % 64 == 0 ? 0 : bits[x / 64];
        bits[x / 64] = before | (uint64_t)(tones[x] >= levels[x % (64 * turn)]) << x % 64;
    }
}

static void at_least_32(uint64_t *bits, const int32_t *tones, const int32_t *levels, size_t turn,
                        size_t count)
{
    for (size_t x = 0; x < 64 * count; x++) {
        uint64_t before = x % 64 == 0 ? 0 : bits[x / 64];
        bits[x / 64] = before | (uint64_t)(tones[x] >= levels[x % (64 * turn)]) << x % 64;
    }
}

static const sfi_kernels table = {
    .name = "reference",
    .popcount = popcount,
    .row_sums = row_sums,
    .and_words = and_words,
    .or_words = or_words,
    .xor_words = xor_words,
    .subtract_words = subtract_words,
    .any_in_rows = any_in_rows,
    .unite = unite,
    .widen = widen,
    .prefix_xor = prefix_xor,
    .trim_box3 = trim_box3,
    .trim_plus3 = trim_plus3,
    .path_row = path_row,
    .at_least_8 = at_least_8,
    .at_least_32 = at_least_32,
};

const sfi_kernels *sfi_kernels_reference(void)
{
    return &table;
}
