// SPDX-License-Identifier: MIT
// Why: slack and bridges are no elements, and whoever trims, checks or edits under them must mean
// the same rule. TRUST 1-5 and 16 and ALGORITHMS 1.6 and 1.7 for every rule: the trim is the
// union of all support-free subsets, found by trying them; the check counts what the oracle counts;
// the incremental trim is the whole trim. What masks make of it: terms.c.

#include "law/rules.h"

static void trim_is_the_field_of_the_oracle(void)
{
    static stack s, found;
    static field f;
    for (int i = 0; i < 3000; i++) {
        sf_rule rule = any_rule(i);
        int nx = i % 10 == 0 ? stack_wide() : 1 + (int)test_random_below(12);
        random_stack(&s, nx, 1 + (int)test_random_below(9), 1 + (int)test_random_below(9));
        uint32_t bed = random_bed(s.nz);
        oracle_field(&f, &s, &rule, bed, NULL);
        library_trim(&found, &s, &rule, bed);
        CHECK(stack_equal(&found, &f.alive));
    }
}

static sf_grid *grid_or_null(const stack *s)
{
    return s != NULL ? stack_grid(s) : NULL;
}

static void trim_is_the_union_of_all_support_free_subsets(void)
{
    static stack s, exempt, best, found;
    for (int i = 0; i < 600; i++) {
        sf_rule rule = any_rule(i);
        small_stack(&s, i, 10);
        stack_random(&exempt, s.nx, s.ny, s.nz, i % 2 == 0 ? 0.0 : 0.15);
        union_of_subsets(&best, &s, &rule, &exempt);
        sf_grid *grid = stack_grid(&s), *mask = grid_or_null(&exempt);
        sf_terms terms = sf_terms_default();
        terms.rule = rule;
        terms.bed_layer = 0;
        terms.exempt = mask;
        CHECK_EQ(sf_grid_trim_on(grid, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
        stack_read(&found, grid);
        CHECK(stack_equal(&found, &best));
        sf_grid_destroy(grid);
        sf_grid_destroy(mask);
    }
}

static void trim_is_monotone_and_idempotent(void)
{
    static stack s, more, a, b, again;
    for (int i = 0; i < 1500; i++) {
        sf_rule rule = any_rule(i);
        random_stack(&s, 9, 6, 6);
        stack_random(&more, 9, 6, 6, 0.2);
        stack_combine(&more, &more, &s, STACK_OR);
        library_trim(&a, &s, &rule, 0);
        library_trim(&b, &more, &rule, 0);
        library_trim(&again, &a, &rule, 0);
        CHECK(stack_within(&a, &b));
        CHECK(stack_equal(&a, &again));
    }
}

static void check_counts_what_the_oracle_counts(void)
{
    static stack s;
    static field f;
    static sf_finding findings[4096];
    for (int i = 0; i < 2000; i++) {
        sf_rule rule = any_rule(i);
        int nx = i % 10 == 0 ? stack_wide() : 1 + (int)test_random_below(14);
        random_stack(&s, nx, 1 + (int)test_random_below(8), 1 + (int)test_random_below(8));
        sf_grid *grid = stack_grid(&s);
        sf_check_options o = sf_check_options_default();
        sf_check_report report;
        size_t count;
        o.rule = rule;
        o.bed_layer = random_bed(s.nz);
        o.findings = findings;
        o.finding_capacity = sizeof findings / sizeof findings[0];
        oracle_field(&f, &s, &rule, o.bed_layer, NULL);
        CHECK_EQ(sf_grid_check(grid, &o, stack_allocator(), NULL, &report, &count), SF_OK);
        CHECK_EQ(report.unsupported_voxels, oracle_unsupported(&s, &rule, o.bed_layer));
        CHECK_EQ(report.trimmed_voxels, stack_volume(&s) - stack_volume(&f.alive));
        uint64_t volume = report.unlinked_voxels, area = 0;
        for (size_t j = 0; j < count; j++) {
            volume += findings[j].volume;
            area += findings[j].area;
        }
        CHECK_EQ(volume, report.trimmed_voxels);
        CHECK_EQ(area, report.unsupported_voxels);
        sf_grid_destroy(grid);
    }
}

// A layer pushed as runs or as grey rows is the layer pushed as bits.
static void all_forms_of_a_layer_are_one(void)
{
    static stack s;
    static uint64_t memory[3][1 << 15];
    static uint8_t pixels[32768];
    for (int i = 0; i < 200; i++) {
        sf_check_options o = sf_check_options_default();
        sf_checker *checkers[3];
        unsigned char *ends[3];
        sf_check_report reports[3];
        o.rule = any_rule(i);
        random_stack(&s, 5 + (int)test_random_below(80), 6, 7);
        o.width = (uint32_t)s.nx;
        o.height = 6;
        sf_grid *grid = stack_grid(&s);
        size_t size = 0;
        CHECK_EQ(sf_checker_size(&o, &size), SF_OK);
        for (int c = 0; c < 3; c++) {
            // Not a byte more than it asks for, and what follows must stay as it is.
            uintptr_t start = ((uintptr_t)memory[c] + 63) & ~(uintptr_t)63;
            ends[c] = (unsigned char *)memory[c] + (start - (uintptr_t)memory[c]) + size;
            CHECK(size + 128 <= sizeof memory[c]);
            memset(ends[c], 0xa5, 64);
            CHECK_EQ(sf_checker_place(&o, ends[c] - size, size - 1, &checkers[c]), SF_ERR_CAPACITY);
            CHECK_EQ(sf_checker_place(&o, ends[c] - size, size, &checkers[c]), SF_OK);
        }
        for (uint32_t k = 0; k < 7; k++) {
            sf_slice slice = sf_grid_slice(grid, k);
            sf_run runs[600];
            size_t count;
            CHECK_EQ(sf_slice_runs(slice, runs, 600, &count), SF_OK);
            for (int j = 0; j < s.nx * 6; j++) {
                pixels[j] = s.solid[(int)k * s.nx * 6 + j] ? 200 : 20;
            }
            CHECK_EQ(sf_checker_push(checkers[0], slice), SF_OK);
            CHECK_EQ(sf_checker_push_runs(checkers[1], runs, count), SF_OK);
            CHECK_EQ(sf_checker_push_grey(checkers[2], pixels, (size_t)s.nx, 128), SF_OK);
        }
        for (int c = 0; c < 3; c++) {
            CHECK_EQ(sf_checker_report(checkers[c], &reports[c], NULL), SF_OK);
            CHECK_EQ(reports[c].unsupported_voxels, reports[0].unsupported_voxels);
            CHECK_EQ(reports[c].trimmed_voxels, reports[0].trimmed_voxels);
            for (int j = 0; j < 64; j++) {
                CHECK_EQ(ends[c][j], 0xa5);
            }
        }
        sf_grid_destroy(grid);
    }
}

// That a box is the smallest one around the voxels of a stack.
static void check_box_around(const stack *s, sf_box box)
{
    sf_grid *grid = stack_grid(s);
    sf_box bounds = sf_grid_bounds(grid);
    CHECK_EQ(box.x0, bounds.x0);
    CHECK_EQ(box.y0, bounds.y0);
    CHECK_EQ(box.z0, bounds.z0);
    CHECK_EQ(box.x1, bounds.x1);
    CHECK_EQ(box.y1, bounds.y1);
    CHECK_EQ(box.z1, bounds.z1);
    sf_grid_destroy(grid);
}

// Matter taken out of a support-free grid, which is then its own drawing.
static void incremental_trim_in_place(void)
{
    static stack drawn, kept, found;
    for (int i = 0; i < 240; i++) {
        sf_rule rule = any_rule(i);
        random_stack(&drawn, 20, 12, 9);
        sf_grid *grid = stack_grid(&drawn);
        CHECK_EQ(sf_grid_trim(grid, &rule, 0, NULL, NULL), SF_OK);
        for (int j = 0; j < 6; j++) {
            sf_box b = {
                test_random_below(20), test_random_below(12), test_random_below(9), 0, 0, 0};
            b.x1 = b.x0 + 1 + test_random_below(20 - b.x0);
            b.y1 = b.y0 + 1 + test_random_below(12 - b.y0);
            b.z1 = b.z0 + 1 + test_random_below(9 - b.z0);
            for (uint32_t z = b.z0; z < b.z1; z++) {
                sf_rect rect = {b.x0, b.y0, b.x1, b.y1};
                CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, z), rect, 0), SF_OK);
            }
            stack_read(&drawn, grid);
            CHECK_EQ(sf_grid_trim_box(grid, grid, &rule, 0, b, NULL), SF_OK);
            stack_read(&found, grid);
            library_trim(&kept, &drawn, &rule, 0);
            CHECK(stack_equal(&found, &kept));
        }
        sf_grid_destroy(grid);
    }
}

static void incremental_trim_is_the_whole_trim(void)
{
    static stack drawn, kept, found, before;
    for (int i = 0; i < 240; i++) {
        sf_rule rule = any_rule(i);
        uint32_t bed = i % 3 == 0 ? 2 : SF_BED_AUTO;
        random_stack(&drawn, i % 10 == 0 ? 130 : 16, 12, 9);
        sf_grid *d = stack_grid(&drawn), *t = stack_grid(&drawn);
        CHECK_EQ(sf_grid_trim(t, &rule, bed, NULL, NULL), SF_OK);
        for (int j = 0; j < 12; j++) {
            sf_box changed = {9, 9, 9, 9, 9, 9};
            sf_box b = {test_random_below((uint32_t)drawn.nx),
                        test_random_below(12),
                        test_random_below(9),
                        0,
                        0,
                        0};
            b.x1 = b.x0 + 1 + test_random_below((uint32_t)drawn.nx - b.x0);
            b.y1 = b.y0 + 1 + test_random_below(12 - b.y0);
            b.z1 = b.z0 + 1 + test_random_below(9 - b.z0);
            int value = (int)test_random_below(2);
            for (uint32_t z = b.z0; z < b.z1; z++) {
                sf_rect rect = {b.x0, b.y0, b.x1, b.y1};
                CHECK_EQ(sf_slice_fill(sf_grid_slice(d, z), rect, value), SF_OK);
            }
            stack_read(&before, t);
            CHECK_EQ(sf_grid_trim_box(d, t, &rule, bed, b, &changed), SF_OK);
            stack_read(&drawn, d);
            stack_read(&found, t);
            library_trim(&kept, &drawn, &rule, bed);
            CHECK(stack_equal(&found, &kept));
            stack_combine(&before, &before, &found, STACK_XOR);
            check_box_around(&before, changed);
        }
        sf_grid_destroy(d);
        sf_grid_destroy(t);
    }
}

static void dirty_padding(sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        for (uint32_t y = 0; y < slice.height && lattice.nx % 64 != 0; y++) {
            slice.words[y * slice.stride + lattice.nx / 64] |= ~UINT64_C(0) << (lattice.nx % 64);
        }
    }
}

// Bits past the width, in the shape and in a mask, change nothing, and are zero in the result.
static void padding_is_nobodys_matter(void)
{
    static stack s, exempt;
    for (int i = 0; i < 300; i++) {
        sf_terms terms = sf_terms_default();
        sf_rule rule = any_rule(i);
        terms.rule = rule;
        terms.bed_layer = random_bed(5);
        random_stack(&s, 1 + (int)test_random_below(130), 4, 5);
        stack_random(&exempt, s.nx, 4, 5, 0.1);
        sf_grid *clean = stack_grid(&s), *dirty = stack_grid(&s), *mask = stack_grid(&exempt);
        terms.exempt = i % 2 == 0 ? mask : NULL;
        CHECK_EQ(sf_grid_trim_on(clean, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
        dirty_padding(dirty);
        dirty_padding(mask);
        if (terms.exempt != NULL) {
            CHECK_EQ(sf_grid_trim_on(dirty, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
        } else {
            CHECK_EQ(sf_grid_trim(dirty, &rule, terms.bed_layer, NULL, NULL), SF_OK);
        }
        for (uint32_t k = 0; k < 5; k++) {
            sf_slice a = sf_grid_slice(clean, k), b = sf_grid_slice(dirty, k);
            for (uint32_t y = 0; y < a.height; y++) {
                size_t bytes = ((size_t)a.width + 63) / 64 * sizeof(uint64_t);
                CHECK(memcmp(a.words + y * a.stride, b.words + y * b.stride, bytes) == 0);
            }
        }
        sf_grid_destroy(clean);
        sf_grid_destroy(dirty);
        sf_grid_destroy(mask);
    }
}

static sf_task watched;
static int reports_left;

static void cancel_later(void *user, double fraction)
{
    (void)user;
    (void)fraction;
    if (--reports_left == 0) {
        sf_task_cancel(&watched);
    }
}

// A trim in place that has begun goes on; one on terms leaves the grid as it was.
static void cancel_half_way_changes_nothing(void)
{
    static stack s, whole, found;
    for (int i = 0; i < 60; i++) {
        sf_rule rule = any_rule(i);
        sf_terms terms = sf_terms_default();
        terms.rule = rule;
        random_stack(&s, 30, 6, 9);
        library_trim(&whole, &s, &rule, SF_BED_AUTO);
        sf_grid *grid = stack_grid(&s), *other = stack_grid(&s);
        watched = sf_task_default();
        watched.progress = cancel_later;
        reports_left = 3;
        CHECK_EQ(sf_grid_trim(grid, &rule, SF_BED_AUTO, &watched, NULL), SF_OK);
        stack_read(&found, grid);
        CHECK(stack_equal(&found, &whole));
        watched = sf_task_default();
        watched.progress = cancel_later;
        reports_left = 3;
        CHECK_EQ(sf_grid_trim_on(other, &terms, stack_allocator(), &watched, NULL, NULL),
                 SF_ERR_CANCELLED);
        stack_read(&found, other);
        CHECK(stack_equal(&found, &s));
        sf_grid_destroy(grid);
        sf_grid_destroy(other);
    }
}

static void rules_made_by_hand_are_refused(void)
{
    static stack s;
    stack_random(&s, 20, 5, 4, 0.5);
    sf_grid *grid = stack_grid(&s);
    for (int i = 0; i < 8; i++) {
        sf_rule rule = slack_rule(45.0, 0.1, 0.1, 0.1);
        switch (i) {
        case 0:
            rule.slack_x = 0;
            break;
        case 1:
            rule.slack_x = rule.slack_y = 1;
            break;
        case 2:
            rule.slack_cap = 255;
            break;
        case 3:
            rule.slack_cap = 0;
            break;
        case 4:
            rule.slack_y = 255;
            break;
        case 5:
            rule.slack_x = 4; // the other is many times as long
            rule.slack_y = 254;
            break;
        case 6:
            rule.reach_x_q24 = UINT64_C(200) << 24;
            break;
        default:
            rule.bridge.span_y = 40000;
            break;
        }
        CHECK_EQ(sf_grid_trim(grid, &rule, 0, NULL, NULL), SF_ERR_ARGUMENT);
    }
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(trim_is_the_field_of_the_oracle);
    TEST(trim_is_the_union_of_all_support_free_subsets);
    TEST(trim_is_monotone_and_idempotent);
    TEST(check_counts_what_the_oracle_counts);
    TEST(all_forms_of_a_layer_are_one);
    TEST(incremental_trim_is_the_whole_trim);
    TEST(incremental_trim_in_place);
    TEST(padding_is_nobodys_matter);
    TEST(cancel_half_way_changes_nothing);
    TEST(rules_made_by_hand_are_refused);
    return test_finish();
}
