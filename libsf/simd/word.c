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
#define SF_POPCOUNT(w) popcount_of(w)
#define SF_NARROWER sfi_kernels_word() // never asked: a word is a vector here
#include "simd/template.h"

const sfi_kernels *sfi_kernels_word(void)
{
    return &table_of_words;
}
