// SPDX-License-Identifier: MIT
// The one body of every kernel, included once for each instruction set.
//
// What the including file defines, and what this file undefines at its end:
//   SF_FN(name)       name of a function in this set: name_avx2 ...
//   SF_TARGET         function attribute that allows the instructions, or nothing
//   SF_VEC, SF_LANES  a vector of SF_LANES 64-bit words
//   SF_LOAD(p) SF_STORE(p, v)            unaligned
//   SF_AND(a, b) SF_OR(a, b) SF_XOR(a, b) SF_ANDNOT(a, b)     the last is a & ~b
//   SF_SHL(v, s) SF_SHR(v, s)            each word by s, 1 <= s <= 63
//   SF_OR3(a, b, c)
//   SF_SHLD(v, from, s) SF_SHRD(v, from, s)    as above, but the bits that come in are those that
//                     leave the same word of `from`, shifted the same way
//   SF_EACH(w)        word w in every lane
//   SF_LAST(w)        word w in the last lane, all ones in the others
//   SF_PREV(p, c)     lane i holds lane i - 1 of c; lane 0 the last lane of p
//   SF_NEXT(c, n)     lane i holds lane i + 1 of c; the last lane holds lane 0 of n
//   SF_POPCOUNT(w)    set bits of one word
//   SF_NARROWER       table for rows that do not fill a vector
//   SF_LOAD16(p) SF_STORE16(p, v)        4 * SF_LANES 16-bit numbers, unaligned
//   SF_MIN16(a, b) SF_ADD16(a, b)        of these; sums end at 0xffff
//   SF_EACH16(n)      number n in every lane of 16 bits
//   SF_SPREAD16(w)    all ones in lane i of 16 bits where bit i of word w is set
//   SF_NIBBLES(p, x, v)   the low four bits of each lane of 16 bits to nibbles x, x + 1, ... of
//                     words p, lowest first; x is a multiple of the lanes
//   SF_AT_LEAST8(p, q)    word whose bit i says whether p[i] >= q[i], of 64 bytes each
//   SF_AT_LEAST32(p, q)   the same of 64 signed 32-bit numbers each
//
// Neighbouring words come from registers by SF_PREV and SF_NEXT rather than by unaligned loads: a
// row of the slice below is loaded once for each of the three rows that it holds up, not nine
// times. Words that do not fill a vector are done one at a time by the same formulas.

#if defined(__GNUC__)
#define SF_INLINE inline __attribute__((always_inline))
// Ask for the memory a few pages ahead of p, into the second cache. A sweep over slices does more
// with each word than a copy does and less than waiting for it takes; without asking, the two times
// add up. Nearer, or into the first cache, hides less. The address may lie outside any object; it
// is never read.
#define SF_AHEAD(p) __builtin_prefetch((const void *)((uintptr_t)(p) + 16384), 0, 2)
// Ask for the memory at p, which is read soon.
#define SF_FETCH(p) __builtin_prefetch(p, 0, 3)
#else
#define SF_INLINE inline
#define SF_AHEAD(p) ((void)(p))
#define SF_FETCH(p) ((void)(p))
#endif

#define SF_WORDWISE(name, vector_op, word_op)                                                      \
    SF_TARGET static void SF_FN(name)(uint64_t * dst, const uint64_t *a, const uint64_t *b,        \
                                      size_t count)                                                \
    {                                                                                              \
        size_t i = 0;                                                                              \
        for (; i + SF_LANES <= count; i += SF_LANES) {                                             \
            SF_STORE(dst + i, vector_op(SF_LOAD(a + i), SF_LOAD(b + i)));                          \
        }                                                                                          \
        for (; i < count; i++) {                                                                   \
            dst[i] = a[i] word_op b[i];                                                            \
        }                                                                                          \
    }

SF_WORDWISE(and_words, SF_AND, &)
SF_WORDWISE(or_words, SF_OR, |)
SF_WORDWISE(xor_words, SF_XOR, ^)
SF_WORDWISE(subtract_words, SF_ANDNOT, &~)

// A place is 64 i + b, and b is six bits: the sum of b over a word is the sum of 2^j times the
// number of set bits whose place has bit j, and the sum of b * b the same over pairs of bits.
SF_TARGET static void SF_FN(row_sums)(const uint64_t *words, size_t count, uint64_t sums[3])
{
    static const uint64_t has_bit[6] = {UINT64_C(0xaaaaaaaaaaaaaaaa), UINT64_C(0xcccccccccccccccc),
                                        UINT64_C(0xf0f0f0f0f0f0f0f0), UINT64_C(0xff00ff00ff00ff00),
                                        UINT64_C(0xffff0000ffff0000), UINT64_C(0xffffffff00000000)};
    for (size_t i = 0; i < count; i++) {
        uint64_t word = words[i], first = 64 * (uint64_t)i, n = 64, b = 2016, bb = 85344;
        if (word == 0) {
            continue;
        }
        if (word != ~UINT64_C(0)) {
            n = SF_POPCOUNT(word);
            b = bb = 0;
            for (unsigned j = 0; j < 6; j++) {
                uint64_t with = word & has_bit[j], single = SF_POPCOUNT(with);
                b += single << j;
                bb += single << 2 * j;
                for (unsigned k = j + 1; k < 6; k++) {
                    bb += SF_POPCOUNT(with & has_bit[k]) << (j + k + 1);
                }
            }
        }
        sums[0] += n;
        sums[1] += first * n + b;
        sums[2] += first * (first * n + 2 * b) + bb;
    }
}

SF_TARGET static uint64_t SF_FN(popcount)(const uint64_t *words, size_t count)
{
    uint64_t sum = 0;
    for (size_t i = 0; i < count; i++) {
        sum += SF_POPCOUNT(words[i]);
    }
    return sum;
}

// In each row a vector at the start, one that ends with the row, and whole ones between.
// Rows are united first, the words of their ends apart from those between, and masked in the end.
SF_TARGET static int SF_FN(any_in_rows)(const uint64_t *words, size_t stride, size_t row_count,
                                        size_t count, uint64_t first, uint64_t last,
                                        const uint64_t *next)
{
    uint64_t lanes[SF_LANES], all = 0;
    if (count < SF_LANES) {
        return SF_NARROWER->any_in_rows(words, stride, row_count, count, first, last, next);
    }
    next = next != NULL ? next : words;
    SF_VEC left = SF_EACH(0), right = left, middle = left;
    for (size_t y = 0; y < row_count; y++) {
        const uint64_t *row = words + y * stride;
        SF_FETCH(next + y * stride);
        left = SF_OR(left, SF_LOAD(row));
        right = SF_OR(right, SF_LOAD(row + count - SF_LANES));
        for (size_t i = SF_LANES; i + SF_LANES < count; i += SF_LANES) {
            middle = SF_OR(middle, SF_LOAD(row + i));
        }
    }
    right = SF_AND(right, SF_LAST(last));
    left = count > SF_LANES ? left : SF_AND(left, right);
    SF_STORE(lanes, left);
    all = lanes[0] & first;
    for (size_t i = 1; i < SF_LANES; i++) {
        all |= lanes[i];
    }
    SF_STORE(lanes, count > SF_LANES ? SF_OR(middle, right) : middle);
    for (size_t i = 0; i < SF_LANES; i++) {
        all |= lanes[i];
    }
    return all != 0;
}

// `here` widened by s to both sides.
#define SF_WIDEN(prev, here, next, s)                                                              \
    SF_OR3(here, SF_SHLD(here, SF_PREV(prev, here), s), SF_SHRD(here, SF_NEXT(here, next), s))

// acc OR a pair of rows, and another pair, and so on; rows may be complemented as they are read.
SF_TARGET static SF_INLINE SF_VEC SF_FN(over)(SF_VEC acc, const uint64_t *const *rows,
                                              size_t row_count, SF_VEC flip, int flips, size_t i)
{
    for (size_t r = 0; r < row_count; r += 2) {
        SF_VEC a = SF_LOAD(rows[r] + i), b = SF_LOAD(rows[r + 1] + i);
        acc = SF_OR3(acc, flips ? SF_XOR(a, flip) : a, flips ? SF_XOR(b, flip) : b);
    }
    return acc;
}

SF_TARGET static SF_INLINE void SF_FN(unite_rows)(uint64_t *dst, const uint64_t *const *rows,
                                                  size_t row_count, uint64_t flip, int flips,
                                                  size_t count)
{
    SF_VEC none = SF_EACH(0), flipped = SF_EACH(flip);
    for (size_t i = 0; i + SF_LANES <= count; i += SF_LANES) {
        SF_STORE(dst + i, SF_FN(over)(none, rows, row_count, flipped, flips, i));
    }
    if (count % SF_LANES != 0) {
        const size_t last = count - SF_LANES;
        SF_STORE(dst + last, SF_FN(over)(none, rows, row_count, flipped, flips, last));
    }
}

SF_TARGET static void SF_FN(unite)(uint64_t *dst, const uint64_t *const *rows, size_t row_count,
                                   uint64_t flip, size_t count)
{
    if (count < SF_LANES) {
        SF_NARROWER->unite(dst, rows, row_count, flip, count);
    } else if (flip == 0) {
        SF_FN(unite_rows)(dst, rows, row_count, flip, 0, count);
    } else {
        SF_FN(unite_rows)(dst, rows, row_count, flip, 1, count);
    }
}

SF_TARGET static SF_INLINE void SF_FN(widen_rows)(uint64_t *dst, const uint64_t *src, unsigned s,
                                                  const uint64_t *const *rows, size_t row_count,
                                                  uint64_t flip, int flips, size_t count)
{
    const size_t last = count - SF_LANES;
    SF_VEC flipped = SF_EACH(flip), prev = SF_EACH(src[-1]), here = SF_LOAD(src);
    for (size_t i = 0; i < last; i += SF_LANES) {
        const size_t j = i + SF_LANES;
        SF_VEC next = j <= last ? SF_LOAD(src + j) : SF_EACH(src[j]);
        SF_VEC wide = SF_WIDEN(prev, here, next, s);
        SF_STORE(dst + i, SF_FN(over)(wide, rows, row_count, flipped, flips, i));
        prev = here;
        here = next;
    }
    if (count % SF_LANES != 0) {
        prev = SF_EACH(src[last - 1]);
        here = SF_LOAD(src + last);
    }
    SF_VEC wide = SF_WIDEN(prev, here, SF_EACH(src[count]), s);
    SF_STORE(dst + last, SF_FN(over)(wide, rows, row_count, flipped, flips, last));
}

SF_TARGET static void SF_FN(widen)(uint64_t *dst, const uint64_t *src, unsigned s,
                                   const uint64_t *const *rows, size_t row_count, uint64_t flip,
                                   size_t count)
{
    if (count < SF_LANES) {
        SF_NARROWER->widen(dst, src, s, rows, row_count, flip, count);
    } else if (flip == 0) {
        SF_FN(widen_rows)(dst, src, s, rows, row_count, flip, 0, count);
    } else {
        SF_FN(widen_rows)(dst, src, s, rows, row_count, flip, 1, count);
    }
}

// The sign of a finished word, spread over all its bits, is what the next word starts from.
SF_TARGET static unsigned SF_FN(prefix_xor)(uint64_t *words, size_t count)
{
    uint64_t carry = 0;
    for (size_t i = 0; i < count; i++) {
        uint64_t w = words[i];
        w ^= w << 1;
        w ^= w << 2;
        w ^= w << 4;
        w ^= w << 8;
        w ^= w << 16;
        w ^= w << 32;
        w ^= carry;
        words[i] = w;
        carry = 0 - (w >> 63);
    }
    return (unsigned)(carry & 1);
}

// One row of a dilation is OR of: the rows in `wide`, widened by one; and the rows in `tall` as
// they are. For the square all three rows are wide; for the plus only the middle one is.
//
// A row is a chain of vectors, each of which needs the one before and the one after; where words
// are left over, a last vector ends with the last word and does some words again, which is harmless
// in place because what holds matter up is not what is written. Padding reaches the result by way
// of the last word only, so the last vector is masked, below and above.
#define SF_WIDE_AT(wide_of, i) wide_of(SF_LOAD(up + (i)), SF_LOAD(mid + (i)), SF_LOAD(down + (i)))

#define SF_TRIM_ROW(name, wide_word, wide_of, tall_of)                                             \
    SF_TARGET static SF_INLINE void SF_FN(name##_row)(                                             \
        uint64_t * dst, const uint64_t *src, const uint64_t *up, const uint64_t *mid,              \
        const uint64_t *down, size_t count, uint64_t tail)                                         \
    {                                                                                              \
        const size_t last = count - SF_LANES;                                                      \
        const int padded = tail != ~UINT64_C(0);                                                   \
        SF_VEC none = SF_EACH(0), edge = SF_LAST(tail), prev = none,                               \
               here = SF_WIDE_AT(wide_of, 0);                                                      \
        for (size_t i = 0; i < last; i += SF_LANES) {                                              \
            const size_t j = i + SF_LANES;                                                         \
            SF_VEC next = j <= last ? SF_WIDE_AT(wide_of, j) : SF_EACH(wide_word(j));              \
            SF_VEC held =                                                                          \
                tall_of(SF_WIDEN(prev, here, next, 1), SF_LOAD(up + i), SF_LOAD(down + i));        \
            SF_AHEAD(src + i);                                                                     \
            SF_STORE(dst + i, SF_AND(SF_LOAD(src + i), held));                                     \
            prev = here;                                                                           \
            here = next;                                                                           \
        }                                                                                          \
        if (count % SF_LANES != 0) {                                                               \
            prev = SF_EACH(wide_word(last - 1));                                                   \
            here = SF_WIDE_AT(wide_of, last);                                                      \
        }                                                                                          \
        here = padded ? SF_AND(here, edge) : here;                                                 \
        SF_VEC held =                                                                              \
            tall_of(SF_WIDEN(prev, here, none, 1), SF_LOAD(up + last), SF_LOAD(down + last));      \
        held = padded ? SF_AND(held, edge) : held;                                                 \
        SF_AHEAD(src + last);                                                                      \
        SF_STORE(dst + last, SF_AND(SF_LOAD(src + last), held));                                   \
    }                                                                                              \
                                                                                                   \
    SF_TARGET static SF_INLINE void SF_FN(name##_rows)(sf_slice dst, sf_slice src, sf_slice below, \
                                                       size_t count, uint64_t tail)                \
    {                                                                                              \
        const uint64_t *up = sfi_empty_row, *mid = below.words;                                    \
        for (uint32_t y = 0; y < src.height; y++) {                                                \
            const uint64_t *down = y + 1 < src.height ? mid + below.stride : sfi_empty_row;        \
            SF_FN(name##_row)                                                                      \
            (dst.words + y * dst.stride, src.words + y * src.stride, up, mid, down, count, tail);  \
            up = mid;                                                                              \
            mid = down;                                                                            \
        }                                                                                          \
    }                                                                                              \
                                                                                                   \
    /* Rows of one vector: what lies below is loaded once and kept for three rows. */              \
    SF_TARGET static SF_INLINE void SF_FN(name##_slim)(sf_slice dst, sf_slice src, sf_slice below) \
    {                                                                                              \
        SF_VEC none = SF_EACH(0), edge = SF_LAST(sfi_tail_mask(src.width));                        \
        SF_VEC up = none, mid = SF_LOAD(below.words);                                              \
        for (uint32_t y = 0; y < src.height; y++) {                                                \
            const uint64_t *from = src.words + y * src.stride, *under = below.words;               \
            SF_VEC down = y + 1 < src.height ? SF_LOAD(under + (y + 1) * below.stride) : none;     \
            SF_VEC here = SF_AND(wide_of(up, mid, down), edge);                                    \
            SF_VEC held = tall_of(SF_WIDEN(none, here, none, 1), up, down);                        \
            SF_AHEAD(from);                                                                        \
            SF_STORE(dst.words + y * dst.stride, SF_AND(SF_AND(SF_LOAD(from), held), edge));       \
            up = mid;                                                                              \
            mid = down;                                                                            \
        }                                                                                          \
    }                                                                                              \
                                                                                                   \
    /* Rows of a few vectors without padding are unrolled. */                                      \
    SF_TARGET static void SF_FN(name)(sf_slice dst, sf_slice src, sf_slice below)                  \
    {                                                                                              \
        size_t count = sfi_row_words(src.width);                                                   \
        uint64_t tail = sfi_tail_mask(src.width);                                                  \
        if (count < SF_LANES) {                                                                    \
            SF_NARROWER->name(dst, src, below);                                                    \
        } else if (count == SF_LANES) {                                                            \
            SF_FN(name##_slim)(dst, src, below);                                                   \
        } else if (src.width == 512) {                                                             \
            SF_FN(name##_rows)(dst, src, below, 8, ~UINT64_C(0));                                  \
        } else if (src.width == 1024) {                                                            \
            SF_FN(name##_rows)(dst, src, below, 16, ~UINT64_C(0));                                 \
        } else {                                                                                   \
            SF_FN(name##_rows)(dst, src, below, count, tail);                                      \
        }                                                                                          \
    }

#define SF_ALL_WORD(i) (up[i] | mid[i] | down[i])
#define SF_ALL_OF(u, m, d) SF_OR3(m, u, d)
#define SF_NONE_OF(v, u, d) (v)
#define SF_MID_WORD(i) (mid[i])
#define SF_MID_OF(u, m, d) (m)
#define SF_ENDS_OF(v, u, d) SF_OR3(v, u, d)

SF_TRIM_ROW(trim_box3, SF_ALL_WORD, SF_ALL_OF, SF_NONE_OF)
SF_TRIM_ROW(trim_plus3, SF_MID_WORD, SF_MID_OF, SF_ENDS_OF)

// Keys of the voxels of a shape around 4 * SF_LANES places, the codes added, and the least of them.
SF_TARGET static SF_INLINE SF_VEC SF_FN(least_key)(const uint16_t *const below[3],
                                                   sfi_path_shape shape, size_t x)
{
    const uint16_t *up = below[0] + x, *mid = below[1] + x, *down = below[2] + x;
    SF_VEC less = SF_EACH16(SFI_PATH_LESS_Y), more = SF_EACH16(SFI_PATH_MORE_Y);
    SF_VEC here = SF_LOAD16(mid), left = here, right = here;
    if (shape == SFI_PATH_POINT) {
        return here;
    }
    left = SF_LOAD16(mid - 1);
    right = SF_LOAD16(mid + 1);
    here = SF_MIN16(here, SF_ADD16(SF_LOAD16(up), less));
    here = SF_MIN16(here, SF_ADD16(SF_LOAD16(down), more));
    if (shape == SFI_PATH_BOX) {
        left = SF_MIN16(left, SF_ADD16(SF_LOAD16(up - 1), less));
        left = SF_MIN16(left, SF_ADD16(SF_LOAD16(down - 1), more));
        right = SF_MIN16(right, SF_ADD16(SF_LOAD16(up + 1), less));
        right = SF_MIN16(right, SF_ADD16(SF_LOAD16(down + 1), more));
    }
    here = SF_MIN16(here, SF_ADD16(left, SF_EACH16(SFI_PATH_LESS_X)));
    return SF_MIN16(here, SF_ADD16(right, SF_EACH16(SFI_PATH_MORE_X)));
}

SF_TARGET static SF_INLINE void SF_FN(path_shape)(uint16_t *keys, uint64_t *codes,
                                                  const uint16_t *const below[3],
                                                  sfi_path_shape shape, const uint64_t *solid,
                                                  const uint64_t *shut, size_t count)
{
    SF_VEC code = SF_EACH16(15), one = SF_EACH16(16);
    for (size_t i = 0; i < count; i++) {
        uint64_t full = solid[i], wall = shut[i];
        for (unsigned b = 0; b < 64; b += 4 * SF_LANES) {
            size_t x = 64 * i + b;
            SF_VEC least = SF_FN(least_key)(below, shape, x);
            SF_VEC next = SF_ADD16(SF_ANDNOT(least, code), one);
            next = SF_OR(next, SF_SPREAD16(wall >> b));
            next = SF_ANDNOT(next, SF_SPREAD16(full >> b));
            SF_STORE16(keys + x, next);
            SF_NIBBLES(codes, x, SF_AND(least, code));
        }
    }
}

SF_TARGET static void SF_FN(path_row)(uint16_t *keys, uint64_t *codes,
                                      const uint16_t *const below[3], sfi_path_shape shape,
                                      const uint64_t *solid, const uint64_t *shut, size_t count)
{
    if (shape == SFI_PATH_BOX) {
        SF_FN(path_shape)(keys, codes, below, SFI_PATH_BOX, solid, shut, count);
    } else if (shape == SFI_PATH_PLUS) {
        SF_FN(path_shape)(keys, codes, below, SFI_PATH_PLUS, solid, shut, count);
    } else {
        SF_FN(path_shape)(keys, codes, below, SFI_PATH_POINT, solid, shut, count);
    }
}

// Levels come again after 64 * turn voxels, so they stay in the nearest cache, and for the shortest
// period in registers: what is read once is the tones.
#define SF_COMPARE(name, type, word_of)                                                            \
    SF_TARGET static void SF_FN(name)(uint64_t * bits, const type *tones, const type *levels,      \
                                      size_t turn, size_t count)                                   \
    {                                                                                              \
        size_t at = 0;                                                                             \
        for (size_t i = 0; i < count; i++) {                                                       \
            SF_AHEAD(tones + 64 * i);                                                              \
            bits[i] = word_of(tones + 64 * i, levels + 64 * at);                                   \
            at = at + 1 < turn ? at + 1 : 0;                                                       \
        }                                                                                          \
    }

SF_COMPARE(at_least_8, uint8_t, SF_AT_LEAST8)
SF_COMPARE(at_least_32, int32_t, SF_AT_LEAST32)

static const sfi_kernels SF_FN(table) = {
    .name = SF_NAME,
    .popcount = SF_FN(popcount),
    .row_sums = SF_FN(row_sums),
    .and_words = SF_FN(and_words),
    .or_words = SF_FN(or_words),
    .xor_words = SF_FN(xor_words),
    .subtract_words = SF_FN(subtract_words),
    .any_in_rows = SF_FN(any_in_rows),
    .unite = SF_FN(unite),
    .widen = SF_FN(widen),
    .prefix_xor = SF_FN(prefix_xor),
    .trim_box3 = SF_FN(trim_box3),
    .trim_plus3 = SF_FN(trim_plus3),
    .path_row = SF_FN(path_row),
    .at_least_8 = SF_FN(at_least_8),
    .at_least_32 = SF_FN(at_least_32),
};

#undef SF_INLINE
#undef SF_AHEAD
#undef SF_FETCH
#undef SF_WORDWISE
#undef SF_WIDEN
#undef SF_TRIM_ROW
#undef SF_WIDE_AT
#undef SF_ALL_WORD
#undef SF_ALL_OF
#undef SF_NONE_OF
#undef SF_MID_WORD
#undef SF_MID_OF
#undef SF_ENDS_OF
#undef SF_COMPARE
#undef SF_FN
#undef SF_NAME
#undef SF_TARGET
#undef SF_VEC
#undef SF_LANES
#undef SF_LOAD
#undef SF_STORE
#undef SF_AND
#undef SF_OR
#undef SF_OR3
#undef SF_SHLD
#undef SF_SHRD
#undef SF_LAST
#undef SF_XOR
#undef SF_ANDNOT
#undef SF_SHL
#undef SF_SHR
#undef SF_EACH
#undef SF_NARROWER
#undef SF_LOAD16
#undef SF_STORE16
#undef SF_MIN16
#undef SF_ADD16
#undef SF_EACH16
#undef SF_SPREAD16
#undef SF_NIBBLES
#undef SF_PREV
#undef SF_NEXT
#undef SF_AT_LEAST8
#undef SF_AT_LEAST32
#undef SF_POPCOUNT
