// SPDX-License-Identifier: MIT
// Small convex quadratic programs, by the dual active set.
//
// Begin at the minimum without rows. While a row is violated, take the worst and move towards it
// along the direction that keeps the active rows as they are; on the way the multiplier of an
// active row may reach zero, and the row is let go. Each row taken in raises the minimum, so that
// no set of active rows comes twice, and the end is the exact solution or the proof that there is
// none: a violated row whose normal is a non-negative combination of active ones.
//
// With H = L L^T everything is done in coordinates y = L^T x, where the program is to find the
// point nearest to a given one: a row r becomes L^-1 r, and the active ones are kept as Q R,
// orthogonal columns times a triangle. Rows that depend on active ones to within rounding have no
// direction left. Sizes are some dozens, so that Q R is simply made anew when a row is let go.
//
// Source: D. Goldfarb, A. Idnani, "A numerically stable dual method for solving strictly convex
// quadratic programs", 1983.

#include "balance/bend/quadratic.h"

#include "base/memory.h"
#include "base/size.h"
#include "base/status.h"

#include <math.h>
#include <string.h>

// Violations below this share of what a row adds up are rounding.
#define ROUNDING 1e-11
// A row depends on others when this share of its length is left beside them.
#define DEPENDENT 1e-10

typedef struct solver {
    const sfi_quadratic *program;
    size_t n, active_count;
    double *factor;                // n x n, the lower triangle of H = L L^T
    double *columns;               // L^-1 row of each active row, n numbers each
    double *ortho;                 // the same, orthonormal
    double *triangle;              // columns = ortho triangle; n numbers a column
    double *x, *multiplier;        // of the active rows
    double *column, *share, *rest; // of the row that is being taken in: in terms of ortho, and rest
    double *along, *ease;          // how x and the multipliers of active rows move
    size_t *active;                // rows
    double *memory;
    size_t memory_count;
} solver;

static double dot(const double *a, const double *b, size_t n)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

// Returns 0 where the matrix is not positive definite.
static int factorize(const double *matrix, size_t n, double *factor)
{
    for (size_t i = 0; i < n; i++) {
        for (size_t j = 0; j <= i; j++) {
            double left = matrix[i * n + j] - dot(factor + i * n, factor + j * n, j);
            if (i != j) {
                factor[i * n + j] = left / factor[j * n + j];
            } else if (left > 0) {
                factor[i * n + i] = sqrt(left);
            } else {
                return 0;
            }
        }
    }
    return 1;
}

// b = L^-1 b.
static void forward(const solver *s, double *b)
{
    for (size_t i = 0; i < s->n; i++) {
        b[i] = (b[i] - dot(s->factor + i * s->n, b, i)) / s->factor[i * s->n + i];
    }
}

// b = L^-T b.
static void backward(const solver *s, double *b)
{
    for (size_t i = s->n; i-- > 0;) {
        b[i] /= s->factor[i * s->n + i];
        for (size_t j = 0; j < i; j++) {
            b[j] -= s->factor[i * s->n + j] * b[i];
        }
    }
}

static void start(solver *s)
{
    for (size_t i = 0; i < s->n; i++) {
        s->x[i] = -s->program->gradient[i];
    }
    forward(s, s->x);
    backward(s, s->x);
}

// share = coordinates of `column` among the first `count` orthonormal columns, rest = what is left.
// Twice, so that the rest is orthogonal even where it is small. Returns its length.
static double split(const solver *s, const double *column, size_t count, double *share,
                    double *rest)
{
    memcpy(rest, column, s->n * sizeof *rest);
    memset(share, 0, count * sizeof *share);
    for (int round = 0; round < 2; round++) {
        for (size_t j = 0; j < count; j++) {
            const double *q = s->ortho + j * s->n;
            double part = dot(q, rest, s->n);
            share[j] += part;
            for (size_t i = 0; i < s->n; i++) {
                rest[i] -= part * q[i];
            }
        }
    }
    return sqrt(dot(rest, rest, s->n));
}

// Put active column j, whose share and rest are known, into Q R.
static void append(solver *s, size_t j, const double *share, const double *rest, double length)
{
    double *triangle = s->triangle + j * s->n;
    memcpy(triangle, share, j * sizeof *share);
    triangle[j] = length;
    for (size_t i = 0; i < s->n; i++) {
        s->ortho[j * s->n + i] = rest[i] / length;
    }
}

// Let active row number j go.
static void drop(solver *s, size_t j)
{
    size_t n = s->n, after = --s->active_count - j;
    memmove(s->columns + j * n, s->columns + (j + 1) * n, after * n * sizeof *s->columns);
    memmove(s->active + j, s->active + j + 1, after * sizeof *s->active);
    memmove(s->multiplier + j, s->multiplier + j + 1, after * sizeof *s->multiplier);
    for (size_t k = j; k < s->active_count; k++) {
        double length = split(s, s->columns + k * n, k, s->ease, s->along);
        append(s, k, s->ease, s->along, length);
    }
}

static double excess(const solver *s, size_t row)
{
    return dot(s->program->rows + row * s->n, s->x, s->n) - s->program->bounds[row];
}

// The row that is violated most for its length, or row_count where none is.
static size_t find_violated(const solver *s)
{
    size_t worst = s->program->row_count;
    double most = 0;
    for (size_t r = 0; r < s->program->row_count; r++) {
        const double *row = s->program->rows + r * s->n;
        double scale = fabs(s->program->bounds[r]), square = 0;
        for (size_t i = 0; i < s->n; i++) {
            scale += fabs(row[i] * s->x[i]);
            square += row[i] * row[i];
        }
        double lacking = -excess(s, r);
        if (lacking > ROUNDING * scale && lacking > most * sqrt(square)) {
            most = square > 0 ? lacking / sqrt(square) : INFINITY;
            worst = r;
        }
    }
    return worst;
}

// How far to go before the multiplier of an active row is used up, and which.
static double find_limit(const solver *s, size_t *which)
{
    double least = INFINITY;
    for (size_t j = 0; j < s->active_count; j++) {
        if (s->ease[j] > 0 && s->multiplier[j] < least * s->ease[j]) {
            least = s->multiplier[j] / s->ease[j];
            *which = j;
        }
    }
    return least;
}

// Directions for the row whose column is set: `ease` of the multipliers, `along` of x. Returns the
// square of the rest's length, 0 where the row depends on active ones.
static double find_direction(solver *s)
{
    size_t n = s->n, count = s->active_count;
    double length = split(s, s->column, count, s->share, s->rest);
    for (size_t i = count; i-- > 0;) {
        double left = s->share[i];
        for (size_t j = i + 1; j < count; j++) {
            left -= s->triangle[j * n + i] * s->ease[j];
        }
        s->ease[i] = left / s->triangle[i * n + i];
    }
    if (count == n || length <= DEPENDENT * sqrt(dot(s->column, s->column, n))) {
        return 0;
    }
    memcpy(s->along, s->rest, n * sizeof *s->along);
    backward(s, s->along);
    return length * length;
}

// Move by `step` along the direction; `moves` says whether x does.
static void go(solver *s, double step, int moves)
{
    for (size_t j = 0; j < s->active_count; j++) {
        s->multiplier[j] -= step * s->ease[j];
    }
    for (size_t i = 0; moves && i < s->n; i++) {
        s->x[i] += step * s->along[i];
    }
}

// Make a violated row hold. SF_ERR_INFEASIBLE where nothing does.
static sf_status take_in(solver *s, size_t row)
{
    double own = 0;
    memcpy(s->column, s->program->rows + row * s->n, s->n * sizeof *s->column);
    forward(s, s->column);
    for (;;) {
        size_t used_up = 0;
        double square = find_direction(s), limit = find_limit(s, &used_up);
        double whole = square > 0 ? -excess(s, row) / square : INFINITY;
        double step = limit < whole ? limit : whole;
        if (isinf(step)) {
            return SF_ERR_INFEASIBLE;
        }
        go(s, step, square > 0);
        own += step;
        if (limit >= whole) {
            size_t at = s->active_count++;
            memcpy(s->columns + at * s->n, s->column, s->n * sizeof *s->column);
            append(s, at, s->share, s->rest, sqrt(square));
            s->active[at] = row;
            s->multiplier[at] = own;
            return SF_OK;
        }
        drop(s, used_up);
    }
}

static sf_status prepare(solver *s, const sf_allocator *allocator)
{
    size_t n = s->n, square, most;
    if (!sfi_size_mul(n, n, &square) || !sfi_size_mul(square, 8, &most) ||
        !sfi_size_add(most, 8 * n, &most)) {
        return SF_ERR_MEMORY;
    }
    s->memory_count = 4 * square + 7 * n;
    s->memory = sfi_alloc_array(allocator, s->memory_count, sizeof *s->memory);
    s->active = sfi_alloc_array(allocator, n, sizeof *s->active);
    if (s->memory == NULL || s->active == NULL) {
        return SF_ERR_MEMORY;
    }
    double *at = s->memory;
    s->factor = sfi_cut(&at, square);
    s->columns = sfi_cut(&at, square);
    s->ortho = sfi_cut(&at, square);
    s->triangle = sfi_cut(&at, square);
    s->x = sfi_cut(&at, n);
    s->multiplier = sfi_cut(&at, n);
    s->column = sfi_cut(&at, n);
    s->share = sfi_cut(&at, n);
    s->rest = sfi_cut(&at, n);
    s->along = sfi_cut(&at, n);
    s->ease = sfi_cut(&at, n);
    return factorize(s->program->hessian, n, s->factor) ? SF_OK : SF_ERR_ARGUMENT;
}

// Rounding could make a set of rows come back; the bound is far above what a program needs.
static sf_status solve(solver *s)
{
    size_t rounds = 100 * (s->n + s->program->row_count) + 1000;
    start(s);
    for (size_t i = 0; i < rounds; i++) {
        size_t row = find_violated(s);
        if (row == s->program->row_count) {
            return SF_OK;
        }
        SF_TRY(take_in(s, row));
    }
    return SF_ERR_INFEASIBLE;
}

sf_status sfi_quadratic_solve(const sfi_quadratic *program, const sf_allocator *allocator,
                              double *x, double *multipliers)
{
    solver s;
    memset(&s, 0, sizeof s);
    s.program = program;
    s.n = program->size;
    sf_status status = prepare(&s, allocator);
    if (status == SF_OK) {
        status = solve(&s);
    }
    if (status == SF_OK) {
        memcpy(x, s.x, s.n * sizeof *x);
    }
    if (status == SF_OK && multipliers != NULL) {
        memset(multipliers, 0, program->row_count * sizeof *multipliers);
        for (size_t j = 0; j < s.active_count; j++) {
            multipliers[s.active[j]] = s.multiplier[j];
        }
    }
    sfi_free_array(allocator, s.memory, s.memory_count, sizeof *s.memory);
    sfi_free_array(allocator, s.active, s.n, sizeof *s.active);
    return status;
}
