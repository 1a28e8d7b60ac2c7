// SPDX-License-Identifier: MIT
// TRUST items 56-62 over all pairs of stacks of 3x1x3 and 4x1x3, with three ways to grow side by
// side: sf_grid_grow(), and two plain ones that the list of laws speaks of,
//
//     column   everything below any voxel
//     need     from the top down, straight below each voxel that nothing carries
//
// The library's grow is the list's greedy one, but for where it looks: it takes the supporters from
// which the way to matter is shortest, wherever they lie, not those straight below. So it has 56,
// 57, 59, the idempotence of 58 and 62 (irredundant), and has not: staying in the vertical shadow
// (58), monotony (60), the union law (61). Nor is there a least result (62). Each false one is
// counted, and must have a counter-example; the smallest stand by name.

#include "tiny.h"

#include <sf/grow.h>

typedef struct growths {
    tiny t;
    uint32_t *grow, *column, *need;
} growths;

static uint32_t by_column(const tiny *t, uint32_t s)
{
    int below = t->nx * t->ny;
    for (int v = t->voxels - 1; v >= below; v--) {
        s |= s >> v & 1 ? 1u << (v - below) : 0;
    }
    return s;
}

static uint32_t by_need(const tiny *t, uint32_t s)
{
    int below = t->nx * t->ny;
    for (int z = t->nz - 1; z > 0; z--) {
        uint32_t was = s; // the voxels of a layer do not see what the others are given
        for (int v = z * below; v < (z + 1) * below; v++) {
            s |= was >> v & 1 && !(t->carriers[v] & was) ? 1u << (v - below) : 0;
        }
    }
    return s;
}

static growths growths_new(int nx, int ny, int nz, const sf_rule *rule)
{
    growths g = {tiny_new(nx, ny, nz, rule), NULL, NULL, NULL};
    sf_lattice lattice = stack_lattice(nx, ny, nz);
    sf_terms terms = sf_terms_default();
    sf_grid *grid = NULL;
    terms.rule = *rule;
    terms.bed_layer = 0;
    g.grow = malloc(g.t.count * sizeof *g.grow);
    g.column = malloc(g.t.count * sizeof *g.column);
    g.need = malloc(g.t.count * sizeof *g.need);
    if (g.grow == NULL || g.column == NULL || g.need == NULL ||
        sf_grid_create(&lattice, NULL, &grid) != SF_OK) {
        abort();
    }
    for (uint32_t s = 0; s < g.t.count; s++) {
        tiny_write(&g.t, grid, s);
        CHECK_EQ(sf_grid_grow(grid, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
        g.grow[s] = tiny_read(&g.t, grid);
        g.column[s] = by_column(&g.t, s);
        g.need[s] = by_need(&g.t, s);
    }
    sf_grid_destroy(grid);
    return g;
}

static void growths_delete(growths *g)
{
    tiny_delete(&g->t);
    free(g->grow);
    free(g->column);
    free(g->need);
}

// ---------------------------------------------------------------------------------------------
// True
// ---------------------------------------------------------------------------------------------

// Laws of one stack that a way to grow has.
static uint32_t broken_by(const tiny *t, const uint32_t *grow, uint32_t s)
{
    uint32_t grown = grow[s], broken = 0;
    broken += (s & ~grown) != 0;       // 56
    broken += !tiny_is_free(t, grown); // 57
    broken += grow[grown] != grown;    // 58
    broken += t->trim[grown] != grown; // 58
    return broken;
}

// 62: each added voxel carries one that nothing else does.
static uint32_t needless(const tiny *t, uint32_t s, uint32_t grown)
{
    uint32_t count = 0;
    for (uint32_t more = grown & ~s; more != 0; more &= more - 1) {
        count += (uint32_t)tiny_is_free(t, grown & ~(more & (~more + 1)));
    }
    return count;
}

static void laws_of(int nx, int ny, int nz, const sf_rule *rule)
{
    growths g = growths_new(nx, ny, nz, rule);
    uint32_t broken = 0;
    for (uint32_t a = 0; a < g.t.count; a++) {
        broken += broken_by(&g.t, g.grow, a) + broken_by(&g.t, g.column, a);
        broken += broken_by(&g.t, g.need, a);
        broken += ((g.column[a] | g.need[a]) & ~g.column[a]) != 0;             // 58: the shadow
        broken += tiny_is_free(&g.t, a) && (g.grow[a] != a || g.need[a] != a); // 59
        broken += needless(&g.t, a, g.grow[a]);                                // 62
        for (uint32_t c = 0; c < g.t.count; c++) {
            broken += (g.column[a] & ~g.column[a | c]) != 0;           // 60
            broken += (g.need[a | c] & ~(g.need[a] | g.need[c])) != 0; // 61
        }
    }
    CHECK_EQ(broken, 0);
    growths_delete(&g);
}

static void true_laws(void)
{
    sf_rule rules[3] = {sf_rule_box3(), rule_of_radius(0), rule_of_angle(SF_RULE_OCTAGON, 30.0)};
    for (int i = 0; i < 3; i++) {
        laws_of(3, 1, 3, &rules[i]);
        laws_of(4, 1, 3, &rules[i]);
        laws_of(2, 2, 2, &rules[i]);
    }
}

// With nothing but straight down there is no choice: all three are one, and a least result exists.
static void straight_down(void)
{
    sf_rule rule = rule_of_radius(0);
    growths g = growths_new(3, 1, 3, &rule);
    uint32_t broken = 0;
    for (uint32_t a = 0; a < g.t.count; a++) {
        broken += g.grow[a] != g.need[a] || g.grow[a] != g.column[a];
        for (uint32_t f = 0; f < g.t.count; f++) {
            broken += tiny_is_free(&g.t, f) && (a & ~f) == 0 && (g.grow[a] & ~f) != 0;
        }
    }
    CHECK_EQ(broken, 0);
    growths_delete(&g);
}

// ---------------------------------------------------------------------------------------------
// False
// ---------------------------------------------------------------------------------------------

// How many stacks, or pairs of them, break each law.
typedef struct counter_examples {
    uint32_t shadow, monotone, smaller, joined, equal, free_column, least, spare;
} counter_examples;

static counter_examples count_pairs(const growths *g)
{
    counter_examples n = {0, 0, 0, 0, 0, 0, 0, 0};
    for (uint32_t a = 0; a < g->t.count; a++) {
        n.shadow += (g->grow[a] & ~g->column[a]) != 0;
        n.free_column += tiny_is_free(&g->t, a) && g->column[a] != a;
        n.spare += needless(&g->t, a, g->need[a]) > 0;
        for (uint32_t c = 0; c < g->t.count; c++) {
            uint32_t joint = g->grow[a | c], both = g->grow[a] | g->grow[c];
            n.monotone += (g->grow[a] & ~joint) != 0;
            n.smaller += tiny_volume(g->grow[a]) > tiny_volume(joint);
            n.joined += (joint & ~both) != 0;
            n.equal += joint != both;
            // Two support-free stacks around `a` that share nothing support-free around it.
            int around = (a & ~c) == 0 && tiny_is_free(&g->t, c);
            n.least += around && (g->grow[a] & ~c) != 0 && !tiny_is_free(&g->t, g->grow[a] & c);
        }
    }
    return n;
}

static void false_laws(void)
{
    sf_rule rule = sf_rule_box3();
    growths g = growths_new(4, 1, 3, &rule);
    counter_examples n = count_pairs(&g);
    printf("# 58 shadow %u, 59 column %u, 60 %u and size %u, 61 %u and equality %u, 62 least %u, "
           "need redundant %u\n",
           n.shadow, n.free_column, n.monotone, n.smaller, n.joined, n.equal, n.least, n.spare);
    CHECK(n.shadow > 0 && n.free_column > 0 && n.monotone > 0 && n.smaller > 0);
    CHECK(n.joined > 0 && n.equal > 0 && n.least > 0 && n.spare > 0);
    growths_delete(&g);
}

static void false_laws_by_name(void)
{
    sf_rule rule = sf_rule_box3();
    growths g = growths_new(4, 1, 3, &rule);
    // 58: what is grown lies straight below something. Matter to one side is closer than the bed.
    uint32_t a = tiny_parse("#...|....|..#.");
    CHECK_EQ(g.grow[a], tiny_parse("#...|.#..|..#."));
    // 59 for the column, which adds to what is support-free.
    a = tiny_parse("#...|.#..|....");
    CHECK_EQ(g.grow[a], a);
    CHECK_EQ(g.need[a], a);
    CHECK_EQ(g.column[a], tiny_parse("##..|.#..|...."));
    // 60: more matter needs more. Here less: its own pillar is not needed.
    uint32_t c = tiny_parse("...#|...#|....");
    a = tiny_parse("....|....|..#.");
    CHECK((g.grow[a] & ~g.grow[a | c]) != 0);
    CHECK_EQ(g.grow[a | c], a | c);
    // 60, sizes: a stack that grows may end larger than one that holds it.
    a = tiny_parse("....|....|#..#");
    c = tiny_parse("....|.##.|....");
    CHECK(tiny_volume(g.grow[a]) > tiny_volume(g.grow[a | c]));
    // 62 for need: one would do for two.
    a = tiny_parse("....|.##.|....");
    CHECK_EQ(g.need[a], tiny_parse(".##.|.##.|...."));
    CHECK_EQ(tiny_volume(g.grow[a]), 3);
    // 62: a least result. Any of three does, and what they share does not.
    a = tiny_parse("....|.#..|....");
    uint32_t left = tiny_parse("#...|.#..|...."), right = tiny_parse("..#.|.#..|....");
    CHECK(tiny_is_free(&g.t, left) && tiny_is_free(&g.t, right));
    CHECK(!tiny_is_free(&g.t, left & right));
    growths_delete(&g);
}

int main(void)
{
    TEST(true_laws);
    TEST(straight_down);
    TEST(false_laws);
    TEST(false_laws_by_name);
    return test_finish();
}
