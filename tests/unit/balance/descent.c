// SPDX-License-Identifier: MIT
// Why: the paper's way is the oracle of ours. Both must set the same tower upright; where both do,
// the quadratic programs must not bend it more. The schedule is held against the paper's words.

#include "balance/bend/descent.h"

#include "failing_allocator.h"
#include "leaning.h"

static const sf_pose at_rest = {1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};

static void rest_all(sf_pose *poses)
{
    for (int j = 0; j < HANDLES; j++) {
        poses[j] = at_rest;
    }
}

static void both_ways_stand(void)
{
    tower t;
    tower_begin(&t, 0.3);
    t.posture.clearance_mm = -TOWER; // the paper does not look at the ground
    sf_pose slow[HANDLES], fast[HANDLES];
    sfi_descent d = sfi_descent_begin(0.5);
    sfi_posture_state state;
    int steps = 0;
    rest_all(slow);
    rest_all(fast);
    do {
        CHECK_EQ(sfi_descent_step(&t.posture, t.free, &t.allocator, NULL, &d, slow, &state), SF_OK);
        steps++;
    } while (state.unsafe > 1e-6 && !d.ended && steps < 2000);
    CHECK(state.unsafe <= 1e-3);
    sfi_freedom freedom = {t.free, 0.2, 5, 1e9, 0.3};
    sfi_sqp_report report;
    CHECK_EQ(sfi_sqp_run(&t.posture, &freedom, 40, &t.allocator, NULL, fast, &report), SF_OK);
    CHECK(report.state.unsafe < 1e-6 && report.steps < (uint32_t)steps);
    CHECK(report.state.energy <= state.energy * 1.001);
    printf("# descent: %d steps, energy %.5f, mu %.2f; programs: %u steps, energy %.5f\n", steps,
           state.energy, d.mu, (unsigned)report.steps, report.state.energy);
    tower_end(&t);
}

// With nothing free no step can be worth it. Where nothing can improve: 5 shorter steps, then mu.
static void the_schedule_is_the_papers(void)
{
    tower t;
    tower_begin(&t, 0);
    sf_pose poses[HANDLES];
    sfi_descent d = sfi_descent_begin(0.1);
    sfi_posture_state state;
    rest_all(poses);
    const double steps[] = {0.8, 0.64, 0.512, 0.4096, 1};
    for (int round = 0; round < 3; round++) {
        for (int i = 0; i < 5; i++) {
            CHECK(!d.ended);
            CHECK_EQ(sfi_descent_step(&t.posture, t.free, &t.allocator, NULL, &d, poses, &state),
                     SF_OK);
            CHECK_NEAR(d.step, steps[i], 1e-12);
        }
        CHECK_NEAR(d.mu, fmax(0, 0.1 - 0.05 * (round + 1)), 1e-12);
    }
    CHECK(d.ended && poses[2].scale == 1);
    tower_end(&t);
}

// Asked for more than its height allows, nothing is safe as high as its centre of mass lies. It
// must go on all the same, to where the least is lacking, which is above the middle of the foot.
static void where_nothing_is_safe_it_comes_nearer(void)
{
    tower t;
    tower_begin(&t, 0.3);
    stand_on_foot(&t, 0.9);
    sf_pose poses[HANDLES];
    sfi_descent d = sfi_descent_begin(0.5);
    sfi_posture_state first, state;
    double com[3];
    rest_all(poses);
    CHECK_EQ(sfi_descent_step(&t.posture, t.free, &t.allocator, NULL, &d, poses, &first), SF_OK);
    for (int i = 0; i < 1000 && !d.ended; i++) {
        CHECK_EQ(sfi_descent_step(&t.posture, t.free, &t.allocator, NULL, &d, poses, &state),
                 SF_OK);
    }
    CHECK_EQ(sf_body_com(state.body, com), SF_OK);
    CHECK(state.unsafe < first.unsafe && com[2] > 0.5 * FOOT / 0.9);
    CHECK_NEAR(com[0], 0.5 * FOOT, 0.1 * FOOT);
    tower_end(&t);
}

static void memory(void)
{
    tower t;
    tower_begin(&t, 0.3);
    sf_pose poses[HANDLES], before[HANDLES];
    sfi_descent d = sfi_descent_begin(0.5);
    sfi_posture_state state;
    failing_allocator failing;
    sf_status status = SF_ERR_MEMORY;
    rest_all(poses);
    rest_all(before);
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        failing_begin(&failing, k);
        status = sfi_descent_step(&t.posture, t.free, &failing.allocator, NULL, &d, poses, &state);
        CHECK(status == SF_OK || memcmp(poses, before, sizeof poses) == 0);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    CHECK(memcmp(poses, before, sizeof poses) != 0);
    tower_end(&t);
}

int main(void)
{
    TEST(both_ways_stand);
    TEST(the_schedule_is_the_papers);
    TEST(where_nothing_is_safe_it_comes_nearer);
    TEST(memory);
    return test_finish();
}
