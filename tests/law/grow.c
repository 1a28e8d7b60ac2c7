// SPDX-License-Identifier: MIT
// TRUST items 56-63: a grown shape holds the shape, is support-free, grows no further; one that is
// support-free already stays as it is; no added voxel can be dropped; and growing within masks is
// possible just when the shape lies within the trim of what may be solid, with the rest as
// culprits. On all small stacks, and on 10^5 random ones with masks, under every rule. False: that
// growing is monotone (60), and that the union of two grown shapes holds what their union grows to
// (61); grow_pairs.c has these and more over all pairs.

#include "../failing_allocator.h"
#include "paths.h"

static sf_rule random_rule(int i)
{
    sf_rule rule = i % 9 == 8 ? rule_of_radius(2) : rule_by_number(i);
    if (i % 5 == 4) {
        static const double angles[3] = {25.0, 45.0, 60.0};
        rule = rule_of_angle(SF_RULE_SLACK, angles[i / 5 % 3]);
    }
    if (i % 4 == 1) {
        rule.bridge.span_x = (uint16_t)test_random_below(6);
        rule.bridge.span_y = (uint16_t)test_random_below(4);
        rule.bridge.span_diagonal = (uint16_t)test_random_below(4);
        rule.bridge.anchor_x = (uint16_t)test_random_below(3);
        rule.bridge.anchor_diagonal = (uint16_t)test_random_below(3);
    }
    return rule;
}

// Trim of a stack under the terms of a case, by the library.
static void trim_of(const path_case *c, const stack *s, stack *trimmed)
{
    sf_grid *grid = stack_grid(s);
    sf_terms terms = c->terms;
    terms.forbid = terms.act = NULL;
    terms.bed_layer = (uint32_t)stack_bed(&c->shape, c->bed_layer);
    if (terms.bed_layer >= (uint32_t)c->shape.nz) {
        terms.bed_layer = 0;
    }
    CHECK_EQ(sf_grid_trim_on(grid, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
    stack_read(trimmed, grid);
    sf_grid_destroy(grid);
}

// TRUST 63: whether it can be, and what of the shape cannot.
static int is_feasible(const path_case *c, stack *culprits)
{
    static stack may, trimmed;
    may = c->shape;
    for (int i = 0; i < stack_count(&may); i++) {
        int x = i % may.nx, y = i / may.nx % may.ny, z = i / (may.nx * may.ny);
        may.solid[i] |= (uint8_t)is_passable(c, x, y, z);
    }
    trim_of(c, &may, &trimmed);
    stack_combine(culprits, &c->shape, &trimmed, STACK_MINUS);
    return stack_volume(culprits) == 0;
}

// TRUST 62: under rules that are elements each added voxel carries one that nothing else carries.
static void check_irredundant(const path_case *c, const stack *grown)
{
    static stack less;
    for (int i = 0; i < stack_count(grown); i++) {
        if (grown->solid[i] && !c->shape.solid[i]) {
            less = *grown;
            less.solid[i] = 0;
            uint32_t bed = (uint32_t)c->bed;
            CHECK(stack_unsupported(&less, &c->rule, bed) >
                  stack_unsupported(grown, &c->rule, bed));
        }
    }
}

static void check_grown(path_case *c)
{
    static stack grown, trimmed, again, added;
    sf_grow_report report = {0, 0, 0};
    stack_read(&grown, c->grid);
    CHECK(stack_within(&c->shape, &grown)); // 56
    trim_of(c, &grown, &trimmed);
    CHECK(stack_equal(&trimmed, &grown)); // 57, 58
    stack_combine(&added, &grown, &c->shape, STACK_MINUS);
    for (int i = 0; i < stack_count(&added); i++) {
        int x = i % added.nx, y = i / added.nx % added.ny, z = i / (added.nx * added.ny);
        CHECK(!added.solid[i] || is_passable(c, x, y, z));
    }
    if (stack_equal(&c->shape, &c->alive)) {
        CHECK_EQ(stack_volume(&added), 0); // 59
    }
    int is_plain = c->rule.kind != SF_RULE_SLACK && c->rule.bridge.span_x == 0 &&
                   c->rule.bridge.span_y == 0 && c->rule.bridge.span_diagonal == 0;
    if (is_plain && !c->has_exempt) {
        check_irredundant(c, &grown); // 62
    }
    c->terms.bed_layer = (uint32_t)c->bed;
    CHECK_EQ(sf_grid_grow(c->grid, &c->terms, stack_allocator(), NULL, NULL, &report), SF_OK);
    stack_read(&again, c->grid);
    CHECK(stack_equal(&again, &grown)); // 58
    CHECK_EQ(report.added_voxels, 0);
    CHECK_EQ(report.kept_voxels, stack_volume(&grown));
}

static void check_case(path_case *c)
{
    static stack culprits, found;
    path_case_open(c);
    sf_grid *named = NULL;
    CHECK_EQ(sf_grid_clone(c->grid, NULL, &named), SF_OK);
    sf_grow_report report = {7, 7, 7};
    int feasible = is_feasible(c, &culprits);
    sf_status expected = feasible ? SF_OK : SF_ERR_INFEASIBLE;
    CHECK_EQ(sf_grid_grow(c->grid, &c->terms, stack_allocator(), NULL, named, &report),
             expected); // 63
    if (feasible) {
        CHECK_EQ(report.kept_voxels, stack_volume(&c->shape));
        CHECK_EQ(report.added_voxels, sf_grid_popcount(c->grid) - report.kept_voxels);
        check_grown(c);
    } else {
        stack_read(&found, named);
        CHECK(stack_equal(&found, &culprits));
        stack_read(&found, c->grid);
        CHECK(stack_equal(&found, &c->shape));
        CHECK_EQ(report.added_voxels, 7);
    }
    sf_grid_destroy(named);
    path_case_close(c);
}

static void many_small_shapes_under_every_rule(void)
{
    static path_case c;
    for (int i = 0; i < 95000 && test_case_failures == 0; i++) {
        path_random_case(&c, i, 1 + (int)test_random_below(5), 1 + (int)test_random_below(3),
                         2 + (int)test_random_below(4));
        c.rule = random_rule(i / 3 + i);
        check_case(&c);
    }
}

static void random_shapes_under_every_rule(void)
{
    static path_case c;
    for (int i = 0; i < 3500; i++) {
        path_random_case(&c, i, 1 + (int)test_random_below(i % 10 == 0 ? 80 : 11),
                         1 + (int)test_random_below(8), 1 + (int)test_random_below(9));
        c.rule = random_rule(i / 3 + i);
        check_case(&c);
    }
}

// Masks so tight that bridges are the only way.
static void bridges_that_must_be(void)
{
    static path_case c;
    int closed = 0;
    for (int i = 0; i < 1500; i++) {
        int nx = 4 + (int)test_random_below(8), nz = 2 + (int)test_random_below(4);
        int ny = 1 + (int)test_random_below(4);
        path_random_case(&c, i, nx, ny, nz);
        // A few voxels in the top layer, and few columns in which something may stand.
        int area = nx * ny;
        for (int j = 0; j < nz * area; j++) {
            c.shape.solid[j] = j >= (nz - 1) * area && test_random_below(12) == 0;
            c.forbid.solid[j] = j < area ? test_random_below(3) > 0 : c.forbid.solid[j - area];
            c.forbid.solid[j] &= j < (nz - 1) * area;
        }
        c.has_forbid = 1;
        c.has_act = 0;
        c.bed_layer = 0;
        c.rule = i % 3 == 0 ? rule_of_angle(SF_RULE_SLACK, 45.0) : rule_by_number(i);
        c.rule.bridge.span_x = (uint16_t)(1 + test_random_below(5));
        c.rule.bridge.span_diagonal = (uint16_t)test_random_below(3);
        c.rule.bridge.anchor_x = (uint16_t)test_random_below(3);
        path_case plain = c;
        plain.rule.bridge.span_x = plain.rule.bridge.span_diagonal = 0;
        static stack culprits;
        path_case_open(&plain);
        int was_feasible = is_feasible(&plain, &culprits);
        path_case_close(&plain);
        path_case_open(&c);
        closed += !was_feasible && is_feasible(&c, &culprits);
        path_case_close(&c);
        check_case(&c);
    }
    CHECK(closed > 20);
}

static void layers_of_different_heights(void)
{
    static path_case c;
    double heights[8];
    uint64_t table[16];
    for (int i = 0; i < 150; i++) {
        for (int k = 0; k < 8; k++) {
            heights[k] = 0.1 * (1.0 + 2.0 * test_random_unit());
        }
        sf_lattice lattice = stack_lattice(9, 6, 8);
        lattice.heights_mm = heights;
        lattice.pitch_y_mm = i % 3 == 0 ? 0.1 : 0.13;
        path_random_case(&c, i, 9, 6, 8);
        sf_rule_kind kind = i % 3 == 0   ? SF_RULE_OCTAGON
                            : i % 3 == 1 ? SF_RULE_DISK
                                         : SF_RULE_SLACK;
        CHECK_EQ(
            sf_rule_make(kind, 0.95 + 0.3 * test_random_unit(), &lattice, table, &c.rule, NULL),
            SF_OK);
        check_case(&c);
    }
}

// Every stack of a size.
static void all_of(int nx, int ny, int nz, const sf_rule *rule)
{
    static path_case c;
    memset(&c, 0, sizeof c);
    c.rule = *rule;
    for (uint32_t a = 0; a < 1u << (nx * ny * nz); a++) {
        stack_clear(&c.shape, nx, ny, nz);
        for (int i = 0; i < nx * ny * nz; i++) {
            c.shape.solid[i] = (uint8_t)(a >> i & 1);
        }
        check_case(&c);
    }
}

static void every_small_stack(void)
{
    sf_rule rules[3] = {sf_rule_box3(), rule_of_angle(SF_RULE_OCTAGON, 45.0),
                        rule_of_angle(SF_RULE_SLACK, 45.0)};
    for (int i = 0; i < 3; i++) {
        all_of(3, 1, 3, &rules[i]);
        all_of(2, 2, 3, &rules[i]);
        all_of(5, 1, 2, &rules[i]);
    }
    rules[0].bridge.span_x = 2;
    all_of(6, 1, 2, &rules[0]);
}

// What stands in memory before it is written has no say, least of all past the end of a row, which
// a step reaches beyond. The allocator's memory is full of bytes that would be living voxels.
static void memory_has_no_say(void)
{
    static path_case c;
    static stack grown, trimmed;
    int found = 0;
    for (int i = 0; i < 300; i++) {
        failing_allocator memory;
        path_random_case(&c, i, (i % 3 + 1) * 64 - (int)test_random_below(4), 2, 4);
        c.rule = rule_of_angle(SF_RULE_SLACK, 25.0 + 10.0 * (i % 5));
        path_case_open(&c);
        failing_begin(&memory, -1);
        sf_status status = sf_grid_grow(c.grid, &c.terms, &memory.allocator, NULL, NULL, NULL);
        CHECK_EQ(status, is_feasible(&c, &trimmed) ? SF_OK : SF_ERR_INFEASIBLE);
        if (status == SF_OK) {
            stack_read(&grown, c.grid);
            trim_of(&c, &grown, &trimmed);
            CHECK(stack_equal(&trimmed, &grown));
            found++;
        }
        CHECK_EQ(memory.live, 0);
        path_case_close(&c);
    }
    CHECK(found > 100);
}

static void grow_text(const char *text, stack *grown)
{
    sf_terms terms = sf_terms_default();
    terms.bed_layer = 0;
    stack_parse(grown, text);
    sf_grid *grid = stack_grid(grown);
    CHECK_EQ(sf_grid_grow(grid, &terms, stack_allocator(), NULL, NULL, NULL), SF_OK);
    stack_read(grown, grid);
    sf_grid_destroy(grid);
}

static void more_matter_may_need_less(void)
{
    static stack alone, with;
    grow_text("...|.#.", &alone);
    grow_text(".##|.#.", &with);
    CHECK(stack_volume(&alone) > 0); // 60: the column is no longer needed
    // 61, by search: the union of what two shapes grow to does not hold what their union grows to.
    static stack grown[256];
    int counter_examples = 0;
    for (int a = 0; a < 256; a++) {
        char text[10] = "....|....";
        for (int i = 0; i < 8; i++) {
            text[i + i / 4] = a >> i & 1 ? '#' : '.';
        }
        grow_text(text, &grown[a]);
    }
    for (int a = 0; a < 256; a++) {
        for (int b = 0; b < a; b++) {
            static stack both;
            stack_combine(&both, &grown[a], &grown[b], STACK_OR);
            counter_examples += !stack_within(&grown[a | b], &both);
        }
    }
    CHECK(counter_examples > 0);
}

// A flat ceiling is held by as few as share, and bridges let go of more.
static void wide_overhangs_share_supporters(void)
{
    static stack s;
    stack_clear(&s, 30, 30, 12);
    for (int i = 0; i < 27 * 27; i++) {
        *stack_at(&s, 1 + i % 27, 1 + i / 27, 11) = 1;
    }
    sf_terms terms = sf_terms_default();
    sf_grow_report plain, bridged;
    terms.bed_layer = 0;
    sf_grid *grid = stack_grid(&s), *other = stack_grid(&s);
    CHECK_EQ(sf_grid_grow(grid, &terms, stack_allocator(), NULL, NULL, &plain), SF_OK);
    CHECK(plain.added_voxels < 81 * 11 / 2); // 81 pillars side by side would be twice as much
    terms.rule.bridge.span_x = 12;
    CHECK_EQ(sf_grid_grow(other, &terms, stack_allocator(), NULL, NULL, &bridged), SF_OK);
    CHECK(bridged.added_voxels < plain.added_voxels);
    sf_grid_destroy(grid);
    sf_grid_destroy(other);
}

int main(void)
{
    TEST(every_small_stack);
    TEST(many_small_shapes_under_every_rule);
    TEST(random_shapes_under_every_rule);
    TEST(bridges_that_must_be);
    TEST(layers_of_different_heights);
    TEST(memory_has_no_say);
    TEST(more_matter_may_need_less);
    TEST(wide_overhangs_share_supporters);
    return test_finish();
}
