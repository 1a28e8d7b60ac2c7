// SPDX-License-Identifier: MIT
// Why: repair changes a user's shape, so what it promises must hold whatever it is given: the
// result is support-free, keeps what must stay, adds only where it may, costs no more than a trim
// or than keeping everything, and names exactly what cannot be had (TRUST 63). Held against an
// oracle that works voxel by voxel, over every kind of rule, with bridges, masks and costs.

#include "unit/support/repair_oracle.h"

static job j;
static stack must, allowed, possible, result, culprits, expected, again;

// A grow of the plainest kind: each voxel that nothing carries, from the top down, gets one voxel
// below it, the cheapest that is possible there. Only for rules that are elements.
static void grow_one_by_one(stack *grown)
{
    int bed = stack_bed(&j.shape, j.bed_layer);
    *grown = j.shape;
    stack_combine(grown, grown, &possible, STACK_AND);
    for (int z = grown->nz - 1; z > bed; z--) {
        sf_element e = stack_step(&j.rule, z - 1);
        for (int i = 0; i < grown->nx * grown->ny; i++) {
            int x = i % grown->nx, y = i / grown->nx, best = -1, least = 1000;
            if (!stack_get(grown, x, y, z) || stack_carried(grown, x, y, z, &e) ||
                (j.is_on[MASK_EXEMPT] && stack_get(&j.masks[MASK_EXEMPT], x, y, z))) {
                continue;
            }
            for (int u = 0; u < grown->nx * grown->ny; u++) {
                int dx = u % grown->nx - x, dy = u / grown->nx - y;
                int at = (z - 1) * grown->nx * grown->ny + u;
                int cost = j.has_costs ? j.add[at] : 1;
                if (element_has(&e, dx, dy) && possible.solid[at] && cost < least) {
                    best = at;
                    least = cost;
                }
            }
            CHECK(best >= 0);
            grown->solid[best >= 0 ? best : 0] = 1;
        }
    }
}

static void no_dearer_than(const stack *other, uint64_t cost, const char *what)
{
    uint64_t theirs = oracle_cost(&j.shape, other, job_costs(&j, j.add), job_costs(&j, j.remove));
    if (cost > theirs) {
        printf("# dearer than %s: %llu > %llu\n", what, (unsigned long long)cost,
               (unsigned long long)theirs);
    }
    CHECK(cost <= theirs);
}

// Everything that a result promises.
static void check_result(const sf_repair_report *r)
{
    const stack *exempt = job_mask(&j, MASK_EXEMPT);
    int bed = stack_bed(&j.shape, j.bed_layer);
    oracle_trim(&expected, &result, &j.rule, bed, exempt);
    CHECK(stack_equal(&expected, &result));
    CHECK(stack_within(&must, &result));
    CHECK(stack_within(&result, &allowed));
    uint64_t cost = oracle_cost(&j.shape, &result, job_costs(&j, j.add), job_costs(&j, j.remove));
    CHECK_EQ(r->cost, cost);
    CHECK(r->cost <= r->first_cost);
    oracle_trim(&expected, &j.shape, &j.rule, bed, exempt);
    if (stack_within(&must, &expected)) {
        no_dearer_than(&expected, cost, "trim");
        CHECK_EQ(r->trim_cost,
                 oracle_cost(&j.shape, &expected, job_costs(&j, j.add), job_costs(&j, j.remove)));
    } else {
        CHECK(r->trim_cost == SF_REPAIR_NO_COST);
    }
    if (r->grow_cost != SF_REPAIR_NO_COST) {
        CHECK(r->cost <= r->grow_cost);
    }
    CHECK_EQ(r->bed_layer, bed == j.shape.nz ? SF_BED_AUTO : (uint32_t)bed);
}

// P without the trim of what is allowed: whether there is any, and that the library names just it.
static void check_job(int number)
{
    sf_repair_report r = {0};
    job_sets(&j, &must, &allowed);
    oracle_trim(&possible, &allowed, &j.rule, stack_bed(&j.shape, j.bed_layer),
                job_mask(&j, MASK_EXEMPT));
    stack_combine(&expected, &must, &possible, STACK_MINUS);
    int is_possible = stack_volume(&expected) == 0;
    sf_status status = job_repair(&j, &result, &culprits, &r);
    CHECK_EQ(status, is_possible ? SF_OK : SF_ERR_INFEASIBLE);
    if (!is_possible) {
        CHECK(stack_equal(&culprits, &expected));
        CHECK(stack_equal(&result, &j.shape));
        CHECK_EQ(r.culprit_count, stack_volume(&expected));
    } else if (status == SF_OK) {
        CHECK(stack_equal(&culprits, &j.shape)); // as it was
        check_result(&r);
    }
    if (test_case_failures > 0) {
        printf("# job %d, rule %s\n", number, sf_rule_kind_name(j.rule.kind));
    }
}

static void keeps_its_promises_on_random_jobs(void)
{
    for (int i = 0; i < 12000 && test_case_failures == 0; i++) {
        random_job(&j, i, 6);
        check_job(i);
    }
}

static void keeps_them_on_larger_jobs(void)
{
    for (int i = 0; i < 200 && test_case_failures == 0; i++) {
        random_job(&j, i, 14);
        check_job(i);
    }
}

static void keeps_them_on_rows_of_several_words(void)
{
    for (int i = 0; i < 900 && test_case_failures == 0; i++) {
        random_wide_job(&j, i);
        j.width = i % 5 == 0 ? 2 : 1;
        check_job(i);
    }
}

static void keeps_them_with_struts(void)
{
    for (int i = 0; i < 2000 && test_case_failures == 0; i++) {
        random_job(&j, i, 8);
        j.width = 2 + test_random_below(3);
        check_job(i);
    }
}

static void keeps_them_at_the_first_result(void)
{
    for (int i = 0; i < 1000 && test_case_failures == 0; i++) {
        random_job(&j, i, 6);
        j.rounds = i % 2 == 0 ? SF_REPAIR_FIRST : 1;
        check_job(i);
    }
}

// No mask that could make it impossible, and a rule that is an element. One lucky grow in a few
// hundred beats the repair by a voxel or two; on the whole they cost a quarter more.
static void costs_far_less_than_a_plain_grow(void)
{
    uint64_t ours = 0, theirs = 0;
    int beaten = 0;
    for (int i = 0; i < 3000; i++) {
        sf_repair_report r = {0};
        random_job(&j, i, 7);
        j.rule = rule_by_number(i);
        j.is_on[MASK_KEEP] = j.is_on[MASK_ACT] = 0;
        job_sets(&j, &must, &allowed);
        oracle_trim(&possible, &allowed, &j.rule, stack_bed(&j.shape, j.bed_layer),
                    job_mask(&j, MASK_EXEMPT));
        CHECK_EQ(job_repair(&j, &result, NULL, &r), SF_OK);
        grow_one_by_one(&again);
        uint64_t grown =
            oracle_cost(&j.shape, &again, job_costs(&j, j.add), job_costs(&j, j.remove));
        ours += r.cost;
        theirs += grown;
        beaten += r.cost > grown;
    }
    printf("# %llu against %llu, beaten %d times\n", (unsigned long long)ours,
           (unsigned long long)theirs, beaten);
    CHECK(beaten <= 30);
    CHECK(ours * 6 <= theirs * 5);
}

// A repair that may give up has all the choices of one that may not. With a least width the other
// may be cheaper under slack: where no struts carry what must stay, its hairs remain.
static void costs_no_more_than_one_that_only_adds(void)
{
    int compared = 0, equal = 0;
    for (int i = 0; i < 5000 && test_case_failures == 0; i++) {
        sf_repair_report plain = {0}, adding = {0};
        if (i % 10 == 0) {
            random_wide_job(&j, i);
        } else {
            random_job(&j, i, i % 10 == 5 ? 11 : 7);
        }
        j.rounds = i % 7 == 0;
        j.width = i % 6 == 0 && j.rule.kind != SF_RULE_SLACK ? 2 : 1;
        sf_status status = job_repair(&j, &result, NULL, &plain);
        j.is_on[MASK_KEEP] = 1;
        j.masks[MASK_KEEP] = j.shape;
        if (job_repair(&j, &again, NULL, &adding) != SF_OK) {
            continue;
        }
        CHECK_EQ(status, SF_OK);
        CHECK(stack_within(&j.shape, &again));
        CHECK(plain.cost <= adding.cost);
        if (test_case_failures > 0) {
            printf("# job %d, rule %s, width %u\n", i, sf_rule_kind_name(j.rule.kind), j.width);
        }
        compared++;
        equal += plain.cost == adding.cost;
    }
    printf("# %d compared, %d at one cost\n", compared, equal);
    CHECK(compared > 2000);
}

static void leaves_a_repaired_shape_alone(void)
{
    for (int i = 0; i < 2000 && test_case_failures == 0; i++) {
        sf_repair_report r = {0};
        random_job(&j, i, 6);
        if (job_repair(&j, &result, NULL, &r) != SF_OK) {
            continue;
        }
        // The bed does not move with the shape's first layer, where that was given up.
        j.bed_layer = r.bed_layer;
        j.shape = result;
        CHECK_EQ(job_repair(&j, &again, NULL, &r), SF_OK);
        CHECK(stack_equal(&again, &result));
        CHECK_EQ(r.cost, 0);
    }
}

static void knows_the_cost_of_hand_made_shapes(void)
{
    // A voxel two layers above the bed: removing it costs 1, a pillar 1 where it is one voxel high.
    static const struct {
        const char *shape;
        uint64_t cost;
    } cases[] = {{"#|#|#", 0},
                 {"#..|...|..#", 1},                 // give it up, or carry it by one
                 {"###|...|###", 1},                 // one voxel carries three
                 {"#.....|......|......|...###", 3}, // a pillar from the bed, or give it up
                 {"......|......|......|...###", 0}, // it is the bed
                 {"#|.|#", 1}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        sf_repair_report r = {0};
        memset(j.is_on, 0, sizeof j.is_on);
        stack_parse(&j.shape, cases[i].shape);
        j.has_costs = 0;
        j.rule = sf_rule_box3();
        j.bed_layer = SF_BED_AUTO;
        j.width = 1;
        j.rounds = 0;
        CHECK_EQ(job_repair(&j, &result, NULL, &r), SF_OK);
        CHECK_EQ(r.cost, cases[i].cost);
    }
}

int main(void)
{
    TEST(knows_the_cost_of_hand_made_shapes);
    TEST(keeps_its_promises_on_random_jobs);
    TEST(keeps_them_on_larger_jobs);
    TEST(keeps_them_on_rows_of_several_words);
    TEST(keeps_them_with_struts);
    TEST(keeps_them_at_the_first_result);
    TEST(costs_far_less_than_a_plain_grow);
    TEST(costs_no_more_than_one_that_only_adds);
    TEST(leaves_a_repaired_shape_alone);
    return test_finish();
}
