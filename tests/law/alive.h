// SPDX-License-Identifier: MIT
// What is alive in a stack, for every rule with slack and bridges and exempt voxels: from the
// definitions in <sf/rule.h>, a voxel at a time. Shares nothing with the library but the numbers
// that a rule holds.

#ifndef SF_TEST_ALIVE_H
#define SF_TEST_ALIVE_H

#include "law/stack.h"

// The rule's numbers for one step, worked out once.
typedef struct alive_step {
    sf_element element;
    int gain, costs[16][16];
} alive_step;

static inline int alive_cost(const sf_rule *rule, int dx, int dy)
{
    int64_t x = dx * rule->slack_x, y = dy * rule->slack_y, c = 0;
    while (c * c < x * x + y * y) {
        c++;
    }
    return (int)c;
}

// Reach from layer 0 to layer k, in units of slack; equal heights.
static inline int64_t alive_units(const sf_rule *rule, int k)
{
    int by_x = rule->slack_x <= rule->slack_y;
    uint64_t reach = by_x ? rule->reach_x_q24 : rule->reach_y_q24;
    if (rule->table != NULL) {
        reach = rule->table[(by_x ? 0 : (int)rule->table_count) + k];
    } else {
        reach *= (uint64_t)k;
    }
    return (int64_t)((reach * (by_x ? rule->slack_x : rule->slack_y)) >> 24);
}

#define ALIVE_STEPS 16

// Steps of a rule; made once for each rule, because tests ask for them often.
typedef struct alive_rule {
    sf_rule rule;
    alive_step steps[ALIVE_STEPS];
} alive_rule;

static inline void alive_prepare(alive_rule *a, const sf_rule *rule, int layers)
{
    a->rule = *rule;
    for (int k = 0; k + 1 < layers && k < ALIVE_STEPS; k++) {
        alive_step *s = &a->steps[k];
        s->element = stack_step(rule, k);
        s->gain = (int)(alive_units(rule, k + 1) - alive_units(rule, k));
        for (int dy = 0; rule->kind == SF_RULE_SLACK && dy < 16; dy++) {
            for (int dx = 0; dx < 16; dx++) {
                s->costs[dy][dx] = alive_cost(rule, dx, dy);
            }
        }
    }
}

static inline int max_int(int a, int b)
{
    return a > b ? a : b;
}

static inline int min_int(int a, int b)
{
    return a < b ? a : b;
}

// Slack of v in layer z given that of layer z - 1, -1 where it is dead; without slack 0 is alive.
static inline int alive_reach(const alive_rule *a, const int *field, const stack *s, int x, int y,
                              int z)
{
    const alive_step *step = &a->steps[z - 1];
    const sf_element *e = &step->element;
    int best = -1, is_slack = a->rule.kind == SF_RULE_SLACK;
    for (int dy = -(int)e->reach_y; dy <= (int)e->reach_y; dy++) {
        int w = e->half_width[abs(dy)];
        for (int dx = -w; dx <= w; dx++) {
            if (!stack_get(s, x + dx, y + dy, z - 1)) {
                continue;
            }
            int u = field[((z - 1) * s->ny + y + dy) * s->nx + x + dx];
            if (u >= 0) {
                int got = is_slack ? u + step->gain - step->costs[abs(dy)][abs(dx)] : 0;
                best = max_int(best, is_slack ? min_int(got, a->rule.slack_cap) : got);
            }
        }
    }
    return best;
}

// Whether (x, y) is an anchor along d: in a run of own voxels of at least the anchor's length.
static inline int alive_is_anchor(const uint8_t *own, int nx, int ny, int x, int y, int dx, int dy,
                                  int anchor)
{
    int length = 0;
    if (x < 0 || y < 0 || x >= nx || y >= ny || !own[y * nx + x]) {
        return 0;
    }
    for (int sign = -1; sign <= 1; sign += 2) {
        int ux = x, uy = y;
        while (ux >= 0 && uy >= 0 && ux < nx && uy < ny && own[uy * nx + ux]) {
            length++;
            ux += sign * dx;
            uy += sign * dy;
        }
    }
    return length - 1 >= max_int(anchor, 1);
}

// Whether voxel (x, y) of layer z, not carried itself, lies in a gap that is bridged along d.
static inline int alive_in_gap(const stack *s, const uint8_t *own, int x, int y, int z, int dx,
                               int dy, int span, int anchor)
{
    int length = 1;
    for (int sign = -1; span > 0 && sign <= 1; sign += 2) {
        int ux = x + sign * dx, uy = y + sign * dy;
        while (stack_get(s, ux, uy, z) &&
               !alive_is_anchor(own, s->nx, s->ny, ux, uy, dx, dy, anchor)) {
            length++;
            ux += sign * dx;
            uy += sign * dy;
        }
        if (!stack_get(s, ux, uy, z)) {
            return 0;
        }
    }
    return span > 0 && length <= span;
}

// field = slack of each living voxel, -1 elsewhere. Layers below the bed: exempt voxels only.
static inline void alive_field(const alive_rule *a, const stack *s, const stack *exempt, int bed,
                               int *field)
{
    const sf_bridge *b = &a->rule.bridge;
    int area = s->nx * s->ny;
    for (int z = 0; z < s->nz; z++) {
        uint8_t own[4096];
        for (int i = 0; i < area; i++) {
            int x = i % s->nx, y = i / s->nx, *f = &field[z * area + i];
            *f = -1;
            if (s->solid[z * area + i]) {
                *f = z == bed  ? a->rule.slack_cap
                     : z > bed ? alive_reach(a, field, s, x, y, z)
                               : -1;
                *f = max_int(*f, exempt != NULL && exempt->solid[z * area + i] ? 0 : -1);
            }
            own[i] = *f >= 0;
        }
        for (int i = 0; z > bed && i < area; i++) {
            int x = i % s->nx, y = i / s->nx, *f = &field[z * area + i];
            if (s->solid[z * area + i] && *f < 0 &&
                (alive_in_gap(s, own, x, y, z, 1, 0, b->span_x, b->anchor_x) ||
                 alive_in_gap(s, own, x, y, z, 0, 1, b->span_y, b->anchor_y) ||
                 alive_in_gap(s, own, x, y, z, 1, 1, b->span_diagonal, b->anchor_diagonal) ||
                 alive_in_gap(s, own, x, y, z, -1, 1, b->span_diagonal, b->anchor_diagonal))) {
                *f = 0;
            }
        }
    }
}

// result = what of s is alive: its trim.
static inline void alive_trim(const alive_rule *a, const stack *s, const stack *exempt, int bed,
                              stack *result)
{
    static int field[STACK_VOXELS];
    alive_field(a, s, exempt, bed, field);
    stack_clear(result, s->nx, s->ny, s->nz);
    for (int i = 0; i < stack_count(s); i++) {
        result->solid[i] = field[i] >= 0;
    }
}

static inline int alive_is_free(const alive_rule *a, const stack *s, const stack *exempt, int bed)
{
    static stack trimmed;
    alive_trim(a, s, exempt, bed, &trimmed);
    return stack_equal(&trimmed, s);
}

// Rules of all kinds, without and with bridges; `i` picks one of 16.
static inline sf_rule alive_rule_by_number(int i)
{
    sf_rule rule = sf_rule_box3();
    switch (i % 8) {
    case 0:
        break;
    case 1:
        rule = rule_of_angle(SF_RULE_OCTAGON, 30.0);
        break;
    case 2:
        rule = rule_of_angle(SF_RULE_OCTAGON, 62.0);
        break;
    case 3:
        rule = rule_of_angle(SF_RULE_DISK, 45.0);
        break;
    case 4:
        rule = rule_of_radius(2);
        break;
    case 5:
        rule = rule_of_angle(SF_RULE_SLACK, 30.0);
        break;
    case 6:
        rule = rule_of_angle(SF_RULE_SLACK, 45.0);
        break;
    default:
        rule = rule_of_angle(SF_RULE_SLACK, 63.0);
        break;
    }
    if (i / 8 % 2 == 1) {
        sf_bridge b = {0};
        b.span_x = (uint16_t)test_random_below(5);
        b.span_y = (uint16_t)test_random_below(4);
        b.span_diagonal = (uint16_t)test_random_below(3);
        b.anchor_x = (uint16_t)test_random_below(3);
        b.anchor_y = (uint16_t)test_random_below(3);
        b.anchor_diagonal = (uint16_t)test_random_below(3);
        rule.bridge = b;
    }
    return rule;
}

// Quick ways between a stack and a grid that is there already.
static inline void stack_put(const stack *s, sf_grid *grid)
{
    for (int z = 0; z < s->nz; z++) {
        sf_slice slice = sf_grid_slice(grid, (uint32_t)z);
        for (int y = 0; y < s->ny; y++) {
            uint64_t *row = slice.words + (size_t)y * slice.stride;
            memset(row, 0, slice.stride * sizeof *row);
            for (int x = 0; x < s->nx; x++) {
                row[x / 64] |= (uint64_t)s->solid[(z * s->ny + y) * s->nx + x] << (x % 64);
            }
        }
    }
}

static inline void stack_take(stack *s, const sf_grid *grid)
{
    for (int z = 0; z < s->nz; z++) {
        sf_slice slice = sf_grid_slice(grid, (uint32_t)z);
        for (int y = 0; y < s->ny; y++) {
            const uint64_t *row = slice.words + (size_t)y * slice.stride;
            for (int x = 0; x < s->nx; x++) {
                s->solid[(z * s->ny + y) * s->nx + x] = row[x / 64] >> (x % 64) & 1;
            }
        }
    }
}

#endif
