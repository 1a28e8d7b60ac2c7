// SPDX-License-Identifier: MIT
// TRUST items 6, 7, 8, 9, 10, 11, 12: trimming and set operations, over all pairs of stacks (all
// 16.8 million of 4x1x3). The union of support-free stacks is support-free, the intersection is
// not; parts must be joined before they are trimmed. False laws stand with their counter-example.

#include "tiny.h"

static void laws_of_pairs(const tiny *t)
{
    uint32_t broken = 0;
    for (uint32_t a = 0; a < t->count; a++) {
        uint32_t kept_a = t->trim[a];
        for (uint32_t c = 0; c < t->count; c++) {
            uint32_t kept_c = t->trim[c], joint = t->trim[a | c];
            broken += ((kept_a | kept_c) & ~joint) != 0;              // 6
            broken += kept_a == a && kept_c == c && joint != (a | c); // 7, 8
            broken += t->trim[a & c] != t->trim[kept_a & kept_c];     // 10
            broken += (t->trim[a & c] & ~(kept_a & kept_c)) != 0;     // 11, the true half
            broken += (t->trim[kept_a | c] & ~joint) != 0;            // 12, the true half
        }
    }
    CHECK_EQ(broken, 0);
}

static void pairs(void)
{
    sf_rule rules[] = {sf_rule_box3(), rule_of_radius(0)};
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        tiny t = tiny_new(4, 1, 3, &rules[i]), u = tiny_new(3, 2, 2, &rules[i]);
        laws_of_pairs(&t);
        laws_of_pairs(&u);
        tiny_delete(&t);
        tiny_delete(&u);
    }
}

// 8 with an element of its own in each step, which the octagon has.
static void pairs_where_steps_differ(void)
{
    sf_rule rule = rule_of_angle(SF_RULE_OCTAGON, 30.0);
    sf_element first = stack_step(&rule, 0), second = stack_step(&rule, 1);
    CHECK(first.reach_y != second.reach_y);
    tiny t = tiny_new(2, 2, 3, &rule);
    laws_of_pairs(&t);
    tiny_delete(&t);
}

// 6 and 8 for any number: joined one after the other, all triples of 3x1x3.
static void triples(void)
{
    sf_rule rule = sf_rule_box3();
    tiny t = tiny_new(3, 1, 3, &rule);
    uint32_t broken = 0;
    for (uint32_t a = 0; a < t.count; a++) {
        for (uint32_t b = a; b < t.count; b++) {
            for (uint32_t c = b; c < t.count; c++) {
                broken += ((t.trim[a] | t.trim[b] | t.trim[c]) & ~t.trim[a | b | c]) != 0;
                broken += (t.trim[a | b] & ~t.trim[a | b | c]) != 0;
            }
        }
    }
    CHECK_EQ(broken, 0);
    tiny_delete(&t);
}

static void false_laws(void)
{
    sf_rule rule = sf_rule_box3(), straight = rule_of_radius(0);
    tiny t = tiny_new(3, 1, 2, &rule), v = tiny_new(3, 1, 2, &straight);
    uint32_t a = tiny_parse("...|#.."), c = tiny_parse("#..|...");
    // 7: trim(A + C) = trim A + trim C. C carries what floats in A.
    CHECK_EQ(t.trim[a | c], a | c);
    CHECK_EQ(t.trim[a] | t.trim[c], c);
    // 12: trim(A + C) = trim(trim A + C).
    CHECK_EQ(t.trim[t.trim[a] | c], c);
    // 9: support-free stacks are closed under intersection; 11: trim(A C) = trim A trim C.
    uint32_t p = tiny_parse(".#.|#.."), q = tiny_parse("#..|#..");
    CHECK(tiny_is_free(&t, p) && tiny_is_free(&t, q));
    CHECK(!tiny_is_free(&t, p & q));
    CHECK_EQ(p & q, a);
    CHECK(t.trim[p & q] != (t.trim[p] & t.trim[q]));
    // 9 holds where each voxel has one carrier only.
    for (uint32_t i = 0; i < v.count; i++) {
        for (uint32_t j = 0; j < v.count; j++) {
            CHECK(!tiny_is_free(&v, i) || !tiny_is_free(&v, j) || tiny_is_free(&v, i & j));
        }
    }
    tiny_delete(&t);
    tiny_delete(&v);
}

int main(void)
{
    TEST(pairs);
    TEST(pairs_where_steps_differ);
    TEST(triples);
    TEST(false_laws);
    return test_finish();
}
