// SPDX-License-Identifier: MIT
// Why: a job's file says anything at all, and so may a program. What a decoder hands over is
// doubted, a layer of too many runs is refused with a clear status and may be given again, a dense
// checker whose layer broke off says so until it is made new, and no argument whatever writes a
// byte.

#include "stacks.h"

static uint64_t memory[4096];
static uint8_t table_bytes[1024];
static stack shape;
static judgement right;

static sf_chip *place(const sf_chip_options *o)
{
    sf_chip *chip = NULL;
    CHECK_EQ(sf_chip_place(o, memory, sizeof memory, &chip), SF_OK);
    return chip;
}

static sf_chip_options options_of(uint32_t run_capacity)
{
    sf_chip_options o = sf_chip_options_default();
    o.width = 40;
    o.height = 3;
    o.run_capacity = run_capacity;
    return o;
}

// One row as a list of runs, which may be any numbers; and what the decoder says at the end.
typedef struct row_list {
    uint32_t runs[4][2];
    uint32_t count;
    sf_status says, expected;
} row_list;

static sf_status decode_list(void *user, sf_chip *chip, uint32_t layer, uint32_t y)
{
    row_list *list = user;
    sf_status last = SF_OK;
    (void)layer;
    for (uint32_t i = 0; y == 1 && i < list->count; i++) {
        last = sf_chip_solid(chip, list->runs[i][0], list->runs[i][1]);
    }
    if (y == 1) {
        CHECK_EQ(last, list->expected);
    }
    return list->says; // whatever it was told
}

static void bad_runs(void)
{
    row_list lists[] = {
        {{{5, 5}}, 1, SF_OK, SF_ERR_ARGUMENT},
        {{{6, 5}}, 1, SF_OK, SF_ERR_ARGUMENT},
        {{{0, 41}}, 1, SF_OK, SF_ERR_ARGUMENT},
        {{{40, 41}}, 1, SF_OK, SF_ERR_ARGUMENT},
        {{{0, 0xffffffffu}}, 1, SF_OK, SF_ERR_ARGUMENT},
        {{{0xffffffffu, 0}}, 1, SF_OK, SF_ERR_ARGUMENT},
        {{{5, 9}, {8, 12}}, 2, SF_OK, SF_ERR_ARGUMENT},
        {{{5, 9}, {1, 2}}, 2, SF_OK, SF_ERR_ARGUMENT},
        {{{5, 9}, {1, 2}, {20, 21}}, 3, SF_OK, SF_ERR_ARGUMENT}, // the first fault stays
        {{{5, 9}, {9, 12}, {39, 40}}, 3, SF_OK, SF_OK},
    };
    for (int i = 0; i < 10; i++) {
        for (uint32_t capacity = 0; capacity < 10; capacity += 5) {
            sf_chip_options o = options_of(capacity);
            sf_chip *chip = place(&o);
            CHECK_EQ(sf_chip_push(chip, decode_list, &lists[i]), lists[i].expected);
            sf_chip_counts counts;
            CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
            CHECK_EQ(counts.layer_count, lists[i].expected == SF_OK);
            CHECK_EQ(counts.solid_voxels, lists[i].expected == SF_OK ? 8 : 0);
        }
    }
}

static void too_many_runs(void)
{
    sf_chip_options o = options_of(2);
    sf_chip *chip = place(&o);
    row_list fits = {{{1, 2}, {2, 3}, {5, 6}}, 3, SF_OK, SF_OK}; // two of them touch
    row_list does_not = {{{1, 2}, {3, 4}, {5, 6}}, 3, SF_OK, SF_ERR_CAPACITY};
    row_list none = {{{0, 0}}, 0, SF_OK, SF_OK};
    sf_chip_counts before, after;
    CHECK_EQ(sf_chip_push(chip, decode_list, &fits), SF_OK);
    CHECK_EQ(sf_chip_report(chip, &before), SF_OK);
    CHECK_EQ(sf_chip_push(chip, decode_list, &does_not), SF_ERR_CAPACITY);
    CHECK_EQ(sf_chip_report(chip, &after), SF_OK);
    check_counts(&before, &after);
    // The layer below is whole: the same one rests on it, and nothing is left of what was refused.
    CHECK_EQ(sf_chip_push(chip, decode_list, &fits), SF_OK);
    CHECK_EQ(sf_chip_report(chip, &after), SF_OK);
    CHECK_EQ(after.unsupported_voxels, 0);
    CHECK_EQ(sf_chip_push(chip, decode_list, &none), SF_OK);
    CHECK_EQ(sf_chip_push(chip, decode_list, &fits), SF_OK);
    CHECK_EQ(sf_chip_report(chip, &after), SF_OK);
    CHECK_EQ(after.unsupported_voxels, 3);
    CHECK_EQ(after.unsupported_runs, 2);
}

// Decoding fails at every row: a run-length checker goes on with the layer given again, a dense one
// is done for, and neither has counted anything.
static void broken_layers(void)
{
    sf_rule rule = sf_rule_box3();
    stack_random(&shape, 40, 3, 4);
    stack_judge(&shape, &rule, 0, SF_BED_AUTO, &right);
    for (int fails_at = 0; fails_at < 12; fails_at++) {
        for (uint32_t capacity = 0; capacity <= 60; capacity += 60) {
            sf_chip_options o = options_of(capacity);
            sf_chip *chip = place(&o);
            sf_chip_counts counts;
            shape.rows_decoded = 0;
            shape.fails_at = fails_at;
            uint32_t layers = 0;
            while (layers < 4 && sf_chip_push(chip, stack_decode, &shape) == SF_OK) {
                layers++;
            }
            CHECK_EQ(layers, fails_at / 3);
            CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
            CHECK_EQ(counts.layer_count, layers);
            if (capacity == 0) {
                CHECK_EQ(sf_chip_push(chip, stack_decode, &shape), SF_ERR_IO);
                continue;
            }
            for (; layers < 4; layers++) {
                CHECK_EQ(sf_chip_push(chip, stack_decode, &shape), SF_OK);
            }
            CHECK_EQ(sf_chip_report(chip, &counts), SF_OK);
            check_counts(&counts, &right.counts);
        }
    }
}

static sf_status decode_meddling(void *user, sf_chip *chip, uint32_t layer, uint32_t y)
{
    sf_chip_store *store = user;
    (void)layer;
    (void)y;
    CHECK_EQ(sf_chip_push(chip, decode_meddling, user), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_save(chip, store), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_resume(chip, store), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_solid(chip, 3, 5), SF_OK);
    CHECK_EQ(sf_chip_grey(chip, 41, NULL, 0, 1), SF_ERR_ARGUMENT);
    return SF_OK;
}

static sf_status decode_grey(void *user, sf_chip *chip, uint32_t layer, uint32_t y)
{
    const uint32_t *asked = user;
    static const uint8_t pixels[64];
    (void)layer;
    (void)y;
    sf_status status = sf_chip_grey(chip, asked[0], asked[2] ? pixels : NULL, asked[1], 0);
    return status;
}

static sf_status no_write(void *user, uint32_t offset, const void *data, size_t size)
{
    (void)user, (void)offset, (void)data, (void)size;
    return SF_ERR_IO;
}

static sf_status no_read(void *user, uint32_t offset, void *data, size_t size)
{
    (void)user, (void)offset, (void)data, (void)size;
    return SF_ERR_IO;
}

static void misuse(void)
{
    sf_chip_options o = options_of(20);
    sf_chip *chip = place(&o);
    sf_chip_store store = {no_read, no_write, NULL, 4096};
    CHECK_EQ(sf_chip_solid(chip, 0, 1), SF_ERR_ARGUMENT); // nobody decodes
    CHECK_EQ(sf_chip_grey(chip, 0, NULL, 0, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_solid(NULL, 0, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_grey(NULL, 0, NULL, 0, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_push(chip, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_push(NULL, decode_meddling, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_push(chip, decode_meddling, &store), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_report(chip, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_report(NULL, NULL), SF_ERR_ARGUMENT);
    // x, count, whether there are pixels.
    uint32_t greys[][3] = {{0, 41, 1}, {1, 40, 1}, {41, 0, 1}, {0, 1, 0}, {0xffffffffu, 2, 1}};
    for (int i = 0; i < 5; i++) {
        CHECK_EQ(sf_chip_push(chip, decode_grey, greys[i]), SF_ERR_ARGUMENT);
    }
    uint32_t good[3] = {0, 40, 1};
    CHECK_EQ(sf_chip_push(chip, decode_grey, good), SF_OK);
}

// Every option that is none is refused, and nothing is written then.
static void bad_options(void)
{
    static const uint8_t too_far[3] = {2, 1, 1}, growing[3] = {1, 0, 1}, steps[2] = {0, 1};
    memset(memory, 0x5a, sizeof memory);
    for (int i = 0; i < 16; i++) {
        sf_chip_options o = options_of(0);
        o.struct_size -= i == 0;
        o.width = i == 1 ? 0 : i == 2 ? SF_EXTENT_MAX + 1 : o.width;
        o.height = i == 3 ? 0 : i == 4 ? SF_EXTENT_MAX + 1 : o.height;
        o.first_layer = i == 5 ? SF_LAYER_MAX : i == 6 ? 5 : 0;
        o.bed_layer = i == 6 ? 4 : i == 7 ? SF_LAYER_MAX : SF_BED_AUTO;
        o.finding_capacity = i == 8;
        o.rule.elements = i == 9 ? NULL : i == 10 ? too_far : i == 11 ? growing : o.rule.elements;
        o.rule.element_count = (uint8_t)(i != 12);
        o.rule.step_count = i == 13 ? 1 : i == 14 ? 2 : 0;
        o.rule.steps = i == 14 ? steps : NULL;
        size_t size = 99;
        sf_chip *chip = NULL;
        sf_status expected = i == 15 ? SF_ERR_CAPACITY : SF_ERR_ARGUMENT;
        if (i < 15) {
            CHECK_EQ(sf_chip_size(&o, &size), SF_ERR_ARGUMENT);
            CHECK_EQ(size, 99);
        }
        size_t short_of = 384 + 2 * 4 * (3 + 3) - 1;
        CHECK_EQ(sf_chip_place(&o, memory, i == 15 ? short_of : sizeof memory, &chip), expected);
        CHECK(chip == NULL);
    }
    sf_chip_options o = options_of(0);
    sf_chip *chip = NULL;
    size_t size;
    CHECK_EQ(sf_chip_size(NULL, &size), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_size(&o, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_place(&o, (char *)memory + 4, sizeof memory - 4, &chip), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_place(&o, NULL, sizeof memory, &chip), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_place(&o, memory, sizeof memory, NULL), SF_ERR_ARGUMENT);
    for (size_t i = 0; i < sizeof memory / 8; i++) {
        CHECK(memory[i] == UINT64_C(0x5a5a5a5a5a5a5a5a));
    }
}

// What the header says of sizes is what they are.
static void sizes(void)
{
    for (int round = 0; round < 200; round++) {
        sf_rule rule = {.kind = SF_RULE_DISK};
        uint32_t reach = 1 + test_random_below(255);
        rule.reach_x_q24 = rule.reach_y_q24 = (uint64_t)reach << 24;
        sf_chip_options o = sf_chip_options_default();
        size_t used, size;
        CHECK_EQ(sf_chip_rule_make(&rule, 0, 9, table_bytes, sizeof table_bytes, &used, &o.rule),
                 SF_OK);
        CHECK_EQ(used, reach + 2);
        o.width = 1 + test_random_below(SF_EXTENT_MAX);
        o.height = 1 + test_random_below(SF_EXTENT_MAX);
        CHECK_EQ(sf_chip_size(&o, &size), SF_OK);
        CHECK_EQ(size, 384 + (o.width + 31) / 32 * 4 * (uint64_t)(o.height + reach + 2));
        o.run_capacity = 1 + test_random_below(100000);
        CHECK_EQ(sf_chip_size(&o, &size), SF_OK);
        CHECK_EQ(size, 400 + 12 * (uint64_t)o.run_capacity + 16 * (uint64_t)reach);
    }
}

// Tables: what no table can hold, too little room, layers that a table does not serve.
static void tables(void)
{
    sf_rule octagon = {.kind = SF_RULE_OCTAGON, .reach_x_q24 = 12345678, .reach_y_q24 = 12345678};
    sf_rule slack = {.kind = SF_RULE_SLACK, .reach_x_q24 = 1 << 24, .reach_y_q24 = 1 << 24};
    slack.slack_x = slack.slack_y = 64;
    slack.slack_cap = 143;
    sf_rule bridged = sf_rule_box3();
    bridged.bridge.span_x = 5;
    sf_chip_rule table = {0};
    size_t size = 0;
    CHECK_EQ(sf_chip_rule_make(&slack, 0, 5, table_bytes, 1024, &size, &table), SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_chip_rule_make(&bridged, 0, 5, table_bytes, 1024, &size, &table),
             SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_chip_rule_make(NULL, 0, 5, table_bytes, 1024, &size, &table), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_rule_make(&octagon, 0, 0, table_bytes, 1024, &size, &table), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_rule_make(&octagon, 0, 5, NULL, 1024, &size, &table), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_rule_make(&octagon, 0, 5, table_bytes, 1024, NULL, &table), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_chip_rule_make(&octagon, 0, 5, table_bytes, 1024, &size, NULL), SF_ERR_ARGUMENT);
    CHECK(table.elements == NULL);
    CHECK_EQ(sf_chip_rule_make(&octagon, 0, 200, NULL, 0, &size, &table), SF_ERR_CAPACITY);
    CHECK(size > 199);
    CHECK_EQ(sf_chip_rule_make(&octagon, 0, 200, table_bytes, size, &size, &table), SF_OK);
    for (size_t less = 0; less < size; less++) {
        size_t again = 0;
        sf_chip_rule other = {0};
        CHECK_EQ(sf_chip_rule_make(&octagon, 0, 200, table_bytes, less, &again, &other),
                 SF_ERR_CAPACITY);
        CHECK(again >= size);
        CHECK(other.elements == NULL);
    }
    // 300 steps of 300 reaches.
    static uint64_t sums[301];
    sf_rule uneven = {.kind = SF_RULE_OCTAGON, .table_count = 301, .table = sums};
    static uint8_t large[80000];
    for (uint32_t k = 1; k < 301; k++) {
        sums[k] = sums[k - 1] + ((uint64_t)(k < 250 ? k : 1) << 24);
    }
    CHECK_EQ(sf_chip_rule_make(&uneven, 0, 301, large, sizeof large, &size, &table), SF_OK);
    CHECK(table.element_count > 200);
    // A table of five layers does not serve a sixth, and none of the lattice's before it.
    sf_chip_options o = options_of(20);
    CHECK_EQ(sf_chip_rule_make(&octagon, 3, 5, table_bytes, 1024, &size, &o.rule), SF_OK);
    row_list none = {{{0, 0}}, 0, SF_OK, SF_OK};
    o.first_layer = 3;
    sf_chip *chip = place(&o);
    for (int z = 0; z < 5; z++) {
        CHECK_EQ(sf_chip_push(chip, decode_list, &none), SF_OK);
    }
    CHECK_EQ(sf_chip_push(chip, decode_list, &none), SF_ERR_ARGUMENT);
    o.first_layer = 2;
    chip = place(&o);
    CHECK_EQ(sf_chip_push(chip, decode_list, &none), SF_OK);
    CHECK_EQ(sf_chip_push(chip, decode_list, &none), SF_ERR_ARGUMENT);
    o.first_layer = SF_LAYER_MAX - 1;
    o.rule = sf_chip_options_default().rule;
    chip = place(&o);
    CHECK_EQ(sf_chip_push(chip, decode_list, &none), SF_OK);
    CHECK_EQ(sf_chip_push(chip, decode_list, &none), SF_ERR_OVERFLOW);
}

int main(void)
{
    TEST(bad_runs);
    TEST(too_many_runs);
    TEST(broken_layers);
    TEST(misuse);
    TEST(bad_options);
    TEST(sizes);
    TEST(tables);
    return test_finish();
}
