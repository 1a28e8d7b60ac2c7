// SPDX-License-Identifier: MIT
// Why: every hull stands on these signs. They are held against sums of 16-bit pieces, worked out
// the way it is done on paper, over values of all sizes and over those that just cancel.

#include "base/exact.h"
#include "test.h"

// A number as 16 digits of 16 bits, two's complement: longer than what is tested, and without a
// word of 64 bits in it.
typedef struct paper {
    uint32_t digit[16];
} paper;

static paper paper_of(int64_t a)
{
    paper p;
    for (int i = 0; i < 16; i++) {
        p.digit[i] = i < 4 ? (uint32_t)((uint64_t)a >> 16 * i & 0xffff) : a < 0 ? 0xffff : 0;
    }
    return p;
}

static paper paper_add(paper a, paper b)
{
    uint32_t carry = 0;
    for (int i = 0; i < 16; i++) {
        uint32_t sum = a.digit[i] + b.digit[i] + carry;
        a.digit[i] = sum & 0xffff;
        carry = sum >> 16;
    }
    return a;
}

static paper paper_negate(paper a)
{
    for (int i = 0; i < 16; i++) {
        a.digit[i] ^= 0xffff;
    }
    return paper_add(a, paper_of(1));
}

static paper paper_times(paper a, paper b)
{
    paper product = paper_of(0);
    for (int i = 0; i < 16; i++) {
        uint32_t carry = 0;
        for (int j = 0; i + j < 16; j++) {
            uint64_t sum = (uint64_t)a.digit[j] * b.digit[i] + product.digit[i + j] + carry;
            product.digit[i + j] = (uint32_t)(sum & 0xffff);
            carry = (uint32_t)(sum >> 16);
        }
    }
    return product;
}

static int paper_sign(paper a)
{
    int any = 0;
    for (int i = 0; i < 16; i++) {
        any |= a.digit[i] != 0;
    }
    return a.digit[15] & 0x8000 ? -1 : any;
}

static int same(sfi_exact a, paper p)
{
    int good = 1;
    for (int i = 0; i < 8; i++) {
        uint64_t word = i < 4 ? a.low : a.high;
        good = good && (word >> 16 * (i % 4) & 0xffff) == p.digit[i];
    }
    return good;
}

// Of any size up to 2^bits.
static int64_t any(int bits)
{
    int64_t value = (int64_t)(test_random() >> (64 - 1 - test_random_below((uint32_t)bits)));
    return test_random_below(2) ? value : -value;
}

static void sums_and_products(void)
{
    for (int i = 0; i < 200000; i++) {
        int64_t a = any(62), b = any(62), c = any(40);
        paper pa = paper_of(a), pb = paper_of(b), pc = paper_of(c);
        sfi_exact ab = sfi_exact_times(sfi_exact_of(a), b);
        CHECK(same(ab, paper_times(pa, pb)));
        CHECK(same(sfi_exact_add(ab, sfi_exact_of(c)), paper_add(paper_times(pa, pb), pc)));
        CHECK(same(sfi_exact_subtract(sfi_exact_of(c), ab),
                   paper_add(pc, paper_negate(paper_times(pa, pb)))));
        CHECK_EQ(sfi_exact_sign(ab),
                 (a > 0) - (a < 0) == 0 ? 0 : ((a > 0) == (b > 0) ? 1 : -1) * (b != 0));
        int64_t d = any(40), e = any(40);
        sfi_exact three = sfi_exact_times(sfi_exact_times(sfi_exact_of(c), d), e);
        CHECK(same(three, paper_times(paper_times(pc, paper_of(d)), paper_of(e))));
    }
}

static void turns(void)
{
    for (int i = 0; i < 200000; i++) {
        // (a, b) and (c, d) nearly along one line: multiples of one vector, then off by little.
        int64_t x = any(30), y = any(30), m = any(30), n = any(30);
        int64_t a = x * m + (int64_t)test_random_below(3) - 1, b = y * m, c = x * n, d = y * n;
        paper determinant = paper_add(paper_times(paper_of(a), paper_of(d)),
                                      paper_negate(paper_times(paper_of(b), paper_of(c))));
        CHECK_EQ(sfi_exact_turn(a, b, c, d), paper_sign(determinant));
    }
    int64_t most = INT64_C(1) << 62;
    CHECK_EQ(sfi_exact_turn(most, most, most, most), 0);
    CHECK_EQ(sfi_exact_turn(most, most, most - 1, most), 1);
    CHECK_EQ(sfi_exact_turn(-most, most, most, most), -1);
    CHECK_EQ(sfi_exact_turn(0, 0, most, -most), 0);
}

int main(void)
{
    TEST(sums_and_products);
    TEST(turns);
    return test_finish();
}
