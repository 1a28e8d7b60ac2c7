// SPDX-License-Identifier: MIT
// Why: this is what bends a model until it stands. Of a tower that falls it must make one whose
// centre of mass, measured from the bent mesh itself, lies in the safe set, with nothing under the
// ground, scales within bounds and the foot where it was; and no small change of the free handles
// may bend less and still stand.

#include "balance/bend/sqp.h"

#include "failing_allocator.h"
#include "leaning.h"

static const sf_pose at_rest = {1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};

static void rest_all(sf_pose *poses)
{
    for (int j = 0; j < HANDLES; j++) {
        poses[j] = at_rest;
    }
}

// The bent tower's vertices, from the definition.
static double *bent_by(const tower *t, const sf_pose *poses)
{
    double *bent = calloc(3 * t->view.vertex_count, sizeof *bent);
    for (size_t i = 0; i < 3 * t->view.vertex_count; i++) {
        for (size_t j = 0; j < HANDLES; j++) {
            const double *p = t->view.vertices + i / 3 * 3, *c = t->centres + 3 * j;
            const double *r = poses[j].turn + 3 * (i % 3);
            double turned = r[0] * (p[0] - c[0]) + r[1] * (p[1] - c[1]) + r[2] * (p[2] - c[2]);
            bent[i] += t->weights[i / 3 * HANDLES + j] *
                       (poses[j].scale * turned + c[i % 3] + poses[j].shift_mm[i % 3]);
        }
    }
    return bent;
}

// How far it is from standing, over its size.
static double lacking(const tower *t, const sf_pose *poses)
{
    double *bent = bent_by(t, poses), com[3], most = 0;
    sf_mesh_view view = t->view;
    sf_body body = {0, {0, 0, 0}};
    view.vertices = bent;
    CHECK_EQ(sf_mesh_body(view, 1, &body), SF_OK);
    CHECK_EQ(sf_body_com(body, com), SF_OK);
    for (int e = 0; e < 4; e++) {
        const sf_halfspace *h = &t->safe[e];
        double at = h->normal[0] * com[0] + h->normal[1] * com[1] + h->normal[2] * com[2];
        most = fmax(most, h->offset_mm - at);
    }
    for (size_t v = 0; v < view.vertex_count; v++) {
        if (!t->held[v]) {
            most = fmax(most, t->posture.clearance_mm - bent[3 * v + 2]);
        } else {
            CHECK_NEAR(bent[3 * v + 2], view.vertices[3 * v + 2], 1e-12);
        }
    }
    free(bent);
    return most / TOWER;
}

static double energy_of(const tower *t, const sf_pose *poses)
{
    double scratch[36 * HANDLES], terms[3];
    sfi_energy_at(&t->energy, poses, scratch, terms, NULL, NULL);
    return terms[0] + terms[1] + terms[2];
}

static void check_least(const tower *t, const sf_pose *poses, double energy)
{
    for (int i = 0; i < 300; i++) {
        sf_pose other[HANDLES];
        memcpy(other, poses, sizeof other);
        double far = ldexp(1, -(int)test_random_below(8)) * 0.5;
        for (size_t j = 1; j < HANDLES; j++) {
            double by[SFI_POSE_SIZE] = {0};
            for (size_t p = 0; p < SFI_POSE_SIZE; p++) {
                double unit = p >= SFI_POSE_SHIFT && p < SFI_POSE_TURN ? TOWER : 1;
                if (t->free[SFI_POSE_SIZE * j + p]) {
                    by[p] = far * unit * (test_random_unit() - 0.5);
                }
            }
            CHECK_EQ(sfi_pose_move(&other[j], by), SF_OK);
        }
        if (lacking(t, other) <= 1e-7) {
            CHECK(energy_of(t, other) > energy - 1e-6);
        }
    }
}

static void stands(double lean, int turns, sfi_freedom freedom)
{
    tower t;
    sf_pose poses[HANDLES];
    sfi_sqp_report report;
    tower_begin(&t, lean);
    for (int p = SFI_POSE_SIZE; turns && p < PARAMETERS; p++) {
        t.free[p] = 1;
    }
    freedom.free = t.free;
    rest_all(poses);
    CHECK(lacking(&t, poses) > 0.01);
    CHECK_EQ(sfi_sqp_run(&t.posture, &freedom, 40, &t.allocator, NULL, poses, &report), SF_OK);
    CHECK(report.settled && report.steps > 1);
    CHECK_NEAR(lacking(&t, poses), 0, 1e-6);
    CHECK_NEAR(fmax(report.state.unsafe, report.state.sunk), lacking(&t, poses), 1e-9);
    CHECK_NEAR(report.state.energy, energy_of(&t, poses), 1e-12);
    for (int j = 1; j < HANDLES; j++) {
        CHECK(poses[j].scale >= freedom.scale_low - 1e-9);
        CHECK(poses[j].scale <= freedom.scale_high + 1e-9);
        for (int d = 0; d < 3; d++) {
            CHECK(fabs(poses[j].shift_mm[d]) <= freedom.shift_max_mm + 1e-9 * TOWER);
        }
    }
    check_least(&t, poses, report.state.energy);
    tower_end(&t);
}

static void a_leaning_tower_stands(void)
{
    sfi_freedom freedom = {NULL, 0.7, 1.4, 1e9, 0.3};
    stands(0.3, 0, freedom);
    stands(0.6, 0, freedom);
    stands(0.3, 1, freedom);
}

static void scales_have_bounds(void)
{
    sfi_freedom freedom = {NULL, 0.98, 1.01, 1e9, 0.3};
    stands(0.3, 0, freedom);
}

// Without them the top goes by more than 3 mm.
static void shifts_have_bounds(void)
{
    sfi_freedom freedom = {NULL, 0.7, 1.4, 3, 0.3};
    stands(0.3, 0, freedom);
    stands(0.3, 1, freedom);
}

// What already stands is left alone, to the byte.
static void what_stands_is_left_alone(void)
{
    tower t;
    sf_pose poses[HANDLES], before[HANDLES];
    sfi_sqp_report report;
    tower_begin(&t, 0);
    sfi_freedom freedom = {t.free, 0.7, 1.4, 1e9, 0.3};
    rest_all(poses);
    rest_all(before);
    CHECK_EQ(sfi_sqp_run(&t.posture, &freedom, 40, &t.allocator, NULL, poses, &report), SF_OK);
    CHECK(report.settled && report.state.energy < 1e-12);
    CHECK_NEAR(poses[2].shift_mm[0], before[2].shift_mm[0], 1e-6);
    tower_end(&t);
}

// With shifts of the top alone and scales fixed there is no way: it must come nearer, and say so.
static void what_cannot_stand_comes_nearer(void)
{
    tower t;
    sf_pose poses[HANDLES];
    sfi_sqp_report report;
    tower_begin(&t, 0.6);
    memset(t.free, 0, sizeof t.free);
    t.free[2 * SFI_POSE_SIZE + SFI_POSE_SCALE] = 1;
    sfi_freedom freedom = {t.free, 0.9, 1.1, 1e9, 0.3};
    rest_all(poses);
    double before = lacking(&t, poses);
    CHECK_EQ(sfi_sqp_run(&t.posture, &freedom, 40, &t.allocator, NULL, poses, &report), SF_OK);
    CHECK(lacking(&t, poses) > 0.01 && lacking(&t, poses) < before - 0.001);
    CHECK(report.settled && report.state.unsafe > 0.01);
    CHECK_NEAR(poses[2].scale, 0.9, 1e-6);
    tower_end(&t);
}

static void memory_and_cancel(void)
{
    tower t;
    sf_pose poses[HANDLES], before[HANDLES];
    sfi_sqp_report report;
    failing_allocator failing;
    tower_begin(&t, 0.3);
    sfi_freedom freedom = {t.free, 0.7, 1.4, 1e9, 0.3};
    rest_all(before);
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status == SF_ERR_MEMORY && k < 1000; k++) {
        failing_begin(&failing, k);
        rest_all(poses);
        status = sfi_sqp_run(&t.posture, &freedom, 3, &failing.allocator, NULL, poses, &report);
        CHECK(status == SF_OK || memcmp(poses, before, sizeof poses) == 0);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    rest_all(poses);
    CHECK_EQ(sfi_sqp_run(&t.posture, &freedom, 3, &t.allocator, &task, poses, &report),
             SF_ERR_CANCELLED);
    CHECK(memcmp(poses, before, sizeof poses) == 0);
    tower_end(&t);
}

int main(void)
{
    TEST(a_leaning_tower_stands);
    TEST(scales_have_bounds);
    TEST(shifts_have_bounds);
    TEST(what_stands_is_left_alone);
    TEST(what_cannot_stand_comes_nearer);
    TEST(memory_and_cancel);
    return test_finish();
}
