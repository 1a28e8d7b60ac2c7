// SPDX-License-Identifier: MIT
// Why: masks decide what a user loses. TRUST 63 and ALGORITHMS 10.5 for every rule: what is
// feasible is what some subset shows, and the culprits are exactly those that no subset holds; a
// trim on terms is refused just when it would lose what must stay; exempt matter stays wherever it
// is.

#include "law/rules.h"

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
        sf_status status =
            sf_grid_feasible(m, p, &terms, stack_allocator(), NULL, culprits, &count);
        stack_read(&found, culprits);
        CHECK_EQ(status, stack_volume(&wrong) == 0 ? SF_OK : SF_ERR_INFEASIBLE);
        CHECK_EQ(count, stack_volume(&wrong));
        CHECK(stack_equal(&found, &wrong));
        CHECK_EQ(sf_grid_feasible(m, p, &terms, stack_allocator(), NULL, NULL, NULL), status);
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
        sf_status status =
            sf_grid_trim_on(grid, &terms, stack_allocator(), NULL, culprits, &report);
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

static void exempt_matter_stays_below_the_bed(void)
{
    static stack s, exempt, found;
    static field f;
    for (int i = 0; i < 300; i++) {
        sf_terms terms = sf_terms_default();
        terms.rule = any_rule(i);
        terms.bed_layer = 1 + test_random_below(4);
        random_stack(&s, 70, 4, 6);
        stack_random(&exempt, 70, 4, 6, 0.2);
        oracle_field(&f, &s, &terms.rule, terms.bed_layer, &exempt);
        sf_grid *grid = stack_grid(&s), *mask = stack_grid(&exempt);
        terms.exempt = mask;
        CHECK_EQ(sf_grid_trim_on(grid, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
        stack_read(&found, grid);
        CHECK(stack_equal(&found, &f.alive));
        sf_grid_destroy(grid);
        sf_grid_destroy(mask);
    }
}

// A mask is only read: it may not be where culprits go.
static void masks_are_not_written(void)
{
    static stack s;
    stack_random(&s, 8, 5, 6, 0.3);
    sf_grid *grid = stack_grid(&s), *mask = stack_grid(&s);
    for (int i = 0; i < 4; i++) {
        sf_terms terms = sf_terms_default();
        const sf_grid **masks[4] = {&terms.exempt, &terms.keep, &terms.forbid, &terms.act};
        *masks[i] = mask;
        CHECK_EQ(sf_grid_trim_on(grid, &terms, stack_allocator(), NULL, mask, NULL),
                 SF_ERR_ARGUMENT);
        CHECK_EQ(sf_grid_trim_on(mask, &terms, stack_allocator(), NULL, NULL, NULL),
                 SF_ERR_ARGUMENT);
        CHECK_EQ(sf_grid_feasible(grid, grid, &terms, stack_allocator(), NULL, mask, NULL),
                 SF_ERR_ARGUMENT);
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(mask);
}

int main(void)
{
    TEST(feasible_is_what_some_subset_shows);
    TEST(trim_on_terms_keeps_its_word);
    TEST(exempt_matter_stays_below_the_bed);
    TEST(masks_are_not_written);
    return test_finish();
}
