// SPDX-License-Identifier: MIT
// Why: the forest's optimum is claimed to be exact. Where only the voxel straight below carries,
// the forest is no choice, so the repair must be the least there is: brute force over all subsets
// says what that is. Where there is a choice, nothing may be below the least, and little much above
// it.

#include "unit/support/repair_oracle.h"

#define VOXELS_MOST 14

static job j;
static stack must, allowed, candidate, trimmed, result;

// The least cost of all subsets of what is allowed that hold what must stay; UINT64_MAX: none is
// support-free.
static uint64_t least_of_all(void)
{
    uint64_t least = UINT64_MAX;
    int count = stack_count(&j.shape), bed = stack_bed(&j.shape, j.bed_layer);
    candidate = j.shape;
    for (uint32_t bits = 0; bits < 1u << count; bits++) {
        for (int i = 0; i < count; i++) {
            candidate.solid[i] = bits >> i & 1;
        }
        if (!stack_within(&must, &candidate) || !stack_within(&candidate, &allowed)) {
            continue;
        }
        uint64_t cost =
            oracle_cost(&j.shape, &candidate, job_costs(&j, j.add), job_costs(&j, j.remove));
        if (cost >= least) {
            continue;
        }
        oracle_trim(&trimmed, &candidate, &j.rule, bed, job_mask(&j, MASK_EXEMPT));
        if (stack_equal(&trimmed, &candidate)) {
            least = cost;
        }
    }
    return least;
}

static void tiny_job(int number)
{
    do {
        random_job(&j, number, 5);
    } while (stack_count(&j.shape) > VOXELS_MOST);
}

static void is_the_least_where_the_forest_is_given(void)
{
    for (int i = 0; i < 400 && test_case_failures == 0; i++) {
        sf_repair_report r = {0};
        tiny_job(i);
        j.rule = rule_of_radius(0);
        job_sets(&j, &must, &allowed);
        uint64_t least = least_of_all();
        sf_status status = job_repair(&j, &result, NULL, &r);
        CHECK_EQ(status, least == UINT64_MAX ? SF_ERR_INFEASIBLE : SF_OK);
        if (status == SF_OK) {
            CHECK_EQ(r.cost, least);
            CHECK_EQ(r.first_cost, least);
        }
    }
}

static void is_close_to_the_least_under_every_rule(void)
{
    uint64_t ours = 0, least_sum = 0;
    for (int i = 0; i < 700; i++) {
        sf_repair_report r = {0};
        tiny_job(i);
        job_sets(&j, &must, &allowed);
        uint64_t least = least_of_all();
        sf_status status = job_repair(&j, &result, NULL, &r);
        CHECK_EQ(status, least == UINT64_MAX ? SF_ERR_INFEASIBLE : SF_OK);
        if (status == SF_OK) {
            CHECK(r.cost >= least);
            ours += r.cost;
            least_sum += least;
        }
    }
    printf("# sum %llu, least %llu\n", (unsigned long long)ours, (unsigned long long)least_sum);
    CHECK(ours * 20 <= least_sum * 21);
}

int main(void)
{
    TEST(is_the_least_where_the_forest_is_given);
    TEST(is_close_to_the_least_under_every_rule);
    return test_finish();
}
