// SPDX-License-Identifier: MIT
// Why: every instruction set must give the bits of the reference, which is the specification, at
// every width and at the very end of memory (TRUST 31, 89, B20).

#define _DEFAULT_SOURCE

#include "simd/kernels.h"
#include "guarded.h"
#include "test.h"

#define ROWS 5

// Four of operands and results, three of further rows.
static unsigned char *area[7];
static sf_isa isa; // of the running case

static void fill(uint64_t *words, size_t count, int pattern)
{
    for (size_t i = 0; i < count; i++) {
        uint64_t edges = UINT64_C(0x8000000000000001), one = UINT64_C(1) << test_random_below(64);
        uint64_t values[] = {test_random(), 0,   ~UINT64_C(0),
                             edges,         one, test_random() | test_random()};
        words[i] = values[pattern % 6];
    }
}

static void binary(const sfi_kernels *k, size_t count, int at_end)
{
    const sfi_kernels *r = sfi_kernels_reference();
    uint64_t *a = guarded_words(area[0], count, at_end), *b = guarded_words(area[1], count, at_end);
    uint64_t *got = guarded_words(area[2], count, at_end),
             *want = guarded_words(area[3], count, at_end);
    void (*const of_k[])(uint64_t *, const uint64_t *, const uint64_t *,
                         size_t) = {k->and_words, k->or_words, k->xor_words, k->subtract_words};
    void (*const of_r[])(uint64_t *, const uint64_t *, const uint64_t *,
                         size_t) = {r->and_words, r->or_words, r->xor_words, r->subtract_words};
    for (int operation = 0; operation < 4; operation++) {
        fill(a, count, operation);
        fill(b, count, (int)test_random_below(6));
        of_k[operation](got, a, b, count);
        of_r[operation](want, a, b, count);
        CHECK(memcmp(got, want, 8 * count) == 0);
        of_k[operation](a, a, b, count); // in place
        CHECK(memcmp(a, want, 8 * count) == 0);
    }
    fill(a, count, (int)test_random_below(6));
    uint64_t sums[3] = {1, 2, 3}, expected[3] = {1, 2, 3};
    k->row_sums(a, count, sums);
    r->row_sums(a, count, expected);
    CHECK(memcmp(sums, expected, sizeof sums) == 0);
    CHECK_EQ(k->popcount(a, count), r->popcount(a, count));
    memcpy(got, a, 8 * count);
    memcpy(want, a, 8 * count);
    CHECK_EQ(k->prefix_xor(got, count), r->prefix_xor(want, count));
    CHECK(memcmp(got, want, 8 * count) == 0);
}

// Rectangles that are empty but for a bit or two, so that each mask and each word decides.
static void rectangles(const sfi_kernels *k, size_t count, int at_end)
{
    const sfi_kernels *r = sfi_kernels_reference();
    size_t stride = count + test_random_below(3), total = stride * (ROWS - 1) + count;
    uint64_t *words = guarded_words(area[0], total, at_end);
    for (int i = 0; i < 40; i++) {
        uint64_t first = ~UINT64_C(0) << test_random_below(64);
        uint64_t last = ~UINT64_C(0) >> test_random_below(64);
        memset(words, 0, 8 * total);
        for (int bit = 0; bit < i % 3; bit++) {
            words[test_random_below((uint32_t)total)] |= UINT64_C(1) << test_random_below(64);
        }
        const uint64_t *next = i % 2 == 0 ? words : NULL;
        CHECK_EQ(k->any_in_rows(words, stride, ROWS, count, first, last, next),
                 r->any_in_rows(words, stride, ROWS, count, first, last, NULL));
    }
}

static void widening(const sfi_kernels *k, size_t count, int at_end)
{
    const sfi_kernels *r = sfi_kernels_reference();
    uint64_t *src = guarded_words(area[0], count + 2, at_end);
    uint64_t *got = guarded_words(area[2], count, at_end),
             *want = guarded_words(area[3], count, at_end);
    uint64_t *rows[4] = {
        guarded_words(area[1], count, at_end), guarded_words(area[4], count, at_end),
        guarded_words(area[5], count, at_end), guarded_words(area[6], count, at_end)};
    const uint64_t *const *const named = (const uint64_t *const *)rows;
    for (unsigned s = 1; s <= 63; s += 1 + test_random_below(9)) {
        uint64_t flip = s % 2 == 0 ? 0 : ~UINT64_C(0);
        size_t row_count = 2 * test_random_below(3);
        fill(src, count + 2, (int)s);
        for (int i = 0; i < 4; i++) {
            fill(rows[i], count, (int)test_random_below(6));
        }
        k->widen(got, src + 1, s, named, row_count, flip, count);
        r->widen(want, src + 1, s, named, row_count, flip, count);
        CHECK(memcmp(got, want, 8 * count) == 0);
        k->unite(got, named, row_count, flip, count);
        r->unite(want, named, row_count, flip, count);
        CHECK(memcmp(got, want, 8 * count) == 0);
    }
}

static int same_rows(sf_slice a, sf_slice b)
{
    int same = 1;
    for (uint32_t y = 0; y < a.height; y++) {
        same = same && memcmp(a.words + y * a.stride, b.words + y * b.stride,
                              8 * sfi_row_words(a.width)) == 0;
    }
    return same;
}

static void trimming(const sfi_kernels *k, uint32_t width, int at_end)
{
    const sfi_kernels *r = sfi_kernels_reference();
    size_t words = sfi_row_words(width), stride = words + test_random_below(3);
    size_t total = stride * (ROWS - 1) + words;
    sf_slice src = {guarded_words(area[0], total, at_end), width, ROWS, stride};
    sf_slice below = {guarded_words(area[1], total, at_end), width, ROWS, stride};
    sf_slice got = {guarded_words(area[2], total, at_end), width, ROWS, stride};
    sf_slice want = {guarded_words(area[3], total, at_end), width, ROWS, stride};
    for (int pattern = 0; pattern < 6; pattern++) {
        fill(src.words, total, pattern % 2 ? 2 : 0); // padding is poisoned along with the rest
        fill(below.words, total, pattern);
        memset(got.words, 0,
               8 * total); // words between the rows belong to nobody: compare them too
        memset(want.words, 0, 8 * total);
        k->trim_box3(got, src, below);
        r->trim_box3(want, src, below);
        CHECK(memcmp(got.words, want.words, 8 * total) == 0);
        k->trim_plus3(got, src, below);
        r->trim_plus3(want, src, below);
        CHECK(memcmp(got.words, want.words, 8 * total) == 0);
        memcpy(got.words, src.words, 8 * total);
        k->trim_plus3(got, got, below); // in place
        CHECK(same_rows(got, want));
        r->trim_box3(want, src, below);
        k->trim_box3(src, src, below);
        CHECK(same_rows(src, want));
    }
}

// Keys of a row as they stand in a path map: some small, some at the limit, some without a path.
static uint16_t *fill_keys(unsigned char *in, size_t count, int at_end)
{
    uint16_t *keys = (uint16_t *)(void *)guarded_words(in, 16 * count + 2, at_end);
    for (size_t x = 0; x < 64 * count + 8; x++) {
        uint32_t some[4] = {test_random_below(4), test_random_below(4096),
                            4095 - test_random_below(2), 4096};
        uint32_t cost = some[test_random_below(4)];
        keys[x] = (uint16_t)(cost < 4096 ? 16 * cost : SFI_PATH_NONE);
    }
    // One value before the row is read, and one behind it: nothing farther out.
    return at_end ? keys + 7 : keys + 1;
}

static void path_rows(const sfi_kernels *k, size_t count, int at_end)
{
    static uint16_t got_keys[64 * 41], want_keys[64 * 41];
    static uint64_t got[4 * 41], want[4 * 41], shut[41];
    const uint16_t *below[3];
    for (int shape = 0; shape < 3; shape++) {
        for (int i = 0; i < 3; i++) {
            below[i] = fill_keys(area[i], count, at_end);
        }
        uint64_t *solid = guarded_words(area[3], count, at_end);
        fill(solid, count, (int)test_random_below(6));
        fill(shut, count, (int)test_random_below(6));
        memset(got, 0xdb, sizeof got); // what is there before must not shine through
        k->path_row(got_keys, got, below, (sfi_path_shape)shape, solid, shut, count);
        sfi_kernels_reference()->path_row(want_keys, want, below, (sfi_path_shape)shape, solid,
                                          shut, count);
        CHECK(memcmp(got_keys, want_keys, 128 * count) == 0);
        CHECK(memcmp(got, want, 32 * count) == 0);
    }
}

// Tones against levels that differ from them by one either way, or by far.
static void comparing(const sfi_kernels *k, size_t count, int at_end)
{
    const sfi_kernels *r = sfi_kernels_reference();
    size_t turn = 1 + test_random_below(4);
    int32_t *tones = (int32_t *)(void *)guarded_words(area[0], 32 * count, at_end);
    int32_t *levels = (int32_t *)(void *)guarded_words(area[1], 32 * turn, at_end);
    uint8_t *small = (uint8_t *)(void *)guarded_words(area[4], 8 * count, at_end);
    uint8_t *low = (uint8_t *)(void *)guarded_words(area[5], 8 * turn, at_end);
    uint64_t *got = guarded_words(area[2], count, at_end),
             *want = guarded_words(area[3], count, at_end);
    static const int32_t bases[5] = {0, 127, 255, INT32_MAX - 1, INT32_MIN + 1};
    int32_t base = bases[test_random_below(5)];
    for (size_t i = 0; i < 64 * turn; i++) {
        levels[i] = i % 7 == 0 ? (int32_t)test_random() : base;
        low[i] = (uint8_t)(i % 7 == 0 ? test_random() : (uint64_t)(uint32_t)base);
    }
    for (size_t i = 0; i < 64 * count; i++) {
        tones[i] = i % 5 == 0 ? (int32_t)test_random() : base - 1 + (int32_t)test_random_below(3);
        small[i] = (uint8_t)(i % 5 == 0 ? test_random() : (uint32_t)base + test_random_below(3));
    }
    k->at_least_8(got, small, low, turn, count);
    r->at_least_8(want, small, low, turn, count);
    CHECK(memcmp(got, want, 8 * count) == 0);
    k->at_least_32(got, tones, levels, turn, count);
    r->at_least_32(want, tones, levels, turn, count);
    CHECK(memcmp(got, want, 8 * count) == 0);
}

static void table_equals_the_reference(void)
{
    const sfi_kernels *kernels = sfi_kernels_for(isa);
    if (kernels == NULL) {
        SKIP("this processor, or this build, lacks the instruction set");
    }
    for (uint32_t width = 1; width <= 257; width++) {
        trimming(kernels, width, 1);
        trimming(kernels, width, 0);
    }
    for (size_t count = 1; count <= 40; count++) {
        binary(kernels, count, 1);
        binary(kernels, count, 0);
        widening(kernels, count, 1);
        widening(kernels, count, 0);
        rectangles(kernels, count, 1);
        rectangles(kernels, count, 0);
        path_rows(kernels, count, 1);
        path_rows(kernels, count, 0);
        comparing(kernels, count, 1);
        comparing(kernels, count, 0);
    }
    trimming(kernels, 4095, 1);
}

static void every_instruction_set_has_its_case(void)
{
    CHECK_EQ(test_count, SF_ISA_COUNT - 1); // the reference is what they are compared with
}

static void a_limit_is_kept_and_lifted(void)
{
    CHECK_STR(sf_isa_limit(SF_ISA_REFERENCE), "reference");
    CHECK(sfi_kernels_get() == sfi_kernels_reference());
    CHECK_STR(sf_isa_limit(SF_ISA_WORD), "word");
    CHECK(sfi_kernels_get() == sfi_kernels_word());
    const char *best = sf_isa_limit(SF_ISA_AVX512);
    CHECK_STR(sf_isa_limit(SF_ISA_COUNT), best);
    CHECK_STR(sfi_kernels_get()->name, best);
}

int main(void)
{
    static const struct {
        sf_isa isa;
        const char *name;
    } cases[] = {{SF_ISA_WORD, "word_equals_the_reference"},
                 {SF_ISA_SSE2, "sse2_equals_the_reference"},
                 {SF_ISA_NEON, "neon_equals_the_reference"},
                 {SF_ISA_AVX2, "avx2_equals_the_reference"},
                 {SF_ISA_AVX512, "avx512_equals_the_reference"}};
    for (int i = 0; i < 7; i++) {
        area[i] = guarded_area();
    }
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        isa = cases[i].isa;
        test_run(cases[i].name, table_equals_the_reference);
    }
    TEST(every_instruction_set_has_its_case);
    TEST(a_limit_is_kept_and_lifted);
    return test_finish();
}
