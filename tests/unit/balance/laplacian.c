// SPDX-License-Identifier: MIT
// Why: the energy decides which of all shapes that stand is taken. Its form, which is made of
// closed formulas, is held against the definition: bend the points, fit a similarity to each ring
// by least squares with seven unknowns, and sum what is left of the details. Where nothing may be
// left, at similarities with small turns, it must be zero.

#include "balance/bend/laplacian.h"
#include "backwards.h"
#include "bent.h"
#include "failing_allocator.h"

static double value(const double *form, const double *y)
{
    double sum = 0;
    for (int i = 0; i < SIZE * SIZE; i++) {
        sum += form[i] * y[i / SIZE] * y[i % SIZE];
    }
    return sum;
}

// Every handle does p -> matrix p + shift.
static void all_alike(const scene *s, const double matrix[9], const double shift[3], double *y)
{
    for (int j = 0; j < HANDLES; j++) {
        const double *c = s->centres + 3 * j;
        for (int d = 0; d < 3; d++) {
            for (int q = 0; q < 3; q++) {
                y[12 * j + 3 * q + d] = matrix[3 * d + q];
            }
            y[12 * j + 9 + d] = matrix[3 * d] * c[0] + matrix[3 * d + 1] * c[1] +
                                matrix[3 * d + 2] * c[2] + shift[d];
        }
    }
}

// Solve a x = b in place by elimination with pivots; b becomes x.
static void eliminate(double a[7][7], double b[7])
{
    for (int c = 0; c < 7; c++) {
        int best = c;
        for (int r = c + 1; r < 7; r++) {
            best = fabs(a[r][c]) > fabs(a[best][c]) ? r : best;
        }
        for (int k = 0; k < 7; k++) {
            double swap = a[c][k];
            a[c][k] = a[best][k];
            a[best][k] = swap;
        }
        double swap = b[c];
        b[c] = b[best];
        b[best] = swap;
        for (int r = 0; r < 7; r++) {
            double factor = r == c ? 0 : a[r][c] / a[c][c];
            for (int k = c; k < 7; k++) {
                a[r][k] -= factor * a[c][k];
            }
            b[r] -= factor * b[c];
        }
    }
    for (int c = 0; c < 7; c++) {
        b[c] /= a[c][c];
    }
}

// The rows of s p + h x p + t in (s, h, t).
static void similarity_rows(const double *p, double rows[3][7])
{
    const double made[3][7] = {{p[0], 0, p[2], -p[1], 1, 0, 0},
                               {p[1], -p[2], 0, p[0], 0, 1, 0},
                               {p[2], p[1], -p[0], 0, 0, 0, 1}};
    memcpy(rows, made, sizeof made);
}

static void fit(const scene *s, const double *bent, const size_t *ring, size_t count, double x[7])
{
    double a[7][7] = {{0}}, rows[3][7];
    memset(x, 0, 7 * sizeof *x);
    for (size_t k = 0; k < count; k++) {
        similarity_rows(s->view.vertices + 3 * ring[k], rows);
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < 7; i++) {
                x[i] += rows[c][i] * bent[3 * ring[k] + (size_t)c];
                for (int j = 0; j < 7; j++) {
                    a[i][j] += rows[c][i] * rows[c][j];
                }
            }
        }
    }
    eliminate(a, x);
}

// The ring of a vertex: itself, then every vertex that shares a triangle's edge, once.
static size_t find_ring(const scene *s, size_t v, size_t *ring)
{
    size_t count = 1;
    ring[0] = v;
    for (size_t c = 0; c < 3 * s->view.triangle_count; c++) {
        size_t t = c - c % 3, next = s->view.triangles[t + (c + 1 - t) % 3];
        if (s->view.triangles[c] == v) {
            ring[count++] = next;
        }
    }
    return count;
}

static double naive(const scene *s, const double *y, double *norm)
{
    double *bent = bend(s, y), sum = 0;
    *norm = 0;
    for (size_t v = 0; v < s->view.vertex_count; v++) {
        size_t ring[64], count = find_ring(s, v, ring);
        double x[7], rows[3][7], detail[3], now[3];
        fit(s, bent, ring, count, x);
        for (int d = 0; d < 3; d++) {
            detail[d] = s->view.vertices[3 * v + (size_t)d];
            now[d] = bent[3 * v + (size_t)d];
            for (size_t k = 1; k < count; k++) {
                detail[d] -= s->view.vertices[3 * ring[k] + (size_t)d] / (double)(count - 1);
                now[d] -= bent[3 * ring[k] + (size_t)d] / (double)(count - 1);
            }
        }
        similarity_rows(detail, rows);
        for (int c = 0; c < 3; c++) {
            double left = now[c];
            for (int i = 0; i < 4; i++) {
                left -= rows[c][i] * x[i];
            }
            sum += left * left;
            *norm += detail[c] * detail[c];
        }
    }
    free(bent);
    return sum;
}

static void form_is_the_definition(void)
{
    scene s;
    static double form[SIZE * SIZE];
    begin(&s);
    double norm = 0, expected_norm, y[SIZE];
    CHECK_EQ(sfi_laplacian_form(s.view, &s.incidence, &s.basis, &s.allocator, NULL, form, &norm),
             SF_OK);
    for (int i = 0; i < 20; i++) {
        for (int k = 0; k < SIZE; k++) {
            y[k] = 2 * test_random_unit() - 1;
        }
        double expected = naive(&s, y, &expected_norm);
        CHECK(expected > 1);
        CHECK_NEAR(value(form, y), expected, 1e-9 * expected);
        CHECK_NEAR(norm, expected_norm, 1e-12 * norm);
    }
    for (int i = 0; i < SIZE * SIZE; i++) {
        CHECK(form[i] == form[i % SIZE * SIZE + i / SIZE]);
    }
    end(&s);
}

static void similarities_cost_nothing(void)
{
    scene s;
    static double form[SIZE * SIZE];
    begin(&s);
    double norm = 0, y[SIZE];
    CHECK_EQ(sfi_laplacian_form(s.view, &s.incidence, &s.basis, &s.allocator, NULL, form, &norm),
             SF_OK);
    for (int i = 0; i < 20; i++) {
        double k = 2 * test_random_unit(), h[3], shift[3];
        for (int d = 0; d < 3; d++) {
            h[d] = test_random_unit() - 0.5;
            shift[d] = 10 * test_random_unit();
        }
        double matrix[9] = {k, -h[2], h[1], h[2], k, -h[0], -h[1], h[0], k};
        all_alike(&s, matrix, shift, y);
        CHECK_NEAR(value(form, y) / norm, 0, 1e-11);
        matrix[0] += 0.2; // stretched along x
        all_alike(&s, matrix, shift, y);
        CHECK(value(form, y) / norm > 1e-3);
    }
    end(&s);
}

static void threads_memory_and_cancel(void)
{
    scene s;
    static double form[SIZE * SIZE], other[SIZE * SIZE];
    begin(&s);
    double norm = 0, other_norm = 0;
    sf_task task = sf_task_default();
    task.parallel_for = backwards;
    CHECK_EQ(sfi_laplacian_form(s.view, &s.incidence, &s.basis, &s.allocator, NULL, form, &norm),
             SF_OK);
    CHECK_EQ(
        sfi_laplacian_form(s.view, &s.incidence, &s.basis, &s.allocator, &task, other, &other_norm),
        SF_OK);
    CHECK(memcmp(form, other, sizeof form) == 0 && norm == other_norm);
    sf_task_cancel(&task);
    other[0] = 7;
    CHECK_EQ(sfi_laplacian_form(s.view, &s.incidence, &s.basis, &s.allocator, &task, other, &norm),
             SF_ERR_CANCELLED);
    for (long k = 0; k < 2; k++) {
        failing_allocator failing;
        failing_begin(&failing, k);
        CHECK_EQ(sfi_laplacian_form(s.view, &s.incidence, &s.basis, &failing.allocator, NULL, other,
                                    &norm),
                 SF_ERR_MEMORY);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    CHECK(other[0] == 7 && norm == other_norm);
    end(&s);
}

int main(void)
{
    TEST(form_is_the_definition);
    TEST(similarities_cost_nothing);
    TEST(threads_memory_and_cancel);
    return test_finish();
}
