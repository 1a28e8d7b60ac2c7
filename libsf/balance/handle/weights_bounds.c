// SPDX-License-Identifier: MIT
// Weights within their bounds: an augmented Lagrangian, each of its problems by Newton's method.
//
// The least w . A w / 2 with 0 <= w <= 1 has multipliers y, not below 0 where w = 0 and not above 0
// where w = 1, with A w = y. For multipliers y and a penalty s of each node the function
//
//     w . A w / 2 + sum of (y'^2 - y^2) / (2 s),   y' = max(y - s w, 0) + min(y + s (1 - w), 0)
//
// is convex, once differentiable and quadratic in pieces; its gradient is A w - y'. Newton's
// method, with an exact search along each step, finds its least value after finitely many steps
// whatever it begins from. Then y becomes y', and s grows. Each Newton step is a linear system with
// s on the diagonal of nodes that a bound holds, which are pinned in the multigrid cycle.
//
// The plain active-set method, which is the same with s without limit and one step for each y, runs
// in circles here: near a handle it swaps the same few nodes for ever.
//
// Source: M. R. Hestenes, "Multiplier and Gradient Methods", 1969; R. T. Rockafellar, "The
// Multiplier Method of Hestenes and Powell Applied to Convex Programming", 1973; L. Qi, J. Sun, "A
// Nonsmooth Version of Newton's Method", 1993.

#include "balance/handle/weights_bounds.h"

#include "base/status.h"

#include <math.h>
#include <string.h>

enum { ROUNDS_MAX = 400, HALVINGS = 24 };
#define STIFF_MAX 1000.0
#define STILL 1e-6

// One of four, on its way.
typedef struct lane {
    int open;
    double stiff;    // penalty of a node, in units of A's diagonal
    double inner;    // how near to stationary the multipliers are changed
    double from, to; // of the search
    double slope;    // along the step, at its beginning
    double left;
} lane;

typedef struct bounds {
    sfi_plate *plate;
    size_t numbers;
    double *w, *multiplier, *gradient, *penalty, *step, *image, *right;
    lane lanes[SFI_LANES];
    double tolerance;
} bounds;

// Diagonal of A at a node.
static double stiffness(const sfi_poisson *p, size_t node)
{
    const sfi_level *l = &p->level[0];
    double own = (double)l->diagonal[node], sum = own * own / p->mass[node];
    for (size_t n = 0; n < 6; n++) {
        double flow = (double)l->flow[6 * node + n];
        sum += flow * flow / p->mass[l->neighbour[6 * node + n]];
    }
    return sum;
}

// y' of a number, and whether a bound holds it.
static inline double pull(double multiplier, double s, double w)
{
    double low = multiplier - s * w, high = low + s;
    return low > 0 ? low : high < 0 ? high : 0;
}

// Everything that a Newton step needs at w: penalty, right-hand side, pins.
static void linearize(bounds *t)
{
    const sfi_poisson *p = t->plate->poisson;
    float *pin = t->plate->cycle.x[0]; // free until the cycle runs
    sfi_plate_apply(t->plate, t->w, t->gradient);
    for (size_t i = 0; i < p->level[0].count; i++) {
        double d = stiffness(p, i);
        for (size_t k = 0; k < SFI_LANES; k++) {
            size_t n = SFI_LANES * i + k;
            double s = t->lanes[k].stiff * d, y = pull(t->multiplier[n], s, t->w[n]);
            int works = t->lanes[k].open && !t->plate->fixed[i];
            t->penalty[n] = works && y != 0 ? s : 0;
            t->right[n] = works ? y - t->gradient[n] : 0;
            pin[n] = (float)sqrt(t->penalty[n] * p->mass[i]);
        }
    }
    sfi_cycle_hold(&t->plate->cycle, t->plate->fixed, pin);
}

// slope[lane] of the function along the step, at w + length step.
static void measure_slope(const bounds *t, const double length[SFI_LANES], double slope[SFI_LANES])
{
    const sfi_poisson *p = t->plate->poisson;
    memset(slope, 0, SFI_LANES * sizeof *slope);
    for (size_t i = 0; i < p->level[0].count; i++) {
        double d = stiffness(p, i);
        for (size_t k = 0; k < SFI_LANES && !t->plate->fixed[i]; k++) {
            size_t n = SFI_LANES * i + k;
            double y =
                pull(t->multiplier[n], t->lanes[k].stiff * d, t->w[n] + length[k] * t->step[n]);
            slope[k] += t->step[n] * (t->gradient[n] + length[k] * t->image[n] - y);
        }
    }
}

// How far to go: all the way where the function still falls there, else to where it ends to fall.
static void search(bounds *t, double length[SFI_LANES])
{
    double low[SFI_LANES] = {0}, high[SFI_LANES], slope[SFI_LANES], zero[SFI_LANES] = {0};
    int any = 0;
    sfi_plate_apply(t->plate, t->step, t->image);
    for (size_t k = 0; k < SFI_LANES; k++) {
        high[k] = length[k] = 1;
    }
    measure_slope(t, zero, zero);
    measure_slope(t, length, slope);
    for (size_t k = 0; k < SFI_LANES; k++) {
        // A slope that rounding made is none.
        int over = slope[k] > 1e-9 * fabs(zero[k]);
        low[k] = over ? 0 : 1;
        any |= over;
    }
    for (int round = 0; any && round < HALVINGS; round++) {
        for (size_t k = 0; k < SFI_LANES; k++) {
            length[k] = 0.5 * (low[k] + high[k]);
        }
        measure_slope(t, length, slope);
        for (size_t k = 0; k < SFI_LANES; k++) {
            low[k] = slope[k] > 0 ? low[k] : length[k];
            high[k] = slope[k] > 0 ? length[k] : high[k];
        }
    }
    memcpy(length, low, SFI_LANES * sizeof *length);
}

// A lane is stationary for its multipliers: change them, or end it.
static void turn_over(bounds *t, size_t k)
{
    const sfi_poisson *p = t->plate->poisson;
    lane *l = &t->lanes[k];
    double off = 0;
    for (size_t i = 0; i < p->level[0].count; i++) {
        size_t n = SFI_LANES * i + k;
        double w = t->w[n];
        if (t->plate->fixed[i]) {
            continue;
        }
        double y = pull(t->multiplier[n], l->stiff * stiffness(p, i), w);
        double gap = y > 0 ? fabs(w) : y < 0 ? fabs(1 - w) : w < 0 ? -w : w > 1 ? w - 1 : 0;
        off = gap > off ? gap : off;
        t->multiplier[n] = y;
    }
    l->left = off > l->left ? off : l->left;
    if (l->left <= t->tolerance && l->inner <= 0.1 * t->tolerance) {
        l->open = 0;
    }
    l->inner = 0.1 * (off > t->tolerance ? off : t->tolerance);
    l->stiff = l->stiff < STIFF_MAX ? 10 * l->stiff : STIFF_MAX;
}

static sf_status newton_round(bounds *t, const sf_task *task)
{
    double length[SFI_LANES];
    sfi_plate_goal goal[SFI_LANES];
    linearize(t);
    for (size_t k = 0; k < SFI_LANES; k++) {
        sfi_plate_goal g = {t->lanes[k].inner, 0.05, 0, 0};
        goal[k] = g;
    }
    SF_TRY(sfi_plate_solve(t->plate, t->penalty, t->right, task, t->step, goal));
    search(t, length);
    for (size_t n = 0; n < t->numbers; n += SFI_LANES) {
        for (size_t k = 0; k < SFI_LANES; k++) {
            t->w[n + k] += length[k] * t->step[n + k];
        }
    }
    for (size_t k = 0; k < SFI_LANES; k++) {
        t->lanes[k].left = goal[k].first;
        // Where rounding lets no step go down any more it is as stationary as it gets.
        if (t->lanes[k].open && (goal[k].first <= t->lanes[k].inner || length[k] < STILL)) {
            turn_over(t, k);
        }
    }
    return SF_OK;
}

sf_status sfi_bounds_solve(sfi_plate *plate, size_t lanes, double tolerance, const sf_task *task,
                           double *scratch, double *w, double *left)
{
    bounds t = {.plate = plate, .w = w, .tolerance = tolerance};
    t.numbers = SFI_LANES * plate->poisson->level[0].count;
    double **vectors[SFI_BOUNDS_VECTORS] = {&t.multiplier, &t.gradient, &t.penalty,
                                            &t.step,       &t.image,    &t.right};
    for (size_t v = 0; v < SFI_BOUNDS_VECTORS; v++) {
        *vectors[v] = scratch + v * t.numbers;
    }
    memset(t.multiplier, 0, t.numbers * sizeof *t.multiplier);
    for (size_t k = 0; k < SFI_LANES; k++) {
        lane l = {.open = k < lanes, .stiff = 1, .inner = 1e-2};
        t.lanes[k] = l;
    }
    for (int round = 0; round < ROUNDS_MAX; round++) {
        int any = 0;
        *left = 0;
        for (size_t k = 0; k < SFI_LANES; k++) {
            any |= t.lanes[k].open;
            *left = t.lanes[k].left > *left ? t.lanes[k].left : *left;
        }
        if (!any) {
            return SF_OK;
        }
        SF_TRY(newton_round(&t, task));
    }
    return SF_ERR_INTERNAL;
}
