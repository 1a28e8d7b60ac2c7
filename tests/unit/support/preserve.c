// SPDX-License-Identifier: MIT
// Why: preserve promises that nothing outside the brush is lost and that the result prints,
// whatever the rule, and each mode promises something of its own. Random shapes and brushes under
// every rule with bridges, exempt voxels, masks, voxels that must go and shapes that were not
// support-free, judged by alive.h; fast against a plain walk through its order of offsets;
// irredundant by trying every kept voxel (TRUST 44-47, 52, ALGORITHMS 1.4, 10.5).

#include "law/alive.h"

#include <sf/preserve.h>

typedef struct scene {
    stack v, brush, ex, act, keep, go; // go: must go
    stack fixed, out;                  // what is outside the brush; the result
    sf_grid *grid, *masks[5];
    sf_terms terms;
    sf_preserve_options options;
    alive_rule alive;
    int bed;
} scene;

static void begin(scene *s, int nx, int ny, int nz, const sf_rule *rule)
{
    stack *stacks[8] = {&s->v, &s->brush, &s->ex, &s->act, &s->keep, &s->go, &s->fixed, &s->out};
    for (int i = 0; i < 8; i++) {
        stack_clear(stacks[i], nx, ny, nz);
    }
    s->grid = stack_grid(&s->v);
    for (int i = 0; i < 5; i++) {
        s->masks[i] = stack_grid(&s->v);
    }
    s->terms = sf_terms_default();
    s->terms.rule = *rule;
    s->options = sf_preserve_options_default();
    alive_prepare(&s->alive, rule, nz);
}

static void end(scene *s)
{
    sf_grid_destroy(s->grid);
    for (int i = 0; i < 5; i++) {
        sf_grid_destroy(s->masks[i]);
    }
}

static const stack *exempt(const scene *s)
{
    return s->terms.exempt != NULL ? &s->ex : NULL;
}

static void draw(stack *s, int nx, int ny, int nz, int boxes)
{
    if (test_random_below(2)) {
        stack_random(s, nx, ny, nz, 0.2 + 0.75 * test_random_unit());
    } else {
        stack_random_boxes(s, nx, ny, nz, boxes);
    }
}

static const sf_grid *mask(scene *s, int i, const stack *content, int there)
{
    stack_put(content, s->masks[i]);
    return there ? s->masks[i] : NULL;
}

// A shape that is support-free if trimmed, a brush, and masks by chance.
static void make(scene *s, int trimmed)
{
    static stack drawn;
    int nx = s->v.nx, ny = s->v.ny, nz = s->v.nz;
    draw(&drawn, nx, ny, nz, 5);
    stack_random(&s->ex, nx, ny, nz, 0.3 * test_random_unit());
    stack_random(&s->act, nx, ny, nz, 0.85);
    stack_random(&s->keep, nx, ny, nz, 0.15);
    s->terms.exempt = mask(s, 1, &s->ex, test_random_below(3) == 0);
    s->terms.act = mask(s, 2, &s->act, test_random_below(4) == 0);
    s->terms.keep = mask(s, 3, &s->keep, test_random_below(4) == 0);
    s->terms.bed_layer = test_random_below(3) == 0 ? test_random_below(2) : SF_BED_AUTO;
    s->bed = stack_bed(&drawn, s->terms.bed_layer);
    s->v = drawn;
    if (trimmed) {
        alive_trim(&s->alive, &drawn, exempt(s), s->bed, &s->v);
        s->bed = stack_bed(&s->v, s->terms.bed_layer);
    }
    draw(&s->brush, nx, ny, nz, 2);
    s->options.must_go = NULL;
    s->options.brush_box = (sf_box){0, 0, 0, 0, 0, 0};
}

// fixed = what of the shape does not count as the brush.
static void find_fixed(scene *s)
{
    sf_box b = s->options.brush_box;
    s->fixed = s->v;
    for (int i = 0; i < stack_count(&s->v); i++) {
        uint32_t x = (uint32_t)(i % s->v.nx), y = (uint32_t)(i / s->v.nx % s->v.ny);
        uint32_t z = (uint32_t)(i / s->v.nx / s->v.ny);
        int in_box =
            b.x1 == 0 || (x >= b.x0 && x < b.x1 && y >= b.y0 && y < b.y1 && z >= b.z0 && z < b.z1);
        int in = s->brush.solid[i] && in_box && (s->terms.act == NULL || s->act.solid[i]) &&
                 (s->terms.keep == NULL || !s->keep.solid[i]);
        s->fixed.solid[i] = s->v.solid[i] && !in;
    }
}

static sf_status run(scene *s, sf_preserve_report *report)
{
    stack_put(&s->v, s->grid);
    stack_put(&s->brush, s->masks[0]);
    sf_status status = sf_grid_preserve(s->grid, s->masks[0], &s->terms, &s->options,
                                        stack_allocator(), NULL, report);
    stack_take(&s->out, s->grid);
    find_fixed(s);
    return status;
}

// What every mode promises, with `free` exempt.
static void check_result(const scene *s, const sf_preserve_report *report, const stack *free)
{
    CHECK(stack_within(&s->fixed, &s->out) && stack_within(&s->out, &s->v));
    CHECK(alive_is_free(&s->alive, &s->out, free, s->bed));
    CHECK_EQ(report->removed_voxels, stack_volume(&s->v) - stack_volume(&s->out));
    CHECK_EQ(report->kept_voxels, stack_volume(&s->out) - stack_volume(&s->fixed));
    CHECK_EQ(report->lost_outside + report->added_voxels, 0);
    if (s->options.must_go == NULL) {
        CHECK_EQ(stack_equal(&s->out, &s->fixed),
                 alive_is_free(&s->alive, &s->fixed, free, s->bed));
    }
}

// No voxel that was kept can go as well.
static void check_irredundant(const scene *s)
{
    static stack without, trimmed;
    for (int i = 0; i < stack_count(&s->out); i++) {
        if (s->out.solid[i] && !s->fixed.solid[i]) {
            without = s->out;
            without.solid[i] = 0;
            alive_trim(&s->alive, &without, exempt(s), s->bed, &trimmed);
            CHECK(!stack_within(&s->fixed, &trimmed));
        }
    }
}

// Of any width where none is given.
static void every_mode(int width, int ny, int nz, int rules, int runs)
{
    static scene s;
    for (int i = 0; i < rules; i++) {
        sf_rule rule = alive_rule_by_number(i);
        begin(&s, width > 0 ? width : stack_wide(), ny, nz, &rule);
        for (int j = 0; j < runs; j++) {
            make(&s, 1);
            s.options.mode = (sf_preserve_mode)(j % 3);
            s.options.known_support_free = (int)test_random_below(2);
            s.options.strut_width = 1 + 2 * test_random_below(3);
            sf_preserve_report report;
            CHECK_EQ(run(&s, &report), SF_OK);
            check_result(&s, &report, exempt(&s));
            if (s.options.mode == SF_PRESERVE_IRREDUNDANT) {
                check_irredundant(&s);
            }
        }
        end(&s);
    }
}

static void random_small(void)
{
    every_mode(5, 4, 5, 160, 90);
}

static void random_middle(void)
{
    every_mode(10, 8, 8, 32, 45);
}

static void random_wide(void)
{
    every_mode(0, 4, 6, 32, 6);
}

static void brush_box(void)
{
    static scene s;
    for (int i = 0; i < 16; i++) {
        sf_rule rule = alive_rule_by_number(i);
        begin(&s, 70, 5, 5, &rule);
        for (int j = 0; j < 12; j++) {
            make(&s, 1);
            s.options.mode = (sf_preserve_mode)(j % 3);
            uint32_t x = test_random_below(70), y = test_random_below(5), z = test_random_below(5);
            s.options.brush_box = (sf_box){x,
                                           y,
                                           z,
                                           x + 1 + test_random_below(70 - x),
                                           y + 1 + test_random_below(5 - y),
                                           z + 1 + test_random_below(5 - z)};
            sf_preserve_report report;
            CHECK_EQ(run(&s, &report), SF_OK);
            check_result(&s, &report, exempt(&s));
        }
        end(&s);
    }
}

// Hard delete: feasible just when all outside the brush lies within trim(V \ Q).
static void must_go(void)
{
    static scene s;
    static stack rest, possible;
    int feasible = 0, refused = 0;
    for (int i = 0; i < 48; i++) {
        sf_rule rule = alive_rule_by_number(i);
        begin(&s, 6, 5, 5, &rule);
        for (int j = 0; j < 60; j++) {
            make(&s, 1);
            s.options.mode = (sf_preserve_mode)(j % 3);
            find_fixed(&s);
            stack_random(&s.go, 6, 5, 5, 0.25 * test_random_unit());
            if (test_random_below(3) > 0) {
                stack_combine(&s.go, &s.go, &s.fixed, STACK_MINUS);
            }
            s.options.must_go = mask(&s, 4, &s.go, 1);
            stack_combine(&rest, &s.v, &s.go, STACK_MINUS);
            alive_trim(&s.alive, &rest, exempt(&s), s.bed, &possible);
            sf_preserve_report report;
            int can = stack_within(&s.fixed, &possible);
            CHECK_EQ(run(&s, &report), can ? SF_OK : SF_ERR_INFEASIBLE);
            *(can ? &feasible : &refused) += 1;
            if (can) {
                check_result(&s, &report, exempt(&s));
                CHECK(stack_within(&s.out, &possible));
            } else {
                CHECK(stack_equal(&s.out, &s.v));
            }
        }
        end(&s);
    }
    CHECK(feasible > 300 && refused > 300);
}

// A shape that is not support-free is refused; accepted, what was dead before counts as exempt.
static void unsupported(void)
{
    static scene s;
    static stack alive, accepted;
    for (int i = 0; i < 48; i++) {
        sf_rule rule = alive_rule_by_number(i);
        begin(&s, 6, 5, 5, &rule);
        for (int j = 0; j < 30; j++) {
            make(&s, 0);
            s.options.mode = (sf_preserve_mode)(j % 3);
            s.options.accept_unsupported = 0;
            sf_preserve_report report;
            int was_free = alive_is_free(&s.alive, &s.v, exempt(&s), s.bed);
            CHECK_EQ(run(&s, &report), was_free ? SF_OK : SF_ERR_INFEASIBLE);
            s.options.accept_unsupported = 1;
            CHECK_EQ(run(&s, &report), SF_OK);
            alive_trim(&s.alive, &s.v, exempt(&s), s.bed, &alive);
            stack_combine(&accepted, &s.v, &alive, STACK_MINUS);
            if (s.terms.exempt != NULL) {
                stack_combine(&accepted, &accepted, &s.ex, STACK_OR);
            }
            check_result(&s, &report, &accepted);
        }
        end(&s);
    }
}

// ---------------------------------------------------------------------------------------------
// Fast, by a plain walk
// ---------------------------------------------------------------------------------------------

// Every voxel of `above` that hangs takes what is at (dx, dy), then all of them look again.
static void serve(const stack *above, stack *out, const stack *v, const sf_element *e, int k,
                  int dx, int dy)
{
    static stack before;
    before = *out;
    for (int i = 0; i < v->nx * v->ny; i++) {
        int x = i % v->nx, y = i / v->nx;
        if (stack_get(above, x, y, k + 1) && !stack_carried(&before, x, y, k + 1, e) &&
            stack_get(v, x + dx, y + dy, k)) {
            *stack_at(out, x + dx, y + dy, k) = 1;
        }
    }
}

static void plain_fast(const scene *s, stack *out)
{
    static stack above;
    *out = s->fixed;
    for (int k = s->v.nz - 2; k >= max_int(s->bed, 0); k--) {
        sf_element e = stack_step(&s->alive.rule, k);
        above = *out;
        if (exempt(s) != NULL) {
            stack_combine(&above, &above, &s->ex, STACK_MINUS);
        }
        serve(&above, out, &s->v, &e, k, 0, 0);
        for (int r = 1; r <= max_int(e.reach_y, e.half_width[0]); r++) {
            for (int t = 0; t <= r; t++) {
                int offsets[8][2] = {{r, t}, {-r, t}, {r, -t}, {-r, -t},
                                     {t, r}, {-t, r}, {t, -r}, {-t, -r}};
                for (int i = 0; i < 8; i++) {
                    if (element_has(&e, offsets[i][0], offsets[i][1])) {
                        serve(&above, out, &s->v, &e, k, offsets[i][0], offsets[i][1]);
                    }
                }
            }
        }
    }
}

static void fast_is_its_order(void)
{
    static scene s;
    static stack expected;
    for (int i = 0; i < 5; i++) {
        sf_rule rule = alive_rule_by_number(i);
        for (int j = 0; j < 250; j++) {
            int wide = j % 8 == 0;
            begin(&s, wide ? 131 : 9, wide ? 5 : 8, 6, &rule);
            make(&s, 1);
            sf_preserve_report report;
            CHECK_EQ(run(&s, &report), SF_OK);
            plain_fast(&s, &expected);
            CHECK(stack_equal(&s.out, &expected));
            end(&s);
        }
    }
}

// Boxes that end near where a word does, in thin noise: what hangs just outside may be carried by
// what is one word farther.
static void fast_at_words(void)
{
    static scene s;
    static stack drawn, expected;
    for (int i = 0; i < 5; i++) {
        sf_rule rule = alive_rule_by_number(i);
        begin(&s, 131, 3, 4, &rule);
        for (int j = 0; j < 150; j++) {
            uint32_t x0 = j % 2 ? 62 + test_random_below(7) : 0;
            stack_random(&drawn, 131, 3, 4, 0.45);
            s.bed = stack_bed(&drawn, SF_BED_AUTO);
            alive_trim(&s.alive, &drawn, NULL, s.bed, &s.v);
            memset(s.brush.solid, 1, (size_t)stack_count(&s.brush));
            s.options.brush_box = (sf_box){x0, 0, 0, x0 + 59 + test_random_below(5), 3, 4};
            CHECK_EQ(run(&s, NULL), SF_OK);
            plain_fast(&s, &expected);
            CHECK(stack_equal(&s.out, &expected));
        }
        end(&s);
    }
}

// A shape that is said to be support-free and is not: what hangs after the edit hung before.
static void known_but_wrong(void)
{
    static scene s;
    for (int i = 0; i < 5; i++) {
        sf_rule rule = alive_rule_by_number(i);
        for (int j = 0; j < 100; j++) {
            begin(&s, 9, 8, 6, &rule);
            make(&s, 0);
            s.options.known_support_free = 1;
            CHECK_EQ(run(&s, NULL), SF_OK);
            for (int v = 0; v < stack_count(&s.v); v++) {
                int x = v % 9, y = v / 9 % 8, z = v / 72;
                if (s.out.solid[v] && z > s.bed && !(exempt(&s) != NULL && s.ex.solid[v])) {
                    const sf_element *e = &s.alive.steps[z - 1].element;
                    CHECK(stack_carried(&s.out, x, y, z, e) || !stack_carried(&s.v, x, y, z, e));
                }
            }
            CHECK(stack_within(&s.fixed, &s.out) && stack_within(&s.out, &s.v));
            end(&s);
        }
    }
}

// Rules with slack or bridges have no words to do it by, and say so: fast is complete().
static void fast_elsewhere_is_complete(void)
{
    static scene s;
    for (int i = 5; i < 16; i++) {
        sf_rule rule = alive_rule_by_number(i);
        if (rule.kind != SF_RULE_SLACK) {
            rule.bridge.span_x = 3;
        }
        begin(&s, 9, 8, 6, &rule);
        make(&s, 1);
        CHECK_EQ(run(&s, NULL), SF_OK);
        stack_put(&s.v, s.masks[0]);
        stack_put(&s.fixed, s.masks[4]);
        CHECK_EQ(
            sf_grid_complete(s.masks[0], s.masks[4], &s.terms, stack_allocator(), NULL, s.grid),
            SF_OK);
        stack_take(&s.v, s.grid);
        CHECK(stack_equal(&s.v, &s.out));
        end(&s);
    }
}

// Whether a voxel lies in a square of 3x3 of its layer.
static int in_square(const stack *s, int x, int y, int z)
{
    for (int i = 0; i < 9; i++) {
        int cx = x + i % 3 - 1, cy = y + i / 3 - 1, full = 1;
        for (int j = 0; j < 9; j++) {
            full = full && stack_get(s, cx + j % 3 - 1, cy + j / 3 - 1, z);
        }
        if (full) {
            return 1;
        }
    }
    return 0;
}

// What a brush may cost, by mode: under a flat ceiling greedy keeps least, and core stays thick.
static void modes_differ(void)
{
    static scene s;
    sf_rule rule = sf_rule_box3();
    uint64_t kept[3];
    begin(&s, 24, 24, 12, &rule);
    for (int i = 0; i < stack_count(&s.v); i++) {
        int z = i / (24 * 24), x = i % 24, y = i / 24 % 24;
        s.v.solid[i] = 1;
        s.brush.solid[i] = z >= 3 && z < 9 && x >= 4 && x < 20 && y >= 4 && y < 20;
    }
    for (int mode = 0; mode < 3; mode++) {
        sf_preserve_report report;
        s.options.mode = (sf_preserve_mode)mode;
        CHECK_EQ(run(&s, &report), SF_OK);
        check_result(&s, &report, NULL);
        kept[mode] = report.kept_voxels;
        for (int i = 0; mode == SF_PRESERVE_CORE && i < stack_count(&s.out); i++) {
            CHECK(!s.out.solid[i] || in_square(&s.out, i % 24, i / 24 % 24, i / (24 * 24)));
        }
    }
    CHECK(kept[SF_PRESERVE_IRREDUNDANT] < kept[SF_PRESERVE_CORE]);
    CHECK(kept[SF_PRESERVE_CORE] < kept[SF_PRESERVE_FAST]);
    printf("# kept of %d: fast %d, irredundant %d, core %d\n", 16 * 16 * 6,
           (int)kept[SF_PRESERVE_FAST], (int)kept[SF_PRESERVE_IRREDUNDANT],
           (int)kept[SF_PRESERVE_CORE]);
    end(&s);
}

int main(void)
{
    TEST(random_small);
    TEST(random_middle);
    TEST(random_wide);
    TEST(brush_box);
    TEST(must_go);
    TEST(unsupported);
    TEST(fast_is_its_order);
    TEST(fast_at_words);
    TEST(known_but_wrong);
    TEST(fast_elsewhere_is_complete);
    TEST(modes_differ);
    return test_finish();
}
