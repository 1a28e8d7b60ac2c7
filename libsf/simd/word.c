// SPDX-License-Identifier: MIT
// The kernels on 64-bit words: what every machine has, in plain C99.

#include "simd/kernels.h"

const uint64_t sfi_empty_row[SFI_ROW_WORDS_MAX];

// Sums of bits in fields of 2, 4, 8 bits, then all bytes by one product (Knuth, TAOCP 4A, 7.1.3).
static uint64_t popcount_of(uint64_t w)
{
    w -= w >> 1 & UINT64_C(0x5555555555555555);
    w = (w & UINT64_C(0x3333333333333333)) + (w >> 2 & UINT64_C(0x3333333333333333));
    w = (w + (w >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f);
    return w * UINT64_C(0x0101010101010101) >> 56;
}

// Four 16-bit numbers in a word, the first one lowest.
static uint64_t load_four(const uint16_t *p)
{
    return p[0] | (uint64_t)p[1] << 16 | (uint64_t)p[2] << 32 | (uint64_t)p[3] << 48;
}

static void store_four(uint16_t *p, uint64_t v)
{
    for (unsigned i = 0; i < 4; i++) {
        p[i] = (uint16_t)(v >> 16 * i);
    }
}

static uint64_t least_of_four(uint64_t a, uint64_t b)
{
    uint64_t least = 0;
    for (unsigned i = 0; i < 64; i += 16) {
        uint64_t p = a >> i & 0xffff, q = b >> i & 0xffff;
        least |= (p < q ? p : q) << i;
    }
    return least;
}

static uint64_t sum_of_four(uint64_t a, uint64_t b)
{
    uint64_t sum = 0;
    for (unsigned i = 0; i < 64; i += 16) {
        uint64_t s = (a >> i & 0xffff) + (b >> i & 0xffff);
        sum |= (s < 0xffff ? s : 0xffff) << i;
    }
    return sum;
}

// Each of the four lowest bits, times 0xffff, in its own lane.
static uint64_t spread_of_four(uint64_t w)
{
    return ((w & 1) | (w & 2) << 15 | (w & 4) << 30 | (w & 8) << 45) * 0xffff;
}

static void put_nibbles(uint64_t *words, size_t x, uint64_t v)
{
    uint64_t four = (v & 15) | (v >> 12 & 0xf0) | (v >> 24 & 0xf00) | (v >> 36 & 0xf000);
    unsigned place = (unsigned)(x % 16) * 4;
    words[x / 16] = (words[x / 16] & ~(UINT64_C(0xffff) << place)) | four << place;
}

static uint64_t bytes_at_least(const uint8_t *p, const uint8_t *q)
{
    uint64_t word = 0;
    for (unsigned i = 0; i < 64; i++) {
        word |= (uint64_t)(p[i] >= q[i]) << i;
    }
    return word;
}

static uint64_t numbers_at_least(const int32_t *p, const int32_t *q)
{
    uint64_t word = 0;
    for (unsigned i = 0; i < 64; i++) {
        word |= (uint64_t)(p[i] >= q[i]) << i;
    }
    return word;
}

#define SF_FN(name) name##_of_words
#define SF_NAME "word"
#define SF_TARGET
#define SF_VEC uint64_t
#define SF_LANES 1
#define SF_LOAD(p) (*(p))
#define SF_STORE(p, v) (*(p) = (v))
#define SF_AND(a, b) ((a) & (b))
#define SF_OR(a, b) ((a) | (b))
#define SF_XOR(a, b) ((a) ^ (b))
#define SF_ANDNOT(a, b) ((a) & ~(b))
#define SF_SHL(v, s) ((v) << (s))
#define SF_SHR(v, s) ((v) >> (s))
#define SF_OR3(a, b, c) SF_OR(a, SF_OR(b, c))
#define SF_SHLD(v, from, s) SF_OR(SF_SHL(v, s), SF_SHR(from, 64 - (s)))
#define SF_SHRD(v, from, s) SF_OR(SF_SHR(v, s), SF_SHL(from, 64 - (s)))
#define SF_EACH(w) ((uint64_t)(w))
#define SF_LAST(w) ((uint64_t)(w))
#define SF_PREV(p, c) (p)
#define SF_NEXT(c, n) (n)
#define SF_LOAD16(p) load_four(p)
#define SF_STORE16(p, v) store_four(p, v)
#define SF_MIN16(a, b) least_of_four(a, b)
#define SF_ADD16(a, b) sum_of_four(a, b)
#define SF_EACH16(n) ((uint64_t)(n)*UINT64_C(0x0001000100010001))
#define SF_SPREAD16(w) spread_of_four(w)
#define SF_NIBBLES(p, x, v) put_nibbles(p, x, v)
#define SF_AT_LEAST8(p, q) bytes_at_least(p, q)
#define SF_AT_LEAST32(p, q) numbers_at_least(p, q)
#define SF_POPCOUNT(w) popcount_of(w)
#define SF_NARROWER sfi_kernels_word() // never asked: a word is a vector here
#include "simd/template.h"

const sfi_kernels *sfi_kernels_word(void)
{
    return &table_of_words;
}
