// SPDX-License-Identifier: MIT
// Why: the checker promises that bits, runs and grey rows of one layer give one report, that a
// stream may start at any layer of the lattice, and that a push that is refused leaves the checker
// as it was (promise P2), so that the layer can be put right and pushed again.

#include "judge.h"

static uint64_t words[STACK_VOXELS];
static sf_run runs[STACK_VOXELS];
static uint8_t pixels[STACK_VOXELS * 2];

static size_t layer_runs(const stack *s, int z)
{
    size_t count = 0;
    for (int y = 0; y < s->ny; y++) {
        for (int x = 0; x < s->nx; x++) {
            if (!stack_get(s, x, y, z)) {
                continue;
            }
            // Now and then a run is cut in two that touch; labels are ignored.
            if (x == 0 || !stack_get(s, x - 1, y, z) || test_random_below(8) == 0) {
                sf_run run = {(uint32_t)x, (uint32_t)x, (uint32_t)y, (uint32_t)test_random()};
                runs[count++] = run;
            }
            runs[count - 1].x1++;
        }
    }
    return count;
}

static size_t layer_grey(const stack *s, int z, uint8_t threshold)
{
    size_t row_bytes = (size_t)s->nx + test_random_below(5);
    for (size_t i = 0; i < row_bytes * (size_t)s->ny; i++) {
        pixels[i] = (uint8_t)test_random();
    }
    for (int y = 0; y < s->ny; y++) {
        for (int x = 0; x < s->nx; x++) {
            uint32_t value = stack_get(s, x, y, z) ? threshold + test_random_below(256u - threshold)
                                                   : test_random_below(threshold);
            pixels[(size_t)y * row_bytes + (size_t)x] = (uint8_t)value;
        }
    }
    return row_bytes;
}

// Form 0 is bits, 1 runs, 2 grey rows, 3 whatever comes.
static void push_form(pushed *p, const stack *s, const sf_check_options *o, uint32_t form)
{
    void *block;
    sf_check_options mine = *o;
    static const uint32_t rooms[4] = {0, 3, 40, 100000}; // for the runs of a layer that rests
    mine.layer_run_capacity = rooms[test_random_below(4)];
    sf_checker *checker = checker_new(&mine, &block);
    for (int z = 0; z < s->nz; z++) {
        uint32_t f = form < 3 ? form : test_random_below(3);
        if (f == 0) {
            sf_slice slice = stack_layer_bits(s, z, words, (size_t)(s->nx + 63) / 64);
            CHECK_EQ(sf_checker_push(checker, slice), SF_OK);
        } else if (f == 1) {
            size_t count = layer_runs(s, z);
            CHECK_EQ(sf_checker_push_runs(checker, count > 0 ? runs : NULL, count), SF_OK);
        } else {
            uint8_t threshold = (uint8_t)(1 + test_random_below(255));
            size_t row_bytes = layer_grey(s, z, threshold);
            CHECK_EQ(sf_checker_push_grey(checker, pixels, row_bytes, threshold), SF_OK);
        }
    }
    CHECK_EQ(sf_checker_report(checker, &p->report, &p->finding_count), SF_OK);
    free(block);
}

static void same_check(const pushed *a, const pushed *b)
{
    same_report(&a->report, &b->report);
    CHECK_EQ(a->finding_count, b->finding_count);
    for (size_t i = 0; i < a->finding_count && i < b->finding_count; i++) {
        same_finding(&a->findings[i], &b->findings[i]);
    }
}

static void bits_runs_and_grey_are_one(void)
{
    static stack s;
    static pushed bits, other;
    for (int i = 0; i < 200; i++) {
        int nx = stack_width(), ny = 1 + (int)test_random_below(9);
        if (i % 2 == 0) {
            stack_random(&s, nx, ny, 6, test_random_unit());
        } else {
            stack_random_boxes(&s, nx, ny, 6, 8);
        }
        sf_rule rule = rule_by_number(i);
        uint32_t bed = i % 5 == 0 ? test_random_below(6) : SF_BED_AUTO;
        sf_check_options o = pushed_options(&s, &rule, bed, &bits);
        push_form(&bits, &s, &o, 0);
        o.findings = other.findings;
        for (uint32_t form = 1; form < 4; form++) {
            push_form(&other, &s, &o, form);
            same_check(&bits, &other);
        }
    }
}

// Layers up to `first` hold nothing; a stream that leaves them out says the same.
static void a_stream_starts_anywhere(void)
{
    static stack s, tail;
    static pushed whole, part;
    for (int i = 0; i < 60; i++) {
        int first = 1 + (int)test_random_below(4), layer = 20 * 9;
        stack_random_boxes(&s, 20, 9, 10, 8);
        memset(s.solid, 0, (size_t)(first * layer));
        stack_clear(&tail, 20, 9, 10 - first);
        memcpy(tail.solid, s.solid + first * layer, (size_t)((10 - first) * layer));
        sf_rule rule = rule_by_number(i);
        uint32_t bed = i % 2 ? SF_BED_AUTO : (uint32_t)first + test_random_below(3);
        sf_check_options o = pushed_options(&s, &rule, bed, &whole);
        push_form(&whole, &s, &o, 0);
        o.findings = part.findings;
        o.first_layer = (uint32_t)first;
        push_form(&part, &tail, &o, 3);
        CHECK_EQ(part.report.layer_count, 10 - first);
        part.report.layer_count = 10;
        same_check(&whole, &part);
    }
}

// Pushes that are refused, put between good ones.
static void refused_pushes(sf_checker *checker, const void *block)
{
    sf_slice good = {words, 70, 4, 2}, none = good, wide = good, narrow = good, inside = good;
    none.words = NULL;
    wide.width = 71;
    narrow.stride = 1;
    inside.words = (uint64_t *)(((uintptr_t)block + 127) / 64 * 64);
    CHECK_EQ(sf_checker_push(NULL, good), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push(checker, none), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push(checker, narrow), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push(checker, inside), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push(checker, wide), SF_ERR_SHAPE);
    sf_run bad[][2] = {{{0, 0, 0, 0}, {1, 2, 0, 0}}, {{0, 71, 0, 0}, {1, 2, 1, 0}},
                       {{0, 3, 4, 0}, {4, 5, 4, 0}}, {{0, 3, 1, 0}, {2, 5, 1, 0}},
                       {{0, 3, 2, 0}, {0, 3, 1, 0}}, {{5, 6, 2, 0}, {0, 3, 2, 0}}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        CHECK_EQ(sf_checker_push_runs(checker, bad[i], 2), SF_ERR_ARGUMENT);
    }
    CHECK_EQ(sf_checker_push_runs(NULL, bad[0], 0), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push_runs(checker, NULL, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push_grey(NULL, pixels, 70, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push_grey(checker, NULL, 70, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push_grey(checker, pixels, 69, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_push_grey(checker, pixels, SIZE_MAX / 2, 1), SF_ERR_ARGUMENT);
}

static void refused_pushes_change_nothing(void)
{
    static stack s;
    static pushed plain, disturbed;
    uint64_t table[12] = {0};
    for (uint64_t k = 0; k < 6; k++) {
        table[k] = table[6 + k] = k << 24;
    }
    sf_rule rule = {.kind = SF_RULE_OCTAGON, .table_count = 6, .table = table};
    stack_random(&s, 70, 4, 6, 0.4);
    sf_check_options o = pushed_options(&s, &rule, SF_BED_AUTO, &plain);
    push_form(&plain, &s, &o, 0);
    o.findings = disturbed.findings;
    void *block;
    sf_checker *checker = checker_new(&o, &block);
    for (int z = 0; z < 6; z++) {
        refused_pushes(checker, block);
        CHECK_EQ(sf_checker_push(checker, stack_layer_bits(&s, z, words, 2)), SF_OK);
    }
    // The table knows six layers: a seventh is refused, and a report is as good as before.
    CHECK_EQ(sf_checker_push(checker, stack_layer_bits(&s, 0, words, 2)), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_report(NULL, &disturbed.report, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_report(checker, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_report(checker, &disturbed.report, &disturbed.finding_count), SF_OK);
    same_check(&plain, &disturbed);
    free(block);
}

static void the_last_layer_of_all(void)
{
    sf_check_options o = sf_check_options_default();
    o.width = o.height = 1;
    o.first_layer = SF_LAYER_MAX - 1;
    void *block;
    sf_checker *checker = checker_new(&o, &block);
    CHECK_EQ(sf_checker_push_runs(checker, NULL, 0), SF_OK);
    CHECK_EQ(sf_checker_push_runs(checker, NULL, 0), SF_ERR_OVERFLOW);
    free(block);
}

int main(void)
{
    TEST(bits_runs_and_grey_are_one);
    TEST(a_stream_starts_anywhere);
    TEST(refused_pushes_change_nothing);
    TEST(the_last_layer_of_all);
    return test_finish();
}
