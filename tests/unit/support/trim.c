// SPDX-License-Identifier: MIT
// Why: trim is what everything above rests on. Here the call itself: that it equals the naive trim
// for every rule on widths around word boundaries, treats the bed as the header says, counts right,
// keeps padding zero (TRUST 31), and that a call that fails leaves the grid as it was (promise P2).
// The laws of trimming are in tests/law.

#include "law/stack.h"

static void random_shape(stack *s, int i)
{
    int nx = stack_width(), ny = 1 + (int)test_random_below(12);
    int nz = 1 + (int)test_random_below(9);
    if (i % 3 == 0) {
        stack_random(s, nx, ny, nz, 0.2 + 0.7 * test_random_unit());
    } else {
        stack_random_boxes(s, nx, ny, nz, 2 + (int)test_random_below(8));
    }
}

static void padding_is_zero(const sf_grid *grid)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        for (uint32_t y = 0; y < slice.height; y++) {
            for (uint32_t x = slice.width; x < slice.stride * 64; x++) {
                CHECK((slice.words[y * slice.stride + x / 64] >> (x % 64) & 1) == 0);
            }
        }
    }
}

static void equals_the_naive_trim(void)
{
    static stack s, expected, chains, found;
    for (int i = 0; i < 600; i++) {
        random_shape(&s, i);
        sf_rule rule = rule_by_number(i / 3);
        uint32_t bed = i % 4 == 0 ? test_random_below((uint32_t)s.nz) : SF_BED_AUTO;
        stack_trim(&expected, &s, &rule, bed);
        stack_chains(&chains, &s, &rule, bed);
        CHECK(stack_equal(&expected, &chains));

        sf_grid *grid = stack_grid(&s);
        sf_trim_report report;
        CHECK_EQ(sf_grid_trim(grid, &rule, bed, NULL, &report), SF_OK);
        stack_read(&found, grid);
        CHECK(stack_equal(&expected, &found));
        CHECK_EQ(report.kept_voxels, stack_volume(&expected));
        CHECK_EQ(report.removed_voxels, stack_volume(&s) - stack_volume(&expected));
        int naive_bed = stack_bed(&s, bed);
        CHECK_EQ(report.bed_layer, naive_bed == s.nz ? SF_BED_AUTO : (uint32_t)naive_bed);
        padding_is_zero(grid);
        sf_grid_destroy(grid);
    }
}

static void layers_of_different_heights(void)
{
    static stack s, expected, found;
    double heights[9];
    uint64_t table[18];
    for (int i = 0; i < 200; i++) {
        for (int k = 0; k < 9; k++) {
            heights[k] = 0.1 * (1.0 + 2.0 * test_random_unit());
        }
        sf_lattice lattice = stack_lattice(20, 14, 9);
        lattice.heights_mm = heights;
        sf_rule rule;
        sf_rule_kind kind = i % 2 ? SF_RULE_DISK : SF_RULE_OCTAGON;
        CHECK_EQ(sf_rule_make(kind, 0.8 + 0.4 * test_random_unit(), &lattice, table, &rule, NULL),
                 SF_OK);
        stack_random_boxes(&s, stack_width(), 14, 9, 6);
        stack_trim(&expected, &s, &rule, SF_BED_AUTO);
        library_trim(&found, &s, &rule, SF_BED_AUTO);
        CHECK(stack_equal(&expected, &found));
    }
}

static void matter_below_the_bed_goes(void)
{
    static stack s, expected, found;
    sf_rule rule = sf_rule_box3();
    stack_parse(&s, "###|###|#..|##.|.##");
    stack_parse(&expected, "...|...|#..|##.|.##");
    library_trim(&found, &s, &rule, 2);
    CHECK(stack_equal(&expected, &found));
    // A bed without matter carries nothing.
    stack_parse(&s, "###|...|###|###");
    stack_parse(&expected, "...|...|...|...");
    library_trim(&found, &s, &rule, 1);
    CHECK(stack_equal(&expected, &found));
    // By itself the bed is where matter starts.
    stack_parse(&s, "...|...|.#.|###|...");
    library_trim(&found, &s, &rule, SF_BED_AUTO);
    CHECK(stack_equal(&s, &found));
    stack_parse(&s, "...|...");
    library_trim(&found, &s, &rule, SF_BED_AUTO);
    CHECK(stack_equal(&s, &found));
}

typedef struct watch {
    double last;
    int calls, backwards;
    sf_task *cancel_at_first;
} watch;

static void watching(void *user, double fraction)
{
    watch *w = user;
    w->backwards += fraction < w->last || fraction < 0.0 || fraction > 1.0;
    w->last = fraction;
    w->calls++;
    sf_task_cancel(w->cancel_at_first);
}

static void progress_and_cancel(void)
{
    static stack s, expected, found;
    sf_rule rule = sf_rule_box3();
    stack_random(&s, 20, 10, 8, 0.5);
    stack_trim(&expected, &s, &rule, SF_BED_AUTO);
    sf_grid *grid = stack_grid(&s);
    watch w = {0.0, 0, 0, NULL};
    sf_task task = sf_task_default();
    task.progress = watching;
    task.user = &w;

    sf_task cancelled = sf_task_default();
    sf_task_cancel(&cancelled);
    sf_trim_report report = {7, 7, 7};
    CHECK_EQ(sf_grid_trim(grid, &rule, SF_BED_AUTO, &cancelled, &report), SF_ERR_CANCELLED);
    stack_read(&found, grid);
    CHECK(stack_equal(&s, &found));
    CHECK(report.kept_voxels == 7 && report.removed_voxels == 7 && report.bed_layer == 7);

    // Once the grid is being written to, the call goes through to the end.
    w.cancel_at_first = &task;
    CHECK_EQ(sf_grid_trim(grid, &rule, SF_BED_AUTO, &task, NULL), SF_OK);
    stack_read(&found, grid);
    CHECK(stack_equal(&expected, &found));
    CHECK(w.calls > 1 && w.backwards == 0 && w.last == 1.0);
    sf_grid_destroy(grid);
}

static void failing_calls_change_nothing(void)
{
    static stack s, found;
    stack_random(&s, 30, 10, 6, 0.5);
    sf_grid *grid = stack_grid(&s);
    uint64_t table[8] = {0, 1 << 24, 2 << 24, 3 << 24, 0, 0, 0, 0};
    sf_rule box = sf_rule_box3(), unknown = {.kind = (sf_rule_kind)9};
    sf_rule low = {.kind = SF_RULE_OCTAGON, .table_count = 4, .table = table};
    sf_trim_report report = {1, 2, 3};
    CHECK_EQ(sf_grid_trim(NULL, &box, SF_BED_AUTO, NULL, &report), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim(grid, NULL, SF_BED_AUTO, NULL, &report), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim(grid, &unknown, SF_BED_AUTO, NULL, &report), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim(grid, &low, SF_BED_AUTO, NULL, &report), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_trim(grid, &box, 6, NULL, &report), SF_ERR_ARGUMENT);
    stack_read(&found, grid);
    CHECK(stack_equal(&s, &found));
    CHECK(report.kept_voxels == 1 && report.removed_voxels == 2 && report.bed_layer == 3);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(equals_the_naive_trim);
    TEST(layers_of_different_heights);
    TEST(matter_below_the_bed_goes);
    TEST(progress_and_cancel);
    TEST(failing_calls_change_nothing);
    return test_finish();
}
