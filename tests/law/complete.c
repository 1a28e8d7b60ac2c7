// SPDX-License-Identifier: MIT
// Why: preserve, cavities, pruning and every mask question are made of complete(), so its theorem
// is the one that all of them rest on (ALGORITHMS 10.1, 10.5; TRUST 63): F within V' within V, V'
// support-free, V' = F just when F is support-free, for every rule, with slack, bridges and exempt
// voxels together. Judged by alive.h, which shares no code with the library; all stacks of 3x1x3,
// some others, and 10^5 random ones.

#include "alive.h"

#include <sf/preserve.h>

typedef struct bench {
    sf_grid *shape, *needed, *exempt, *result;
    stack v, f, ex, out;
    sf_terms terms;
    alive_rule alive;
} bench;

static void begin(bench *b, int nx, int ny, int nz)
{
    stack_clear(&b->v, nx, ny, nz);
    stack_clear(&b->f, nx, ny, nz);
    stack_clear(&b->ex, nx, ny, nz);
    stack_clear(&b->out, nx, ny, nz);
    b->shape = stack_grid(&b->v);
    b->needed = stack_grid(&b->v);
    b->exempt = stack_grid(&b->v);
    b->result = stack_grid(&b->v);
    b->terms = sf_terms_default();
}

static void end(bench *b)
{
    sf_grid_destroy(b->shape);
    sf_grid_destroy(b->needed);
    sf_grid_destroy(b->exempt);
    sf_grid_destroy(b->result);
}

static void use_rule(bench *b, const sf_rule *rule)
{
    b->terms.rule = *rule;
    alive_prepare(&b->alive, rule, b->v.nz);
}

// The theorem for b->v and b->f; b->ex counts where the terms name it.
static void check_theorem(bench *b)
{
    const stack *ex = b->terms.exempt != NULL ? &b->ex : NULL;
    int bed = stack_bed(&b->v, b->terms.bed_layer);
    stack_put(&b->v, b->shape);
    stack_put(&b->f, b->needed);
    sf_status status =
        sf_grid_complete(b->shape, b->needed, &b->terms, stack_allocator(), NULL, b->result);
    CHECK_EQ(status, SF_OK);
    stack_take(&b->out, b->result);
    CHECK(stack_within(&b->f, &b->out) && stack_within(&b->out, &b->v));
    CHECK(alive_is_free(&b->alive, &b->out, ex, bed));
    CHECK_EQ(stack_equal(&b->out, &b->f), alive_is_free(&b->alive, &b->f, ex, bed));
}

static void from_bits(stack *s, uint32_t bits)
{
    for (int i = 0; i < stack_count(s); i++) {
        s->solid[i] = bits >> i & 1;
    }
}

// All shapes of one size, and all that may have to stay of them.
static void all_of(bench *b)
{
    uint32_t count = 1u << stack_count(&b->v);
    for (uint32_t v = 0; v < count; v++) {
        from_bits(&b->v, v);
        if (!alive_is_free(&b->alive, &b->v, NULL, 0)) {
            continue;
        }
        for (uint32_t f = v;; f = (f - 1) & v) {
            from_bits(&b->f, f);
            check_theorem(b);
            if (f == 0) {
                break;
            }
        }
    }
}

// A row of three in three layers under twelve rules; larger ones under a few.
static void all_tiny(void)
{
    static const int numbers[15] = {0, 1, 3, 5, 6, 7, 8, 11, 13, 14, 15, 14, 8, 5, 14};
    static const int sizes[4][3] = {{3, 1, 3}, {5, 1, 2}, {5, 1, 2}, {2, 2, 2}};
    static bench b;
    for (int i = 0; i < 15; i++) {
        const int *n = sizes[i < 12 ? 0 : i - 11];
        begin(&b, n[0], n[1], n[2]);
        sf_rule rule = alive_rule_by_number(numbers[i]);
        if (numbers[i] >= 8) {
            rule.bridge.span_x = (uint16_t)(1 + i % 2);
            rule.bridge.anchor_x = (uint16_t)(i % 3 == 0 ? 2 : 1);
        }
        use_rule(&b, &rule);
        b.terms.bed_layer = 0;
        all_of(&b);
        end(&b);
    }
}

// Noise or boxes, trimmed by the oracle, and a part of it that must stay.
static void make_random(bench *b)
{
    int nx = b->v.nx, ny = b->v.ny, nz = b->v.nz;
    static stack drawn, hole;
    if (test_random_below(2)) {
        stack_random(&drawn, nx, ny, nz, 0.15 + 0.8 * test_random_unit());
    } else {
        stack_random_boxes(&drawn, nx, ny, nz, 2 + (int)test_random_below(6));
    }
    b->terms.exempt = NULL;
    if (test_random_below(3) == 0) {
        stack_random(&b->ex, nx, ny, nz, 0.3 * test_random_unit());
        stack_put(&b->ex, b->exempt);
        b->terms.exempt = b->exempt;
    }
    b->terms.bed_layer = test_random_below(3) == 0 ? test_random_below(2) : SF_BED_AUTO;
    int bed = stack_bed(&drawn, b->terms.bed_layer);
    alive_trim(&b->alive, &drawn, b->terms.exempt != NULL ? &b->ex : NULL, bed, &b->v);
    if (test_random_below(2)) {
        stack_random_boxes(&hole, nx, ny, nz, 1 + (int)test_random_below(2));
    } else {
        stack_random(&hole, nx, ny, nz, test_random_unit());
    }
    stack_combine(&b->f, &b->v, &hole, STACK_MINUS);
}

// Of any width where none is given.
static void run_random(int width, int ny, int nz, int rules, int runs)
{
    static bench b;
    for (int i = 0; i < rules; i++) {
        sf_rule rule = alive_rule_by_number(i);
        begin(&b, width > 0 ? width : stack_wide(), ny, nz);
        use_rule(&b, &rule);
        for (int j = 0; j < runs; j++) {
            make_random(&b);
            check_theorem(&b);
        }
        end(&b);
    }
}

static void random_small(void)
{
    run_random(4, 3, 4, 160, 450);
    run_random(7, 1, 6, 80, 300);
}

static void random_middle(void)
{
    run_random(7, 6, 6, 96, 100);
    run_random(11, 9, 8, 32, 40);
}

// Wider than a word, where windows and codes have more than one to a row.
static void random_wide(void)
{
    run_random(0, 3, 5, 64, 6);
    run_random(0, 9, 6, 32, 4);
}

// Layers of many heights, pixels that are not square: every step has numbers of its own.
static void random_uneven(void)
{
    static bench b;
    static const double heights[7] = {0.1, 0.2, 0.05, 0.1, 0.3, 0.15, 0.1};
    sf_lattice lattice = stack_lattice(8, 7, 7);
    lattice.heights_mm = heights;
    lattice.pitch_y_mm = 0.14;
    for (int i = 0; i < 16; i++) {
        uint64_t table[14];
        sf_rule rule = sf_rule_box3();
        begin(&b, 8, 7, 7);
        sf_status status =
            sf_rule_make(i % 4 == 0 ? SF_RULE_DISK : SF_RULE_SLACK,
                         i % 4 == 0 ? 1.3 : 0.6 + 0.1 * (i % 4), &lattice, table, &rule, NULL);
        CHECK_EQ(status, SF_OK);
        rule.bridge = alive_rule_by_number(i).bridge;
        use_rule(&b, &rule);
        for (int j = 0; j < 60; j++) {
            make_random(&b);
            check_theorem(&b);
        }
        end(&b);
    }
}

// ---------------------------------------------------------------------------------------------
// Masks: what must stay, what may be, and whether both can be had
// ---------------------------------------------------------------------------------------------

// Whether any support-free R with P within R within M exists, by trying all of them.
static int exists(bench *b, uint32_t p, uint32_t m, int bed)
{
    static stack r;
    uint32_t optional = m & ~p;
    stack_clear(&r, b->v.nx, b->v.ny, b->v.nz);
    if ((p & ~m) != 0) {
        return 0;
    }
    for (uint32_t q = optional;; q = (q - 1) & optional) {
        from_bits(&r, p | q);
        if (alive_is_free(&b->alive, &r, b->terms.exempt != NULL ? &b->ex : NULL, bed)) {
            return 1;
        }
        if (q == 0) {
            return 0;
        }
    }
}

// One question: feasible() must know the answer, complete() must build it.
static void check_mask(bench *b, uint32_t p, uint32_t m)
{
    static stack allowed, possible;
    stack_clear(&allowed, b->v.nx, b->v.ny, b->v.nz);
    from_bits(&allowed, m);
    from_bits(&b->f, p);
    stack_put(&allowed, b->shape);
    stack_put(&b->f, b->needed);
    int bed = stack_bed(&allowed, b->terms.bed_layer), there = exists(b, p, m, bed);
    sf_status status =
        sf_grid_feasible(b->shape, b->needed, &b->terms, stack_allocator(), NULL, NULL, NULL);
    CHECK_EQ(status, there ? SF_OK : SF_ERR_INFEASIBLE);
    alive_trim(&b->alive, &allowed, b->terms.exempt != NULL ? &b->ex : NULL, bed, &possible);
    CHECK_EQ(stack_within(&b->f, &possible), there);
    if (there) {
        b->v = possible;
        check_theorem(b);
    }
}

// P of four kinds: single voxels, a layer, a sparse set, most of what may be.
static void masks(void)
{
    static bench b;
    static const int sizes[4][3] = {{3, 1, 3}, {5, 1, 2}, {5, 1, 2}, {2, 2, 2}};
    for (int i = 0; i < 64; i++) {
        const int *n = sizes[i % 4];
        int count = n[0] * n[1] * n[2], area = n[0] * n[1];
        begin(&b, n[0], n[1], n[2]);
        sf_rule rule = alive_rule_by_number(i / 4);
        use_rule(&b, &rule);
        for (int j = 0; j < 40; j++) {
            uint32_t all = (1u << count) - 1, m = (uint32_t)test_random() & all;
            m |= (uint32_t)test_random() & all;
            uint32_t kinds[4] = {1u << test_random_below((uint32_t)count),
                                 m & (((1u << area) - 1) << (area * (n[2] - 1))),
                                 m & (uint32_t)test_random() & (uint32_t)test_random(),
                                 m & ((uint32_t)test_random() | (uint32_t)test_random())};
            b.terms.bed_layer = j % 2 ? SF_BED_AUTO : 0;
            stack_random(&b.ex, n[0], n[1], n[2], 0.15);
            stack_put(&b.ex, b.exempt);
            b.terms.exempt = j % 3 == 0 ? b.exempt : NULL;
            check_mask(&b, kinds[j / 2 % 4] & all, m);
        }
        end(&b);
    }
}

int main(void)
{
    TEST(all_tiny);
    TEST(random_small);
    TEST(random_middle);
    TEST(random_wide);
    TEST(random_uneven);
    TEST(masks);
    return test_finish();
}
