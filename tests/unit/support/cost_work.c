// SPDX-License-Identifier: MIT
// Why: @cost of sf_findings_cost() says that a finding costs its region and what stands below it,
// not the rectangle around it. Seams of a voxelised slope are regions of this kind: one voxel wide,
// across the whole layer. Lines along the rows, whose rectangles are the regions themselves, are
// timed beside as many diagonals as long; when places were looked for in rectangles, diagonals took
// fourteen times as long.

#include "law/stack.h"

#include <sf/finding.h>

#include <time.h>

enum { SIDE = 384, LAYERS = 5, LINES = 48, RUNS = 3, TIMES_AS_LONG = 6 };

// Lines in the air, eight voxels apart, `slope` rows down a column.
static sf_grid *lines(int slope)
{
    sf_lattice lattice = stack_lattice(SIDE, SIDE + 8 * LINES, LAYERS);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, 0), 0, 0, 1), SF_OK);
    for (uint32_t i = 0; i < LINES * SIDE; i++) {
        uint32_t x = i % SIDE, y = 8 * (i / SIDE) + x * (uint32_t)slope;
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, LAYERS - 1), x, y, 1), SF_OK);
    }
    return grid;
}

static double least_seconds(const sf_grid *grid, uint64_t *sum)
{
    static sf_finding findings[LINES];
    static sf_finding_cost costs[LINES];
    sf_terms terms = sf_terms_default();
    sf_check_options options = sf_check_options_default();
    sf_check_report report;
    size_t count;
    options.rule = terms.rule;
    options.findings = findings;
    options.finding_capacity = LINES;
    CHECK_EQ(sf_grid_check(grid, &options, NULL, NULL, &report, &count), SF_OK);
    CHECK_EQ(count, LINES);
    double least = 1e9;
    for (int i = 0; i < RUNS; i++) {
        clock_t begun = clock();
        CHECK_EQ(sf_findings_cost(grid, &terms, findings, count, NULL, NULL, costs, NULL), SF_OK);
        double seconds = (double)(clock() - begun) / CLOCKS_PER_SEC;
        least = seconds < least ? seconds : least;
    }
    *sum = 0;
    for (size_t i = 0; i < count; i++) {
        *sum += costs[i].grow_voxels;
    }
    return least;
}

static void diagonals(void)
{
    uint64_t along_sum, across_sum;
    sf_grid *along = lines(0), *across = lines(1);
    double straight = least_seconds(along, &along_sum),
           diagonal = least_seconds(across, &across_sum);
    printf("# along rows %.4f s, %llu voxels; diagonal %.4f s, %llu voxels\n", straight,
           (unsigned long long)along_sum, diagonal, (unsigned long long)across_sum);
    CHECK(diagonal < TIMES_AS_LONG * straight);
    // A third of the voxels is the least that carries a line, whichever way it goes.
    CHECK(along_sum >= LINES * SIDE / 3 && across_sum >= LINES * SIDE / 3);
    sf_grid_destroy(along);
    sf_grid_destroy(across);
}

int main(void)
{
    TEST(diagonals);
    return test_finish();
}
