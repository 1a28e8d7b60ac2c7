// SPDX-License-Identifier: MIT
// Why: bridges are found word by word, and a gap that is one voxel too long, or anchored by one
// voxel too few, hangs in the air. The gaps of ALGORITHMS 1.7 (as corrected: ends by an opening)
// for all pairs of short rows and for random slices of any width, against a walk over cells; their
// lengths in mm; and the laws that the proofs need: more anchored matter, and more matter, never
// bridge less.

#include "law/rules.h"

#include "support/rule/carry.h"

static void gaps_of(stack *gaps, const stack *s, const stack *own, const sf_bridge *bridge)
{
    sf_grid *a = stack_grid(s), *b = stack_grid(own), *c = stack_grid(s), *d = stack_grid(s);
    sfi_bridge_gaps(bridge, sf_grid_slice(a, 0), sf_grid_slice(b, 0), sf_grid_slice(c, 0),
                    sf_grid_slice(d, 0));
    stack_read(gaps, d);
    sf_grid_destroy(a);
    sf_grid_destroy(b);
    sf_grid_destroy(c);
    sf_grid_destroy(d);
}

static void expected_gaps(stack *gaps, const stack *s, const stack *own, const sf_bridge *bridge)
{
    stack_clear(gaps, s->nx, s->ny, 1);
    for (int i = 0; i < s->nx * s->ny; i++) {
        int x = i % s->nx, y = i / s->nx;
        gaps->solid[i] = (uint8_t)(!own->solid[i] && oracle_bridged(s, own, x, y, 0, bridge));
    }
}

// All rows of eight with all that can be carried of them, along x and, turned, along y.
static void all_pairs_of_short_rows(void)
{
    static stack s, own, found, wanted;
    for (int span = 1; span <= 6; span += 2) {
        for (int anchor = 1; anchor <= 3; anchor++) {
            uint16_t l = (uint16_t)span, a = (uint16_t)anchor;
            sf_bridge bridge = {l, l, 0, a, a, 0};
            for (int bits = 0; bits < 256 * 256; bits++) {
                int carried = bits >> 8, solid = bits & 255;
                if ((carried & ~solid) != 0 || solid % 3 == 0) {
                    continue; // a third less, which is plenty
                }
                int turned = bits & 1;
                stack_clear(&s, turned ? 1 : 8, turned ? 8 : 1, 1);
                stack_clear(&own, s.nx, s.ny, 1);
                for (int i = 0; i < 8; i++) {
                    s.solid[i] = solid >> i & 1;
                    own.solid[i] = carried >> i & 1;
                }
                gaps_of(&found, &s, &own, &bridge);
                expected_gaps(&wanted, &s, &own, &bridge);
                CHECK(stack_equal(&found, &wanted));
            }
        }
    }
}

static void random_slices_of_any_width(void)
{
    static stack s, own, found, wanted;
    for (int i = 0; i < 3000; i++) {
        int nx = 1 + (int)test_random_below(200), ny = 1 + (int)test_random_below(20);
        sf_bridge b = {(uint16_t)test_random_below(9), (uint16_t)test_random_below(9),
                       (uint16_t)test_random_below(9), (uint16_t)test_random_below(5),
                       (uint16_t)test_random_below(5), (uint16_t)test_random_below(5)};
        stack_random(&s, nx, ny, 1, 0.6 + 0.39 * test_random_unit());
        stack_random(&own, nx, ny, 1, 0.3 + 0.6 * test_random_unit());
        stack_combine(&own, &own, &s, STACK_AND);
        gaps_of(&found, &s, &own, &b);
        expected_gaps(&wanted, &s, &own, &b);
        CHECK(stack_equal(&found, &wanted));
    }
}

// Gaps longer than a word.
static void long_spans(void)
{
    static stack s, own, found;
    for (int gap = 1; gap < 190; gap++) {
        for (int more = -1; more <= 1; more++) {
            sf_bridge b = {(uint16_t)(gap + more), 0, 0, 4, 0, 0};
            stack_clear(&s, 200, 1, 1);
            stack_clear(&own, 200, 1, 1);
            for (int x = 0; x < gap + 8; x++) {
                s.solid[x] = 1;
                own.solid[x] = x < 4 || x >= gap + 4;
            }
            gaps_of(&found, &s, &own, &b);
            CHECK_EQ(stack_volume(&found), more >= 0 ? gap : 0);
            own.solid[0] = 0; // an end of three
            gaps_of(&found, &s, &own, &b);
            CHECK_EQ(stack_volume(&found), 0);
        }
    }
}

static void monotone_in_both(void)
{
    static stack s, own, more_s, more_own, low, high;
    for (int i = 0; i < 3000; i++) {
        sf_bridge b = {(uint16_t)(1 + i % 5), (uint16_t)(i % 4), (uint16_t)(i % 3), 2, 1, 2};
        stack_random(&more_s, 30, 8, 1, 0.9);
        stack_random(&s, 30, 8, 1, 0.9);
        stack_combine(&s, &s, &more_s, STACK_AND);
        stack_random(&more_own, 30, 8, 1, 0.6);
        stack_combine(&more_own, &more_own, &more_s, STACK_AND);
        stack_random(&own, 30, 8, 1, 0.8);
        stack_combine(&own, &own, &more_own, STACK_AND);
        stack_combine(&own, &own, &s, STACK_AND);
        gaps_of(&low, &s, &own, &b);
        gaps_of(&high, &more_s, &more_own, &b);
        stack_combine(&low, &low, &own, STACK_OR);
        stack_combine(&high, &high, &more_own, STACK_OR);
        CHECK(stack_within(&low, &high));
    }
}

static void lengths_in_millimetres(void)
{
    sf_lattice lattice = {8, 8, 8, 0.1, 0.2, 0.05, NULL, {0, 0, 0}};
    sf_rule rule = sf_rule_box3();
    sf_fault fault;
    CHECK_EQ(sf_rule_set_bridges(&rule, 0.3, 0.15, &lattice, &fault), SF_OK);
    CHECK_EQ(rule.bridge.span_x, 3); // 0.3 / 0.1 is a little less than 3 in doubles
    CHECK_EQ(rule.bridge.span_y, 1);
    CHECK_EQ(rule.bridge.span_diagonal, 1);
    CHECK_EQ(rule.bridge.anchor_x, 2);
    CHECK_EQ(rule.bridge.anchor_y, 1);
    CHECK_EQ(rule.bridge.anchor_diagonal, 1);
    CHECK_EQ(sf_rule_set_bridges(&rule, 0, 5, &lattice, NULL), SF_OK);
    CHECK(!sfi_bridge_any(&rule.bridge) && rule.bridge.anchor_x == 0);
}

static void refusals_say_what_to_do(void)
{
    sf_lattice lattice = {8, 8, 8, 0.1, 0.1, 0.1, NULL, {0, 0, 0}}, broken = lattice;
    sf_rule rule = sf_rule_box3(), before = rule;
    sf_fault fault;
    static const struct {
        double span, anchor;
        sf_status status;
        const char *word;
    } cases[] = {{-1, 0, SF_ERR_ARGUMENT, "0 or more"},
                 {NAN, 0, SF_ERR_ARGUMENT, "0 or more"},
                 {1, NAN, SF_ERR_ARGUMENT, "0 or more"},
                 {HUGE_VAL, 0, SF_ERR_UNSUPPORTED, "larger pitch"},
                 {1, 1e9, SF_ERR_UNSUPPORTED, "larger pitch"},
                 {0.05, 0, SF_ERR_UNSUPPORTED, "smaller pitch"}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        CHECK_EQ(sf_rule_set_bridges(&rule, cases[i].span, cases[i].anchor, &lattice, &fault),
                 cases[i].status);
        CHECK(strstr(fault.message, cases[i].word) != NULL);
        CHECK(memcmp(&rule.bridge, &before.bridge, sizeof rule.bridge) == 0);
    }
    broken.pitch_x_mm = 0;
    CHECK_EQ(sf_rule_set_bridges(NULL, 1, 0, &lattice, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_set_bridges(&rule, 1, 0, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_rule_set_bridges(&rule, 1, 0, &broken, NULL), SF_ERR_ARGUMENT);
}

int main(void)
{
    TEST(all_pairs_of_short_rows);
    TEST(random_slices_of_any_width);
    TEST(long_spans);
    TEST(monotone_in_both);
    TEST(lengths_in_millimetres);
    TEST(refusals_say_what_to_do);
    return test_finish();
}
