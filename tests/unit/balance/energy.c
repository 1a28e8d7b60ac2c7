// SPDX-License-Identifier: MIT
// Why: a step of balancing goes where this energy is least. Its terms are held against sums over
// the bent points, its gradient and its second derivatives by scale, shift and turn against
// differences; poses that must cost nothing do.

#include "balance/bend/energy.h"
#include "balance/bend/laplacian.h"

#include "bent.h"
#include "failing_allocator.h"

enum { PARAMETERS = SFI_POSE_SIZE * HANDLES };

static const double weights[3] = {1, 0.3, 0.05}, size_mm = 7;

static const sf_pose at_rest = {1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};

static void random_poses(sf_pose *poses)
{
    for (int j = 0; j < HANDLES; j++) {
        double by[SFI_POSE_SIZE];
        for (int i = 0; i < SFI_POSE_SIZE; i++) {
            by[i] = test_random_unit() - 0.5;
        }
        poses[j] = at_rest;
        CHECK_EQ(sfi_pose_move(&poses[j], by), SF_OK);
    }
}

static void make(scene *s, sfi_energy *energy)
{
    begin(s);
    CHECK_EQ(sfi_energy_make(s->view, &s->incidence, &s->basis, size_mm, weights, &s->allocator,
                             NULL, energy),
             SF_OK);
}

static void terms_are_sums(void)
{
    scene s;
    sfi_energy energy;
    static double form[SIZE * SIZE];
    make(&s, &energy);
    double scratch[36 * HANDLES], terms[3], y[SIZE], norm = 0, details = 0, moved = 0, scales = 0;
    sf_pose poses[HANDLES];
    random_poses(poses);
    CHECK_EQ(sfi_energy_scratch(HANDLES), 36 * HANDLES);
    sfi_energy_at(&energy, poses, scratch, terms, NULL, NULL);
    sfi_pose_coefficients(poses, s.centres, HANDLES, y);
    CHECK_EQ(sfi_laplacian_form(s.view, &s.incidence, &s.basis, &s.allocator, NULL, form, &norm),
             SF_OK);
    for (int i = 0; i < SIZE * SIZE; i++) {
        details += form[i] * y[i / SIZE] * y[i % SIZE] / norm;
    }
    // Bent by hand from the definition: s R (p - c) + c + t, weighed.
    for (size_t v = 0; v < s.view.vertex_count; v++) {
        for (int d = 0; d < 3; d++) {
            double at = -s.view.vertices[3 * v + (size_t)d];
            for (size_t j = 0; j < HANDLES; j++) {
                const double *c = s.centres + 3 * j, *p = s.view.vertices + 3 * v;
                const double *r = poses[j].turn + 3 * d;
                double turned = r[0] * (p[0] - c[0]) + r[1] * (p[1] - c[1]) + r[2] * (p[2] - c[2]);
                at += s.weights[HANDLES * v + j] *
                      (poses[j].scale * turned + c[d] + poses[j].shift_mm[d]);
            }
            moved += at * at / (double)s.view.vertex_count / (size_mm * size_mm);
        }
    }
    for (int j = 0; j < HANDLES; j++) {
        scales += (poses[j].scale - 1) * (poses[j].scale - 1);
    }
    CHECK_NEAR(terms[0], weights[0] * details, 1e-11);
    CHECK_NEAR(terms[1], weights[1] * moved, 1e-11);
    CHECK_NEAR(terms[2], weights[2] * scales, 1e-13);
    CHECK(terms[0] > 1e-3 && terms[1] > 1e-4 && terms[2] > 1e-4);
    sfi_energy_free(&energy);
    end(&s);
}

static double total(const sfi_energy *energy, const sf_pose *poses, double *gradient)
{
    double scratch[36 * HANDLES], terms[3];
    sfi_energy_at(energy, poses, scratch, terms, gradient, NULL);
    return terms[0] + terms[1] + terms[2];
}

static void derivatives_agree(void)
{
    scene s;
    sfi_energy energy;
    make(&s, &energy);
    sf_pose poses[HANDLES], moved[HANDLES];
    double scratch[36 * HANDLES], terms[3], gradient[PARAMETERS], up[PARAMETERS], down[PARAMETERS];
    static double hessian[PARAMETERS * PARAMETERS];
    random_poses(poses);
    sfi_energy_at(&energy, poses, scratch, terms, gradient, hessian);
    for (int i = 0; i < PARAMETERS; i++) {
        double by[SFI_POSE_SIZE] = {0}, step = 1e-5;
        memcpy(moved, poses, sizeof poses);
        by[i % SFI_POSE_SIZE] = step;
        CHECK_EQ(sfi_pose_move(&moved[i / SFI_POSE_SIZE], by), SF_OK);
        double high = total(&energy, moved, up);
        memcpy(moved, poses, sizeof poses);
        by[i % SFI_POSE_SIZE] = -step;
        CHECK_EQ(sfi_pose_move(&moved[i / SFI_POSE_SIZE], by), SF_OK);
        double low = total(&energy, moved, down);
        CHECK_NEAR((high - low) / (2 * step), gradient[i], 1e-7);
        // In scale and shift the energy is quadratic, so that its second derivatives are exact.
        for (int k = 0; k < PARAMETERS; k++) {
            double slope = (up[k] - down[k]) / (2 * step), value = hessian[i * PARAMETERS + k];
            if (i % SFI_POSE_SIZE < SFI_POSE_TURN && k % SFI_POSE_SIZE < SFI_POSE_TURN) {
                CHECK_NEAR(slope, value, 1e-6);
            }
            CHECK_NEAR(value, hessian[k * PARAMETERS + i], 1e-9);
        }
    }
    sfi_energy_free(&energy);
    end(&s);
}

// At rest everything is zero, and there the curvature is that of turns as well.
static void rest_costs_nothing(void)
{
    scene s;
    sfi_energy energy;
    make(&s, &energy);
    sf_pose poses[HANDLES] = {at_rest, at_rest, at_rest};
    double scratch[36 * HANDLES], terms[3], gradient[PARAMETERS];
    static double hessian[PARAMETERS * PARAMETERS];
    sfi_energy_at(&energy, poses, scratch, terms, gradient, hessian);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(terms[i], 0, 1e-13);
    }
    for (int i = 0; i < PARAMETERS; i++) {
        CHECK_NEAR(gradient[i], 0, 1e-12);
        double by[SFI_POSE_SIZE] = {0}, step = 1e-4, slope[PARAMETERS];
        by[i % SFI_POSE_SIZE] = step;
        sf_pose moved[HANDLES] = {at_rest, at_rest, at_rest};
        CHECK_EQ(sfi_pose_move(&moved[i / SFI_POSE_SIZE], by), SF_OK);
        (void)total(&energy, moved, slope);
        for (int k = 0; k < PARAMETERS; k++) {
            CHECK_NEAR(slope[k] / step, hessian[i * PARAMETERS + k], 2e-3);
        }
    }
    sfi_energy_free(&energy);
    end(&s);
}

static void turns_stay_turns(void)
{
    sf_pose pose = at_rest;
    for (int i = 0; i < 1000; i++) {
        double by[SFI_POSE_SIZE] = {0};
        for (int d = 0; d < 3; d++) {
            by[SFI_POSE_TURN + d] = 2 * test_random_unit() - 1;
        }
        CHECK_EQ(sfi_pose_move(&pose, by), SF_OK);
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                sum += pose.turn[3 * i + k] * pose.turn[3 * j + k];
            }
            CHECK_NEAR(sum, i == j, 1e-12);
        }
    }
    // A small turn about z.
    double by[SFI_POSE_SIZE] = {0, 0, 0, 0, 0, 0, 1e-3};
    pose = at_rest;
    CHECK_EQ(sfi_pose_move(&pose, by), SF_OK);
    CHECK_NEAR(pose.turn[1], -sin(1e-3), 1e-9);
    CHECK_NEAR(pose.turn[3], sin(1e-3), 1e-9);
    CHECK_NEAR(pose.turn[0], cos(1e-3), 1e-9);
}

static void memory_and_cancel(void)
{
    scene s;
    begin(&s);
    failing_allocator failing;
    sfi_energy energy;
    memset(&energy, 7, sizeof energy);
    for (long k = 0; k < 7; k++) {
        failing_begin(&failing, k);
        CHECK_EQ(sfi_energy_make(s.view, &s.incidence, &s.basis, size_mm, weights,
                                 &failing.allocator, NULL, &energy),
                 SF_ERR_MEMORY);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    failing_begin(&failing, -1);
    CHECK_EQ(sfi_energy_make(s.view, &s.incidence, &s.basis, size_mm, weights, &failing.allocator,
                             &task, &energy),
             SF_ERR_CANCELLED);
    CHECK(failing.live == 0 && failing.faults == 0);
    CHECK_EQ(sfi_energy_make(s.view, &s.incidence, &s.basis, size_mm, weights, &failing.allocator,
                             NULL, &energy),
             SF_OK);
    sfi_energy_free(&energy);
    CHECK(failing.live == 0 && failing.faults == 0);
    end(&s);
}

int main(void)
{
    TEST(terms_are_sums);
    TEST(derivatives_agree);
    TEST(rest_costs_nothing);
    TEST(turns_stay_turns);
    TEST(memory_and_cancel);
    return test_finish();
}
