// SPDX-License-Identifier: MIT
// Why: slack and bridges are no elements, and whoever trims, checks or edits under them must mean
// the same rule. TRUST 1-5, 16 and 63 and ALGORITHMS 1.6, 1.7, 10.5 for every rule: the trim is the
// union of all support-free subsets, found by trying them; the check counts what the oracle counts;
// the incremental trim is the whole trim; what is feasible is what some subset shows, and the
// culprits are exactly those that no subset holds.

#include "law/rules.h"

#define RULES 24

static void random_stack(stack *s, int nx, int ny, int nz)
{
    if (test_random_below(2) == 0) {
        stack_random(s, nx, ny, nz, 0.15 + 0.7 * test_random_unit());
    } else {
        stack_random_boxes(s, nx, ny, nz, 2 + (int)test_random_below(6));
    }
}

static uint32_t random_bed(int nz)
{
    return test_random_below(3) == 0 ? test_random_below((uint32_t)nz) : SF_BED_AUTO;
}

static void trim_is_the_field_of_the_oracle(void)
{
    static stack s, found;
    static field f;
    for (int i = 0; i < 3000; i++) {
        sf_rule rule = any_rule(i);
        int nx = 1 + (int)test_random_below(12), ny = 1 + (int)test_random_below(9);
        random_stack(&s, i % 50 == 0 ? nx + 60 : nx, ny, 1 + (int)test_random_below(9));
        uint32_t bed = random_bed(s.nz);
        oracle_field(&f, &s, &rule, bed, NULL);
        library_trim(&found, &s, &rule, bed);
        CHECK(stack_equal(&found, &f.alive));
    }
}

// The union of all support-free subsets of s, by trying all of them.
static void union_of_subsets(stack *all, const stack *s, const sf_rule *rule, const stack *exempt)
{
    static stack subset;
    int places[16], count = 0;
    for (int i = 0; i < stack_count(s); i++) {
        if (s->solid[i]) {
            places[count++] = i;
        }
    }
    stack_clear(all, s->nx, s->ny, s->nz);
    for (unsigned bits = 0; bits < 1u << count; bits++) {
        stack_clear(&subset, s->nx, s->ny, s->nz);
        for (int j = 0; j < count; j++) {
            subset.solid[places[j]] = bits >> j & 1;
        }
        if (oracle_is_support_free(&subset, rule, 0, exempt)) {
            stack_combine(all, all, &subset, STACK_OR);
        }
    }
}

// A stack of at most `most` voxels, in one of three shapes.
static void small_stack(stack *s, int i, int most)
{
    static const int sizes[3][3] = {{6, 1, 3}, {3, 2, 3}, {5, 2, 2}};
    do {
        const int *n = sizes[i % 3];
        stack_random(s, n[0], n[1], n[2], 0.2 + 0.5 * test_random_unit());
    } while ((int)stack_volume(s) > most);
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
        CHECK_EQ(sf_grid_trim_on(grid, &terms, NULL, NULL, NULL, NULL), SF_OK);
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
        random_stack(&s, 1 + (int)test_random_below(14), 1 + (int)test_random_below(8),
                     1 + (int)test_random_below(8));
        sf_grid *grid = stack_grid(&s);
        sf_check_options o = sf_check_options_default();
        sf_check_report report;
        size_t count;
        o.rule = rule;
        o.bed_layer = random_bed(s.nz);
        o.findings = findings;
        o.finding_capacity = sizeof findings / sizeof findings[0];
        oracle_field(&f, &s, &rule, o.bed_layer, NULL);
        CHECK_EQ(sf_grid_check(grid, &o, NULL, NULL, &report, &count), SF_OK);
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
        sf_check_report reports[3];
        o.rule = any_rule(i);
        random_stack(&s, 5 + (int)test_random_below(80), 6, 7);
        o.width = (uint32_t)s.nx;
        o.height = 6;
        sf_grid *grid = stack_grid(&s);
        for (int c = 0; c < 3; c++) {
            uintptr_t start = ((uintptr_t)memory[c] + 63) & ~(uintptr_t)63;
            unsigned char *place = (unsigned char *)memory[c] + (start - (uintptr_t)memory[c]);
            CHECK_EQ(sf_checker_place(&o, place, sizeof memory[c] - 64, &checkers[c]), SF_OK);
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
        }
        sf_grid_destroy(grid);
    }
}

static void incremental_trim_is_the_whole_trim(void)
{
    static stack drawn, kept, found;
    for (int i = 0; i < 240; i++) {
        sf_rule rule = any_rule(i);
        uint32_t bed = i % 3 == 0 ? 2 : SF_BED_AUTO;
        random_stack(&drawn, i % 10 == 0 ? 130 : 16, 12, 9);
        sf_grid *d = stack_grid(&drawn), *t = stack_grid(&drawn);
        CHECK_EQ(sf_grid_trim(t, &rule, bed, NULL, NULL), SF_OK);
        for (int j = 0; j < 12; j++) {
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
            CHECK_EQ(sf_grid_trim_box(d, t, &rule, bed, b, NULL), SF_OK);
            stack_read(&drawn, d);
            stack_read(&found, t);
            library_trim(&kept, &drawn, &rule, bed);
            CHECK(stack_equal(&found, &kept));
        }
        sf_grid_destroy(d);
        sf_grid_destroy(t);
    }
}

static void feasible_is_what_some_subset_shows(void)
{
    static stack allowed, needed, exempt, best, wrong, found;
    int infeasible = 0;
    for (int i = 0; i < 400; i++) {
        sf_terms terms = sf_terms_default();
        terms.rule = any_rule(i);
        terms.bed_layer = 0;
        small_stack(&allowed, i, 10);
        stack_random(&needed, allowed.nx, allowed.ny, allowed.nz, 0.15);
        stack_random(&exempt, allowed.nx, allowed.ny, allowed.nz, i % 2 == 0 ? 0.0 : 0.15);
        union_of_subsets(&best, &allowed, &terms.rule, &exempt);
        stack_combine(&wrong, &needed, &best, STACK_MINUS);
        sf_grid *m = stack_grid(&allowed), *p = stack_grid(&needed), *e = stack_grid(&exempt);
        sf_grid *culprits = stack_grid(&allowed);
        uint64_t count = 99;
        terms.exempt = e;
        sf_status status = sf_grid_feasible(m, p, &terms, NULL, NULL, culprits, &count);
        stack_read(&found, culprits);
        CHECK_EQ(status, stack_volume(&wrong) == 0 ? SF_OK : SF_ERR_INFEASIBLE);
        CHECK_EQ(count, stack_volume(&wrong));
        CHECK(stack_equal(&found, &wrong));
        CHECK_EQ(sf_grid_feasible(m, p, &terms, NULL, NULL, NULL, NULL), status);
        infeasible += status != SF_OK;
        sf_grid_destroy(m);
        sf_grid_destroy(p);
        sf_grid_destroy(e);
        sf_grid_destroy(culprits);
    }
    CHECK(infeasible > 20 && infeasible < 380);
}

// Trimming on terms is refused just when the trim lacks what must stay, and then changes nothing.
static void trim_on_terms_keeps_its_word(void)
{
    static stack s, keep, act, must, best, found;
    static field f;
    int refused = 0;
    for (int i = 0; i < 600; i++) {
        sf_terms terms = sf_terms_default();
        terms.rule = any_rule(i);
        random_stack(&s, 8, 5, 6);
        stack_random(&keep, 8, 5, 6, 0.02);
        stack_random(&act, 8, 5, 6, i % 3 == 0 ? 1.0 : 0.99);
        oracle_field(&f, &s, &terms.rule, SF_BED_AUTO, NULL);
        stack_combine(&must, &s, &act, STACK_MINUS);
        stack_combine(&best, &s, &keep, STACK_AND);
        stack_combine(&must, &must, &best, STACK_OR);
        stack_combine(&must, &must, &f.alive, STACK_MINUS);
        sf_grid *grid = stack_grid(&s), *k = stack_grid(&keep), *a = stack_grid(&act);
        sf_grid *culprits = stack_grid(&act);
        sf_trim_report report = {7, 7, 7};
        terms.keep = k;
        terms.act = a;
        sf_status status = sf_grid_trim_on(grid, &terms, NULL, NULL, culprits, &report);
        CHECK_EQ(status, stack_volume(&must) == 0 ? SF_OK : SF_ERR_INFEASIBLE);
        stack_read(&found, grid);
        CHECK(stack_equal(&found, status == SF_OK ? &f.alive : &s));
        CHECK_EQ(report.kept_voxels, status == SF_OK ? stack_volume(&f.alive) : 7);
        stack_read(&found, culprits);
        CHECK(stack_equal(&found, status == SF_OK ? &act : &must));
        refused += status != SF_OK;
        sf_grid_destroy(grid);
        sf_grid_destroy(k);
        sf_grid_destroy(a);
        sf_grid_destroy(culprits);
    }
    CHECK(refused > 60 && refused < 540);
}

int main(void)
{
    TEST(trim_is_the_field_of_the_oracle);
    TEST(trim_is_the_union_of_all_support_free_subsets);
    TEST(trim_is_monotone_and_idempotent);
    TEST(check_counts_what_the_oracle_counts);
    TEST(all_forms_of_a_layer_are_one);
    TEST(incremental_trim_is_the_whole_trim);
    TEST(feasible_is_what_some_subset_shows);
    TEST(trim_on_terms_keeps_its_word);
    return test_finish();
}
