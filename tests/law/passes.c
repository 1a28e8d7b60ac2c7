// SPDX-License-Identifier: MIT
// TRUST items 13, 14, 19: trimming cannot be had from all layers at once. One pass that compares
// each slice with the untrimmed one below is not enough; n - 1 passes are, n - 2 are not; and two
// layers cannot be taken in one stride. A trim that wants to run its layers in parallel reads this
// first.

#include "tiny.h"

// All slices against the ones below as they were, by the library's fused step.
static uint32_t one_pass(const tiny *t, const sf_rule *rule, uint32_t a)
{
    uint32_t result = a & t->layer;
    for (int z = 1; z < t->nz; z++) {
        uint64_t above = tiny_layer(t, a, z), below = tiny_layer(t, a, z - 1), out = 0;
        sf_slice s = {&above, (uint32_t)t->nx, 1, 1}, b = {&below, (uint32_t)t->nx, 1, 1};
        sf_slice d = {&out, (uint32_t)t->nx, 1, 1};
        sf_element e = stack_step(rule, z - 1);
        CHECK_EQ(sf_slice_and_dilate(d, s, b, &e), SF_OK);
        result |= (uint32_t)out << (z * t->nx);
    }
    return result;
}

static void passes_for_all_layers_are_the_trim(void)
{
    sf_rule rules[] = {sf_rule_box3(), rule_of_radius(0), rule_of_angle(SF_RULE_OCTAGON, 30.0)};
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        tiny t = tiny_new(3, 1, 5, &rules[i]);
        uint32_t short_by_one = 0;
        for (uint32_t a = 0; a < t.count; a++) {
            uint32_t s = a;
            for (int pass = 0; pass < t.nz - 2; pass++) {
                s = one_pass(&t, &rules[i], s);
            }
            short_by_one += s != t.trim[a];
            CHECK_EQ(one_pass(&t, &rules[i], s), t.trim[a]); // 14
        }
        CHECK(short_by_one > 0); // 14, the false half
        tiny_delete(&t);
    }
}

static void false_one_pass_is_enough(void)
{
    sf_rule rule = sf_rule_box3();
    tiny t = tiny_new(3, 1, 3, &rule);
    uint32_t a = tiny_parse("...|#..|#.."), once = one_pass(&t, &rule, a);
    CHECK_EQ(once, tiny_parse("...|...|#..")); // 13: not idempotent, and 14 with n = 3
    CHECK_EQ(one_pass(&t, &rule, once), 0);
    CHECK_EQ(t.trim[a], 0);
    tiny_delete(&t);
}

static void two_layers_in_one_stride(void)
{
    sf_rule rule = sf_rule_box3();
    sf_element step = element_along_x(1), two;
    CHECK_EQ(sf_element_sum(&step, &step, &two), SF_OK);
    tiny t = tiny_new(5, 1, 3, &rule);
    uint32_t *stride = tiny_morph(5, 1, &two, SF_BORDER_EMPTY, TINY_DILATE);
    for (uint32_t a = 0; a < t.count; a++) {
        CHECK(!tiny_is_free(&t, a) ||
              (tiny_layer(&t, a, 2) & ~stride[tiny_layer(&t, a, 0)]) == 0); // 19
    }
    // 19, the false half: that every second layer passes says nothing of the ones between.
    uint32_t gap = tiny_parse("#....|.....|#....");
    CHECK((tiny_layer(&t, gap, 2) & ~stride[tiny_layer(&t, gap, 0)]) == 0);
    CHECK_EQ(tiny_layer(&t, t.trim[gap], 2), 0);
    free(stride);
    tiny_delete(&t);
}

int main(void)
{
    TEST(passes_for_all_layers_are_the_trim);
    TEST(false_one_pass_is_enough);
    TEST(two_layers_in_one_stride);
    return test_finish();
}
