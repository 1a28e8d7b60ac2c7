// SPDX-License-Identifier: MIT
// TRUST items 29, 30: sums and changes of resolution. Sweeping a support-free brush along a
// support-free path leaves a support-free sweep; a brush that is not leaves none. Resampling does
// not keep what was proved on another lattice: doubling breaks it, and of the ways to halve only
// "solid where any is" under the square keeps it. So a shape is checked on the lattice that it is
// printed on.

#include "tiny.h"

// Minkowski sum, layers included.
static void sum_of(stack *sum, const stack *a, const stack *b)
{
    stack_clear(sum, a->nx + b->nx - 1, a->ny + b->ny - 1, a->nz + b->nz - 1);
    for (int i = 0; i < stack_count(a); i++) {
        for (int j = 0; a->solid[i] && j < stack_count(b); j++) {
            if (b->solid[j]) {
                int x = i % a->nx + j % b->nx, y = i / a->nx % a->ny + j / b->nx % b->ny;
                *stack_at(sum, x, y, i / (a->nx * a->ny) + j / (b->nx * b->ny)) = 1;
            }
        }
    }
}

// The library's verdict.
static int is_free(const stack *s, const sf_rule *rule)
{
    sf_check_options o = sf_check_options_default();
    sf_check_report report = {0};
    sf_grid *grid = stack_grid(s);
    o.rule = *rule;
    o.bed_layer = 0;
    CHECK_EQ(sf_grid_check(grid, &o, stack_allocator(), NULL, &report, NULL), SF_OK);
    sf_grid_destroy(grid);
    CHECK_EQ(report.support_free, stack_is_support_free(s, rule, 0));
    return report.support_free;
}

static void stack_of(stack *s, const tiny *t, uint32_t bits)
{
    stack_clear(s, t->nx, t->ny, t->nz);
    for (int v = 0; v < t->voxels; v++) {
        s->solid[v] = (uint8_t)(bits >> v & 1);
    }
}

static void every_sum_of_support_free_stacks(void)
{
    static stack a, b, sum;
    sf_rule rule = sf_rule_box3();
    tiny t = tiny_new(3, 1, 2, &rule), u = tiny_new(2, 2, 2, &rule);
    for (uint32_t i = 0; i < t.count; i++) {
        for (uint32_t j = 0; j < u.count; j++) {
            if (tiny_is_free(&t, i) && tiny_is_free(&u, j)) {
                stack_of(&a, &t, i);
                stack_of(&b, &u, j);
                sum_of(&sum, &a, &b);
                CHECK(is_free(&sum, &rule));
            }
        }
    }
    tiny_delete(&t);
    tiny_delete(&u);
}

static void random_sweeps(void)
{
    static stack a, b, kept_a, kept_b, sum;
    sf_rule rules[] = {sf_rule_box3(), rule_of_radius(1), rule_of_radius(2)};
    for (int i = 0; i < 150; i++) {
        const sf_rule *rule = &rules[i % 3];
        stack_random(&a, 9, 6, 4, 0.1 + 0.3 * test_random_unit());
        stack_random(&b, 5, 4, 4, 0.1 + 0.5 * test_random_unit());
        library_trim(&kept_a, &a, rule, 0);
        library_trim(&kept_b, &b, rule, 0);
        sum_of(&sum, &kept_a, &kept_b);
        CHECK(is_free(&sum, rule));
    }
}

// 29, the false half: a brush that floats.
static void false_sum_with_any_brush(void)
{
    static stack path, brush, sum;
    sf_rule rule = sf_rule_box3();
    stack_parse(&path, "#..|...");
    stack_parse(&brush, ".|#");
    CHECK(is_free(&path, &rule) && !is_free(&brush, &rule));
    sum_of(&sum, &path, &brush);
    CHECK(!is_free(&sum, &rule));
}

static void doubled(stack *result, const stack *s)
{
    stack_clear(result, 2 * s->nx, 2 * s->ny, 2 * s->nz);
    for (int i = 0; i < stack_count(result); i++) {
        int x = i % result->nx, y = i / result->nx % result->ny;
        result->solid[i] = (uint8_t)stack_get(s, x / 2, y / 2, i / (result->nx * result->ny) / 2);
    }
}

enum { ANY, ALL };

static void halved(stack *result, const stack *s, int which)
{
    stack_clear(result, (s->nx + 1) / 2, (s->ny + 1) / 2, s->nz / 2);
    for (int i = 0; i < stack_count(result); i++) {
        int x = i % result->nx, y = i / result->nx % result->ny, z = i / (result->nx * result->ny);
        int solid = 0, cells = 0;
        for (int c = 0; c < 8; c++) {
            int px = 2 * x + c % 2, py = 2 * y + c / 2 % 2;
            cells += px < s->nx && py < s->ny;
            solid += stack_get(s, px, py, 2 * z + c / 4);
        }
        result->solid[i] = which == ANY ? solid > 0 : solid == cells;
    }
}

static void halving_by_any_under_the_square(void)
{
    static stack s, kept, half;
    sf_rule rule = sf_rule_box3();
    tiny t = tiny_new(4, 1, 4, &rule);
    for (uint32_t a = 0; a < t.count; a++) {
        if (tiny_is_free(&t, a)) {
            stack_of(&s, &t, a);
            halved(&half, &s, ANY);
            CHECK(stack_is_support_free(&half, &rule, 0));
        }
    }
    tiny_delete(&t);
    for (int i = 0; i < 200; i++) {
        stack_random(&s, 10, 8, 6, 0.1 + 0.3 * test_random_unit());
        library_trim(&kept, &s, &rule, 0);
        halved(&half, &kept, ANY);
        CHECK(is_free(&half, &rule));
    }
}

// 30: the ways that lose it.
static void false_resampling(void)
{
    static stack s, r;
    sf_rule box = sf_rule_box3(), plus = rule_of_radius(1);
    // Doubling: a step of one column becomes a step of two.
    stack_parse(&s, "#.|.#");
    CHECK(is_free(&s, &box));
    doubled(&r, &s);
    CHECK(!is_free(&r, &box));
    // Any, under the plus: two steps to the side within one cell's height make a diagonal.
    stack_parse(&s,
                "..../.#../..../....|..../.#../..../....|..../..#./..../....|..../..../..#./....");
    CHECK(is_free(&s, &plus));
    halved(&r, &s, ANY);
    CHECK(!is_free(&r, &plus));
    CHECK(is_free(&r, &box));
    // All: a half-filled cell carries a full one, until it counts as empty.
    stack_parse(&s, ".#..|.#..|##..|##..");
    CHECK(is_free(&s, &box));
    halved(&r, &s, ALL);
    CHECK(!is_free(&r, &box));
}

int main(void)
{
    TEST(every_sum_of_support_free_stacks);
    TEST(random_sweeps);
    TEST(false_sum_with_any_brush);
    TEST(halving_by_any_under_the_square);
    TEST(false_resampling);
    return test_finish();
}
