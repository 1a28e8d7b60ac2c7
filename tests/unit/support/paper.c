// SPDX-License-Identifier: MIT
// Why: the paper's preserve is kept to compare with, so it must be what the paper says, in text and
// shader, and must fail where it is said to fail (ALGORITHMS 1.4): under an 11x11 pillar a brush of
// height 6 costs it all 16 layers above, 1936 voxels, and up to height 5 none; the library's own
// modes lose none at any height.

#include "law/alive.h"

#include <sf/preserve.h>

static void preserve(stack *s, const stack *brush, const sf_rule *rule, sf_preserve_mode mode,
                     int trim_after, sf_preserve_report *report)
{
    sf_terms terms = sf_terms_default();
    sf_preserve_options options = sf_preserve_options_default();
    sf_grid *grid = stack_grid(s), *mask = stack_grid(brush);
    terms.rule = *rule;
    terms.bed_layer = 0;
    options.mode = mode;
    options.trim_after = trim_after;
    CHECK_EQ(sf_grid_preserve(grid, mask, &terms, &options, stack_allocator(), NULL, report),
             SF_OK);
    stack_take(s, grid);
    sf_grid_destroy(grid);
    sf_grid_destroy(mask);
}

// A pillar of 11x11, 16 layers above a brush of a height that holds all of it there.
static void make_pillar(stack *s, stack *brush, int height)
{
    stack_clear(s, 15, 15, 2 + height + 16);
    stack_clear(brush, 15, 15, 2 + height + 16);
    for (int i = 0; i < stack_count(s); i++) {
        int x = i % 15, y = i / 15 % 15, z = i / 225;
        s->solid[i] = x >= 2 && x < 13 && y >= 2 && y < 13;
        brush->solid[i] = z >= 2 && z < 2 + height;
    }
}

static void pillar(void)
{
    static stack s, brush;
    sf_rule rule = sf_rule_box3();
    sf_preserve_report report;
    for (int height = 1; height <= 12; height++) {
        for (int mode = SF_PRESERVE_FAST; mode <= SF_PRESERVE_CORE; mode++) {
            make_pillar(&s, &brush, height);
            preserve(&s, &brush, &rule, (sf_preserve_mode)mode, 0, &report);
            CHECK_EQ(report.lost_outside, 0);
            CHECK(stack_is_support_free(&s, &rule, 0));
            if (height == 6) {
                printf("# mode %d keeps %llu of %d\n", mode, (unsigned long long)report.kept_voxels,
                       6 * 121);
            }
        }
        make_pillar(&s, &brush, height);
        preserve(&s, &brush, &rule, SF_PRESERVE_PAPER_SHADER, 1, &report);
        CHECK_EQ(report.lost_outside, height <= 5 ? 0 : 1936);
        CHECK(stack_is_support_free(&s, &rule, 0));
        make_pillar(&s, &brush, height);
        preserve(&s, &brush, &rule, SF_PRESERVE_PAPER_TEXT, 1, &report);
        CHECK_EQ(report.lost_outside, height <= 5 ? 0 : 1936);
    }
    // Without the trim the shader leaves it in the air, on a stalactite that ends in one voxel.
    make_pillar(&s, &brush, 6);
    preserve(&s, &brush, &rule, SF_PRESERVE_PAPER_SHADER, 0, &report);
    CHECK_EQ(report.lost_outside, 0);
    CHECK_EQ(stack_unsupported(&s, &rule, 0), 1);
}

// Whether all that the element around (x, y) has in layer z is solid; outside is empty.
static int in_erosion(const stack *s, int x, int y, int z, const sf_element *e)
{
    for (int dy = -(int)e->reach_y; dy <= (int)e->reach_y; dy++) {
        for (int dx = -(int)e->half_width[0]; dx <= (int)e->half_width[0]; dx++) {
            if (element_has(e, dx, dy) && !stack_get(s, x + dx, y + dy, z)) {
                return 0;
            }
        }
    }
    return 1;
}

// Both readings, a voxel at a time. The brush spans the layers z0 <= z < z1.
static void by_hand(stack *s, const stack *brush, const sf_rule *rule, int is_text, int z0, int z1)
{
    int area = s->nx * s->ny;
    for (int i = 0; is_text && i < stack_count(s); i++) {
        s->solid[i] = s->solid[i] && !brush->solid[i];
    }
    for (int z = is_text ? z1 : z1 - 1; z >= (is_text ? max_int(z0 - 1, 0) : z0); z--) {
        for (int i = 0; i < area && z < s->nz; i++) {
            int x = i % s->nx, y = i / s->nx, core = 0;
            uint8_t *v = stack_at(s, x, y, z);
            if (z + 1 < s->nz) {
                sf_element e = stack_step(rule, z);
                core = in_erosion(s, x, y, z + 1, &e);
            }
            if (is_text) {
                *v = *v || core;
            } else if (stack_get(brush, x, y, z)) {
                *v = *v && core;
            }
        }
    }
}

static void as_written(void)
{
    static stack s, before, brush, expected, gained, lost;
    for (int i = 0; i < 800; i++) {
        sf_rule rule = alive_rule_by_number(i % 8);
        int nx = i % 9 == 0 ? 75 : 8, z0 = (int)test_random_below(4);
        int z1 = z0 + 1 + (int)test_random_below((uint32_t)(6 - z0));
        stack_random(&s, nx, 7, 6, i % 2 ? 0.95 : 0.8);
        stack_random(&brush, nx, 7, 6, 0.6);
        for (int v = 0; v < stack_count(&brush); v++) {
            int z = v / (nx * 7);
            brush.solid[v] = brush.solid[v] && z >= z0 && z < z1;
        }
        *stack_at(&brush, 0, 0, z0) = *stack_at(&brush, 0, 0, z1 - 1) = 1;
        before = expected = s;
        int is_text = i / 2 % 2;
        sf_preserve_report report;
        by_hand(&expected, &brush, &rule, is_text, z0, z1);
        preserve(&s, &brush, &rule, is_text ? SF_PRESERVE_PAPER_TEXT : SF_PRESERVE_PAPER_SHADER, 0,
                 &report);
        CHECK(stack_equal(&s, &expected));
        stack_combine(&gained, &s, &before, STACK_MINUS);
        stack_combine(&lost, &before, &s, STACK_MINUS);
        CHECK_EQ(report.added_voxels, stack_volume(&gained));
        CHECK_EQ(report.removed_voxels + report.lost_outside, stack_volume(&lost));
        CHECK_EQ(report.lost_outside, 0);
    }
}

// What the text says of its erosion: that it is the least that carries. Of 5x5 it has nine voxels,
// four carry, and it could do without its middle.
static void erosion_is_no_cover(void)
{
    static stack s, brush;
    sf_rule rule = sf_rule_box3();
    sf_preserve_report report;
    for (int mode = SF_PRESERVE_IRREDUNDANT; mode <= SF_PRESERVE_PAPER_SHADER; mode++) {
        stack_clear(&s, 5, 5, 2);
        memset(s.solid, 1, 50);
        stack_clear(&brush, 5, 5, 2);
        memset(brush.solid, 1, 25);
        preserve(&s, &brush, &rule, (sf_preserve_mode)mode, 0, &report);
        CHECK(stack_is_support_free(&s, &rule, 0));
        if (mode == SF_PRESERVE_IRREDUNDANT) {
            CHECK_EQ(report.kept_voxels, 4);
        } else if (mode != SF_PRESERVE_CORE) {
            CHECK_EQ(report.kept_voxels, 9);
            *stack_at(&s, 2, 2, 0) = 0;
            CHECK(stack_is_support_free(&s, &rule, 0));
        }
    }
}

int main(void)
{
    TEST(pillar);
    TEST(as_written);
    TEST(erosion_is_no_cover);
    return test_finish();
}
