// SPDX-License-Identifier: MIT
// Why: a layer that is said to rest by its runs is never looked at again, so a yes must be exact;
// and a no where all rests would only be slow, so it is allowed for runs in many pieces alone. Held
// against dilated bits for every form of element. Then whole checks, of shapes that mostly rest,
// with now and then an island: with room for runs, with too little, and without, they say the same.
// Guards: ALGORITHMS 10.7, promise P2.

#include "judge.h"

#include "support/check/run_front.h"

enum { W = 200, H = 40, RUNS = 8192 };

static uint64_t words[3][H * 4];
static sf_run above[RUNS], below[RUNS];
static uint32_t rows[H + 1];

static size_t runs_of(sf_slice slice, sf_run *runs)
{
    size_t count = 0;
    CHECK_EQ(sf_slice_runs(slice, runs, RUNS, &count), SF_OK);
    return count;
}

static sf_element any_element(void)
{
    sf_element e = sf_element_box3();
    uint32_t kind = test_random_below(4);
    if (kind == 1) {
        e = sf_element_plus3();
    } else if (kind == 2) {
        CHECK_EQ(sf_element_ellipse(test_random_below(9 << 16), test_random_below(9 << 16), &e),
                 SF_OK);
    } else if (kind == 3) {
        e.reach_y = 0;
        e.half_width[0] = (uint16_t)test_random_below(3);
    }
    return e;
}

static void a_yes_is_exact(void)
{
    int yes = 0, no = 0, unsure = 0;
    for (int round = 0; round < 4000; round++) {
        sf_slice a = {words[0], W, H, 4}, b = {words[1], W, H, 4}, wide = {words[2], W, H, 4};
        sf_element e = any_element();
        memset(words, 0, sizeof words);
        for (uint32_t i = 0, n = 1 + test_random_below(60); i < n; i++) {
            uint32_t x = test_random_below(W - 12), y = test_random_below(H - 6);
            sf_rect rect = {x, y, x + 1 + test_random_below(12), y + 1 + test_random_below(6)};
            CHECK_EQ(sf_slice_fill(b, rect, 1), SF_OK);
        }
        // What rests, and sometimes a voxel more.
        CHECK_EQ(sf_slice_dilate(wide, b, &e, SF_BORDER_EMPTY), SF_OK);
        CHECK_EQ(sf_slice_copy(a, wide), SF_OK);
        for (uint32_t i = test_random_below(30); i > 0; i--) {
            CHECK_EQ(sf_slice_set(a, test_random_below(W), test_random_below(H), 0), SF_OK);
        }
        if (test_random_below(2) == 0) {
            CHECK_EQ(sf_slice_set(a, test_random_below(W), test_random_below(H), 1), SF_OK);
        }
        sfi_run_front front = {below, rows, RUNS, 0, H, 0};
        size_t count = runs_of(b, below);
        sfi_run_front_take(&front, below, count);
        CHECK(front.is_valid);
        int said = sfi_run_front_carries(&front, above, runs_of(a, above), &e);
        CHECK_EQ(sf_slice_subtract(b, a, wide), SF_OK);
        int rests = sf_slice_popcount(b) == 0;
        CHECK(!said || rests);
        yes += said;
        no += !rests;
        unsure += rests && !said;
    }
    CHECK(yes > 500 && no > 500);
    CHECK(unsure * 20 < yes);
}

static void push_all(const stack *s, sf_check_options o, int as_runs, uint32_t room, pushed *p)
{
    void *block;
    o.findings = p->findings;
    o.layer_run_capacity = room;
    sf_checker *checker = checker_new(&o, &block);
    for (int z = 0; z < s->nz; z++) {
        sf_slice slice = stack_layer_bits(s, z, words[0], (size_t)(s->nx + 63) / 64);
        if (as_runs) {
            size_t count = runs_of(slice, above);
            CHECK_EQ(sf_checker_push_runs(checker, above, count), SF_OK);
            memset(above, 0xa5, sizeof above); // they are the caller's again
        } else {
            CHECK_EQ(sf_checker_push(checker, slice), SF_OK);
        }
    }
    CHECK_EQ(sf_checker_report(checker, &p->report, &p->finding_count), SF_OK);
    free(block);
}

static void checks_say_the_same(void)
{
    static stack s;
    static pushed bits, runs;
    int clean = 0, dirty = 0;
    for (int i = 0; i < 300; i++) {
        sf_rule rule = rule_by_number(i);
        // A cone that leans, so that it rests; and at times something in the air, for a few layers.
        stack_clear(&s, 24, 10, 12);
        uint32_t island = test_random_below(3) == 0 ? 2 + test_random_below(6) : 99;
        for (int z = 0; z < 12; z++) {
            for (int y = 2; y < 8; y++) {
                for (int x = 3 + z / 2; x < 12 + z / 3; x++) {
                    s.solid[(z * 10 + y) * 24 + x] = 1;
                }
            }
            if ((uint32_t)z >= island && (uint32_t)z < island + 3) {
                s.solid[(z * 10 + 4) * 24 + 21] = 1;
            }
        }
        sf_check_options o = pushed_options(&s, &rule, i % 5 == 0 ? 1 : SF_BED_AUTO, &bits);
        push_all(&s, o, 0, 0, &bits);
        for (uint32_t room = 0; room < 3; room++) {
            push_all(&s, o, 1, room == 0 ? 100 : room == 1 ? 6 : 0, &runs);
            same_report(&bits.report, &runs.report);
            CHECK_EQ(bits.finding_count, runs.finding_count);
            for (size_t n = 0; n < bits.finding_count && n < runs.finding_count; n++) {
                same_finding(&bits.findings[n], &runs.findings[n]);
            }
        }
        clean += bits.report.support_free;
        dirty += !bits.report.support_free;
    }
    CHECK(clean > 30 && dirty > 30);
}

int main(void)
{
    TEST(a_yes_is_exact);
    TEST(checks_say_the_same);
    return test_finish();
}
