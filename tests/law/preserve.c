// SPDX-License-Identifier: MIT
// TRUST items 44-55: removing a brush and keeping what carries the rest, over all support-free
// stacks of 3x1x3 and 2x2x2 with all brushes, in the three modes that promise something. The laws
// that do not hold stand with the counter-example that our ties give; 55: with nothing but straight
// down all of them hold, because then a least result exists.

#include "tiny.h"

#include <sf/preserve.h>

// All results of one mode: what becomes of a stack without a brush that lies within it.
typedef struct removals {
    tiny t;
    uint32_t *result; // [stack * count + brush]
} removals;

static removals removals_new(int nx, int ny, int nz, const sf_rule *rule, sf_preserve_mode mode)
{
    removals r = {tiny_new(nx, ny, nz, rule), NULL};
    sf_lattice lattice = stack_lattice(nx, ny, nz);
    sf_grid *grid = NULL, *brush = NULL;
    sf_terms terms = sf_terms_default();
    sf_preserve_options options = sf_preserve_options_default();
    terms.rule = *rule;
    terms.bed_layer = 0;
    options.mode = mode;
    r.result = calloc((size_t)r.t.count * r.t.count, sizeof *r.result);
    if (r.result == NULL || sf_grid_create(&lattice, stack_allocator(), &grid) != SF_OK ||
        sf_grid_create(&lattice, stack_allocator(), &brush) != SF_OK) {
        abort();
    }
    for (uint32_t a = 0; a < r.t.count; a++) {
        for (uint32_t d = a; tiny_is_free(&r.t, a); d = (d - 1) & a) {
            sf_preserve_report report;
            tiny_write(&r.t, grid, a);
            tiny_write(&r.t, brush, d);
            CHECK_EQ(
                sf_grid_preserve(grid, brush, &terms, &options, stack_allocator(), NULL, &report),
                SF_OK);
            uint32_t left = r.result[a * r.t.count + d] = tiny_read(&r.t, grid);
            CHECK_EQ(report.kept_voxels, tiny_volume(left & d));
            CHECK_EQ(report.removed_voxels, tiny_volume(d & ~left));
            CHECK_EQ(report.lost_outside + report.added_voxels, 0);
            if (d == 0) {
                break;
            }
        }
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(brush);
    return r;
}

static void removals_delete(removals *r)
{
    tiny_delete(&r->t);
    free(r->result);
}

static uint32_t rp(const removals *r, uint32_t a, uint32_t d)
{
    return r->result[a * r->t.count + (d & a)];
}

// Laws of one stack and one brush.
static uint32_t broken_laws(const removals *r, uint32_t a, uint32_t d, int is_irredundant)
{
    uint32_t left = rp(r, a, d), fixed = a & ~d, broken = 0, trimmed = r->t.trim[fixed];
    int was_free = tiny_is_free(&r->t, fixed);
    broken += (fixed & ~left) != 0 || (left & ~a) != 0;                     // 44
    broken += (trimmed & ~left) != 0 || (trimmed & ~r->t.trim[left]) != 0;  // 45
    broken += !tiny_is_free(&r->t, left);                                   // 46
    broken += (left == fixed) != was_free || (left == trimmed) != was_free; // 47
    for (uint32_t kept = left & d; is_irredundant && kept != 0; kept &= kept - 1) {
        uint32_t without = left & ~(kept & (~kept + 1));
        broken += (fixed & ~r->t.trim[without]) == 0; // 52
    }
    return broken;
}

static void laws_of(int nx, int ny, int nz, const sf_rule *rule, sf_preserve_mode mode)
{
    removals r = removals_new(nx, ny, nz, rule, mode);
    uint32_t broken = 0;
    for (uint32_t a = 0; a < r.t.count; a++) {
        if (!tiny_is_free(&r.t, a)) {
            continue;
        }
        for (uint32_t d = 0; d < r.t.count; d++) {
            broken += broken_laws(&r, a, d, mode == SF_PRESERVE_IRREDUNDANT);
            // 48; core may find less to be thick about the second time.
            broken += mode != SF_PRESERVE_CORE && rp(&r, rp(&r, a, d), d) != rp(&r, a, d);
            // 54: what a brush adds, removing it takes away again.
            uint32_t both = r.t.trim[a | d];
            broken += (d & a) == 0 && rp(&r, both, d) != a;
        }
    }
    CHECK_EQ(broken, 0);
    removals_delete(&r);
}

static void true_laws(void)
{
    sf_rule rules[3] = {sf_rule_box3(), rule_of_radius(0), rule_of_angle(SF_RULE_OCTAGON, 30.0)};
    for (int i = 0; i < 3; i++) {
        for (int mode = SF_PRESERVE_FAST; mode <= SF_PRESERVE_CORE; mode++) {
            laws_of(3, 1, 3, &rules[i], (sf_preserve_mode)mode);
            laws_of(2, 2, 2, &rules[i], (sf_preserve_mode)mode);
        }
    }
}

// 46, the false halves: keeping only what is straight below is not enough, and no way is for a
// stack that is not support-free; that is refused.
static void false_support(void)
{
    sf_rule rule = sf_rule_box3();
    tiny t = tiny_new(3, 1, 2, &rule);
    uint32_t a = tiny_parse("#..|.#."), d = tiny_parse("#..|..."), column = a & ~d;
    column |= (column >> 3) & a & d;
    CHECK(tiny_is_free(&t, a) && !tiny_is_free(&t, column));
    sf_lattice lattice = stack_lattice(3, 1, 2);
    sf_grid *grid = NULL, *brush = NULL;
    sf_terms terms = sf_terms_default();
    terms.bed_layer = 0;
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &grid), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, stack_allocator(), &brush), SF_OK);
    for (int mode = SF_PRESERVE_FAST; mode <= SF_PRESERVE_CORE; mode++) {
        sf_preserve_options options = sf_preserve_options_default();
        options.mode = (sf_preserve_mode)mode;
        tiny_write(&t, grid, tiny_parse("#..|..#"));
        tiny_write(&t, brush, d);
        CHECK_EQ(sf_grid_preserve(grid, brush, &terms, &options, stack_allocator(), NULL, NULL),
                 SF_ERR_INFEASIBLE);
        CHECK_EQ(tiny_read(&t, grid), tiny_parse("#..|..#"));
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(brush);
    tiny_delete(&t);
}

static void false_laws_of(sf_preserve_mode mode, const char *a49, const char *d49, const char *e49)
{
    sf_rule rule = sf_rule_box3();
    removals r = removals_new(3, 1, 2, &rule, mode);
    // 49: a bigger brush leaves less.
    uint32_t a = tiny_parse(a49), d = tiny_parse(d49), e = tiny_parse(e49);
    CHECK((rp(&r, a, d | e) & d & ~rp(&r, a, d)) != 0);
    // 50: order does not matter; one after the other leaves no more than both at once.
    a = tiny_parse("#..|#.."), d = tiny_parse("#..|..."), e = tiny_parse("...|#..");
    CHECK_EQ(rp(&r, rp(&r, a, d), e), d);
    CHECK_EQ(rp(&r, rp(&r, a, e), d), 0);
    CHECK_EQ(rp(&r, a, d | e), 0);
    // 51: more matter leaves more.
    uint32_t more = tiny_parse("##.|#..");
    CHECK((rp(&r, a, d) & ~rp(&r, more, d)) != 0);
    // 53: a least result: either of two does, what they share does not.
    uint32_t left = tiny_parse("#..|#.."), right = tiny_parse(".#.|#..");
    CHECK(tiny_is_free(&r.t, left) && tiny_is_free(&r.t, right));
    CHECK(!tiny_is_free(&r.t, left & right));
    removals_delete(&r);
}

// 50, its other half: one after the other leaves all that both at once leave.
static int sequence_may_leave_less(const removals *r)
{
    for (uint32_t a = 0; a < r->t.count; a++) {
        for (uint32_t d = a; tiny_is_free(&r->t, a) && d != 0; d = (d - 1) & a) {
            for (uint32_t e = a; e != 0; e = (e - 1) & a) {
                if ((rp(r, a, d | e) & ~rp(r, rp(r, a, d), e)) != 0) {
                    return 1;
                }
            }
        }
    }
    return 0;
}

static void false_laws(void)
{
    // What is kept for the voxel above in the middle: fast asks to the right first, greedy takes
    // the lowest x.
    false_laws_of(SF_PRESERVE_FAST, "#.#|.#.", "..#|...", "#..|...");
    false_laws_of(SF_PRESERVE_IRREDUNDANT, "#.#|.#.", "#..|...", "..#|...");
    sf_rule rule = sf_rule_box3();
    for (int mode = SF_PRESERVE_FAST; mode <= SF_PRESERVE_IRREDUNDANT; mode++) {
        removals r = removals_new(3, 1, 3, &rule, (sf_preserve_mode)mode);
        CHECK(sequence_may_leave_less(&r));
        removals_delete(&r);
    }
}

// 52, the false half: fast keeps what could be left out.
static void fast_is_redundant(void)
{
    sf_rule rule = sf_rule_box3();
    removals r = removals_new(3, 1, 2, &rule, SF_PRESERVE_FAST);
    removals g = removals_new(3, 1, 2, &rule, SF_PRESERVE_IRREDUNDANT);
    uint32_t a = tiny_parse("###|###"), d = tiny_parse("###|...");
    CHECK_EQ(rp(&r, a, d), a);
    CHECK_EQ(rp(&g, a, d), tiny_parse(".#.|###"));
    removals_delete(&r);
    removals_delete(&g);
}

// 55: with nothing but straight down 49, 51 and 53 hold.
static void straight_down(void)
{
    sf_rule rule = rule_of_radius(0);
    for (int mode = SF_PRESERVE_FAST; mode <= SF_PRESERVE_IRREDUNDANT; mode++) {
        removals r = removals_new(3, 1, 3, &rule, (sf_preserve_mode)mode);
        uint32_t broken = 0;
        for (uint32_t a = 0; a < r.t.count; a++) {
            for (uint32_t d = 0; tiny_is_free(&r.t, a) && d < r.t.count; d++) {
                for (uint32_t more = 0; more < r.t.count; more++) {
                    broken += (rp(&r, a, d | more) & ~rp(&r, a, d)) != 0; // 49
                    broken += tiny_is_free(&r.t, a | more) &&
                              (rp(&r, a, d) & ~rp(&r, a | more, d)) != 0; // 51
                    int serves = tiny_is_free(&r.t, more) && (a & ~d & ~more) == 0;
                    broken += serves && (rp(&r, a, d) & ~more) != 0; // 53
                }
            }
        }
        CHECK_EQ(broken, 0);
        removals_delete(&r);
    }
}

int main(void)
{
    TEST(true_laws);
    TEST(false_support);
    TEST(false_laws);
    TEST(fast_is_redundant);
    TEST(straight_down);
    return test_finish();
}
