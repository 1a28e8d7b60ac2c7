// SPDX-License-Identifier: MIT
// Why: a printer may believe its own processor only if that says what the library says. Both forms
// of the checker on a chip, dense and run-length, are held on random stacks against a judgement
// voxel by voxel (every count, every finding, both hashes) and against the library's checker (the
// counts that both have), for every rule that is an element, for tables made by
// sf_chip_rule_make().

#include "stacks.h"

#define MEMORY_SIZE 200000

static uint64_t memory[MEMORY_SIZE / 8];
static uint64_t checker_memory[MEMORY_SIZE / 8 + 8];
static uint8_t table_bytes[4096];
static stack shape;
static judgement right;

// What the library's own checker says of the stack.
static void ask_library(stack *s, const sf_rule *rule, uint32_t first, uint32_t bed,
                        sf_check_report *report)
{
    sf_check_options options = sf_check_options_default();
    options.rule = *rule;
    options.width = s->width;
    options.height = s->height;
    options.first_layer = first;
    options.bed_layer = bed;
    size_t size = 0;
    sf_checker *checker = NULL;
    unsigned char *at = (unsigned char *)checker_memory;
    at += (64 - (uintptr_t)at % 64) % 64;
    CHECK_EQ(sf_checker_size(&options, &size), SF_OK);
    CHECK(size <= MEMORY_SIZE);
    CHECK_EQ(sf_checker_place(&options, at, size, &checker), SF_OK);
    for (uint32_t z = 0; z < s->layers; z++) {
        CHECK_EQ(sf_checker_push_grey(checker, stack_row(s, z, 0), s->width, 1), SF_OK);
    }
    CHECK_EQ(sf_checker_report(checker, report, NULL), SF_OK);
}

static void check_findings(const sf_chip_finding *findings, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        CHECK_EQ(findings[i].layer, right.findings[i].layer);
        CHECK_EQ(findings[i].y, right.findings[i].y);
        CHECK_EQ(findings[i].x0, right.findings[i].x0);
        CHECK_EQ(findings[i].x1, right.findings[i].x1);
    }
}

static void check_form(stack *s, sf_chip_options *options, uint32_t run_capacity)
{
    sf_chip_finding findings[20];
    options->run_capacity = run_capacity;
    options->findings = findings;
    options->finding_capacity = test_random_below(21);
    size_t size = 0;
    sf_chip *chip = NULL;
    sf_chip_counts counts;
    CHECK_EQ(sf_chip_size(options, &size), SF_OK);
    CHECK(size <= sizeof memory);
    memset(memory, 0xa5, sizeof memory);
    CHECK_EQ(sf_chip_place(options, memory, size, &chip), SF_OK);
    for (uint32_t z = 0; z < s->layers && chip != NULL; z++) {
        CHECK_EQ(sf_chip_push(chip, stack_decode, s), SF_OK);
    }
    CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
    right.counts.finding_count = right.counts.unsupported_runs < options->finding_capacity
                                     ? (uint32_t)right.counts.unsupported_runs
                                     : options->finding_capacity;
    check_counts(&counts, &right.counts);
    check_findings(findings, counts.finding_count);
    for (size_t i = (size + 7) / 8; i < MEMORY_SIZE / 8; i++) { // nothing beyond what was asked for
        CHECK(memory[i] == UINT64_C(0xa5a5a5a5a5a5a5a5));
    }
}

static void check_stack(stack *s, const sf_rule *rule, uint32_t first, uint32_t bed)
{
    sf_chip_options options = sf_chip_options_default();
    sf_check_report report = {0};
    size_t used = 0;
    options.width = s->width;
    options.height = s->height;
    options.first_layer = first;
    options.bed_layer = bed;
    CHECK_EQ(sf_chip_rule_make(rule, first, s->layers, table_bytes, sizeof table_bytes, &used,
                               &options.rule),
             SF_OK);
    stack_judge(s, rule, first, bed, &right);
    ask_library(s, rule, first, bed, &report);
    CHECK_EQ(report.solid_voxels, right.counts.solid_voxels);
    CHECK_EQ(report.unsupported_voxels, right.counts.unsupported_voxels);
    CHECK_EQ(report.bed_layer, right.counts.bed_layer);
    CHECK_EQ(report.support_free, right.counts.support_free);
    check_form(s, &options, 0);
    check_form(s, &options, (s->width + 1) / 2 * s->height);
}

static sf_rule random_rule(void)
{
    uint64_t reach = ((uint64_t)1 << 23) + (test_random() >> (38 + test_random_below(4)));
    uint64_t wide = reach + (test_random() >> 39);
    sf_rule octagon = {.kind = SF_RULE_OCTAGON, .reach_x_q24 = reach, .reach_y_q24 = reach};
    sf_rule disk = {.kind = SF_RULE_DISK, .reach_x_q24 = wide, .reach_y_q24 = reach};
    uint32_t which = test_random_below(3);
    return which == 0 ? sf_rule_box3() : which == 1 ? octagon : disk;
}

// Small ones, of every width up to three words.
static void random_stacks(void)
{
    for (int round = 0; round < 1500; round++) {
        sf_rule rule = random_rule();
        uint32_t first = test_random_below(3) * 1000, layers = 1 + test_random_below(6);
        stack_random(&shape, 1 + test_random_below(100), 1 + test_random_below(12), layers);
        uint32_t bed = test_random_below(4) > 0 ? SF_BED_AUTO : first + test_random_below(layers);
        check_stack(&shape, &rule, first, bed);
    }
}

// Elements that reach far, across words and beyond the borders.
static void far_reaches(void)
{
    for (int round = 0; round < 60; round++) {
        uint64_t x = test_random_below(250), y = test_random_below(40);
        sf_rule rule = {.kind = SF_RULE_DISK, .reach_x_q24 = (1 + x) << 24, .reach_y_q24 = y << 24};
        stack_random(&shape, 1 + test_random_below(400), 1 + test_random_below(24), 3);
        // Few enough for some of the next layer to be out of reach.
        for (size_t i = 0; i < sizeof shape.solid; i++) {
            shape.solid[i] = (uint8_t)(shape.solid[i] && test_random_below(100) < 3);
        }
        check_stack(&shape, &rule, 0, SF_BED_AUTO);
    }
}

// Layers of different heights: a table of reaches, and so of elements.
static void uneven_layers(void)
{
    for (int round = 0; round < 60; round++) {
        uint64_t sums[2][8] = {{0}};
        for (int k = 1; k < 8; k++) {
            sums[0][k] = sums[0][k - 1] + (test_random() >> (38 + test_random_below(4)));
            sums[1][k] = sums[0][k];
        }
        sf_rule rule = {.kind = SF_RULE_OCTAGON, .table_count = 8, .table = &sums[0][0]};
        stack_random(&shape, 1 + test_random_below(70), 1 + test_random_below(12), 8);
        check_stack(&shape, &rule, 0, SF_BED_AUTO);
    }
}

// Rows of single voxels, one apart: the most runs that there can be.
static void combs(void)
{
    sf_rule rule = sf_rule_box3();
    for (uint32_t width = 1; width < 140; width += 23) {
        stack_random(&shape, width, 9, 5);
        for (uint32_t i = 0; i < width * 9 * 5; i++) {
            shape.solid[i] = (uint8_t)((i % width + i / (width * 9)) % 2 == 0);
        }
        check_stack(&shape, &rule, 0, SF_BED_AUTO);
    }
}

int main(void)
{
    TEST(random_stacks);
    TEST(far_reaches);
    TEST(uneven_layers);
    TEST(combs);
    return test_finish();
}
