// SPDX-License-Identifier: MIT
// Why: a printer's chip gives the checker little memory. Counts must be exact all the same; a short
// array must hold the first findings and the report must say what is missing: volumes and unlinked
// voxels together are what trimming takes. The memory asked for must be enough, and one byte less
// refused (promise P3).

#include "judge.h"

static void random_shape(stack *s, int i)
{
    int nx = stack_width(), ny = 1 + (int)test_random_below(12);
    if (i % 2 == 0) {
        stack_random(s, nx, ny, 7, test_random_unit());
    } else {
        stack_random_boxes(s, nx, ny, 7, 9);
    }
}

static void sums_are_kept(const pushed *p)
{
    uint64_t sum = p->report.unlinked_voxels;
    for (size_t i = 0; i < p->finding_count; i++) {
        sum += p->findings[i].volume;
    }
    CHECK_EQ(sum, p->report.trimmed_voxels);
    CHECK_EQ(p->finding_count + p->report.findings_dropped,
             p->report.island_count + p->report.overhang_count);
}

// Counts that never depend on what fits.
static void counts_are_exact(const sf_check_report *a, const sf_check_report *b)
{
    sf_check_report left = *a, right = *b;
    left.findings_dropped = right.findings_dropped = 0;
    left.runs_dropped = right.runs_dropped = 0;
    left.unlinked_voxels = right.unlinked_voxels = 0;
    same_report(&left, &right);
}

static void a_short_array_is_a_prefix(void)
{
    static stack s;
    static pushed whole, part;
    for (int i = 0; i < 150; i++) {
        random_shape(&s, i);
        sf_rule rule = rule_by_number(i);
        sf_check_options o = pushed_options(&s, &rule, SF_BED_AUTO, &whole);
        push_stack(&whole, &s, &o);
        sums_are_kept(&whole);
        CHECK_EQ(whole.report.unlinked_voxels, 0);
        o.findings = part.findings;
        o.finding_capacity = test_random_below((uint32_t)whole.finding_count + 1);
        push_stack(&part, &s, &o);
        sums_are_kept(&part);
        counts_are_exact(&whole.report, &part.report);
        CHECK_EQ(part.finding_count, o.finding_capacity);
        CHECK_EQ(part.report.runs_dropped, 0);
        for (size_t k = 0; k < part.finding_count; k++) {
            same_finding(&part.findings[k], &whole.findings[k]);
        }
    }
}

static void few_runs(void)
{
    static stack s;
    static pushed whole, part;
    for (int i = 0; i < 150; i++) {
        random_shape(&s, i);
        sf_rule rule = rule_by_number(i);
        sf_check_options o = pushed_options(&s, &rule, SF_BED_AUTO, &whole);
        push_stack(&whole, &s, &o);
        o.findings = part.findings;
        o.run_capacity = i % 3 == 0 ? 0 : test_random_below(20);
        push_stack(&part, &s, &o);
        sums_are_kept(&part);
        counts_are_exact(&whole.report, &part.report);
        CHECK_EQ(part.finding_count, whole.finding_count);
        for (size_t k = 0; k < part.finding_count; k++) {
            const sf_finding *a = &part.findings[k], *b = &whole.findings[k];
            CHECK(a->kind == b->kind && a->layer == b->layer && a->area == b->area);
            CHECK(a->volume >= a->area);
            CHECK(part.report.runs_dropped > 0 || a->volume == b->volume);
            CHECK(o.run_capacity > 0 || (a->volume == a->area && a->cause == SF_FINDING_ROOT));
        }
    }
}

static void no_findings_at_all(void)
{
    static stack s;
    static pushed whole, part;
    for (int i = 0; i < 40; i++) {
        random_shape(&s, i);
        sf_rule rule = rule_by_number(i);
        sf_check_options o = pushed_options(&s, &rule, SF_BED_AUTO, &whole);
        push_stack(&whole, &s, &o);
        o.findings = NULL;
        o.finding_capacity = 0;
        push_stack(&part, &s, &o);
        sums_are_kept(&part);
        counts_are_exact(&whole.report, &part.report);
        CHECK_EQ(part.report.unlinked_voxels, part.report.trimmed_voxels);
        CHECK_EQ(part.report.runs_dropped, 0);
    }
}

// Bytes behind the size that was asked for stay as they are.
static void memory_is_exact(void)
{
    for (uint32_t width = 1; width < 200; width += 13) {
        static sf_finding findings[4];
        sf_check_options o = sf_check_options_default();
        o.width = width;
        o.height = 5;
        o.run_capacity = width % 3;
        o.findings = findings;
        o.finding_capacity = 4;
        size_t size = 0;
        sf_checker *checker = NULL;
        CHECK_EQ(sf_checker_size(&o, &size), SF_OK);
        unsigned char *block = malloc(size + 128);
        memset(block, 0xa5, size + 128);
        unsigned char *memory = block + (64 - (uintptr_t)block % 64) % 64;
        CHECK_EQ(sf_checker_place(&o, memory, size - 1, &checker), SF_ERR_CAPACITY);
        CHECK_EQ(sf_checker_place(&o, memory + 1, size, &checker), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_checker_place(&o, NULL, size, &checker), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_checker_place(&o, memory, size, NULL), SF_ERR_ARGUMENT);
        CHECK(checker == NULL);
        CHECK_EQ(sf_checker_place(&o, memory, size, &checker), SF_OK);
        for (uint32_t z = 0; z < 4; z++) {
            uint64_t bits[20];
            for (int i = 0; i < 20; i++) {
                bits[i] = test_random();
            }
            sf_slice layer = {bits, width, 5, 4};
            CHECK_EQ(sf_checker_push(checker, layer), SF_OK);
        }
        for (int i = 0; i < 64; i++) {
            CHECK_EQ(memory[size + (size_t)i], 0xa5);
        }
        free(block);
    }
}

static void bad_options(void)
{
    sf_finding finding;
    sf_check_options good = sf_check_options_default(), o;
    size_t size = 77;
    good.width = good.height = 4;
    good.first_layer = 3;
    good.findings = &finding;
    good.finding_capacity = 1;
    CHECK_EQ(sf_checker_size(NULL, &size), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_checker_size(&good, NULL), SF_ERR_ARGUMENT);
#define REFUSED(change, status)                                                                    \
    do {                                                                                           \
        o = good;                                                                                  \
        change;                                                                                    \
        CHECK_EQ(sf_checker_size(&o, &size), status);                                              \
        CHECK_EQ(size, 77);                                                                        \
    } while (0)
    REFUSED(o.struct_size = 8, SF_ERR_ARGUMENT);
    REFUSED(o.width = 0, SF_ERR_ARGUMENT);
    REFUSED(o.height = SF_EXTENT_MAX + 1, SF_ERR_ARGUMENT);
    REFUSED(o.bed_layer = 2, SF_ERR_ARGUMENT);
    REFUSED(o.bed_layer = SF_LAYER_MAX, SF_ERR_ARGUMENT);
    REFUSED(o.first_layer = SF_LAYER_MAX, SF_ERR_ARGUMENT);
    REFUSED(o.findings = NULL, SF_ERR_ARGUMENT);
    REFUSED(o.rule.kind = (sf_rule_kind)9, SF_ERR_ARGUMENT);
    REFUSED(o.run_capacity = UINT32_MAX, SF_ERR_OVERFLOW);
    REFUSED(o.finding_capacity = SIZE_MAX, SF_ERR_OVERFLOW);
    CHECK_EQ(sf_checker_size(&good, &size), SF_OK);
}

int main(void)
{
    TEST(a_short_array_is_a_prefix);
    TEST(few_runs);
    TEST(no_findings_at_all);
    TEST(memory_is_exact);
    TEST(bad_options);
    return test_finish();
}
