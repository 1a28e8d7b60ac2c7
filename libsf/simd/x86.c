// SPDX-License-Identifier: MIT
// The kernels for x86: SSE2, AVX2 and AVX-512, chosen while the program runs.
//
// Each function carries its own target attribute, so that no file needs compiler flags of its own
// and nothing built for newer processors can leak into code that runs everywhere. Without a C
// library to ask what the processor has (a freestanding build) there are no such kernels.

#include "simd/kernels.h"

#if __STDC_HOSTED__ && (defined(__x86_64__) || defined(__i386__))

#include <immintrin.h>
#include <string.h>

static uint64_t popcount_of(uint64_t w)
{
    w -= w >> 1 & UINT64_C(0x5555555555555555);
    w = (w & UINT64_C(0x3333333333333333)) + (w >> 2 & UINT64_C(0x3333333333333333));
    w = (w + (w >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f);
    return w * UINT64_C(0x0101010101010101) >> 56;
}

// Each set bit of w, of 8 or 16, as a lane of ones.
__attribute__((target("sse2"))) static inline __m128i spread_8(uint64_t w)
{
    __m128i bits = _mm_set_epi16(128, 64, 32, 16, 8, 4, 2, 1);
    return _mm_cmpeq_epi16(_mm_and_si128(_mm_set1_epi16((short)(w & 0xff)), bits), bits);
}

__attribute__((target("avx2"))) static inline __m256i spread_16(uint64_t w)
{
    __m256i bits = _mm256_set_epi16(-32768, 16384, 8192, 4096, 2048, 1024, 512, 256, 128, 64, 32,
                                    16, 8, 4, 2, 1);
    return _mm256_cmpeq_epi16(_mm256_and_si256(_mm256_set1_epi16((short)w), bits), bits);
}

// Lanes of four bits each, two to a byte: in each 32 bits the upper lane goes next to the lower.
__attribute__((target("sse2"))) static inline void nibbles_8(void *to, __m128i v)
{
    v = _mm_and_si128(_mm_or_si128(v, _mm_srli_epi32(v, 12)), _mm_set1_epi32(0xff));
    v = _mm_packs_epi32(v, v);
    int four = _mm_cvtsi128_si32(_mm_packus_epi16(v, v));
    memcpy(to, &four, sizeof four);
}

__attribute__((target("avx2"))) static inline void nibbles_16(void *to, __m256i v)
{
    v = _mm256_and_si256(_mm256_or_si256(v, _mm256_srli_epi32(v, 12)), _mm256_set1_epi32(0xff));
    v = _mm256_packs_epi32(v, v);
    v = _mm256_packus_epi16(v, v);
    int four[2] = {_mm256_extract_epi32(v, 0), _mm256_extract_epi32(v, 4)};
    memcpy(to, four, sizeof four);
}

// a >= b is where the greater of both is a, or where b > a does not hold.
__attribute__((target("sse2"))) static inline uint64_t bytes_sse2(const uint8_t *p,
                                                                  const uint8_t *q)
{
    uint64_t word = 0;
    for (unsigned i = 0; i < 64; i += 16) {
        __m128i a = _mm_loadu_si128((const __m128i *)(const void *)(p + i));
        __m128i b = _mm_loadu_si128((const __m128i *)(const void *)(q + i));
        int mask = _mm_movemask_epi8(_mm_cmpeq_epi8(_mm_max_epu8(a, b), a));
        word |= (uint64_t)(uint32_t)mask << i;
    }
    return word;
}

__attribute__((target("sse2"))) static inline uint64_t numbers_sse2(const int32_t *p,
                                                                    const int32_t *q)
{
    uint64_t less = 0;
    for (unsigned i = 0; i < 64; i += 4) {
        __m128i a = _mm_loadu_si128((const __m128i *)(const void *)(p + i));
        __m128i b = _mm_loadu_si128((const __m128i *)(const void *)(q + i));
        int mask = _mm_movemask_ps(_mm_castsi128_ps(_mm_cmpgt_epi32(b, a)));
        less |= (uint64_t)(uint32_t)mask << i;
    }
    return ~less;
}

__attribute__((target("avx2"))) static inline uint64_t bytes_avx2(const uint8_t *p,
                                                                  const uint8_t *q)
{
    uint64_t word = 0;
    for (unsigned i = 0; i < 64; i += 32) {
        __m256i a = _mm256_loadu_si256((const __m256i *)(const void *)(p + i));
        __m256i b = _mm256_loadu_si256((const __m256i *)(const void *)(q + i));
        int mask = _mm256_movemask_epi8(_mm256_cmpeq_epi8(_mm256_max_epu8(a, b), a));
        word |= (uint64_t)(uint32_t)mask << i;
    }
    return word;
}

__attribute__((target("avx2"))) static inline uint64_t numbers_avx2(const int32_t *p,
                                                                    const int32_t *q)
{
    uint64_t less = 0;
    for (unsigned i = 0; i < 64; i += 8) {
        __m256i a = _mm256_loadu_si256((const __m256i *)(const void *)(p + i));
        __m256i b = _mm256_loadu_si256((const __m256i *)(const void *)(q + i));
        int mask = _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpgt_epi32(b, a)));
        less |= (uint64_t)(uint32_t)mask << i;
    }
    return ~less;
}

#define SF_FN(name) name##_sse2
#define SF_NAME "sse2"
#define SF_TARGET __attribute__((target("sse2")))
#define SF_VEC __m128i
#define SF_LANES 2
#define SF_LOAD(p) _mm_loadu_si128((const __m128i *)(const void *)(p))
#define SF_STORE(p, v) _mm_storeu_si128((__m128i *)(void *)(p), v)
#define SF_AND(a, b) _mm_and_si128(a, b)
#define SF_OR(a, b) _mm_or_si128(a, b)
#define SF_XOR(a, b) _mm_xor_si128(a, b)
#define SF_ANDNOT(a, b) _mm_andnot_si128(b, a)
#define SF_SHL(v, s) _mm_slli_epi64(v, (int)(s))
#define SF_SHR(v, s) _mm_srli_epi64(v, (int)(s))
#define SF_OR3(a, b, c) SF_OR(a, SF_OR(b, c))
#define SF_SHLD(v, from, s) SF_OR(SF_SHL(v, s), SF_SHR(from, 64 - (s)))
#define SF_SHRD(v, from, s) SF_OR(SF_SHR(v, s), SF_SHL(from, 64 - (s)))
#define SF_EACH(w) _mm_set1_epi64x((long long)(w))
#define SF_LAST(w) _mm_set_epi64x((long long)(w), -1)
#define SF_PREV(p, c) _mm_castpd_si128(_mm_shuffle_pd(_mm_castsi128_pd(p), _mm_castsi128_pd(c), 1))
#define SF_NEXT(c, n) _mm_castpd_si128(_mm_shuffle_pd(_mm_castsi128_pd(c), _mm_castsi128_pd(n), 1))
#define SF_LOAD16(p) _mm_loadu_si128((const __m128i *)(const void *)(p))
#define SF_STORE16(p, v) _mm_storeu_si128((__m128i *)(void *)(p), v)
#define SF_MIN16(a, b) _mm_sub_epi16(a, _mm_subs_epu16(a, b))
#define SF_ADD16(a, b) _mm_adds_epu16(a, b)
#define SF_EACH16(n) _mm_set1_epi16((short)(n))
#define SF_SPREAD16(w) spread_8(w)
#define SF_NIBBLES(p, x, v) nibbles_8((unsigned char *)(p) + (x) / 2, v)
#define SF_AT_LEAST8(p, q) bytes_sse2(p, q)
#define SF_AT_LEAST32(p, q) numbers_sse2(p, q)
#define SF_POPCOUNT(w) popcount_of(w)
#define SF_NARROWER sfi_kernels_word()
#include "simd/template.h"

#define SF_FN(name) name##_avx2
#define SF_NAME "avx2"
#define SF_TARGET __attribute__((target("avx2,popcnt")))
#define SF_VEC __m256i
#define SF_LANES 4
#define SF_LOAD(p) _mm256_loadu_si256((const __m256i *)(const void *)(p))
#define SF_STORE(p, v) _mm256_storeu_si256((__m256i *)(void *)(p), v)
#define SF_AND(a, b) _mm256_and_si256(a, b)
#define SF_OR(a, b) _mm256_or_si256(a, b)
#define SF_XOR(a, b) _mm256_xor_si256(a, b)
#define SF_ANDNOT(a, b) _mm256_andnot_si256(b, a)
#define SF_SHL(v, s) _mm256_slli_epi64(v, (int)(s))
#define SF_SHR(v, s) _mm256_srli_epi64(v, (int)(s))
#define SF_OR3(a, b, c) SF_OR(a, SF_OR(b, c))
#define SF_SHLD(v, from, s) SF_OR(SF_SHL(v, s), SF_SHR(from, 64 - (s)))
#define SF_SHRD(v, from, s) SF_OR(SF_SHR(v, s), SF_SHL(from, 64 - (s)))
#define SF_EACH(w) _mm256_set1_epi64x((long long)(w))
#define SF_LAST(w) _mm256_set_epi64x((long long)(w), -1, -1, -1)
#define SF_PREV(p, c) _mm256_alignr_epi8(c, _mm256_permute2x128_si256(p, c, 0x21), 8)
#define SF_NEXT(c, n) _mm256_alignr_epi8(_mm256_permute2x128_si256(c, n, 0x21), c, 8)
#define SF_LOAD16(p) _mm256_loadu_si256((const __m256i *)(const void *)(p))
#define SF_STORE16(p, v) _mm256_storeu_si256((__m256i *)(void *)(p), v)
#define SF_MIN16(a, b) _mm256_min_epu16(a, b)
#define SF_ADD16(a, b) _mm256_adds_epu16(a, b)
#define SF_EACH16(n) _mm256_set1_epi16((short)(n))
#define SF_SPREAD16(w) spread_16(w)
#define SF_NIBBLES(p, x, v) nibbles_16((unsigned char *)(p) + (x) / 2, v)
#define SF_AT_LEAST8(p, q) bytes_avx2(p, q)
#define SF_AT_LEAST32(p, q) numbers_avx2(p, q)
#define SF_POPCOUNT(w) ((uint64_t)__builtin_popcountll(w))
#define SF_NARROWER (&table_sse2)
#include "simd/template.h"

// Windows compilers do not keep the stack aligned for 64-byte spills.
#if defined(__x86_64__) && !defined(_WIN32)

__attribute__((target("avx512f,avx512bw"))) static inline uint64_t bytes_avx512(const uint8_t *p,
                                                                                const uint8_t *q)
{
    return _mm512_cmpge_epu8_mask(_mm512_loadu_si512((const void *)p),
                                  _mm512_loadu_si512((const void *)q));
}

__attribute__((target("avx512f,avx512bw"))) static inline uint64_t numbers_avx512(const int32_t *p,
                                                                                  const int32_t *q)
{
    uint64_t word = 0;
    for (unsigned i = 0; i < 64; i += 16) {
        __mmask16 mask = _mm512_cmpge_epi32_mask(_mm512_loadu_si512((const void *)(p + i)),
                                                 _mm512_loadu_si512((const void *)(q + i)));
        word |= (uint64_t)mask << i;
    }
    return word;
}

#define SF_FN(name) name##_avx512
#define SF_NAME "avx512"
#define SF_TARGET __attribute__((target("avx512f,avx512bw,avx512vbmi2,popcnt")))
#define SF_VEC __m512i
#define SF_LANES 8
#define SF_LOAD(p) _mm512_loadu_si512((const void *)(p))
#define SF_STORE(p, v) _mm512_storeu_si512((void *)(p), v)
#define SF_AND(a, b) _mm512_and_si512(a, b)
#define SF_OR(a, b) _mm512_or_si512(a, b)
#define SF_XOR(a, b) _mm512_xor_si512(a, b)
#define SF_ANDNOT(a, b) _mm512_andnot_si512(b, a)
#define SF_SHL(v, s) _mm512_slli_epi64(v, (unsigned)(s))
#define SF_SHR(v, s) _mm512_srli_epi64(v, (unsigned)(s))
#define SF_OR3(a, b, c) _mm512_ternarylogic_epi64(a, b, c, 0xfe)
#define SF_SHLD(v, from, s) _mm512_shldv_epi64(v, from, _mm512_set1_epi64((long long)(s)))
#define SF_SHRD(v, from, s) _mm512_shrdv_epi64(v, from, _mm512_set1_epi64((long long)(s)))
#define SF_EACH(w) _mm512_set1_epi64((long long)(w))
#define SF_LAST(w) _mm512_mask_set1_epi64(_mm512_set1_epi64(-1), 0x80, (long long)(w))
#define SF_PREV(p, c) _mm512_alignr_epi64(c, p, 7)
#define SF_NEXT(c, n) _mm512_alignr_epi64(n, c, 1)
#define SF_LOAD16(p) _mm512_loadu_si512((const void *)(p))
#define SF_STORE16(p, v) _mm512_storeu_si512((void *)(p), v)
#define SF_MIN16(a, b) _mm512_min_epu16(a, b)
#define SF_ADD16(a, b) _mm512_adds_epu16(a, b)
#define SF_EACH16(n) _mm512_set1_epi16((short)(n))
#define SF_SPREAD16(w) _mm512_movm_epi16((__mmask32)(w))
#define SF_NIBBLES(p, x, v)                                                                        \
    _mm_storeu_si128((__m128i *)(void *)((unsigned char *)(p) + (x) / 2),                          \
                     _mm512_cvtepi32_epi8(_mm512_or_si512(v, _mm512_srli_epi32(v, 12))))
#define SF_AT_LEAST8(p, q) bytes_avx512(p, q)
#define SF_AT_LEAST32(p, q) numbers_avx512(p, q)
#define SF_POPCOUNT(w) ((uint64_t)__builtin_popcountll(w))
#define SF_NARROWER (&table_avx2)
#include "simd/template.h"

const sfi_kernels *sfi_kernels_avx512(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                   __builtin_cpu_supports("avx512vbmi2") && __builtin_cpu_supports("popcnt")
               ? &table_avx512
               : NULL;
}

#else

const sfi_kernels *sfi_kernels_avx512(void)
{
    return NULL;
}

#endif

const sfi_kernels *sfi_kernels_sse2(void)
{
    return __builtin_cpu_supports("sse2") ? &table_sse2 : NULL;
}

const sfi_kernels *sfi_kernels_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt") ? &table_avx2 : NULL;
}

#else

const sfi_kernels *sfi_kernels_sse2(void)
{
    return NULL;
}

const sfi_kernels *sfi_kernels_avx2(void)
{
    return NULL;
}

const sfi_kernels *sfi_kernels_avx512(void)
{
    return NULL;
}

#endif
