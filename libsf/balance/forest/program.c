// SPDX-License-Identifier: MIT
// Program: a linear program of a dozen rows, solved by the simplex method on a dense tableau.
//
// The program always has a solution: the first column alone, and as much shortfall as its worst row
// needs, are where the method begins. So there is no first phase. Variables are the mixture, a
// surplus s_e for each row, and t; where t is free it is the difference of two. Rows are
//
//     s_e - sum gain_ei mix_i - t = 0,      sum mix_i = 1
//
// The reduced cost of s_e at the end is the price of row e.
//
// The column of least reduced cost comes in, of equals the first; after some dozens of steps only
// the first that is negative does, as R. G. Bland has shown to end always. Sums run in one order,
// so the answer is the same bytes everywhere.
//
// Source: G. B. Dantzig, "Linear Programming and Extensions", 1963; R. G. Bland, "New finite
// pivoting rules for the simplex method", 1977.

#include "balance/forest/program.h"

#include <math.h>

enum { WIDTH = SFI_PROGRAM_COLUMNS + SFI_PROGRAM_ROWS + 3, HEIGHT = SFI_PROGRAM_ROWS + 2 };

// A reduced cost or a pivot of less counts as 0.
#define TINY 1e-12
#define STEPS_BEFORE_BLAND 60
#define STEPS_MOST 600

typedef struct tableau {
    size_t height, width;       // rows without that of costs; columns without the right side
    double cell[HEIGHT][WIDTH]; // the last row holds reduced costs, the last column the right side
    size_t basic[SFI_PROGRAM_ROWS + 1];
} tableau;

static void pivot(tableau *t, size_t row, size_t column)
{
    double by = 1 / t->cell[row][column];
    for (size_t j = 0; j <= t->width; j++) {
        t->cell[row][j] *= by;
    }
    for (size_t i = 0; i <= t->height; i++) {
        double factor = t->cell[i][column];
        for (size_t j = 0; i != row && factor != 0 && j <= t->width; j++) {
            t->cell[i][j] -= factor * t->cell[row][j];
        }
    }
    t->basic[row] = column;
}

// Rows and costs as they are, then the first column and the worst row's shortfall made basic.
static void begin(const sfi_program *p, tableau *t)
{
    size_t n = p->column_count, m = p->row_count, help = n + m;
    *t = (tableau){m + 1, n + m + (p->is_free ? 2u : 1u), {{0}}, {0}};
    for (size_t e = 0; e < m; e++) {
        for (size_t i = 0; i < n; i++) {
            t->cell[e][i] = -p->gain[e][i];
        }
        t->cell[e][n + e] = 1;
        t->cell[e][help] = -1;
        t->cell[e][help + 1] = p->is_free ? 1 : 0; // or the right side
        t->basic[e] = n + e;
    }
    for (size_t i = 0; i < n; i++) {
        t->cell[m][i] = 1;
        t->cell[m + 1][i] = p->cost[i];
    }
    t->cell[m][t->width] = 1;
    t->cell[m + 1][help] = p->penalty;
    if (p->is_free) {
        t->cell[m + 1][help + 1] = -p->penalty;
    }
    pivot(t, m, 0);
    size_t worst = m;
    for (size_t e = 0; e < m; e++) {
        double here = t->cell[e][t->width], least = worst < m ? t->cell[worst][t->width] : 0;
        worst = here < least ? e : worst;
    }
    if (worst < m) {
        pivot(t, worst, help);
    }
}

static size_t incoming(const tableau *t, int by_bland)
{
    size_t best = t->width;
    double least = -TINY;
    for (size_t j = 0; j < t->width; j++) {
        double here = t->cell[t->height][j];
        if (here < least) {
            best = j;
            if (by_bland) {
                break;
            }
            least = here;
        }
    }
    return best;
}

// The row whose variable is the first to reach 0; of equals the one of the least variable.
static size_t outgoing(const tableau *t, size_t column)
{
    size_t best = t->height;
    double least = 0;
    for (size_t i = 0; i < t->height; i++) {
        if (t->cell[i][column] <= TINY) {
            continue;
        }
        double ratio = t->cell[i][t->width] / t->cell[i][column];
        if (best == t->height || ratio < least ||
            (ratio == least && t->basic[i] < t->basic[best])) {
            best = i;
            least = ratio;
        }
    }
    return best;
}

static void read_answer(const sfi_program *p, const tableau *t, sfi_program_answer *a)
{
    size_t n = p->column_count, m = p->row_count;
    double value[WIDTH] = {0};
    for (size_t i = 0; i < t->height; i++) {
        value[t->basic[i]] = t->cell[i][t->width];
    }
    for (size_t i = 0; i < n; i++) {
        a->mix[i] = value[i] > 0 ? value[i] : 0;
    }
    for (size_t e = 0; e < m; e++) {
        double price = t->cell[t->height][n + e];
        a->price[e] = price > 0 ? price : 0;
    }
    a->shortfall = value[n + m] - (p->is_free ? value[n + m + 1] : 0);
    a->least = p->penalty * a->shortfall;
    for (size_t i = 0; i < n; i++) {
        a->least += p->cost[i] * a->mix[i];
    }
}

void sfi_program_solve(const sfi_program *program, sfi_program_answer *answer)
{
    tableau t;
    begin(program, &t);
    for (int step = 0; step < STEPS_MOST; step++) {
        size_t column = incoming(&t, step >= STEPS_BEFORE_BLAND);
        size_t row = column < t.width ? outgoing(&t, column) : t.height;
        if (row == t.height) {
            break; // the best; or so close to it that no pivot is to be trusted
        }
        pivot(&t, row, column);
    }
    read_answer(program, &t, answer);
}
