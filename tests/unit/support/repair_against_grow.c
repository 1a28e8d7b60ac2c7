// SPDX-License-Identifier: MIT
// Why: whoever repairs must not pay more than for the plain ways, a trim and sf_grid_grow(). Guards
// that promise of <sf/repair.h> on 10^4 random grids: every kind of rule, bridges, masks, beds,
// prices; and that grow, asked for what can be kept, is never refused.

#include "unit/support/repair_oracle.h"

#include <sf/grow.h>

static job j;
static stack repaired, grown;

// The library's grow of the job; its status.
static sf_status job_grow(stack *result)
{
    sf_terms terms = sf_terms_default();
    sf_grid *grid = stack_grid(&j.shape), *masks[MASK_COUNT];
    for (int m = 0; m < MASK_COUNT; m++) {
        masks[m] = j.is_on[m] ? stack_grid(&j.masks[m]) : NULL;
    }
    terms.rule = j.rule;
    terms.bed_layer = j.bed_layer;
    terms.exempt = masks[MASK_EXEMPT];
    terms.forbid = masks[MASK_FORBID];
    terms.act = masks[MASK_ACT];
    sf_status status = sf_grid_grow(grid, &terms, NULL, NULL, NULL, NULL);
    stack_read(result, grid);
    for (int m = 0; m < MASK_COUNT; m++) {
        sf_grid_destroy(masks[m]);
    }
    sf_grid_destroy(grid);
    return status;
}

static uint64_t cost_of(const stack *after)
{
    return oracle_cost(&j.shape, after, job_costs(&j, j.add), job_costs(&j, j.remove));
}

typedef struct tally {
    int compared, equal;
    uint64_t ours, theirs;
} tally;

static void compare(tally *t)
{
    sf_repair_report r = {0};
    sf_status could = job_grow(&grown), status = job_repair(&j, &repaired, NULL, &r);
    // Grow keeps all; where it can, a repair can keep what must stay.
    CHECK(could == SF_OK || could == SF_ERR_INFEASIBLE);
    CHECK(status == SF_OK || (status == SF_ERR_INFEASIBLE && could == SF_ERR_INFEASIBLE));
    if (status != SF_OK) {
        return;
    }
    CHECK_EQ(r.cost, cost_of(&repaired));
    CHECK(r.cost <= r.trim_cost && r.cost <= r.first_cost);
    if (could == SF_OK) {
        uint64_t theirs = cost_of(&grown);
        CHECK(r.cost <= theirs);
        t->compared++;
        t->equal += r.cost == theirs;
        t->ours += r.cost;
        t->theirs += theirs;
    }
}

static void show(const tally *t)
{
    printf("# %d compared, %d at one cost, %llu against %llu\n", t->compared, t->equal,
           (unsigned long long)t->ours, (unsigned long long)t->theirs);
}

static void masks_and_beds_of_every_kind(void)
{
    tally t = {0, 0, 0, 0};
    for (int i = 0; i < 4000 && test_case_failures == 0; i++) {
        if (i % 10 == 9) {
            random_wide_job(&j, i);
        } else {
            random_job(&j, i, 7);
        }
        j.rounds = i % 7 == 0;
        compare(&t);
    }
    CHECK(t.compared > 1000);
    show(&t);
}

// Where grow is strongest: little hangs, and giving up is dear.
static void shapes_worth_keeping(void)
{
    tally t = {0, 0, 0, 0};
    for (int i = 0; i < 6000 && test_case_failures == 0; i++) {
        random_job(&j, i, 9);
        memset(j.is_on, 0, sizeof j.is_on);
        j.is_on[MASK_FORBID] = i % 4 == 0;
        stack_random(&j.shape, j.shape.nx, j.shape.ny, j.shape.nz, 0.03 + 0.03 * (i % 5));
        for (int v = 0; v < stack_count(&j.shape); v++) {
            j.add[v] = (uint8_t)(1 + test_random_below(3));
            j.remove[v] = (uint8_t)(20 + test_random_below(200));
        }
        j.has_costs = 1;
        compare(&t);
    }
    CHECK(t.compared > 4000);
    show(&t);
}

int main(void)
{
    TEST(masks_and_beds_of_every_kind);
    TEST(shapes_worth_keeping);
    return test_finish();
}
