// SPDX-License-Identifier: MIT
// The kernels for x86: SSE2 and AVX2, chosen while the program runs.
//
// Each function carries its own target attribute, so that no file needs compiler flags of its own
// and nothing built for AVX2 can leak into code that runs everywhere. Without a C library to ask
// what the processor has (a freestanding build) there are no such kernels.

#include "simd/kernels.h"

#if __STDC_HOSTED__ && (defined(__x86_64__) || defined(__i386__))

#include <immintrin.h>

static uint64_t popcount_of(uint64_t w)
{
    w -= w >> 1 & UINT64_C(0x5555555555555555);
    w = (w & UINT64_C(0x3333333333333333)) + (w >> 2 & UINT64_C(0x3333333333333333));
    w = (w + (w >> 4)) & UINT64_C(0x0f0f0f0f0f0f0f0f);
    return w * UINT64_C(0x0101010101010101) >> 56;
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
#define SF_SHL(v, s) _mm_sll_epi64(v, _mm_cvtsi32_si128((int)(s)))
#define SF_SHR(v, s) _mm_srl_epi64(v, _mm_cvtsi32_si128((int)(s)))
#define SF_FIRST(w) _mm_set_epi64x(0, (long long)(w))
#define SF_PREV(p, c) _mm_castpd_si128(_mm_shuffle_pd(_mm_castsi128_pd(p), _mm_castsi128_pd(c), 1))
#define SF_NEXT(c, n) _mm_castpd_si128(_mm_shuffle_pd(_mm_castsi128_pd(c), _mm_castsi128_pd(n), 1))
#define SF_POPCOUNT(w) popcount_of(w)
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
#define SF_SHL(v, s) _mm256_sll_epi64(v, _mm_cvtsi32_si128((int)(s)))
#define SF_SHR(v, s) _mm256_srl_epi64(v, _mm_cvtsi32_si128((int)(s)))
#define SF_FIRST(w) _mm256_set_epi64x(0, 0, 0, (long long)(w))
#define SF_PREV(p, c) _mm256_alignr_epi8(c, _mm256_permute2x128_si256(p, c, 0x21), 8)
#define SF_NEXT(c, n) _mm256_alignr_epi8(_mm256_permute2x128_si256(c, n, 0x21), c, 8)
#define SF_POPCOUNT(w) ((uint64_t)__builtin_popcountll(w))
#include "simd/template.h"

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

#endif
