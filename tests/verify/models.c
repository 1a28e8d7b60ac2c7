// SPDX-License-Identifier: MIT
// Why: the promise to a user is about real parts. Four models, voxelised with 256 voxels along
// their longest side and trimmed under every rule, are written as stacks, and the verifier, which
// shares no line with the library, finds each support-free and judges 1,000 single flipped voxels
// of each as the library's check of the whole grid does. Guards issue 2 (independent verifier). The
// models lie in the folder that SF_DATA names; the twin that always runs is verify shapes.

#include "judge.h"

#include "model.h"

#define RESOLUTION 256
#define FLIPS "--corrupt 1000 --seed 11"

static void judge_under(const sf_grid *shape, int which)
{
    sf_rule_kind kind = verified_rules[which].kind;
    sf_stack_info info = stack_info(kind, verified_rules[which].degrees, SF_BED_AUTO);
    sf_lattice lattice = sf_grid_lattice(shape);
    sf_rule rule;
    sf_grid *grid = NULL;
    CHECK_EQ(sf_rule_make(kind, info.angle_rad, &lattice, NULL, &rule, NULL), SF_OK);
    CHECK_EQ(sf_grid_clone(shape, NULL, &grid), SF_OK);
    CHECK_EQ(sf_grid_trim(grid, &rule, SF_BED_AUTO, NULL, NULL), SF_OK);
    CHECK(sf_grid_popcount(grid) > 0);
    CHECK(write_stack(grid, &info, folder_path("stack")));
    CHECK(verifier_exits(folder_path("stack"), FLIPS, 0));
    int good = agree_on_corruptions(grid, &rule, SF_BED_AUTO, 1000);
    CHECK(good > 50 && good < 950);
    sf_grid_destroy(grid);
}

// The three kinds at 45 degrees.
static void judge_model(const char *name)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    snprintf(models, sizeof models, "%s", getenv("SF_DATA"));
    sf_grid *grid = voxelize(name, RESOLUTION);
    for (int i = 0; grid != NULL && i < VERIFIED_RULES; i += 2) {
        judge_under(grid, i);
    }
    sf_grid_destroy(grid);
}

static void armadillo(void)
{
    judge_model("characters/armadillo.obj");
}

static void bunny(void)
{
    judge_model("characters/stanford-bunny.obj");
}

static void fdm_test(void)
{
    judge_model("parts/ksr_fdmtest_v4.stl");
}

static void frog_legs(void)
{
    judge_model("parts/frog_legs.obj");
}

int main(int argc, char **argv)
{
    verifier = argc > 1 ? argv[1] : "./verify";
    folder_begin("verify-models");
    TEST(armadillo);
    TEST(bunny);
    TEST(fdm_test);
    TEST(frog_legs);
    folder_end();
    return test_finish();
}
