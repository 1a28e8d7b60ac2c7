// SPDX-License-Identifier: MIT
// The oracle of repairs: trim under any rule, slack, bridges and exempt voxels included, voxel by
// voxel from the sentences of <sf/rule.h>; and random jobs for all of it. The library does them in
// memory that is full of something when it comes.

#ifndef SF_TEST_REPAIR_ORACLE_H
#define SF_TEST_REPAIR_ORACLE_H

#include "failing_allocator.h"
#include "law/stack.h"

#include <sf/repair.h>

// Least integer whose square is at least n.
static inline int oracle_root(long n)
{
    long r = 0;
    while (r * r < n) {
        r++;
    }
    return (int)r;
}

// Slack that a step from layer k gives, in units, on layers of one height.
static inline int oracle_gain(const sf_rule *rule, int k)
{
    int by_x = rule->slack_x <= rule->slack_y;
    uint64_t units = by_x ? rule->slack_x : rule->slack_y;
    uint64_t reach = by_x ? rule->reach_x_q24 : rule->reach_y_q24;
    uint64_t one = (uint64_t)1 << 24;
    return (int)((uint64_t)(k + 1) * reach * units / one - (uint64_t)k * reach * units / one);
}

// What u, with `have` slack (-1: dead), leaves to a voxel (dx, dy) away in layer k + 1; -1:
// nothing.
static inline int oracle_left(const sf_rule *rule, const sf_element *e, int k, int have, int dx,
                              int dy)
{
    if (have < 0 || !element_has(e, dx, dy)) {
        return -1;
    }
    if (rule->kind != SF_RULE_SLACK) {
        return 0;
    }
    long x = (long)dx * rule->slack_x, y = (long)dy * rule->slack_y;
    int left = have + oracle_gain(rule, k) - oracle_root(x * x + y * y);
    return left < 0 ? -1 : left > rule->slack_cap ? rule->slack_cap : left;
}

// Whether (x, y) lies in a gap of layer z that bridges along (dx, dy) keep; `own` is alive alone.
static inline int oracle_bridged(const stack *s, const stack *own, int x, int y, int z, int dx,
                                 int dy, int span, int anchor)
{
    anchor = anchor > 0 ? anchor : 1;
    int ends[2], length = 1;
    for (int side = 0; side < 2; side++) {
        int sign = side == 0 ? -1 : 1, i = 1;
        for (;; i++) {
            int px = x + sign * i * dx, py = y + sign * i * dy, run = 1;
            if (!stack_get(s, px, py, z)) {
                ends[side] = 0;
                break;
            }
            // Length of the carried run through here.
            if (!stack_get(own, px, py, z)) {
                continue;
            }
            for (int j = 1; stack_get(own, px + j * dx, py + j * dy, z); j++) {
                run++;
            }
            for (int j = 1; stack_get(own, px - j * dx, py - j * dy, z); j++) {
                run++;
            }
            if (run >= anchor) {
                ends[side] = 1;
                break;
            }
        }
        length += i - 1;
    }
    return ends[0] && ends[1] && length <= span;
}

static inline int oracle_any_bridge(const sf_rule *rule, const stack *s, const stack *own, int x,
                                    int y, int z)
{
    const sf_bridge *b = &rule->bridge;
    return (b->span_x && oracle_bridged(s, own, x, y, z, 1, 0, b->span_x, b->anchor_x)) ||
           (b->span_y && oracle_bridged(s, own, x, y, z, 0, 1, b->span_y, b->anchor_y)) ||
           (b->span_diagonal &&
            (oracle_bridged(s, own, x, y, z, 1, 1, b->span_diagonal, b->anchor_diagonal) ||
             oracle_bridged(s, own, x, y, z, -1, 1, b->span_diagonal, b->anchor_diagonal)));
}

// Best slack that anything below leaves to a voxel.
static inline int oracle_best(const sf_rule *rule, const sf_element *e, const stack *s,
                              const int *slack, int x, int y, int z)
{
    int best = -1;
    for (int v = 0; v < s->ny; v++) {
        for (int u = 0; u < s->nx; u++) {
            int have = slack[((z - 1) * s->ny + v) * s->nx + u];
            int left = oracle_left(rule, e, z - 1, have, x - u, y - v);
            best = left > best ? left : best;
        }
    }
    return best;
}

// Greatest support-free part, apart from exempt voxels (a stack, or NULL).
static inline void oracle_trim(stack *result, const stack *s, const sf_rule *rule, int bed,
                               const stack *exempt)
{
    static int slack[STACK_VOXELS];
    static stack own;
    stack_clear(result, s->nx, s->ny, s->nz);
    stack_clear(&own, s->nx, s->ny, s->nz);
    for (int z = 0; z < s->nz; z++) {
        sf_element e = {0, {0}};
        if (z > 0) {
            e = stack_step(rule, z - 1);
        }
        for (int i = 0; i < s->nx * s->ny; i++) {
            int x = i % s->nx, y = i / s->nx, at = z * s->nx * s->ny + i;
            slack[at] = -1;
            if (!s->solid[at]) {
                continue;
            }
            if (z == bed) {
                slack[at] = rule->kind == SF_RULE_SLACK ? rule->slack_cap : 0;
            } else if (z > bed) {
                slack[at] = oracle_best(rule, &e, s, slack, x, y, z);
            }
            if (slack[at] < 0 && exempt != NULL && exempt->solid[at]) {
                slack[at] = 0;
            }
            own.solid[at] = slack[at] >= 0;
        }
        for (int i = 0; i < s->nx * s->ny; i++) {
            int x = i % s->nx, y = i / s->nx, at = z * s->nx * s->ny + i;
            if (z > bed && s->solid[at] && slack[at] < 0 &&
                oracle_any_bridge(rule, s, &own, x, y, z)) {
                slack[at] = 0;
            }
        }
        for (int i = 0; i < s->nx * s->ny; i++) {
            int at = z * s->nx * s->ny + i;
            result->solid[at] = slack[at] >= 0;
            // What is exempt below the bed carries nothing: the bed does not ask, and nothing else
            // is alive there.
            slack[at] = z < bed ? -1 : slack[at];
        }
    }
}

static inline uint64_t oracle_cost(const stack *before, const stack *after, const uint8_t *add,
                                   const uint8_t *remove)
{
    uint64_t cost = 0;
    for (int i = 0; i < stack_count(before); i++) {
        if (before->solid[i] != after->solid[i]) {
            const uint8_t *costs = after->solid[i] ? add : remove;
            cost += costs != NULL ? costs[i] : 1;
        }
    }
    return cost;
}

// ---------------------------------------------------------------------------------------------
// Jobs
// ---------------------------------------------------------------------------------------------

enum { MASK_EXEMPT, MASK_KEEP, MASK_FORBID, MASK_ACT, MASK_COUNT };

// A shape, terms, masks and costs; is_on says which masks are given.
typedef struct job {
    stack shape, masks[MASK_COUNT];
    int is_on[MASK_COUNT], has_costs;
    sf_rule rule;
    uint32_t bed_layer;
    uint32_t width, rounds;
    uint8_t add[STACK_VOXELS], remove[STACK_VOXELS];
} job;

static inline sf_rule random_rule(int number)
{
    sf_rule rule = number % 9 < 7    ? rule_by_number(number % 9)
                   : number % 9 == 7 ? rule_of_angle(SF_RULE_SLACK, 30.0)
                                     : rule_of_angle(SF_RULE_SLACK, 50.0);
    if (number % 2 == 1 && number / 9 % 2 == 1) {
        rule.bridge.span_x = (uint16_t)test_random_below(5);
        rule.bridge.span_y = (uint16_t)test_random_below(5);
        rule.bridge.span_diagonal = (uint16_t)test_random_below(3);
        rule.bridge.anchor_x = (uint16_t)test_random_below(3);
        rule.bridge.anchor_y = (uint16_t)test_random_below(3);
    }
    return rule;
}

static inline void random_job_of(job *j, int number, const int n[3])
{
    if (number % 3 == 0) {
        stack_random_boxes(&j->shape, n[0], n[1], n[2], 3);
    } else {
        stack_random(&j->shape, n[0], n[1], n[2], 0.1 + 0.2 * (number % 3));
    }
    j->rule = random_rule(number);
    j->bed_layer = number % 5 == 0 ? test_random_below((uint32_t)n[2]) : SF_BED_AUTO;
    for (int m = 0; m < MASK_COUNT; m++) {
        j->is_on[m] = test_random_below(3) == 0;
        stack_random(&j->masks[m], n[0], n[1], n[2],
                     m == MASK_ACT      ? 0.9
                     : m == MASK_FORBID ? 0.3
                                        : 0.1);
    }
    j->has_costs = test_random_below(2) == 0;
    for (int i = 0; i < stack_count(&j->shape); i++) {
        j->add[i] = (uint8_t)(1 + test_random_below(number % 2 ? 4 : 255));
        j->remove[i] = (uint8_t)(1 + test_random_below(number % 2 ? 4 : 255));
    }
    j->width = 1;
    j->rounds = 0;
}

static inline void random_job(job *j, int number, int extent)
{
    int n[3];
    for (int i = 0; i < 3; i++) {
        n[i] = 1 + (int)test_random_below((uint32_t)extent);
    }
    random_job_of(j, number, n);
}

// Rows of a word and more: 61 to 130 voxels.
static inline void random_wide_job(job *j, int number)
{
    int n[3] = {61 + (int)test_random_below(70), 1 + (int)test_random_below(3),
                2 + (int)test_random_below(5)};
    random_job_of(j, number, n);
}

static inline const uint8_t *job_costs(const job *j, const uint8_t *costs)
{
    return j->has_costs ? costs : NULL;
}

static inline const stack *job_mask(const job *j, int mask)
{
    return j->is_on[mask] ? &j->masks[mask] : NULL;
}

// What must stay, and what may be solid.
static inline void job_sets(const job *j, stack *must, stack *allowed)
{
    int layer = j->shape.nx * j->shape.ny, bed = stack_bed(&j->shape, j->bed_layer);
    stack_clear(must, j->shape.nx, j->shape.ny, j->shape.nz);
    stack_clear(allowed, j->shape.nx, j->shape.ny, j->shape.nz);
    for (int i = 0; i < stack_count(&j->shape); i++) {
        int keep = j->is_on[MASK_KEEP] && j->masks[MASK_KEEP].solid[i];
        int act = !j->is_on[MASK_ACT] || j->masks[MASK_ACT].solid[i];
        int forbid = j->is_on[MASK_FORBID] && j->masks[MASK_FORBID].solid[i];
        must->solid[i] = j->shape.solid[i] && (keep || !act);
        allowed->solid[i] = j->shape.solid[i] || (act && !forbid && i / layer >= bed);
    }
}

// The library's repair. `result` and `culprits` may be NULL.
static inline sf_status job_repair(const job *j, stack *result, stack *culprits,
                                   sf_repair_report *report)
{
    sf_repair_options o = sf_repair_options_default();
    failing_allocator memory;
    sf_grid *grid = stack_grid(&j->shape), *masks[MASK_COUNT] = {NULL},
            *out = stack_grid(&j->shape);
    for (int m = 0; m < MASK_COUNT; m++) {
        masks[m] = j->is_on[m] ? stack_grid(&j->masks[m]) : NULL;
    }
    o.terms.rule = j->rule;
    o.terms.bed_layer = j->bed_layer;
    o.terms.exempt = masks[MASK_EXEMPT];
    o.terms.keep = masks[MASK_KEEP];
    o.terms.forbid = masks[MASK_FORBID];
    o.terms.act = masks[MASK_ACT];
    o.add_cost = job_costs(j, j->add);
    o.remove_cost = job_costs(j, j->remove);
    o.min_feature_vx = j->width;
    o.rounds = j->rounds;
    failing_begin(&memory, -1);
    sf_status status = sf_grid_repair(grid, &o, &memory.allocator, NULL, out, report);
    CHECK_EQ(memory.live, 0);
    CHECK_EQ(memory.faults, 0);
    if (result != NULL) {
        stack_read(result, grid);
    }
    if (culprits != NULL) {
        stack_read(culprits, out);
    }
    for (int m = 0; m < MASK_COUNT; m++) {
        sf_grid_destroy(masks[m]);
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(out);
    return status;
}

#endif
