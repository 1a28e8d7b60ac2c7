// SPDX-License-Identifier: MIT
// Why: @cost of sf_grid_preserve() says that a voxel is tried in the time of what its loss changes.
// When each trial went up to the ceiling that it failed to carry, hollowing a ball took twenty
// times as long as completing alone, forty with bridges, and more in a finer lattice. Times are
// compared within one run, the best of three each, and the bounds are wide: 1.3 and 5 are usual.

#include "test.h"

#include <sf/preserve.h>

#include <time.h>

enum { SIDE = 96, RUNS = 3 };

// A ball is to be hollowed: what is left of it is the shape's skin and struts.
static void fill(sf_grid *grid, double radius)
{
    for (int i = 0; i < SIDE * SIDE * SIDE; i++) {
        double x = i % SIDE - 47.5, y = i / SIDE % SIDE - 47.5, z = i / (SIDE * SIDE) - 47.5;
        if (x * x + y * y + z * z < radius * radius) {
            CHECK_EQ(sf_slice_set(sf_grid_slice(grid, (uint32_t)(i / (SIDE * SIDE))),
                                  (uint32_t)(i % SIDE), (uint32_t)(i / SIDE % SIDE), 1),
                     SF_OK);
        }
    }
}

static double least_seconds(const sf_grid *shape, const sf_grid *brush, const sf_terms *terms,
                            sf_preserve_mode mode, uint64_t *kept)
{
    double least = 1e9;
    for (int i = 0; i < RUNS; i++) {
        sf_grid *grid;
        sf_preserve_report report;
        sf_preserve_options options = sf_preserve_options_default();
        options.mode = mode;
        CHECK_EQ(sf_grid_clone(shape, NULL, &grid), SF_OK);
        clock_t begun = clock();
        CHECK_EQ(sf_grid_preserve(grid, brush, terms, &options, NULL, NULL, &report), SF_OK);
        double seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
        least = seconds < least ? seconds : least;
        *kept = report.kept_voxels;
        sf_grid_destroy(grid);
    }
    return least;
}

// `bridge`: the longest bridge, in voxels; `times`: how much longer irredundant may take.
static void hollow(double bridge, double times)
{
    sf_lattice lattice = {SIDE, SIDE, SIDE, 1.0, 1.0, 1.0, NULL, {0, 0, 0}};
    sf_grid *shape, *brush;
    sf_terms terms = sf_terms_default();
    uint64_t few, least;
    CHECK_EQ(sf_rule_make(SF_RULE_SLACK, 0.78539816339744831, &lattice, NULL, &terms.rule, NULL),
             SF_OK);
    CHECK_EQ(sf_rule_set_bridges(&terms.rule, bridge, 1.0, &lattice, NULL), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &shape), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &brush), SF_OK);
    fill(shape, 47);
    fill(brush, 43);
    CHECK_EQ(sf_grid_trim(shape, &terms.rule, SF_BED_AUTO, NULL, NULL), SF_OK);
    double greedy = least_seconds(shape, brush, &terms, SF_PRESERVE_FAST, &few);
    double exact = least_seconds(shape, brush, &terms, SF_PRESERVE_IRREDUNDANT, &least);
    printf("# bridges of %g voxels: complete %.3f s, irredundant %.3f s; %llu and %llu voxels\n",
           bridge, greedy, exact, (unsigned long long)few, (unsigned long long)least);
    CHECK(exact < times * greedy);
    CHECK(least < few && least > 1000); // there was something to try
    sf_grid_destroy(shape);
    sf_grid_destroy(brush);
}

static void under_slack(void)
{
    hollow(0.0, 8);
}

static void under_slack_with_bridges(void)
{
    hollow(3.0, 16);
}

int main(void)
{
    TEST(under_slack);
    TEST(under_slack_with_bridges);
    return test_finish();
}
