// SPDX-License-Identifier: MIT
// The oracle of rules beyond elements: slack, bridges and exempt voxels, written straight from
// their definitions on stacks of bytes. Distances are squared and compared, gaps are walked cell by
// cell; of the library only the numbers of the rule are used.

#ifndef SF_TEST_RULES_H
#define SF_TEST_RULES_H

#include "law/stack.h"

// Alive voxels of a stack, and what each has to spare: -1 for a dead one.
typedef struct field {
    stack alive, own; // own: alive without bridges
    int spare[STACK_VOXELS];
} field;

// What a step from layer k gives, in units: the sum of all reaches up to it, rounded down, less
// that of all before.
static inline int oracle_gain(const sf_rule *rule, int k)
{
    int by_x = rule->slack_x <= rule->slack_y;
    double units = by_x ? rule->slack_x : rule->slack_y;
    double step = (double)(by_x ? rule->reach_x_q24 : rule->reach_y_q24);
    double below = k * step, above = (k + 1) * step;
    if (rule->table != NULL) {
        const uint64_t *table = rule->table + (by_x ? 0 : rule->table_count);
        below = (double)table[k];
        above = (double)table[k + 1];
    }
    return (int)(floor(above * units / 16777216.0) - floor(below * units / 16777216.0));
}

// Distance in units, rounded up.
static inline int oracle_cost(const sf_rule *rule, int dx, int dy)
{
    double x = (double)dx * rule->slack_x, y = (double)dy * rule->slack_y;
    return (int)ceil(sqrt(x * x + y * y) - 1e-9);
}

// What voxel (x, y) of layer z has to spare by its supporters; -1 where it has none.
static inline int oracle_reach(const field *f, const sf_rule *rule, int x, int y, int z)
{
    sf_element e = stack_step(rule, z - 1);
    int best = -1, gain = rule->kind == SF_RULE_SLACK ? oracle_gain(rule, z - 1) : 0;
    for (int dy = -(int)e.reach_y; dy <= (int)e.reach_y; dy++) {
        for (int dx = -255; dx <= 255; dx++) {
            if (!element_has(&e, dx, dy) || !stack_get(&f->alive, x + dx, y + dy, z - 1)) {
                continue;
            }
            int i = ((z - 1) * f->alive.ny + y + dy) * f->alive.nx + x + dx, spare = 0;
            if (rule->kind == SF_RULE_SLACK) {
                spare = f->spare[i] + gain - oracle_cost(rule, dx, dy);
                spare = spare > (int)rule->slack_cap ? (int)rule->slack_cap : spare;
            }
            best = spare > best ? spare : best;
        }
    }
    return best;
}

// Whether (x, y, z) lies in a run of own voxels along (dx, dy) of at least `anchor`.
static inline int oracle_anchored(const stack *own, int x, int y, int z, int dx, int dy, int anchor)
{
    int length = 1;
    if (!stack_get(own, x, y, z)) {
        return 0;
    }
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 1; stack_get(own, x + side * i * dx, y + side * i * dy, z); i++) {
            length++;
        }
    }
    return length >= anchor;
}

// Whether a solid voxel lies in a gap along (dx, dy) that is bridged.
static inline int oracle_in_gap(const stack *s, const stack *own, int x, int y, int z, int dx,
                                int dy, int span, int anchor)
{
    int length = 1;
    if (!stack_get(s, x, y, z) || oracle_anchored(own, x, y, z, dx, dy, anchor)) {
        return 0;
    }
    for (int side = -1; side <= 1; side += 2) {
        int i = 1;
        while (stack_get(s, x + side * i * dx, y + side * i * dy, z) &&
               !oracle_anchored(own, x + side * i * dx, y + side * i * dy, z, dx, dy, anchor)) {
            i++;
            length++;
        }
        if (!oracle_anchored(own, x + side * i * dx, y + side * i * dy, z, dx, dy, anchor)) {
            return 0;
        }
    }
    return length <= span;
}

static inline int oracle_bridged(const stack *s, const stack *own, int x, int y, int z,
                                 const sf_bridge *b)
{
    return (b->span_x > 0 && oracle_in_gap(s, own, x, y, z, 1, 0, b->span_x, b->anchor_x)) ||
           (b->span_y > 0 && oracle_in_gap(s, own, x, y, z, 0, 1, b->span_y, b->anchor_y)) ||
           (b->span_diagonal > 0 &&
            (oracle_in_gap(s, own, x, y, z, 1, 1, b->span_diagonal, b->anchor_diagonal) ||
             oracle_in_gap(s, own, x, y, z, -1, 1, b->span_diagonal, b->anchor_diagonal)));
}

// One layer of the field: alive are the voxels of s that are carried, exempt or bridged. `anyway`:
// solid voxels that are none of these stand all the same, as in a check; their number is returned.
static inline int oracle_layer(field *f, const stack *s, const sf_rule *rule, int bed,
                               const stack *exempt, int z, int anyway)
{
    int nx = s->nx, hanging = 0;
    for (int i = 0; i < nx * s->ny; i++) {
        int x = i % nx, y = i / nx, at = z * nx * s->ny + i;
        int solid = stack_get(s, x, y, z), spare = z == bed ? (int)rule->slack_cap : -1;
        if (z > bed || anyway) {
            spare = z == bed ? spare : z > 0 ? oracle_reach(f, rule, x, y, z) : -1;
        }
        if (exempt != NULL && stack_get(exempt, x, y, z) && spare < 0) {
            spare = 0;
        }
        f->spare[at] = solid ? spare : -1;
        f->own.solid[at] = (uint8_t)(solid && spare >= 0);
        f->alive.solid[at] = f->own.solid[at];
    }
    for (int i = 0; i < nx * s->ny; i++) {
        int x = i % nx, y = i / nx, at = z * nx * s->ny + i;
        int bridged = z != bed && (z > bed || anyway) && !f->own.solid[at] &&
                      oracle_bridged(s, &f->own, x, y, z, &rule->bridge);
        int stands = anyway && stack_get(s, x, y, z) && !f->own.solid[at];
        hanging += stands && !bridged;
        if (bridged || stands) {
            f->alive.solid[at] = 1;
            f->spare[at] = 0;
        }
    }
    return hanging;
}

// The greatest support-free part of s by the recursion; returns it in f->alive.
static inline void oracle_field(field *f, const stack *s, const sf_rule *rule, uint32_t bed_layer,
                                const stack *exempt)
{
    int bed = stack_bed(s, bed_layer);
    stack_clear(&f->alive, s->nx, s->ny, s->nz);
    stack_clear(&f->own, s->nx, s->ny, s->nz);
    for (int z = 0; z < s->nz; z++) {
        (void)oracle_layer(f, s, rule, bed, exempt, z, 0);
    }
}

// Whether all of s is alive.
static inline int oracle_is_support_free(const stack *s, const sf_rule *rule, uint32_t bed_layer,
                                         const stack *exempt)
{
    static field f;
    oracle_field(&f, s, rule, bed_layer, exempt);
    return stack_equal(&f.alive, s);
}

// Voxels that a check counts: not carried by the layer below as drawn.
static inline uint64_t oracle_unsupported(const stack *s, const sf_rule *rule, uint32_t bed_layer)
{
    static field f;
    int bed = stack_bed(s, bed_layer);
    uint64_t sum = 0;
    stack_clear(&f.alive, s->nx, s->ny, s->nz);
    stack_clear(&f.own, s->nx, s->ny, s->nz);
    for (int z = 0; z < s->nz; z++) {
        sum += (uint64_t)oracle_layer(&f, s, rule, bed, NULL, z, 1);
    }
    return sum;
}

// A slack rule for voxels of px by py by h.
static inline sf_rule slack_rule(double degrees, double px, double py, double h)
{
    sf_lattice lattice = {8, 8, 8, px, py, h, NULL, {0.0, 0.0, 0.0}};
    sf_rule rule = sf_rule_box3();
    CHECK_EQ(sf_rule_make(SF_RULE_SLACK, degrees * (3.14159265358979323846 / 180.0), &lattice, NULL,
                          &rule, NULL),
             SF_OK);
    return rule;
}

// A rule for 16 layers whose heights differ, on pixels of px by py.
static inline sf_rule uneven_rule(sf_rule_kind kind, double degrees, double px, double py)
{
    static const double heights[16] = {0.1,  0.05, 0.12, 0.2,  0.08, 0.1, 0.1,  0.03,
                                       0.15, 0.1,  0.07, 0.11, 0.1,  0.2, 0.06, 0.1};
    static uint64_t tables[2][32];
    sf_lattice lattice = {8, 8, 16, px, py, 0.1, heights, {0.0, 0.0, 0.0}};
    sf_rule rule = sf_rule_box3();
    CHECK_EQ(sf_rule_make(kind, degrees * (3.14159265358979323846 / 180.0), &lattice,
                          tables[kind == SF_RULE_SLACK], &rule, NULL),
             SF_OK);
    return rule;
}

// Every rule there is, with and without bridges: 30 of them by number.
static inline sf_rule any_rule(int i)
{
    static const sf_bridge bridges[3] = {
        {0, 0, 0, 0, 0, 0}, {3, 3, 3, 1, 1, 1}, {4, 2, 0, 2, 1, 0}};
    sf_rule rule;
    switch (i % 10) {
    case 0:
        rule = sf_rule_box3();
        break;
    case 1:
        rule = rule_of_angle(SF_RULE_OCTAGON, 45.0);
        break;
    case 2:
        rule = rule_of_radius(1);
        break;
    case 3:
        rule = slack_rule(45.0, 0.1, 0.1, 0.1);
        break;
    case 4:
        rule = slack_rule(30.0, 0.1, 0.1, 0.1);
        break;
    case 5:
        rule = slack_rule(60.0, 0.1, 0.15, 0.1);
        break;
    case 6:
        rule = rule_of_radius(2);
        break;
    case 7:
        rule = slack_rule(20.0, 0.2, 0.1, 0.15);
        break;
    case 8:
        rule = uneven_rule(SF_RULE_SLACK, 50.0, 0.15, 0.1);
        break;
    default:
        rule = uneven_rule(SF_RULE_OCTAGON, 48.0, 0.1, 0.1);
        break;
    }
    rule.bridge = bridges[i / 10 % 3];
    return rule;
}

// ---------------------------------------------------------------------------------------------
// What the laws go through
// ---------------------------------------------------------------------------------------------

static inline void random_stack(stack *s, int nx, int ny, int nz)
{
    if (test_random_below(2) == 0) {
        stack_random(s, nx, ny, nz, 0.15 + 0.7 * test_random_unit());
    } else {
        stack_random_boxes(s, nx, ny, nz, 2 + (int)test_random_below(6));
    }
}

static inline uint32_t random_bed(int nz)
{
    return test_random_below(3) == 0 ? test_random_below((uint32_t)nz) : SF_BED_AUTO;
}

// The union of all support-free subsets of s, by trying all of them.
static inline void union_of_subsets(stack *all, const stack *s, const sf_rule *rule,
                                    const stack *exempt)
{
    static stack subset;
    int places[16], count = 0;
    for (int i = 0; i < stack_count(s); i++) {
        if (s->solid[i]) {
            places[count++] = i;
        }
    }
    stack_clear(all, s->nx, s->ny, s->nz);
    for (unsigned bits = 0; bits < 1u << count; bits++) {
        stack_clear(&subset, s->nx, s->ny, s->nz);
        for (int j = 0; j < count; j++) {
            subset.solid[places[j]] = bits >> j & 1;
        }
        if (oracle_is_support_free(&subset, rule, 0, exempt)) {
            stack_combine(all, all, &subset, STACK_OR);
        }
    }
}

// A stack of at most `most` voxels, in one of three shapes.
static inline void small_stack(stack *s, int i, int most)
{
    static const int sizes[3][3] = {{6, 1, 3}, {3, 2, 3}, {5, 2, 2}};
    do {
        const int *n = sizes[i % 3];
        stack_random(s, n[0], n[1], n[2], 0.2 + 0.5 * test_random_unit());
    } while ((int)stack_volume(s) > most);
}

#endif
