// SPDX-License-Identifier: MIT
// Why: bounds of components, grids and edits are all made by these few lines; they must be the
// smallest rectangle or box around every voxel of the parts, for every pair of small ones, empty or
// not.

#include "voxel/rect.h"
#include "test.h"

#define SIDE 4

static int in_rect(sf_rect r, uint32_t x, uint32_t y)
{
    return r.x0 <= x && x < r.x1 && r.y0 <= y && y < r.y1;
}

static sf_rect nth(uint32_t i)
{
    sf_rect r = {i % SIDE, i / SIDE % SIDE, i / SIDE / SIDE % (SIDE + 1),
                 i / SIDE / SIDE / (SIDE + 1)};
    return r;
}

#define RECTS (SIDE * SIDE * (SIDE + 1) * (SIDE + 1))

// The smallest rectangle around what is in a or in b, voxel by voxel; all zero around nothing.
static sf_rect around(sf_rect a, sf_rect b)
{
    sf_rect r = {0, 0, 0, 0};
    for (uint32_t y = 0; y < SIDE; y++) {
        for (uint32_t x = 0; x < SIDE; x++) {
            if (in_rect(a, x, y) || in_rect(b, x, y)) {
                int first = r.x1 == 0;
                r.x0 = first || x < r.x0 ? x : r.x0;
                r.y0 = first ? y : r.y0;
                r.x1 = first || x >= r.x1 ? x + 1 : r.x1;
                r.y1 = y + 1;
            }
        }
    }
    return r;
}

static int same(sf_rect a, sf_rect b)
{
    return (sfi_rect_is_empty(a) && sfi_rect_is_empty(b)) || memcmp(&a, &b, sizeof a) == 0;
}

static void a_union_is_the_smallest(void)
{
    for (uint32_t i = 0; i < RECTS; i++) {
        for (uint32_t j = 0; j < RECTS; j++) {
            sf_rect a = nth(i), b = nth(j), both = around(a, b);
            CHECK(same(sfi_rect_union(a, b), both));
            sf_box box = {a.x0, a.y0, 5, a.x1, a.y1, 7}, grown = sfi_box_union(box, b, j % 3 + 4);
            sf_rect flat = {grown.x0, grown.y0, grown.x1, grown.y1};
            CHECK(sfi_box_is_empty(grown) == sfi_rect_is_empty(both) && same(flat, both));
            int old = !sfi_rect_is_empty(a), new = !sfi_rect_is_empty(b);
            if (old || new) {
                CHECK_EQ(grown.z0, old && (!new || j % 3 > 0) ? 5 : j % 3 + 4);
                CHECK_EQ(grown.z1, old ? 7 : j % 3 + 5);
            }
        }
    }
}

static void growth_is_clipped(void)
{
    sf_slice slice = {NULL, SIDE, SIDE, 1};
    for (uint32_t i = 0; i < RECTS; i++) {
        for (uint32_t reach = 0; reach < 16; reach++) {
            sf_rect r = nth(i), grown = sfi_rect_grow(r, reach % 4, reach / 4, slice);
            for (uint32_t at = 0; at < SIDE * SIDE && !sfi_rect_is_empty(r); at++) {
                uint32_t x = at % SIDE, y = at / SIDE;
                int near = x + reach % 4 >= r.x0 && x < r.x1 + reach % 4 && y + reach / 4 >= r.y0 &&
                           y < r.y1 + reach / 4;
                CHECK_EQ(in_rect(grown, x, y), near);
            }
            CHECK(sfi_rect_is_empty(r) ? sfi_rect_is_empty(grown)
                                       : grown.x1 <= SIDE && grown.y1 <= SIDE);
        }
    }
}

int main(void)
{
    TEST(a_union_is_the_smallest);
    TEST(growth_is_clipped);
    return test_finish();
}
