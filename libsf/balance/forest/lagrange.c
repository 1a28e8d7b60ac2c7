// SPDX-License-Identifier: MIT
// Lagrange: the best shape under half-spaces, by asking for the best shape without them.
//
// With m(R) the mass of a shape and g_e(R) what the lever of half-space e counts over it, wanted is
//
//     least  c m(R)   where  g_e(R) >= 0 for all e        (c = -1: keep as much as can be; 1: as
//     little)
//
// Let price_e >= 0. Then phi = min over R of c m(R) - sum price_e g_e(R) is less than or equal to
// that least, and finding it is a question about one lever, the sum. The largest phi over all
// prices is the least over mixtures of shapes. It is found by adding shapes: the best mixture of
// those that are known is a small linear program (program.c), whose prices say for which lever to
// ask next; what is found joins, until it is no better than the mixture. Few half-spaces bind, so
// the program takes up only those that a mixture broke.
//
// The deepest: the largest depth for which g_e - depth * h_e >= 0 for all e, with h_e > 0. For a
// depth that is the question how far above 0 the least of these can be brought, with prices that
// sum up to 1; the mixture that answers it holds to a larger depth, and so on (W. Dinkelbach's
// method). The depth is raised between two questions, which costs nothing but small programs.
//
// What is far from possible is helped by a shortfall that is so dear that it is only used where
// there is no other way. Whether half-spaces can hold at all is told by what is left of it.
//
// Source: G. B. Dantzig, P. Wolfe, "Decomposition principle for linear programs", 1960; W.
// Dinkelbach, "On nonlinear fractional programming", 1967.

#include "balance/forest/lagrange.h"

#include "balance/forest/program.h"
#include "base/status.h"

#include <math.h>

// What a shortfall of 1 costs, where a mass of 1 is the whole; and what counts as nothing.
#define PENALTY 1e4
#define TINY 1e-9

enum { DEPTHS_MOST = 30 };

typedef struct solver {
    const sfi_search *search;
    sf_body bodies[SFI_PROGRAM_COLUMNS];
    size_t body_count;
    size_t rows[SFI_PROGRAM_ROWS]; // half-spaces that the program knows
    size_t row_count;
    double depth;
    sfi_program program;
    sfi_program_answer answer;
    sf_body mixture;
} solver;

double sfi_depth_of(const sfi_search *s, const sf_body *body)
{
    double least = 0;
    for (size_t e = 0; e < s->count; e++) {
        double slope = sfi_lever_body(&s->slopes[e], body);
        double depth = slope > 0 ? sfi_lever_body(&s->levers[e], body) / slope : -INFINITY;
        least = e == 0 || depth < least ? depth : least;
    }
    return least;
}

static double cost_of(const sfi_search *s, const sf_body *body)
{
    double mass = body->mass / s->mass_unit;
    return s->goal == SFI_FOREST_MOST ? -mass : s->goal == SFI_FOREST_LEAST ? mass : 0;
}

// Half-space e at the depth that is tried.
static sfi_lever lever_at_depth(const solver *v, size_t e)
{
    return sfi_lever_add(v->search->levers[e], -v->depth, &v->search->slopes[e]);
}

static void load_program(solver *v)
{
    sfi_program *p = &v->program;
    p->row_count = v->row_count;
    p->column_count = v->body_count;
    p->is_free = v->search->goal == SFI_FOREST_DEEPEST;
    p->penalty = p->is_free ? 1 : PENALTY;
    for (size_t i = 0; i < v->body_count; i++) {
        p->cost[i] = cost_of(v->search, &v->bodies[i]);
    }
    for (size_t r = 0; r < v->row_count; r++) {
        sfi_lever l = lever_at_depth(v, v->rows[r]);
        for (size_t i = 0; i < v->body_count; i++) {
            p->gain[r][i] = sfi_lever_body(&l, &v->bodies[i]);
        }
    }
}

static sf_body mix(const solver *v)
{
    sf_body sum = {0, {0, 0, 0}};
    for (size_t i = 0; i < v->body_count; i++) {
        sum = sf_body_add(sum, v->answer.mix[i], v->bodies[i]);
    }
    return sum;
}

// The half-space that a body breaks most, at the depth that is tried; `least` is by how much.
static size_t worst_of(const solver *v, const sf_body *body, double *least)
{
    size_t worst = 0;
    *least = 0;
    for (size_t e = 0; e < v->search->count; e++) {
        sfi_lever l = lever_at_depth(v, e);
        double here = sfi_lever_body(&l, body);
        if (e == 0 || here < *least) {
            *least = here;
            worst = e;
        }
    }
    return worst;
}

// Let the program know half-space e: in a new row, or in that of the one that costs least.
static void take_row(solver *v, size_t e)
{
    size_t row = v->row_count;
    if (row == SFI_PROGRAM_ROWS) {
        row = 0;
        for (size_t r = 1; r < v->row_count; r++) {
            row = v->answer.price[r] < v->answer.price[row] ? r : row;
        }
    } else {
        v->row_count++;
    }
    v->rows[row] = e;
}

static int is_known(const solver *v, size_t e)
{
    for (size_t r = 0; r < v->row_count; r++) {
        if (v->rows[r] == e) {
            return 1;
        }
    }
    return 0;
}

// The best mixture at the depth that is tried, under all half-spaces.
static void solve_at_depth(solver *v)
{
    for (size_t round = 0; round < 2 * SFI_PROGRAM_ROWS; round++) {
        double least;
        load_program(v);
        sfi_program_solve(&v->program, &v->answer);
        v->mixture = mix(v);
        size_t worst = worst_of(v, &v->mixture, &least);
        if (v->search->count == 0 || least + v->answer.shortfall >= -TINY || is_known(v, worst)) {
            return;
        }
        take_row(v, worst);
    }
}

static void solve(solver *v)
{
    solve_at_depth(v);
    for (int i = 0; v->search->goal == SFI_FOREST_DEEPEST && i < DEPTHS_MOST; i++) {
        double depth = sfi_depth_of(v->search, &v->mixture);
        if (!(depth > v->depth)) {
            return;
        }
        v->depth = depth;
        solve_at_depth(v);
    }
}

// The lever that tells what is missing in the mixture.
static sfi_lever next_weight(const solver *v)
{
    sfi_lever weight = {{0, 0, 0}, 0};
    if (v->search->goal != SFI_FOREST_DEEPEST) {
        weight.base = (v->search->goal == SFI_FOREST_MOST ? -1 : 1) / v->search->mass_unit;
    }
    for (size_t r = 0; r < v->row_count; r++) {
        sfi_lever l = lever_at_depth(v, v->rows[r]);
        weight = sfi_lever_add(weight, -v->answer.price[r], &l);
    }
    return weight;
}

// A body joins; where there is no room, in the place of one that is in no mixture.
static void join(solver *v, const sf_body *body)
{
    size_t place = v->body_count;
    if (place == SFI_PROGRAM_COLUMNS) {
        for (place = 0; place + 1 < v->body_count && v->answer.mix[place] > 0;) {
            place++;
        }
    } else {
        v->body_count++;
    }
    v->bodies[place] = *body;
}

// How deep shapes can be by these prices: W. Dinkelbach's steps, from the body that was found last.
static sf_status bound_depth(solver *v, sf_body body, sfi_multipliers *a)
{
    for (;;) {
        double gain = 0, slope = 0, depth = v->depth;
        for (size_t r = 0; r < v->row_count; r++) {
            const sfi_search *s = v->search;
            gain += v->answer.price[r] * sfi_lever_body(&s->levers[v->rows[r]], &body);
            slope += v->answer.price[r] * sfi_lever_body(&s->slopes[v->rows[r]], &body);
        }
        a->bound = slope > 0 && gain / slope > depth ? gain / slope : depth;
        if (!(a->bound > depth) || a->evaluations >= v->search->most) {
            return SF_OK;
        }
        v->depth = a->bound;
        a->weight = next_weight(v);
        SF_TRY(v->search->find(v->search->context, &a->weight, &body));
        a->evaluations++;
    }
}

static sf_status ask(solver *v, sfi_multipliers *a, sf_body *body)
{
    a->weight = next_weight(v);
    a->evaluations++;
    return v->search->find(v->search->context, &a->weight, body);
}

sf_status sfi_multipliers_find(const sfi_search *search, sfi_multipliers *answer)
{
    solver v = {.search = search, .bodies = {search->start}, .body_count = 1};
    sfi_multipliers a = {{{0, 0, 0}, 0}, 0, 0, -INFINITY, 0};
    int is_deepest = search->goal == SFI_FOREST_DEEPEST;
    sf_body body = search->start;
    if (is_deepest) {
        double least;
        v.depth = sfi_depth_of(search, &search->start);
        take_row(&v, worst_of(&v, &search->start, &least));
    }
    do {
        solve(&v);
        SF_TRY(ask(&v, &a, &body));
        double found = sfi_lever_body(&a.weight, &body);
        a.bound = found > a.bound ? found : a.bound;
        if (found >= v.answer.least - TINY) {
            break;
        }
        join(&v, &body);
    } while (a.evaluations < search->most);
    a.holds = is_deepest ? v.depth >= 0 : v.answer.shortfall <= TINY;
    a.value = is_deepest ? v.depth : v.mixture.mass;
    if (is_deepest) {
        SF_TRY(bound_depth(&v, body, &a));
    } else {
        a.bound *= search->goal == SFI_FOREST_MOST ? -search->mass_unit : search->mass_unit;
    }
    *answer = a;
    return SF_OK;
}
