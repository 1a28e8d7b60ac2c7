// SPDX-License-Identifier: MIT
// TRUST item 73, one layer: a shape is support-free under a disk of reach r just when no voxel is
// farther than r from the closest one below it. The largest such distance is found pixel by pixel;
// at the least reach that rounds to no less the check must say yes, and at 2^-16 voxel less no.
// All stacks of 3x2x2 and 10^5 random ones. What is asked over many layers is in
// ../unit/support/steepest.c.

#include "alive.h"

// The largest squared distance of a voxel above layer 0 from the layer below it; -1 where some
// voxel has nothing below it at all.
static int farthest(const stack *s)
{
    int most = 0, area = s->nx * s->ny;
    for (int v = area; v < stack_count(s); v++) {
        int least = -1, below = v / area * area - area;
        for (int u = below; s->solid[v] && u < below + area; u++) {
            int dx = u % s->nx - v % s->nx, dy = u % area / s->nx - v % area / s->nx;
            int d = dx * dx + dy * dy;
            least = s->solid[u] && (least < 0 || d < least) ? d : least;
        }
        if (s->solid[v] && least < 0) {
            return -1;
        }
        most = least > most ? least : most;
    }
    return most;
}

// The least reach in 2^-16 voxel whose square is no less.
static uint64_t reach_of(int square)
{
    uint64_t reach = (uint64_t)(sqrt(square) * 65536.0);
    while (reach * reach < (uint64_t)square << 32) {
        reach++;
    }
    while (reach > 0 && (reach - 1) * (reach - 1) >= (uint64_t)square << 32) {
        reach--;
    }
    return reach;
}

static int is_free(const sf_grid *grid, uint64_t reach)
{
    sf_check_options o = sf_check_options_default();
    sf_check_report report = {0};
    sf_rule rule = {.kind = SF_RULE_DISK, .reach_x_q24 = reach << 8, .reach_y_q24 = reach << 8};
    o.rule = rule;
    o.bed_layer = 0;
    CHECK_EQ(sf_grid_check(grid, &o, stack_allocator(), NULL, &report, NULL), SF_OK);
    return report.support_free;
}

static void check_stack(const stack *s, sf_grid *grid)
{
    int most = farthest(s);
    stack_put(s, grid);
    if (most < 0) {
        CHECK(!is_free(grid, (uint64_t)40 << 16));
        return;
    }
    uint64_t reach = reach_of(most);
    CHECK(is_free(grid, reach));
    CHECK(reach == 0 || !is_free(grid, reach - 1));
}

static void all_small(void)
{
    static stack s;
    stack_clear(&s, 3, 2, 2);
    sf_grid *grid = stack_grid(&s);
    for (uint32_t bits = 0; bits < 1u << 12; bits++) {
        for (int i = 0; i < 12; i++) {
            s.solid[i] = bits >> i & 1;
        }
        check_stack(&s, grid);
    }
    sf_grid_destroy(grid);
}

static void random_ones(void)
{
    static stack s;
    for (int i = 0; i < 1000; i++) {
        int nx = 1 + (int)test_random_below(9), ny = 1 + (int)test_random_below(7);
        int nz = 2 + (int)test_random_below(3);
        stack_clear(&s, nx, ny, nz);
        sf_grid *grid = stack_grid(&s);
        for (int j = 0; j < 100; j++) {
            stack_random(&s, nx, ny, nz, 0.05 + 0.6 * test_random_unit());
            check_stack(&s, grid);
        }
        sf_grid_destroy(grid);
    }
}

int main(void)
{
    TEST(all_small);
    TEST(random_ones);
    return test_finish();
}
