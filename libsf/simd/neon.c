// SPDX-License-Identifier: MIT
// The kernels for 64-bit Arm, where NEON is always there. A freestanding build may run where nobody
// saves vector registers, so it has none.

#include "simd/kernels.h"

#if __STDC_HOSTED__ && defined(__aarch64__)

#include <arm_neon.h>

#define SF_FN(name) name##_neon
#define SF_NAME "neon"
#define SF_TARGET
#define SF_VEC uint64x2_t
#define SF_LANES 2
#define SF_LOAD(p) vld1q_u64(p)
#define SF_STORE(p, v) vst1q_u64(p, v)
#define SF_AND(a, b) vandq_u64(a, b)
#define SF_OR(a, b) vorrq_u64(a, b)
#define SF_XOR(a, b) veorq_u64(a, b)
#define SF_ANDNOT(a, b) vbicq_u64(a, b)
#define SF_SHL(v, s) vshlq_u64(v, vdupq_n_s64((int64_t)(s)))
#define SF_SHR(v, s) vshlq_u64(v, vdupq_n_s64(-(int64_t)(s)))
#define SF_OR3(a, b, c) SF_OR(a, SF_OR(b, c))
#define SF_SHLD(v, from, s) SF_OR(SF_SHL(v, s), SF_SHR(from, 64 - (s)))
#define SF_SHRD(v, from, s) SF_OR(SF_SHR(v, s), SF_SHL(from, 64 - (s)))
#define SF_EACH(w) vdupq_n_u64(w)
#define SF_LAST(w) vcombine_u64(vcreate_u64(~UINT64_C(0)), vcreate_u64(w))
#define SF_PREV(p, c) vextq_u64(p, c, 1)
#define SF_NEXT(c, n) vextq_u64(c, n, 1)
#define SF_POPCOUNT(w) ((uint64_t)vaddv_u8(vcnt_u8(vcreate_u8(w))))
#define SF_NARROWER sfi_kernels_word()
#include "simd/template.h"

const sfi_kernels *sfi_kernels_neon(void)
{
    return &table_neon;
}

#else

const sfi_kernels *sfi_kernels_neon(void)
{
    return NULL;
}

#endif
