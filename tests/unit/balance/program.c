// SPDX-License-Identifier: MIT
// Why: the multipliers trust a small linear program. Its answers are held against their own proof:
// a mixture that is allowed, prices that are allowed, and one and the same value by both; no third
// thing can then be better. Random programs, many of them degenerate.

#include "balance/forest/program.h"

#include "test.h"

#include <math.h>

static double coarse(void)
{
    // A few values only, so that ties and columns that are the same come up often.
    return test_random_below(3) == 0 ? 2 * test_random_unit() - 1
                                     : (double)test_random_below(5) / 2 - 1;
}

static void check_answer(const sfi_program *p, const sfi_program_answer *a)
{
    double sum = 0, cost = p->penalty * a->shortfall, prices = 0, bound = INFINITY;
    for (size_t i = 0; i < p->column_count; i++) {
        double reduced = p->cost[i];
        for (size_t e = 0; e < p->row_count; e++) {
            reduced -= a->price[e] * p->gain[e][i];
        }
        bound = reduced < bound ? reduced : bound;
        CHECK(a->mix[i] >= 0);
        sum += a->mix[i];
        cost += p->cost[i] * a->mix[i];
    }
    CHECK_NEAR(sum, 1, 1e-9);
    CHECK(p->is_free || a->shortfall >= -1e-12);
    for (size_t e = 0; e < p->row_count; e++) {
        double here = a->shortfall;
        for (size_t i = 0; i < p->column_count; i++) {
            here += p->gain[e][i] * a->mix[i];
        }
        CHECK(here >= -1e-9);
        CHECK(a->price[e] >= 0);
        prices += a->price[e];
    }
    CHECK(prices <= p->penalty * (1 + 1e-9));
    if (p->is_free) {
        CHECK_NEAR(prices, p->penalty, 1e-9 * p->penalty);
    }
    CHECK_NEAR(cost, bound, 1e-8 * (1 + p->penalty * (a->shortfall > 1e-12 || p->is_free)));
    CHECK_NEAR(cost, a->least, 1e-9 * (1 + fabs(cost)));
}

static void answers_prove_themselves(void)
{
    for (int round = 0; round < 20000; round++) {
        static sfi_program p;
        sfi_program_answer a;
        p.is_free = (int)test_random_below(2);
        p.penalty = p.is_free ? 1 : test_random_below(2) ? 10 : 1e4;
        p.column_count = 1 + test_random_below(round % 100 == 0 ? SFI_PROGRAM_COLUMNS : 9);
        p.row_count = test_random_below(round % 10 == 0 ? SFI_PROGRAM_ROWS + 1 : 5);
        p.row_count += p.is_free && p.row_count == 0;
        for (size_t i = 0; i < p.column_count; i++) {
            p.cost[i] = p.is_free ? 0 : coarse();
            for (size_t e = 0; e < p.row_count; e++) {
                p.gain[e][i] = coarse();
            }
        }
        sfi_program_solve(&p, &a);
        check_answer(&p, &a);
    }
}

int main(void)
{
    TEST(answers_prove_themselves);
    return test_finish();
}
