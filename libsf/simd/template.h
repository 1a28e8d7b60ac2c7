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
//   SF_FIRST(w)       word w in lane 0, the other lanes zero
//   SF_PREV(p, c)     lane i holds lane i - 1 of c; lane 0 the last lane of p
//   SF_NEXT(c, n)     lane i holds lane i + 1 of c; the last lane holds lane 0 of n
//   SF_POPCOUNT(w)    set bits of one word
//
// Neighbouring words come from registers by SF_PREV and SF_NEXT rather than by unaligned loads: a
// row of the slice below is loaded once for each of the three rows that it holds up, not nine
// times. Words that do not fill a vector are done one at a time by the same formulas.

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

SF_TARGET static void SF_FN(widen)(uint64_t *dst, const uint64_t *src, unsigned s, size_t count)
{
    size_t i = 0;
    for (; i + SF_LANES <= count; i += SF_LANES) {
        SF_VEC mid = SF_LOAD(src + i);
        SF_VEC up = SF_OR(SF_SHL(mid, s), SF_SHR(SF_LOAD(src + i - 1), 64 - s));
        SF_VEC down = SF_OR(SF_SHR(mid, s), SF_SHL(SF_LOAD(src + i + 1), 64 - s));
        SF_STORE(dst + i, SF_OR(mid, SF_OR(up, down)));
    }
    for (; i < count; i++) {
        const uint64_t *p = src + i;
        dst[i] = p[0] | p[0] << s | p[-1] >> (64 - s) | p[0] >> s | p[1] << (64 - s);
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
#define SF_WIDEN1(prev, here, next)                                                                \
    SF_OR(SF_OR(here, SF_OR(SF_SHL(here, 1), SF_SHR(here, 1))),                                    \
          SF_OR(SF_SHR(SF_PREV(prev, here), 63), SF_SHL(SF_NEXT(here, next), 63)))

#define SF_TRIM_ROW(name, wide_word, wide_vec, tall_word, tall_vec)                                \
    static inline uint64_t SF_FN(name##_word)(const uint64_t *up, const uint64_t *mid,             \
                                              const uint64_t *down, size_t i, size_t count,        \
                                              uint64_t tail)                                       \
    {                                                                                              \
        uint64_t here = wide_word(i) & (i + 1 == count ? tail : ~UINT64_C(0));                     \
        uint64_t prev = i > 0 ? wide_word(i - 1) : 0;                                              \
        uint64_t next = 0;                                                                         \
        if (i + 1 < count) {                                                                       \
            next = wide_word(i + 1) & (i + 2 == count ? tail : ~UINT64_C(0));                      \
        }                                                                                          \
        return tall_word(i) | here | here << 1 | here >> 1 | prev >> 63 | next << 63;              \
    }                                                                                              \
                                                                                                   \
    SF_TARGET static inline void SF_FN(name##_row)(                                                \
        uint64_t * dst, const uint64_t *src, const uint64_t *up, const uint64_t *mid,              \
        const uint64_t *down, size_t count, uint64_t tail)                                         \
    {                                                                                              \
        /* Padding of the rows below reaches the last word only; that one is done apart. */        \
        uint64_t last =                                                                            \
            src[count - 1] & tail & SF_FN(name##_word)(up, mid, down, count - 1, count, tail);     \
        size_t i = 0;                                                                              \
        if (count >= SF_LANES) {                                                                   \
            SF_VEC prev = SF_FIRST(0);                                                             \
            SF_VEC here = wide_vec(0);                                                             \
            for (; i + SF_LANES <= count; i += SF_LANES) {                                         \
                size_t j = i + SF_LANES;                                                           \
                SF_VEC next;                                                                       \
                if (j + SF_LANES <= count) {                                                       \
                    next = wide_vec(j);                                                            \
                } else {                                                                           \
                    next = SF_FIRST(j < count ? wide_word(j) : 0);                                 \
                }                                                                                  \
                SF_VEC held = tall_vec(i, SF_WIDEN1(prev, here, next));                            \
                SF_STORE(dst + i, SF_AND(SF_LOAD(src + i), held));                                 \
                prev = here;                                                                       \
                here = next;                                                                       \
            }                                                                                      \
        }                                                                                          \
        for (; i + 1 < count; i++) {                                                               \
            dst[i] = src[i] & SF_FN(name##_word)(up, mid, down, i, count, tail);                   \
        }                                                                                          \
        dst[count - 1] = last;                                                                     \
    }                                                                                              \
                                                                                                   \
    SF_TARGET static void SF_FN(name)(sf_slice dst, sf_slice src, sf_slice below)                  \
    {                                                                                              \
        size_t count = sfi_row_words(src.width);                                                   \
        uint64_t tail = sfi_tail_mask(src.width);                                                  \
        const uint64_t *up = sfi_empty_row, *mid = below.words;                                    \
        for (uint32_t y = 0; y < src.height; y++) {                                                \
            const uint64_t *down = y + 1 < src.height ? mid + below.stride : sfi_empty_row;        \
            SF_FN(name##_row)                                                                      \
            (dst.words + y * dst.stride, src.words + y * src.stride, up, mid, down, count, tail);  \
            up = mid;                                                                              \
            mid = down;                                                                            \
        }                                                                                          \
    }

#define SF_ALL_WORD(i) (up[i] | mid[i] | down[i])
#define SF_ALL_VEC(i) SF_OR(SF_LOAD(mid + (i)), SF_OR(SF_LOAD(up + (i)), SF_LOAD(down + (i))))
#define SF_NO_WORD(i) UINT64_C(0)
#define SF_NO_VEC(i, v) (v)
#define SF_MID_WORD(i) (mid[i])
#define SF_MID_VEC(i) SF_LOAD(mid + (i))
#define SF_ENDS_WORD(i) (up[i] | down[i])
#define SF_ENDS_VEC(i, v) SF_OR(v, SF_OR(SF_LOAD(up + (i)), SF_LOAD(down + (i))))

SF_TRIM_ROW(trim_box3, SF_ALL_WORD, SF_ALL_VEC, SF_NO_WORD, SF_NO_VEC)
SF_TRIM_ROW(trim_plus3, SF_MID_WORD, SF_MID_VEC, SF_ENDS_WORD, SF_ENDS_VEC)

static const sfi_kernels SF_FN(table) = {
    .name = SF_NAME,
    .popcount = SF_FN(popcount),
    .row_sums = SF_FN(row_sums),
    .and_words = SF_FN(and_words),
    .or_words = SF_FN(or_words),
    .xor_words = SF_FN(xor_words),
    .subtract_words = SF_FN(subtract_words),
    .widen = SF_FN(widen),
    .prefix_xor = SF_FN(prefix_xor),
    .trim_box3 = SF_FN(trim_box3),
    .trim_plus3 = SF_FN(trim_plus3),
};

#undef SF_WORDWISE
#undef SF_WIDEN1
#undef SF_TRIM_ROW
#undef SF_ALL_WORD
#undef SF_ALL_VEC
#undef SF_NO_WORD
#undef SF_NO_VEC
#undef SF_MID_WORD
#undef SF_MID_VEC
#undef SF_ENDS_WORD
#undef SF_ENDS_VEC
#undef SF_FN
#undef SF_NAME
#undef SF_TARGET
#undef SF_VEC
#undef SF_LANES
#undef SF_LOAD
#undef SF_STORE
#undef SF_AND
#undef SF_OR
#undef SF_XOR
#undef SF_ANDNOT
#undef SF_SHL
#undef SF_SHR
#undef SF_FIRST
#undef SF_PREV
#undef SF_NEXT
#undef SF_POPCOUNT
