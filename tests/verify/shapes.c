// SPDX-License-Identifier: MIT
// Why: that a trimmed shape is support-free must not rest on the word of the code that trimmed it.
// The verifier, which shares no line with the library, reads the written stack and agrees: on
// trimmed shapes under every rule, with equal and different heights, oblong pixels and a given bed;
// it refuses untrimmed ones, naming a voxel that indeed nothing carries; and on single flipped
// voxels it judges as the library's check of the whole grid does. Twin of verify models.

#include "judge.h"

#include "law/stack.h"

#define FLIPS "--corrupt 300 --seed 7"

static void shape_on(sf_grid *grid)
{
    static stack s;
    sf_lattice lattice = sf_grid_lattice(grid);
    stack_random_boxes(&s, (int)lattice.nx, (int)lattice.ny, (int)lattice.nz, 14);
    for (int i = 0; i < stack_count(&s); i++) {
        s.solid[i] |= test_random_below(12) == 0;
    }
    stack_write(&s, grid);
}

static void judge_on(const sf_lattice *lattice, int which, uint32_t bed)
{
    uint64_t table[128];
    sf_rule_kind kind = verified_rules[which].kind;
    sf_stack_info info = stack_info(kind, verified_rules[which].degrees, bed);
    sf_rule rule;
    CHECK_EQ(sf_rule_make(kind, info.angle_rad, lattice, table, &rule, NULL), SF_OK);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    shape_on(grid);
    CHECK(!library_says_free(grid, &rule, bed));
    CHECK(write_stack(grid, &info, folder_path("stack")));
    CHECK(verifier_exits(folder_path("stack"), "", 1));

    CHECK_EQ(sf_grid_trim(grid, &rule, bed, NULL, NULL), SF_OK);
    CHECK(write_stack(grid, &info, folder_path("stack")));
    CHECK(verifier_exits(folder_path("stack"), FLIPS, 0));
    int good = agree_on_corruptions(grid, &rule, bed, 300);
    CHECK(good > 0 && good < 300); // both verdicts occur
    sf_grid_destroy(grid);
}

static void every_rule_on_cubes(void)
{
    sf_lattice lattice = stack_lattice(37, 29, 30);
    for (int i = 0; i < VERIFIED_RULES; i++) {
        judge_on(&lattice, i, SF_BED_AUTO);
    }
}

static void a_given_bed(void)
{
    sf_lattice lattice = stack_lattice(30, 31, 20);
    for (int i = 0; i < VERIFIED_RULES; i += 2) {
        judge_on(&lattice, i, 3);
    }
}

static void layers_of_different_heights(void)
{
    double heights[40];
    for (int k = 0; k < 40; k++) {
        heights[k] = 0.1 + 0.15 * test_random_unit();
    }
    sf_lattice lattice = stack_lattice(31, 26, 40);
    lattice.heights_mm = heights;
    for (int i = 0; i < VERIFIED_RULES; i++) {
        judge_on(&lattice, i, SF_BED_AUTO);
    }
}

static void oblong_pixels(void)
{
    sf_lattice lattice = stack_lattice(40, 30, 20);
    lattice.pitch_y_mm = 0.07;
    lattice.layer_mm = 0.13;
    judge_on(&lattice, 0, SF_BED_AUTO);
    judge_on(&lattice, 4, SF_BED_AUTO);
    judge_on(&lattice, 5, SF_BED_AUTO);
}

static void names_a_voxel_that_nothing_carries(void)
{
    static stack s;
    sf_rule rule = sf_rule_box3();
    sf_stack_info info = stack_info(SF_RULE_BOX3, 45.0, SF_BED_AUTO);
    for (int i = 0; i < 12; i++) {
        unsigned x = 0, y = 0, z = 0;
        stack_random_boxes(&s, 21, 17, 12, 6);
        sf_grid *grid = stack_grid(&s);
        CHECK(write_stack(grid, &info, folder_path("stack")));
        int is_free = stack_is_support_free(&s, &rule, SF_BED_AUTO);
        CHECK(verifier_exits(folder_path("stack"), "", is_free ? 0 : 1));
        FILE *said = fopen(folder_path("said"), "r");
        if (!is_free && said != NULL) {
            sf_element e = sf_element_box3();
            CHECK_EQ(fscanf(said, "not support-free: nothing carries x %u, y %u, z %u", &x, &y, &z),
                     3);
            CHECK(stack_get(&s, (int)x, (int)y, (int)z));
            CHECK(!stack_carried(&s, (int)x, (int)y, (int)z, &e));
        }
        if (said != NULL) {
            fclose(said);
        }
        sf_grid_destroy(grid);
    }
}

static void no_such_stack(void)
{
    static stack s;
    CHECK(verifier_exits(folder_path("nothing"), "", 3));
    stack_random(&s, 9, 8, 7, 0.5);
    sf_grid *grid = stack_grid(&s);
    CHECK(write_stack(grid, NULL, folder_path("stack"))); // without a rule
    CHECK(verifier_exits(folder_path("stack"), "", 3));
    sf_stack_info info = stack_info(SF_RULE_BOX3, 45.0, SF_BED_AUTO);
    CHECK(write_stack(grid, &info, folder_path("stack")));
    char picture[1024];
    snprintf(picture, sizeof picture, "%s/layer_00004.png", folder_path("stack"));
    CHECK_EQ(remove(picture), 0);
    CHECK(verifier_exits(folder_path("stack"), "", 3));
    sf_grid_destroy(grid);
}

int main(int argc, char **argv)
{
    verifier = argc > 1 ? argv[1] : "./verify";
    folder_begin("verify-shapes");
    TEST(every_rule_on_cubes);
    TEST(a_given_bed);
    TEST(layers_of_different_heights);
    TEST(oblong_pixels);
    TEST(names_a_voxel_that_nothing_carries);
    TEST(no_such_stack);
    folder_end();
    return test_finish();
}
