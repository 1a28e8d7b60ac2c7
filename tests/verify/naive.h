// SPDX-License-Identifier: MIT
// Every rule by its definition (<sf/rule.h>), a number per voxel: the reference that neither the
// library nor the verifier has a thought in common with but the words of the header.
//
// What a voxel has to spare is told in units, -1 for a voxel that is not alive. A rule without
// slack is one where reaching costs nothing and nothing is to spare.

#ifndef SF_TEST_VERIFY_NAIVE_H
#define SF_TEST_VERIFY_NAIVE_H

#include "law/stack.h"

typedef struct naive {
    const stack *s, *exempt; // exempt: NULL where there is none
    const sf_rule *rule;
    int bed;
    int spare[STACK_VOXELS], own[STACK_VOXELS];
} naive;

static inline int naive_at(const naive *n, int x, int y, int z)
{
    return (z * n->s->ny + y) * n->s->nx + x;
}

// Units of the reach from layer 0 to layer k, along the axis of the finer unit.
static inline uint64_t naive_reach(const sf_rule *rule, int k)
{
    int y = rule->slack_y < rule->slack_x;
    uint64_t one = y ? rule->reach_y_q24 : rule->reach_x_q24;
    uint64_t q24 =
        rule->table == NULL ? one * (uint64_t)k : rule->table[k + (y ? (int)rule->table_count : 0)];
    return q24 * (y ? rule->slack_y : rule->slack_x) >> 24;
}

static inline int naive_cost(const sf_rule *rule, int dx, int dy)
{
    int x = dx * rule->slack_x, y = dy * rule->slack_y, cost = 0;
    while (cost * cost < x * x + y * y) {
        cost++;
    }
    return cost;
}

// What voxel (x, y, z) has to spare by its supporters alone.
static inline int naive_carry(const naive *n, int x, int y, int z)
{
    int best = -1, slack = n->rule->kind == SF_RULE_SLACK;
    int gain = slack ? (int)(naive_reach(n->rule, z) - naive_reach(n->rule, z - 1)) : 0;
    sf_element e = stack_step(n->rule, z - 1);
    for (int v = 0; v < n->s->ny; v++) {
        for (int u = 0; u < n->s->nx; u++) {
            int below = n->spare[naive_at(n, u, v, z - 1)];
            if (below < 0 || !element_has(&e, u - x, v - y)) {
                continue;
            }
            int left = slack ? below + gain - naive_cost(n->rule, u - x, v - y) : 0;
            left = slack && left > n->rule->slack_cap ? n->rule->slack_cap : left;
            best = left > best ? left : best;
        }
    }
    return best;
}

static inline int naive_own(const naive *n, int x, int y, int z)
{
    return stack_get(n->s, x, y, z) && n->own[naive_at(n, x, y, z)];
}

// Whether (x, y) lies in a run of A along d that is long enough.
static inline int naive_anchored(const naive *n, int x, int y, int z, int dx, int dy, int anchor)
{
    int run = 1;
    if (!naive_own(n, x, y, z)) {
        return 0;
    }
    for (int i = 1; naive_own(n, x + i * dx, y + i * dy, z); i++) {
        run++;
    }
    for (int i = 1; naive_own(n, x - i * dx, y - i * dy, z); i++) {
        run++;
    }
    return run >= anchor;
}

// Whether a bridge along d holds (x, y): the maximal run of S \ A* through it.
static inline int naive_bridged(const naive *n, int x, int y, int z, int d)
{
    const sf_bridge *b = &n->rule->bridge;
    int dx = d == 3 ? -1 : d != 1, dy = d > 0, length = 1, ends = 0;
    int span = d == 0 ? b->span_x : d == 1 ? b->span_y : b->span_diagonal;
    int anchor = d == 0 ? b->anchor_x : d == 1 ? b->anchor_y : b->anchor_diagonal;
    if (span == 0 || naive_anchored(n, x, y, z, dx, dy, anchor)) {
        return 0;
    }
    for (int side = -1; side < 2; side += 2) {
        for (int i = side;; i += side) {
            int u = x + i * dx, v = y + i * dy;
            if (naive_anchored(n, u, v, z, dx, dy, anchor)) {
                ends++;
                break;
            }
            if (!stack_get(n->s, u, v, z)) {
                break;
            }
            length++;
        }
    }
    return ends == 2 && length <= span;
}

// One layer; returns whether all of it is alive.
static inline int naive_layer(naive *n, int z)
{
    int good = 1, top = n->rule->kind == SF_RULE_SLACK ? n->rule->slack_cap : 0;
    for (int i = 0; i < n->s->nx * n->s->ny; i++) {
        int x = i % n->s->nx, y = i / n->s->nx, at = naive_at(n, x, y, z), spare = -1;
        if (stack_get(n->s, x, y, z)) {
            spare = z == n->bed ? top : z > n->bed ? naive_carry(n, x, y, z) : -1;
            if (spare < 0 && n->exempt != NULL && stack_get(n->exempt, x, y, z)) {
                spare = 0;
            }
        }
        n->spare[at] = spare;
        n->own[at] = spare >= 0;
    }
    for (int i = 0; i < n->s->nx * n->s->ny; i++) {
        int x = i % n->s->nx, y = i / n->s->nx, at = naive_at(n, x, y, z);
        for (int d = 0; d < 4 && z > n->bed && n->spare[at] < 0 && stack_get(n->s, x, y, z); d++) {
            n->spare[at] = naive_bridged(n, x, y, z, d) ? 0 : -1;
        }
        good = good && (n->spare[at] >= 0 || !stack_get(n->s, x, y, z));
    }
    return good;
}

static inline int naive_is_free(const stack *s, const stack *exempt, const sf_rule *rule,
                                uint32_t bed_layer)
{
    static naive n;
    n.s = s;
    n.exempt = exempt;
    n.rule = rule;
    n.bed = stack_bed(s, bed_layer);
    for (int z = 0; z < s->nz; z++) {
        if (!naive_layer(&n, z)) {
            return 0;
        }
    }
    return 1;
}

#endif
