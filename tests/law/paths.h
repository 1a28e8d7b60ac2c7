// SPDX-License-Identifier: MIT
// The oracle of supporting paths: everything in bytes, straight from the definitions in
// <sf/grow.h>.
//
// A case is a shape, masks, a rule, a bed and what may be landed on. The oracle knows each path
// that there is by a search with whole sets; under slack by a search over voxels and slacks from
// the bottom up, which is not how the library goes.

#ifndef SF_TEST_PATHS_H
#define SF_TEST_PATHS_H

#include "stack.h"

#include <sf/grow.h>

#define PATHS_NONE 1000000

typedef struct path_case {
    stack shape, exempt, forbid, act;
    int has_exempt, has_forbid, has_act;
    sf_rule rule;
    uint32_t bed_layer;
    sf_landing landing;
    // Made by path_case_open():
    sf_grid *grid, *masks[3];
    sf_terms terms;
    int bed;
    stack alive; // under the whole rule, by the library's trim, which has tests of its own
    int slack[STACK_VOXELS];
} path_case;

// --- slack by its definition -------------------------------------------------------------------

static inline int naive_cost(const sf_rule *rule, int dx, int dy)
{
    int64_t x = (int64_t)dx * rule->slack_x, y = (int64_t)dy * rule->slack_y;
    int r = 0;
    while ((int64_t)r * r < x * x + y * y) {
        r++;
    }
    return r;
}

static inline int naive_gain(const sf_rule *rule, int k)
{
    const uint64_t *t = rule->table;
    int by_x = rule->slack_x <= rule->slack_y;
    uint64_t unit = by_x ? rule->slack_x : rule->slack_y;
    uint64_t step = by_x ? rule->reach_x_q24 : rule->reach_y_q24;
    t = t != NULL && !by_x ? t + rule->table_count : t;
    uint64_t low = t != NULL ? t[k] : step * (uint64_t)k;
    uint64_t high = t != NULL ? t[k + 1] : low + step;
    return (int)((high * unit >> 24) - (low * unit >> 24));
}

// What a step up from (ux, uy, z - 1) to (x, y, z) adds to slack; PATHS_NONE: there is none.
static inline int naive_room(const sf_rule *rule, const sf_element *e, int x, int y, int z, int ux,
                             int uy)
{
    if (!element_has(e, x - ux, y - uy)) {
        return PATHS_NONE;
    }
    return rule->kind == SF_RULE_SLACK ? naive_gain(rule, z - 1) - naive_cost(rule, x - ux, y - uy)
                                       : 0;
}

// Slack above a step with that room from a voxel with s; negative: not carried.
static inline int naive_step(const sf_rule *rule, int room, int s)
{
    int left = room == PATHS_NONE ? -1 : s + room;
    int cap = rule->kind == SF_RULE_SLACK ? rule->slack_cap : 0;
    return left < cap ? left : cap;
}

// The slack that living voxels of the layer below give to (x, y, z); negative: none carries it.
static inline int naive_own(const path_case *c, const sf_rule *rule, int x, int y, int z)
{
    sf_element e = stack_step(rule, z - 1);
    int best = -1, reach_y = e.reach_y, reach_x = e.half_width[0];
    for (int uy = y - reach_y; uy <= y + reach_y; uy++) {
        for (int ux = x - reach_x; ux <= x + reach_x; ux++) {
            if (stack_get(&c->alive, ux, uy, z - 1)) {
                int i = (int)(stack_at((stack *)&c->alive, ux, uy, z - 1) - c->alive.solid);
                int s = naive_step(rule, naive_room(rule, &e, x, y, z, ux, uy), c->slack[i]);
                best = s > best ? s : best;
            }
        }
    }
    return best;
}

// --- a case ------------------------------------------------------------------------------------

static inline sf_terms path_terms(const path_case *c)
{
    sf_terms terms = sf_terms_default();
    terms.rule = c->rule;
    terms.bed_layer = c->bed_layer;
    terms.exempt = c->masks[0];
    terms.forbid = c->masks[1];
    terms.act = c->masks[2];
    return terms;
}

static inline void path_case_open(path_case *c)
{
    c->grid = stack_grid(&c->shape);
    c->masks[0] = c->has_exempt ? stack_grid(&c->exempt) : NULL;
    c->masks[1] = c->has_forbid ? stack_grid(&c->forbid) : NULL;
    c->masks[2] = c->has_act ? stack_grid(&c->act) : NULL;
    c->terms = path_terms(c);
    c->bed = stack_bed(&c->shape, c->bed_layer);
    c->bed = c->bed == c->shape.nz ? 0 : c->bed;
    sf_grid *trimmed = NULL;
    CHECK_EQ(sf_grid_clone(c->grid, NULL, &trimmed), SF_OK);
    CHECK_EQ(sf_grid_trim_on(trimmed,
                             &(sf_terms){c->terms.struct_size, c->rule, c->bed_layer, c->masks[0],
                                         NULL, NULL, NULL},
                             stack_allocator(), NULL, NULL, NULL),
             SF_OK);
    stack_read(&c->alive, trimmed);
    sf_grid_destroy(trimmed);
    for (int i = 0; i < stack_count(&c->shape); i++) {
        int x = i % c->shape.nx, y = i / c->shape.nx % c->shape.ny;
        int z = i / (c->shape.nx * c->shape.ny);
        c->slack[i] = 0;
        if (c->alive.solid[i] && z == c->bed) {
            c->slack[i] = c->rule.slack_cap;
        } else if (c->alive.solid[i] && z > c->bed) {
            int s = naive_own(c, &c->rule, x, y, z);
            c->slack[i] = s > 0 ? s : 0; // exempt and bridged voxels have none
        }
    }
}

static inline void path_case_close(path_case *c)
{
    sf_grid_destroy(c->grid);
    for (int i = 0; i < 3; i++) {
        sf_grid_destroy(c->masks[i]);
    }
}

static inline int is_root(const path_case *c, int x, int y, int z)
{
    return z >= c->bed && stack_get(c->landing == SF_LANDING_ANY ? &c->shape : &c->alive, x, y, z);
}

static inline int is_exempt(const path_case *c, int x, int y, int z)
{
    return c->has_exempt && stack_get(&c->exempt, x, y, z);
}

static inline int is_passable(const path_case *c, int x, int y, int z)
{
    if (stack_get(&c->shape, x, y, z)) {
        return 1;
    }
    return x >= 0 && y >= 0 && z >= c->bed && x < c->shape.nx && y < c->shape.ny &&
           !(c->has_forbid && stack_get(&c->forbid, x, y, z)) &&
           !(c->has_act && !stack_get(&c->act, x, y, z));
}

// Squared distance to the closest root of a layer; -1 where it has none.
static inline int naive_square(const path_case *c, int x, int y, int z)
{
    int least = -1;
    for (int v = 0; v < c->shape.ny; v++) {
        for (int u = 0; u < c->shape.nx; u++) {
            int d = (x - u) * (x - u) + (y - v) * (y - v);
            if (is_root(c, u, v, z) && (least < 0 || d < least)) {
                least = d;
            }
        }
    }
    return least;
}

static inline int naive_distance(const path_case *c, int x, int y, int z)
{
    int square = naive_square(c, x, y, z), root = 0;
    while (root * root < square) {
        root++;
    }
    return square < 0 ? 1 : root;
}

// --- the best landing --------------------------------------------------------------------------

// In what order landings of one layer are preferred: less is better.
typedef struct path_rank {
    int found, end; // end: an sf_path_end in the order matter, held, bed
    int square, off, y, x;
} path_rank;

static inline int is_better(const path_rank *a, const path_rank *b)
{
    int keys_a[5] = {a->end, a->square, a->off, a->y, a->x};
    int keys_b[5] = {b->end, b->square, b->off, b->y, b->x};
    for (int i = 0; b->found && i < 5; i++) {
        if (keys_a[i] != keys_b[i]) {
            return keys_a[i] < keys_b[i];
        }
    }
    return !b->found;
}

// What a chain of t steps down that reaches (x, y) with demand d may end on, if anything.
static inline int may_end(const path_case *c, int x, int y, int z, int demand, int *end)
{
    int i = (z * c->shape.ny + y) * c->shape.nx + x;
    int spare = stack_get(&c->alive, x, y, z) ? c->slack[i] : 0;
    if (is_root(c, x, y, z) && spare >= demand) {
        *end = 0;
        return 1;
    }
    if (is_exempt(c, x, y, z) && is_passable(c, x, y, z) && demand == 0) {
        *end = 1;
        return 1;
    }
    *end = 2;
    return z == c->bed && is_passable(c, x, y, z);
}

// Slacks of a voxel that would do, a bit for each of 0..255.
typedef struct slack_set {
    uint64_t bits[4];
} slack_set;

static inline int set_has(const slack_set *set, int d)
{
    return set->bits[d / 64] >> (d % 64) & 1;
}

// to |= the slacks 0..cap from which a step with this room leads to one of `from`.
static inline void set_add_step(slack_set *to, const slack_set *from, int room, int cap)
{
    if ((from->bits[0] | from->bits[1] | from->bits[2] | from->bits[3]) == 0) {
        return;
    }
    for (int w = 0; w < 4; w++) {
        // Bit d of the word is bit d + room of the set.
        int at = w * 64 + room, low = at >= 0 ? at / 64 : -((63 - at) / 64), shift = at - low * 64;
        uint64_t first = low >= 0 && low < 4 ? from->bits[low] : 0;
        uint64_t next = low + 1 >= 0 && low + 1 < 4 ? from->bits[low + 1] : 0;
        to->bits[w] |= shift == 0 ? first : first >> shift | next << (64 - shift);
    }
    // With more than the cap one has the cap.
    for (int d = room > 0 && room < cap ? cap - room + 1 : room > 0 ? 0 : cap + 1; d <= cap; d++) {
        to->bits[d / 64] |= (uint64_t)set_has(from, cap) << (d % 64);
    }
    for (int d = cap + 1; d < 256; d++) {
        to->bits[d / 64] &= ~((uint64_t)1 << (d % 64));
    }
}

// here[u] = with which slacks a voxel u of layer z would do, given the same of layer z + 1.
static inline void naive_layer(const path_case *c, int z, const slack_set *above, slack_set *here)
{
    int nx = c->shape.nx, ny = c->shape.ny, cap = c->rule.slack_cap;
    sf_element e = stack_step(&c->rule, z);
    int reach_y = e.reach_y, reach_x = e.half_width[0];
    memset(here, 0, (size_t)(nx * ny) * sizeof *here);
    for (int i = 0; i < nx * ny; i++) {
        int x = i % nx, y = i / nx;
        for (int v = y - reach_y; v <= y + reach_y && is_passable(c, x, y, z); v++) {
            for (int u = x - reach_x; u <= x + reach_x; u++) {
                int is_inside = u >= 0 && v >= 0 && u < nx && v < ny;
                int room = is_inside ? naive_room(&c->rule, &e, u, v, z + 1, x, y) : PATHS_NONE;
                if (room != PATHS_NONE) {
                    set_add_step(&here[i], &above[v * nx + u], room, cap);
                }
            }
        }
    }
}

// The best path of a voxel; t = layers down to its end, 0 for a voxel that needs none. Returns
// whether there is one. All pairs of a voxel and a slack are gone through, each with what it leads
// to. Elements are the case of a cap of 0.
static inline int naive_path(const path_case *c, int fx, int fy, int fz, path_rank *best, int *t)
{
    static slack_set reach[2][1024];
    int area = c->shape.nx * c->shape.ny, cap = c->rule.slack_cap;
    memset(best, 0, sizeof *best);
    *t = 0;
    if (fz == c->bed || is_exempt(c, fx, fy, fz)) {
        best->found = 1;
        best->end = fz == c->bed ? 2 : 1;
        return 1;
    }
    if (fz < c->bed) {
        return 0;
    }
    memset(reach[0], 0, sizeof reach[0]);
    for (int d = 0; d <= cap; d++) {
        reach[0][fy * c->shape.nx + fx].bits[d / 64] |= (uint64_t)1 << (d % 64);
    }
    for (int z = fz - 1; z >= c->bed; z--) {
        naive_layer(c, z, reach[*t % 2], reach[(*t + 1) % 2]);
        const slack_set *here = reach[++*t % 2];
        for (int i = 0; i < area; i++) {
            int x = i % c->shape.nx, y = i / c->shape.nx, d = 0, end;
            while (d <= cap && !set_has(&here[i], d)) {
                d++;
            }
            if (d > cap || !may_end(c, x, y, z, d, &end)) {
                continue;
            }
            int square = end == 2 ? naive_square(c, x, y, z) : 0;
            path_rank rank = {1, end, square, (x - fx) * (x - fx) + (y - fy) * (y - fy), y, x};
            if (is_better(&rank, best)) {
                *best = rank;
            }
        }
        if (best->found) {
            return 1;
        }
    }
    return 0;
}

// --- random cases ------------------------------------------------------------------------------

static inline void path_random_case(path_case *c, int i, int nx, int ny, int nz)
{
    memset(c, 0, sizeof *c);
    if (i % 3 == 0) {
        stack_random(&c->shape, nx, ny, nz, 0.02 + 0.3 * test_random_unit());
    } else {
        stack_random_boxes(&c->shape, nx, ny, nz, 1 + (int)test_random_below(4));
        for (int j = 0; j < nx * ny * (nz / 2) && i % 3 == 2; j++) {
            c->shape.solid[j] = 0; // in the air, mostly
        }
    }
    stack_random(&c->exempt, nx, ny, nz, 0.03);
    stack_random(&c->forbid, nx, ny, nz, 0.1 + 0.3 * test_random_unit());
    stack_random(&c->act, nx, ny, nz, 0.8);
    c->has_exempt = i % 5 == 1;
    c->has_forbid = i % 4 == 1;
    c->has_act = i % 7 == 2;
    c->bed_layer = i % 3 == 0 ? SF_BED_AUTO : test_random_below(i % 6 == 1 && nz > 1 ? 2 : 1);
    c->landing = i % 4 == 3 ? SF_LANDING_ALIVE : SF_LANDING_ANY;
}

#endif
