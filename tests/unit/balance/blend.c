// SPDX-License-Identifier: MIT
// Why: everything that bends goes through a blend, and an optimiser trusts its derivatives. Blends
// are held against the paper's sum written out, pushes against differences of blends, pulls against
// the transpose of pushes, turns against rotations by known angles. Promise: the same bytes for any
// number of threads, in place or not; nothing changes in calls that fail.

#include "backwards.h"
#include "failing_allocator.h"
#include "test.h"

#include <sf/blend.h>

enum { POINTS = 10000, HANDLES = 5 };

typedef struct cloud {
    double *rest, *weights, centers[3 * HANDLES];
    sf_pose poses[HANDLES];
    sf_pose_change changes[HANDLES];
    sf_blend blend;
} cloud;

static double spread(void)
{
    return 2 * test_random_unit() - 1;
}

static void fill(double *x, size_t count, double size)
{
    for (size_t i = 0; i < count; i++) {
        x[i] = size * spread();
    }
}

static void cloud_begin(cloud *c)
{
    c->rest = malloc(3 * POINTS * sizeof(double));
    c->weights = malloc(HANDLES * POINTS * sizeof(double));
    fill(c->rest, 3 * POINTS, 10);
    fill(c->centers, 3 * HANDLES, 10);
    for (size_t i = 0; i < POINTS; i++) {
        double sum = 0;
        for (size_t j = 0; j < HANDLES; j++) {
            c->weights[HANDLES * i + j] = test_random_unit();
            sum += c->weights[HANDLES * i + j];
        }
        for (size_t j = 0; j < HANDLES; j++) {
            c->weights[HANDLES * i + j] /= sum;
        }
    }
    for (size_t j = 0; j < HANDLES; j++) {
        double *change = &c->changes[j].scale;
        fill(change, 7, 0.5);
        c->poses[j] = sf_pose_identity();
        CHECK_EQ(sf_pose_move(&c->poses[j], &c->changes[j]), SF_OK);
        fill(change, 7, 1);
    }
    sf_blend blend = {c->rest, c->weights, POINTS, c->centers, HANDLES};
    c->blend = blend;
}

static void cloud_end(cloud *c)
{
    free(c->rest);
    free(c->weights);
}

// The paper's equation 9, term by term.
static void naive(const cloud *c, size_t i, double v[3])
{
    v[0] = v[1] = v[2] = 0;
    for (size_t j = 0; j < HANDLES; j++) {
        for (size_t r = 0; r < 3; r++) {
            double turned = 0;
            for (size_t k = 0; k < 3; k++) {
                turned +=
                    c->poses[j].turn[3 * r + k] * (c->rest[3 * i + k] - c->centers[3 * j + k]);
            }
            v[r] += c->weights[HANDLES * i + j] *
                    (c->poses[j].scale * turned + c->centers[3 * j + r] + c->poses[j].shift_mm[r]);
        }
    }
}

static void blends_are_the_papers_sum(void)
{
    cloud c;
    cloud_begin(&c);
    double *out = malloc(3 * POINTS * sizeof *out);
    CHECK_EQ(sf_blend_apply(c.blend, c.poses, NULL, out), SF_OK);
    for (size_t i = 0; i < POINTS; i++) {
        double v[3];
        naive(&c, i, v);
        for (size_t r = 0; r < 3; r++) {
            CHECK_NEAR(out[3 * i + r], v[r], 1e-12);
        }
    }
    for (size_t j = 0; j < HANDLES; j++) {
        c.poses[j] = sf_pose_identity();
    }
    CHECK_EQ(sf_blend_apply(c.blend, c.poses, NULL, out), SF_OK);
    for (size_t n = 0; n < 3 * POINTS; n++) {
        CHECK_NEAR(out[n], c.rest[n], 1e-13);
    }
    free(out);
    cloud_end(&c);
}

// Blends of poses moved by a part of the changes.
static void blend_moved(const cloud *c, double part, double *out)
{
    sf_pose poses[HANDLES];
    for (size_t j = 0; j < HANDLES; j++) {
        sf_pose_change change = c->changes[j];
        for (int n = 0; n < 7; n++) {
            (&change.scale)[n] *= part;
        }
        poses[j] = c->poses[j];
        CHECK_EQ(sf_pose_move(&poses[j], &change), SF_OK);
    }
    CHECK_EQ(sf_blend_apply(c->blend, poses, NULL, out), SF_OK);
}

static void pushes_are_how_blends_change(void)
{
    cloud c;
    cloud_begin(&c);
    double *push = malloc(9 * POINTS * sizeof *push), *up = push + 3 * POINTS,
           *down = up + 3 * POINTS;
    CHECK_EQ(sf_blend_push(c.blend, c.poses, c.changes, NULL, push), SF_OK);
    blend_moved(&c, 1e-5, up);
    blend_moved(&c, -1e-5, down);
    for (size_t n = 0; n < 3 * POINTS; n++) {
        CHECK_NEAR(push[n], (up[n] - down[n]) / 2e-5, 1e-7);
    }
    // Without spins a blend is linear in the change, however large.
    for (size_t j = 0; j < HANDLES; j++) {
        memset(c.changes[j].spin_rad, 0, sizeof c.changes[j].spin_rad);
    }
    CHECK_EQ(sf_blend_push(c.blend, c.poses, c.changes, NULL, push), SF_OK);
    blend_moved(&c, 0, down);
    blend_moved(&c, 1, up);
    for (size_t n = 0; n < 3 * POINTS; n++) {
        CHECK_NEAR(push[n], up[n] - down[n], 1e-12);
    }
    free(push);
    cloud_end(&c);
}

static void pulls_are_the_transpose_of_pushes(void)
{
    cloud c;
    cloud_begin(&c);
    double *push = malloc(6 * POINTS * sizeof *push), *gradient = push + 3 * POINTS, left = 0;
    sf_pose_change pulled[HANDLES];
    fill(gradient, 3 * POINTS, 1);
    CHECK_EQ(sf_blend_push(c.blend, c.poses, c.changes, NULL, push), SF_OK);
    CHECK_EQ(sf_blend_pull(c.blend, c.poses, gradient, NULL, NULL, pulled), SF_OK);
    for (size_t n = 0; n < 3 * POINTS; n++) {
        left += push[n] * gradient[n];
    }
    double right = 0;
    for (size_t j = 0; j < HANDLES; j++) {
        for (int n = 0; n < 7; n++) {
            right += (&c.changes[j].scale)[n] * (&pulled[j].scale)[n];
        }
    }
    CHECK_NEAR(left, right, 1e-9 * (1 + fabs(left)));
    // And number by number: each change alone.
    memset(c.changes, 0, sizeof c.changes);
    for (size_t n = 0; n < 7 * HANDLES; n++) {
        double *one = &c.changes[n / 7].scale + n % 7;
        *one = 1;
        CHECK_EQ(sf_blend_push(c.blend, c.poses, c.changes, NULL, push), SF_OK);
        *one = 0;
        left = 0;
        for (size_t i = 0; i < 3 * POINTS; i++) {
            left += push[i] * gradient[i];
        }
        CHECK_NEAR((&pulled[n / 7].scale)[n % 7], left, 1e-9 * (1 + fabs(left)));
    }
    free(push);
    cloud_end(&c);
}

static void turns_are_rotations(void)
{
    sf_pose pose = sf_pose_identity();
    sf_pose_change quarter = {0, {1, 2, 3}, {0, 0, 1.5707963267948966}};
    CHECK_EQ(sf_pose_move(&pose, &quarter), SF_OK);
    const double expected[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
    for (int n = 0; n < 9; n++) {
        CHECK_NEAR(pose.turn[n], expected[n], 1e-15);
    }
    // A turn about x comes after: x stays where the first turn has put it.
    sf_pose_change half = {0.5, {0, 0, 0}, {2, 0, 0}};
    CHECK_EQ(sf_pose_move(&pose, &half), SF_OK);
    CHECK_NEAR(pose.turn[3], cos(2.0), 1e-15);
    CHECK_NEAR(pose.turn[6], sin(2.0), 1e-15);
    CHECK(pose.scale == 1.5 && pose.shift_mm[2] == 3);
    for (int i = 0; i < 10000; i++) {
        sf_pose_change change = {0, {0, 0, 0}, {spread(), spread(), spread()}};
        CHECK_EQ(sf_pose_move(&pose, &change), SF_OK);
    }
    for (int i = 0; i < 9; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            sum += pose.turn[3 * (i / 3) + k] * pose.turn[3 * (i % 3) + k];
        }
        CHECK_NEAR(sum, i % 4 == 0, 1e-12);
    }
}

static void the_same_bytes(void)
{
    cloud c;
    cloud_begin(&c);
    sf_task task = sf_task_default();
    task.parallel_for = backwards;
    double *out = malloc(6 * POINTS * sizeof *out), *again = out + 3 * POINTS;
    sf_pose_change one[HANDLES], two[HANDLES];
    CHECK_EQ(sf_blend_apply(c.blend, c.poses, NULL, out), SF_OK);
    CHECK_EQ(sf_blend_pull(c.blend, c.poses, out, NULL, NULL, one), SF_OK);
    CHECK_EQ(sf_blend_pull(c.blend, c.poses, out, NULL, &task, two), SF_OK);
    CHECK(memcmp(one, two, sizeof one) == 0);
    memcpy(again, c.rest, 3 * POINTS * sizeof *again);
    c.blend.rest_mm = again;
    CHECK_EQ(sf_blend_apply(c.blend, c.poses, &task, again), SF_OK);
    CHECK(memcmp(out, again, 3 * POINTS * sizeof *out) == 0);
    free(out);
    cloud_end(&c);
}

static void nonsense_is_refused(void)
{
    cloud c;
    cloud_begin(&c);
    double out[3] = {7, 7, 7};
    sf_pose_change changes[HANDLES];
    sf_task task = sf_task_default();
    c.blend.point_count = 1;
    sf_blend many = c.blend, none = c.blend, empty = c.blend;
    many.handle_count = SF_HANDLE_MAX + 1;
    none.handle_count = 0;
    empty.rest_mm = NULL;
    CHECK_EQ(sf_blend_apply(many, c.poses, NULL, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_apply(none, c.poses, NULL, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_apply(empty, c.poses, NULL, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_apply(c.blend, NULL, NULL, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_apply(c.blend, c.poses, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_push(c.blend, c.poses, NULL, NULL, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_pull(c.blend, c.poses, NULL, NULL, NULL, changes), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_pull(c.blend, c.poses, out, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_task_cancel(&task);
    CHECK_EQ(sf_blend_apply(c.blend, c.poses, &task, out), SF_ERR_CANCELLED);
    CHECK_EQ(sf_blend_pull(c.blend, c.poses, out, NULL, &task, changes), SF_ERR_CANCELLED);
    sf_pose before = c.poses[0];
    sf_pose_change far = {0, {0, 0, 0}, {3, 0, 0}}, nan = {NAN, {0, 0, 0}, {0, 0, 0}};
    CHECK_EQ(sf_pose_move(&c.poses[0], &far), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_pose_move(&c.poses[0], &nan), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_pose_move(NULL, &far), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_pose_move(&c.poses[0], NULL), SF_ERR_ARGUMENT);
    CHECK(memcmp(&before, &c.poses[0], sizeof before) == 0);
    c.poses[HANDLES - 1].turn[4] = INFINITY;
    CHECK_EQ(sf_blend_apply(c.blend, c.poses, NULL, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_push(c.blend, c.poses, c.changes, NULL, out), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_blend_pull(c.blend, c.poses, out, NULL, NULL, changes), SF_ERR_ARGUMENT);
    CHECK(out[0] == 7 && out[1] == 7 && out[2] == 7);
    cloud_end(&c);
}

static void memory_runs_out(void)
{
    cloud c;
    cloud_begin(&c);
    failing_allocator failing;
    sf_pose_change changes[HANDLES], before[HANDLES];
    memset(changes, 7, sizeof changes);
    memcpy(before, changes, sizeof changes);
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100; k++) {
        failing_begin(&failing, k);
        status = sf_blend_pull(c.blend, c.poses, c.rest, &failing.allocator, NULL, changes);
        CHECK(status == SF_OK || memcmp(changes, before, sizeof changes) == 0);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    // No points: a gradient of nothing.
    c.blend.point_count = 0;
    CHECK_EQ(sf_blend_pull(c.blend, c.poses, NULL, NULL, NULL, changes), SF_OK);
    CHECK(changes[0].scale == 0 && changes[HANDLES - 1].spin_rad[2] == 0);
    cloud_end(&c);
}

int main(void)
{
    TEST(blends_are_the_papers_sum);
    TEST(pushes_are_how_blends_change);
    TEST(pulls_are_the_transpose_of_pushes);
    TEST(turns_are_rotations);
    TEST(the_same_bytes);
    TEST(nonsense_is_refused);
    TEST(memory_runs_out);
    return test_finish();
}
