// SPDX-License-Identifier: MIT
// Why: the check is what people look at first: what is wrong, where, how much, and because of what.
// Here every count and every field of every finding is held against an oracle that floods voxels:
// for all stacks of some tiny sizes, and for random ones of every rule, bed and width around word
// boundaries. Law: findings partition what trimming takes, so their volumes sum up to it.

#include "judge.h"

static judged expected;
static pushed found;

static void compare(const stack *s, const sf_rule *rule, uint32_t bed)
{
    sf_check_options o = pushed_options(s, rule, bed, &found);
    judge(&expected, s, rule, bed);
    push_stack(&found, s, &o);
    same_report(&found.report, &expected.report);
    CHECK_EQ(found.finding_count, expected.finding_count);
    uint64_t volume = 0;
    for (size_t i = 0; i < found.finding_count && i < expected.finding_count; i++) {
        same_finding(&found.findings[i], &expected.findings[i]);
        volume += found.findings[i].volume;
    }
    CHECK_EQ(volume, found.report.trimmed_voxels);
}

static void all_stacks(int nx, int ny, int nz, const sf_rule *rule)
{
    static stack s;
    int voxels = nx * ny * nz;
    stack_clear(&s, nx, ny, nz);
    for (uint32_t bits = 0; bits < 1u << voxels; bits++) {
        for (int i = 0; i < voxels; i++) {
            s.solid[i] = (uint8_t)(bits >> i & 1);
        }
        compare(&s, rule, SF_BED_AUTO);
    }
}

static void every_stack_of_three_by_two_by_two(void)
{
    sf_rule box = sf_rule_box3(), none = rule_of_radius(0);
    all_stacks(3, 2, 2, &box);
    all_stacks(3, 2, 2, &none);
}

static void every_stack_in_a_row(void)
{
    sf_rule box = sf_rule_box3(), plus = rule_of_radius(1);
    all_stacks(4, 1, 3, &box);
    all_stacks(3, 1, 4, &box);
    all_stacks(1, 4, 3, &plus);
}

static void random_stacks(void)
{
    static stack s;
    for (int i = 0; i < 250; i++) {
        int nx = stack_width(), ny = 1 + (int)test_random_below(12);
        int nz = 1 + (int)test_random_below(9);
        if (i % 3 == 0) {
            stack_random(&s, nx, ny, nz, 0.1 + 0.7 * test_random_unit());
        } else {
            stack_random_boxes(&s, nx, ny, nz, 2 + (int)test_random_below(9));
        }
        sf_rule rule = rule_by_number(i / 3);
        compare(&s, &rule, i % 4 == 0 ? test_random_below((uint32_t)nz) : SF_BED_AUTO);
    }
}

// Combs, spirals and nested rings: regions that grow together late, and that hold others.
static void regions_that_join_late(void)
{
    static stack s;
    static const char *const shapes[] = {
        "#.#.#.#/#.#.#.#/#######",       "#######/#.#.#.#/#.#.#.#",
        "#####/....#/###.#/#...#/#####", "#######/#.....#/#.###.#/#.#.#.#/#.###.#/#.....#/#######",
        "#...#/.#.#./..#../.#.#./#...#", "#.#.#.#/.......#/#.#.#.#",
        ".#.#.#./#.#.#.#/.#.#.#."};
    sf_rule none = rule_of_radius(0);
    for (size_t i = 0; i < sizeof shapes / sizeof *shapes; i++) {
        stack_parse(&s, shapes[i]);
        static stack lifted;
        stack_clear(&lifted, s.nx, s.ny, 3);
        for (int z = 1; z < 3; z++) {
            memcpy(stack_at(&lifted, 0, 0, z), s.solid, (size_t)(s.nx * s.ny));
        }
        compare(&lifted, &none, 0);
    }
}

// A tower on a stalk, an arm out of it, and an arm out of the arm.
static void causes_make_a_chain(void)
{
    static stack s;
    sf_rule none = rule_of_radius(0);
    stack_parse(&s, "#.......|#.##....|..##.##.|..######|......##");
    compare(&s, &none, SF_BED_AUTO);
    CHECK_EQ(found.finding_count, 4);
    CHECK_EQ(found.findings[0].kind, SF_FINDING_ISLAND);
    CHECK_EQ(found.findings[0].cause, SF_FINDING_ROOT);
    CHECK_EQ(found.findings[0].volume, 6);
    CHECK_EQ(found.findings[1].kind, SF_FINDING_ISLAND);
    CHECK_EQ(found.findings[1].cause, SF_FINDING_ROOT);
    CHECK_EQ(found.findings[2].kind, SF_FINDING_OVERHANG);
    CHECK_EQ(found.findings[2].cause, 0);
    CHECK_EQ(found.findings[3].kind, SF_FINDING_OVERHANG);
    CHECK_EQ(found.findings[3].cause, 1);
    CHECK_EQ(found.findings[3].volume, 2);
    // An arm out of kept matter is nobody's fault but its own, though lost matter touches it too.
    stack_parse(&s, "#....|#.#..|#.#..|####.");
    compare(&s, &none, SF_BED_AUTO);
    CHECK_EQ(found.finding_count, 3);
    CHECK_EQ(found.findings[1].cause, SF_FINDING_ROOT);
    CHECK_EQ(found.findings[2].cause, 0);
}

int main(void)
{
    TEST(every_stack_of_three_by_two_by_two);
    TEST(every_stack_in_a_row);
    TEST(random_stacks);
    TEST(regions_that_join_late);
    TEST(causes_make_a_chain);
    return test_finish();
}
