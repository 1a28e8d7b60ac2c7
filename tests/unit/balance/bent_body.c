// SPDX-License-Identifier: MIT
// Why: what a handle does to the balance is known through this gradient alone. Values are held
// against the mass of the bent mesh itself, gradients against central differences of it.

#include "balance/bend/bent_body.h"
#include "backwards.h"

#include "bent.h"
#include "failing_allocator.h"

static void random_coefficients(double *y)
{
    for (int i = 0; i < SIZE; i++) {
        int diagonal = i % 12 < 9 && i % 12 / 3 == i % 3;
        y[i] = (diagonal ? 1 : 0) + (i % 12 < 9 ? 0.3 : 3) * test_random_unit();
    }
}

static sf_body body_at(const scene *s, const double *y)
{
    sf_mesh_view view = s->view;
    double *bent = bend(s, y);
    sf_body body = {0, {0, 0, 0}};
    view.vertices = bent;
    CHECK_EQ(sf_mesh_body(view, 1, &body), SF_OK);
    free(bent);
    return body;
}

static sf_status derive(const scene *s, const double *y, const sf_allocator *allocator,
                        sf_task *task, sf_body *body, double *gradient)
{
    const double middle[3] = {5, 6, 3};
    double *bent = bend(s, y);
    sf_status status = sfi_bent_body(bent, s->view.triangles, &s->incidence, &s->basis, middle,
                                     allocator, task, body, gradient);
    free(bent);
    return status;
}

static void values_and_gradients(void)
{
    scene s;
    begin(&s);
    for (int round = 0; round < 10; round++) {
        double y[SIZE], gradient[4 * SIZE], most = 0, worst = 0;
        sf_body body = {0, {0, 0, 0}};
        random_coefficients(y);
        CHECK_EQ(derive(&s, y, &s.allocator, NULL, &body, gradient), SF_OK);
        sf_body expected = body_at(&s, y);
        CHECK_NEAR(body.mass, expected.mass, 1e-11 * expected.mass);
        for (int d = 0; d < 3; d++) {
            CHECK_NEAR(body.moment[d], expected.moment[d], 1e-11 * fabs(expected.moment[d]));
        }
        for (int i = 0; i < SIZE; i++) {
            double was = y[i], step = 1e-4;
            y[i] = was + step;
            sf_body up = body_at(&s, y);
            y[i] = was - step;
            sf_body down = body_at(&s, y);
            y[i] = was;
            for (int f = 0; f < 4; f++) {
                double slope = f == 0 ? up.mass - down.mass : up.moment[f - 1] - down.moment[f - 1];
                double exact = gradient[12 * (i / 3) + 3 * f + i % 3];
                worst = fmax(worst, fabs(slope / (2 * step) - exact));
                most = fmax(most, fabs(exact));
            }
        }
        CHECK_NEAR(worst / most, 0, 1e-8);
    }
    end(&s);
}

static void threads_and_memory(void)
{
    scene s;
    begin(&s);
    double y[SIZE], gradient[4 * SIZE], other[4 * SIZE];
    sf_body body = {0, {0, 0, 0}}, same = {0, {0, 0, 0}};
    sf_task task = sf_task_default();
    task.parallel_for = backwards;
    random_coefficients(y);
    CHECK_EQ(derive(&s, y, &s.allocator, NULL, &body, gradient), SF_OK);
    CHECK_EQ(derive(&s, y, &s.allocator, &task, &same, other), SF_OK);
    CHECK(memcmp(gradient, other, sizeof other) == 0 && memcmp(&body, &same, sizeof body) == 0);
    failing_allocator failing;
    failing_begin(&failing, 0);
    same.mass = 7;
    CHECK_EQ(derive(&s, y, &failing.allocator, NULL, &same, other), SF_ERR_MEMORY);
    CHECK(same.mass == 7 && memcmp(gradient, other, sizeof other) == 0 && failing.live == 0);
    end(&s);
}

int main(void)
{
    TEST(values_and_gradients);
    TEST(threads_and_memory);
    return test_finish();
}
