// SPDX-License-Identifier: MIT
// The kernels for 64-bit Arm, where NEON is always there. A freestanding build may run where nobody
// saves vector registers, so it has none.

#include "simd/kernels.h"

#if __STDC_HOSTED__ && defined(__aarch64__)

#include <arm_neon.h>

static inline uint64x2_t load_eight(const uint16_t *p)
{
    return vreinterpretq_u64_u16(vld1q_u16(p));
}

// Each of the eight lowest bits of w as a lane of ones.
static inline uint64x2_t spread_eight(uint64_t w)
{
    static const uint16_t bits[8] = {1, 2, 4, 8, 16, 32, 64, 128};
    return vreinterpretq_u64_u16(vtstq_u16(vdupq_n_u16((uint16_t)w), vld1q_u16(bits)));
}

// Eight lanes of four bits each, two to a byte: in each 32 bits the upper lane goes next to the
// lower.
static inline void put_nibbles(unsigned char *to, uint64x2_t v)
{
    uint32x4_t lanes = vreinterpretq_u32_u64(v);
    lanes = vandq_u32(vorrq_u32(lanes, vshrq_n_u32(lanes, 12)), vdupq_n_u32(0xff));
    uint16x4_t four = vmovn_u32(lanes);
    uint8x8_t bytes = vmovn_u16(vcombine_u16(four, four));
    vst1_lane_u32((uint32_t *)(void *)to, vreinterpret_u32_u8(bytes), 0);
}

// Each of sixteen comparisons keeps one bit of its byte; a sum over eight lanes is a byte of bits.
static inline uint64_t bytes_neon(const uint8_t *p, const uint8_t *q)
{
    static const uint8_t bits[16] = {1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128};
    uint64_t word = 0;
    for (unsigned i = 0; i < 64; i += 16) {
        uint8x16_t kept = vandq_u8(vcgeq_u8(vld1q_u8(p + i), vld1q_u8(q + i)), vld1q_u8(bits));
        word |= (uint64_t)vaddv_u8(vget_low_u8(kept)) << i;
        word |= (uint64_t)vaddv_u8(vget_high_u8(kept)) << (i + 8);
    }
    return word;
}

static inline uint64_t numbers_neon(const int32_t *p, const int32_t *q)
{
    static const uint32_t bits[4] = {1, 2, 4, 8};
    uint64_t word = 0;
    for (unsigned i = 0; i < 64; i += 4) {
        uint32x4_t kept = vandq_u32(vcgeq_s32(vld1q_s32(p + i), vld1q_s32(q + i)), vld1q_u32(bits));
        word |= (uint64_t)vaddvq_u32(kept) << i;
    }
    return word;
}

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
#define SF_LOAD16(p) load_eight(p)
#define SF_STORE16(p, v) vst1q_u16(p, vreinterpretq_u16_u64(v))
#define SF_MIN16(a, b)                                                                             \
    vreinterpretq_u64_u16(vminq_u16(vreinterpretq_u16_u64(a), vreinterpretq_u16_u64(b)))
#define SF_ADD16(a, b)                                                                             \
    vreinterpretq_u64_u16(vqaddq_u16(vreinterpretq_u16_u64(a), vreinterpretq_u16_u64(b)))
#define SF_EACH16(n) vreinterpretq_u64_u16(vdupq_n_u16((uint16_t)(n)))
#define SF_SPREAD16(w) spread_eight(w)
#define SF_NIBBLES(p, x, v) put_nibbles((unsigned char *)(p) + (x) / 2, v)
#define SF_AT_LEAST8(p, q) bytes_neon(p, q)
#define SF_AT_LEAST32(p, q) numbers_neon(p, q)
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
