// SPDX-License-Identifier: MIT
// Why: every step of balancing is a small quadratic program. What is returned must meet the
// conditions that make a point the minimum (Karush, Kuhn, Tucker), which are checked from the
// definition; and where it says that nothing meets the rows, multipliers of Farkas must exist: here
// such programs are built so that they are known to be empty, or known not to be.

#include "balance/bend/quadratic.h"
#include "base/memory.h"
#include "failing_allocator.h"
#include "test.h"

enum { SIZE_MAX_TESTED = 20, ROWS_MAX = 60 };

typedef struct made {
    double hessian[SIZE_MAX_TESTED * SIZE_MAX_TESTED], gradient[SIZE_MAX_TESTED];
    double rows[ROWS_MAX * SIZE_MAX_TESTED], bounds[ROWS_MAX], inside[SIZE_MAX_TESTED];
    sfi_quadratic program;
} made;

static double centred(void)
{
    return 2 * test_random_unit() - 1;
}

// H = B^T B + ridge; rows with a known point inside, some of them double or dependent.
static void make(made *m, size_t n, size_t row_count, double ridge)
{
    double b[SIZE_MAX_TESTED * SIZE_MAX_TESTED];
    for (size_t i = 0; i < n * n; i++) {
        b[i] = centred();
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j < n; j++) {
            double sum = i == j ? ridge : 0;
            for (size_t k = 0; k < n; k++) {
                sum += b[k * n + i] * b[k * n + j];
            }
            m->hessian[i * n + j] = sum;
        }
        m->gradient[i] = 3 * centred();
        m->inside[i] = centred();
    }
    for (size_t r = 0; r < row_count; r++) {
        double at = 0;
        for (size_t i = 0; i < n; i++) {
            double *row = m->rows + r * n;
            row[i] = r % 5 == 4 ? row[i - n] : r % 7 == 6 ? row[i - n] + row[i - 2 * n] : centred();
            at += row[i] * m->inside[i];
        }
        m->bounds[r] = at - (test_random_below(3) == 0 ? 0 : test_random_unit());
    }
    sfi_quadratic p = {n, m->hessian, m->gradient, row_count, m->rows, m->bounds};
    m->program = p;
}

static void check_minimum(const sfi_quadratic *p, const double *x, const double *multipliers)
{
    for (size_t i = 0; i < p->size; i++) {
        double slope = p->gradient[i];
        for (size_t j = 0; j < p->size; j++) {
            slope += p->hessian[i * p->size + j] * x[j];
        }
        for (size_t r = 0; r < p->row_count; r++) {
            slope -= multipliers[r] * p->rows[r * p->size + i];
        }
        CHECK_NEAR(slope, 0, 1e-7);
    }
    for (size_t r = 0; r < p->row_count; r++) {
        double over = -p->bounds[r];
        for (size_t i = 0; i < p->size; i++) {
            over += p->rows[r * p->size + i] * x[i];
        }
        CHECK(over > -1e-8 && multipliers[r] > -1e-8);
        CHECK_NEAR(over * multipliers[r], 0, 1e-7);
    }
}

static void results_are_minima(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    static made m;
    for (int i = 0; i < 3000; i++) {
        double x[SIZE_MAX_TESTED], multipliers[ROWS_MAX];
        size_t n = 1 + test_random_below(SIZE_MAX_TESTED);
        make(&m, n, test_random_below(ROWS_MAX + 1), i % 3 == 0 ? 1e-3 : 0.1);
        CHECK_EQ(sfi_quadratic_solve(&m.program, &allocator, x, multipliers), SF_OK);
        check_minimum(&m.program, x, multipliers);
    }
}

// Three rows that add up to 0 >= something above 0.
static void contradictions_are_found(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    static made m;
    for (int i = 0; i < 1000; i++) {
        double x[SIZE_MAX_TESTED] = {7}, multipliers[ROWS_MAX] = {7};
        size_t n = 2 + test_random_below(SIZE_MAX_TESTED - 2);
        make(&m, n, 3 + test_random_below(20), 0.1);
        for (size_t k = 0; k < n; k++) {
            m.rows[2 * n + k] = -m.rows[k] - 2 * m.rows[n + k];
        }
        m.bounds[2] = 0.001 - m.bounds[0] - 2 * m.bounds[1];
        CHECK_EQ(sfi_quadratic_solve(&m.program, &allocator, x, multipliers), SF_ERR_INFEASIBLE);
        CHECK(x[0] == 7 && multipliers[0] == 7);
    }
}

static void by_hand(void)
{
    // Nearest point to (3, 4) with x + y <= 1 and x >= 0.5: (0.5, 0.5).
    const double hessian[] = {1, 0, 0, 1}, gradient[] = {-3, -4}, rows[] = {-1, -1, 1, 0},
                 bounds[] = {-1, 0.5}, indefinite[] = {1, 2, 2, 1};
    sfi_quadratic p = {2, hessian, gradient, 2, rows, bounds};
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    double x[2], multipliers[2];
    CHECK_EQ(sfi_quadratic_solve(&p, &allocator, x, multipliers), SF_OK);
    CHECK_NEAR(x[0], 0.5, 1e-14);
    CHECK_NEAR(x[1], 0.5, 1e-14);
    CHECK_NEAR(multipliers[0], 3.5, 1e-14);
    CHECK_NEAR(multipliers[1], 1, 1e-14);
    p.row_count = 0;
    CHECK_EQ(sfi_quadratic_solve(&p, &allocator, x, NULL), SF_OK);
    CHECK(x[0] == 3 && x[1] == 4);
    p.hessian = indefinite;
    CHECK_EQ(sfi_quadratic_solve(&p, &allocator, x, NULL), SF_ERR_ARGUMENT);
    CHECK(x[0] == 3 && x[1] == 4);
}

static void memory_may_fail(void)
{
    static made m;
    make(&m, 5, 9, 0.1);
    for (long k = 0; k < 3; k++) {
        failing_allocator failing;
        double x[5] = {7};
        failing_begin(&failing, k);
        CHECK_EQ(sfi_quadratic_solve(&m.program, &failing.allocator, x, NULL),
                 k < 2 ? SF_ERR_MEMORY : SF_OK);
        CHECK(k == 2 || x[0] == 7);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
}

int main(void)
{
    TEST(results_are_minima);
    TEST(contradictions_are_found);
    TEST(by_hand);
    TEST(memory_may_fail);
    return test_finish();
}
