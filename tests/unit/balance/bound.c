// SPDX-License-Identifier: MIT
// Why: what no carving can pass decides whether a shape must be bent at all, so it must be neither
// too high nor too low. With one half-space the fractional optimum is a matter of sorting; with two
// it is the least, over all ways to weigh them against each other, of what one can reach, found by
// trying ways in small steps. Neither knows of linear programs.

#include "carving.h"

// What a voxel adds to half-space e, gain and slope, and what it weighs.
typedef struct part {
    double gain[2], slope[2], mass;
} part;

typedef struct problem {
    part loose[4096], fixed; // what may go; all else, with the rest
    int count;
} problem;

static part part_of(const carving_scene *c, const sf_body *b)
{
    part p = {{0, 0}, {0, 0}, b->mass};
    for (size_t e = 0; e < 2 && e < c->options.count; e++) {
        const sf_halfspace *h = &c->halfspaces[e], *g = &c->slopes[e];
        p.gain[e] = -h->offset_mm * b->mass;
        p.slope[e] = c->options.slopes != NULL ? -g->offset_mm * b->mass : b->mass;
        for (int i = 0; i < 3; i++) {
            p.gain[e] += h->normal[i] * b->moment[i];
            p.slope[e] += c->options.slopes != NULL ? g->normal[i] * b->moment[i] : 0;
        }
    }
    return p;
}

static void read_problem(const carving_scene *c, problem *p)
{
    static stack one;
    sf_body fixed = naive_body(&c->given, c->options.density, c->options.rest);
    sf_body none = {0, {0, 0, 0}};
    p->fixed = part_of(c, &fixed);
    p->count = 0;
    stack_clear(&one, c->s.nx, c->s.ny, c->s.nz);
    for (int i = 0; i < stack_count(&c->s); i++) {
        if (c->s.solid[i] && !c->given.solid[i]) {
            one.solid[i] = 1;
            sf_body body = naive_body(&one, c->options.density, none);
            one.solid[i] = 0;
            p->loose[p->count++] = part_of(c, &body);
        }
    }
}

// The most that share * (gain - depth slope) of the first and (1 - share) of the second can be.
static double most_at(const problem *p, double depth, double share)
{
    double sum = 0;
    for (int i = -1; i < p->count; i++) {
        const part *q = i < 0 ? &p->fixed : &p->loose[i];
        double here = share * (q->gain[0] - depth * q->slope[0]) +
                      (1 - share) * (q->gain[1] - depth * q->slope[1]);
        sum += i < 0 || here > 0 ? here : 0;
    }
    return sum;
}

// Depth at which the most is 0, by halving.
static double depth_at(const problem *p, double share)
{
    double low = -30, high = 30;
    for (int i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        *(most_at(p, middle, share) > 0 ? &low : &high) = middle;
    }
    return low;
}

static double naive_depth_bound(const problem *p, int is_double)
{
    double least = depth_at(p, 1), step = 1 / 64.0, at = 1;
    for (int i = 0; is_double && i <= 64; i++) {
        double here = depth_at(p, i * step);
        at = here < least ? i * step : at;
        least = here < least ? here : least;
    }
    // What a way can reach has one valley only: go on in smaller steps around the least.
    for (; is_double && step > 1e-9; step /= 2) {
        for (int side = -1; side <= 1; side += 2) {
            double share = at + side * step / 2;
            double here = share >= 0 && share <= 1 ? depth_at(p, share) : INFINITY;
            if (here < least) {
                least = here;
                at = share;
                side = -3;
            }
        }
    }
    return least;
}

static int by_price(const void *a, const void *b)
{
    double p = *(const double *)a, q = *(const double *)b;
    return (p > q) - (p < q);
}

// The most mass under one half-space: all that helps, and of what harms the cheapest for its mass.
static double naive_mass_bound(const problem *p)
{
    static double harm[4096][2];
    double mass = p->fixed.mass, gain = p->fixed.gain[0];
    int count = 0;
    for (int i = 0; i < p->count; i++) {
        if (p->loose[i].gain[0] >= 0) {
            mass += p->loose[i].mass;
            gain += p->loose[i].gain[0];
        } else {
            harm[count][0] = -p->loose[i].gain[0] / p->loose[i].mass; // has mass, or it did no harm
            harm[count++][1] = p->loose[i].mass;
        }
    }
    qsort(harm, (size_t)count, sizeof harm[0], by_price);
    if (gain < 0) {
        return 0;
    }
    for (int i = 0; i < count; i++) {
        double share = harm[i][0] * harm[i][1] > gain ? gain / (harm[i][0] * harm[i][1]) : 1;
        mass += share * harm[i][1];
        gain -= share * harm[i][0] * harm[i][1];
    }
    return mass;
}

static void bounds_are_optima(void)
{
    static carving_scene c;
    static problem p;
    int checked = 0;
    for (int round = 0; round < 600; round++) {
        double depth = 7, mass = 7;
        carving_begin(&c, 0, 2 + (int)test_random_below(6), 1 + (int)test_random_below(5),
                      1 + (int)test_random_below(6));
        c.options.count = c.options.count > 2 ? 2 : c.options.count;
        read_problem(&c, &p);
        if (c.options.count > 0 && p.fixed.mass > 1e-6 && p.fixed.slope[0] > 1e-6) {
            CHECK_EQ(
                sfi_carve_bound(c.solid, c.stays, &c.terms, &c.options, NULL, NULL, &depth, &mass),
                SF_OK);
            CHECK_NEAR(depth, naive_depth_bound(&p, c.options.count == 2), 2e-6);
            if (c.options.count == 1) {
                CHECK_NEAR(mass, naive_mass_bound(&p), 1e-6);
            }
            checked++;
        }
        carving_end(&c);
    }
    CHECK(checked > 200);
}

static void nonsense_is_refused(void)
{
    static carving_scene c;
    carving_begin(&c, 0, 5, 5, 5);
    double depth = 7, mass = 7;
    sfi_forest_options o = c.options;
#define BOUND(solid, wall, options, depth)                                                         \
    sfi_carve_bound(solid, wall, &c.terms, options, NULL, NULL, depth, &mass)
    o.count = 0;
    CHECK_EQ(BOUND(c.solid, c.stays, &o, &depth), SF_ERR_ARGUMENT);
    o.count = 1;
    CHECK_EQ(BOUND(c.solid, c.stays, NULL, &depth), SF_ERR_ARGUMENT);
    CHECK_EQ(BOUND(c.solid, c.stays, &o, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(BOUND(NULL, c.stays, &o, &depth), SF_ERR_ARGUMENT);
    CHECK_EQ(BOUND(c.solid, NULL, &o, &depth), SF_ERR_ARGUMENT);
    o.halfspaces = NULL;
    CHECK_EQ(BOUND(c.solid, c.stays, &o, &depth), SF_ERR_ARGUMENT);
    o.halfspaces = c.halfspaces;
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    sf_halfspace any = {{1, 0, 0}, 0.1};
    c.halfspaces[0] = any;
    CHECK_EQ(sfi_carve_bound(c.solid, c.stays, NULL, &o, NULL, &task, &depth, &mass),
             SF_ERR_CANCELLED);
    CHECK(depth == 7 && mass == 7);
    carving_end(&c);
}

int main(void)
{
    TEST(bounds_are_optima);
    TEST(nonsense_is_refused);
    return test_finish();
}
