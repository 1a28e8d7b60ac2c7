// SPDX-License-Identifier: MIT
// Why: components by runs must be those that a flood fill finds, numbered in the order of their
// first voxel, for both kinds of neighbours; area and bounds likewise. Spirals and combs are where
// a forest without path halving goes quadratic or wrong.

#include "random_slice.h"

enum { SIDE_MAX = 200 };

static uint64_t memory[SIDE_MAX * 4];
static sf_run runs[SIDE_MAX * SIDE_MAX];
static sf_component components[SIDE_MAX * SIDE_MAX];
static uint32_t label[SIDE_MAX][SIDE_MAX], queue[SIDE_MAX * SIDE_MAX];

// Labels 1, 2, ... by breadth-first search; returns how many.
static uint32_t flood(sf_slice slice, int connectivity)
{
    uint32_t count = 0;
    memset(label, 0, sizeof label);
    for (uint32_t start = 0; start < slice.width * slice.height; start++) {
        uint32_t head = 0, tail = 0, sx = start % slice.width, sy = start / slice.width;
        if (!sf_slice_get(slice, sx, sy) || label[sy][sx] != 0) {
            continue;
        }
        label[sy][sx] = ++count;
        queue[tail++] = start;
        while (head < tail) {
            uint32_t x = queue[head] % slice.width, y = queue[head] / slice.width;
            head++;
            for (int d = 0; d < 9; d++) {
                uint32_t u = x + (uint32_t)(d % 3) - 1, v = y + (uint32_t)(d / 3) - 1;
                int corner = d % 3 != 1 && d / 3 != 1;
                if ((corner && connectivity == 4) || !sf_slice_get(slice, u, v) ||
                    label[v][u] != 0) {
                    continue;
                }
                label[v][u] = count;
                queue[tail++] = v * slice.width + u;
            }
        }
    }
    return count;
}

static void compare_measures(sf_slice slice, size_t run_count, uint32_t count)
{
    CHECK_EQ(sf_runs_measure(runs, run_count, components, count), SF_OK);
    for (uint32_t c = 0; c < count; c++) {
        sf_component want = {0, {UINT32_MAX, UINT32_MAX, 0, 0}};
        for (uint32_t y = 0; y < slice.height; y++) {
            for (uint32_t x = 0; x < slice.width; x++) {
                if (label[y][x] == c + 1) {
                    want.area++;
                    want.bounds.x0 = x < want.bounds.x0 ? x : want.bounds.x0;
                    want.bounds.y0 = y < want.bounds.y0 ? y : want.bounds.y0;
                    want.bounds.x1 = x + 1 > want.bounds.x1 ? x + 1 : want.bounds.x1;
                    want.bounds.y1 = y + 1;
                }
            }
        }
        CHECK_EQ(components[c].area, want.area);
        CHECK(memcmp(&components[c].bounds, &want.bounds, sizeof want.bounds) == 0);
    }
    if (count > 0) {
        CHECK_EQ(sf_runs_measure(runs, run_count, components, count - 1), SF_ERR_CAPACITY);
    }
}

static void compare(sf_slice slice, int measure)
{
    size_t run_count = 0;
    CHECK_EQ(sf_slice_runs(slice, runs, SIDE_MAX * SIDE_MAX, &run_count), SF_OK);
    for (int connectivity = 4; connectivity <= 8; connectivity += 4) {
        uint32_t count = 12345, want = flood(slice, connectivity);
        CHECK_EQ(sf_runs_label(runs, run_count, (sf_connectivity)connectivity, &count), SF_OK);
        CHECK_EQ(count, want);
        for (size_t i = 0; i < run_count; i++) {
            CHECK_EQ(runs[i].label + 1, label[runs[i].y][runs[i].x0]);
        }
        if (measure) {
            compare_measures(slice, run_count, count);
        }
    }
}

static void every_four_by_four(void)
{
    for (uint32_t pattern = 0; pattern < 65536; pattern++) {
        sf_slice slice = {memory, 4, 4, 1};
        for (uint32_t y = 0; y < 4; y++) {
            memory[y] = pattern >> 4 * y & 15;
        }
        compare(slice, pattern % 64 == 0);
    }
}

static void random_slices(void)
{
    for (int round = 0; round < 60; round++) {
        sf_slice slice = {memory, 1 + test_random_below(SIDE_MAX), 1 + test_random_below(40), 4};
        random_slice(slice, 1 + test_random_below(6));
        compare(slice, 0);
    }
}

// Combs from above and below, and a spiral: long chains of joins.
static void chains(void)
{
    sf_slice slice = {memory, SIDE_MAX, SIDE_MAX, 4};
    memset(memory, 0, sizeof memory);
    for (uint32_t x = 0; x < SIDE_MAX; x += 2) {
        sf_rect tooth = {x, x % 4 == 0 ? 0u : 2u, x + 1, SIDE_MAX - (x % 4 == 0 ? 2u : 0u)};
        CHECK_EQ(sf_slice_fill(slice, tooth, 1), SF_OK);
    }
    sf_rect floor = {0, 0, SIDE_MAX, 1}, ceiling = {0, SIDE_MAX - 1, SIDE_MAX, SIDE_MAX};
    CHECK_EQ(sf_slice_fill(slice, floor, 1), SF_OK);
    CHECK_EQ(sf_slice_fill(slice, ceiling, 1), SF_OK);
    compare(slice, 1);
    memset(memory, 0, sizeof memory);
    uint32_t low = 0, high = SIDE_MAX;
    for (; low + 4 < high; low += 2, high -= 2) {
        sf_rect all = {low, low, high, high}, inner = {low + 1, low + 1, high - 1, high - 1};
        sf_rect gap = {low, low + 1, low + 1, low + 2};
        CHECK_EQ(sf_slice_fill(slice, all, 1), SF_OK);
        CHECK_EQ(sf_slice_fill(slice, inner, 0), SF_OK);
        CHECK_EQ(sf_slice_fill(slice, gap, 0), SF_OK);
    }
    compare(slice, 1);
}

static void runs_out_of_order_are_refused(void)
{
    sf_run rows[] = {{0, 1, 1, 9}, {0, 1, 0, 9}}, touching[] = {{0, 2, 0, 9}, {2, 3, 0, 9}};
    uint32_t count = 7;
    CHECK_EQ(sf_runs_label(rows, 2, SF_CONNECT_EDGES, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_runs_label(touching, 2, SF_CONNECT_EDGES, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_runs_label(rows, 1, (sf_connectivity)6, &count), SF_ERR_ARGUMENT);
    CHECK_EQ(rows[0].label, 9);
    CHECK_EQ(count, 7);
    CHECK_EQ(sf_runs_label(NULL, 0, SF_CONNECT_EDGES, &count), SF_OK);
    CHECK_EQ(count, 0);
}

// No slice holds them, and the ends of their bounds would wrap.
static void runs_beyond_every_slice_are_refused(void)
{
    const sf_run beyond[] = {{0, 1, UINT32_MAX, 0},
                             {0, 1, SF_EXTENT_MAX, 0},
                             {0, UINT32_MAX, 0, 0},
                             {0, SF_EXTENT_MAX + 1, 0, 0},
                             {3, 3, 0, 0}};
    sf_component component = {7, {1, 2, 3, 4}};
    uint32_t count = 7;
    for (size_t i = 0; i < sizeof beyond / sizeof *beyond; i++) {
        sf_run run = beyond[i];
        run.label = 0;
        CHECK_EQ(sf_runs_measure(&run, 1, &component, 1), SF_ERR_ARGUMENT);
        CHECK_EQ(component.area, 7);
        run.label = 9;
        CHECK_EQ(sf_runs_label(&run, 1, SF_CONNECT_EDGES, &count), SF_ERR_ARGUMENT);
        CHECK(run.label == 9 && count == 7);
    }
    sf_run last = {SF_EXTENT_MAX - 1, SF_EXTENT_MAX, SF_EXTENT_MAX - 1, 0};
    CHECK_EQ(sf_runs_label(&last, 1, SF_CONNECT_CORNERS, &count), SF_OK);
    CHECK_EQ(sf_runs_measure(&last, 1, &component, 1), SF_OK);
    CHECK_EQ(component.bounds.x1, SF_EXTENT_MAX);
    CHECK_EQ(component.bounds.y1, SF_EXTENT_MAX);
}

int main(void)
{
    TEST(every_four_by_four);
    TEST(random_slices);
    TEST(chains);
    TEST(runs_out_of_order_are_refused);
    TEST(runs_beyond_every_slice_are_refused);
    return test_finish();
}
