// SPDX-License-Identifier: MIT
// Why: vertices are put in this order and results must be put back. It must be an order, name every
// point once, and bring the neighbours of a fine mesh together: on average many times closer than a
// random order does.

#include "mesh/morton.h"
#include "base/memory.h"
#include "failing_allocator.h"
#include "test.h"

static void every_point_once(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    for (size_t count = 0; count < 300; count += 1 + count / 3) {
        double points[900];
        uint32_t order[300], seen[300] = {0};
        for (size_t i = 0; i < 3 * count; i++) {
            points[i] = i % 3 == 2 ? 7 : 1e6 * (test_random_unit() - 0.5);
        }
        CHECK_EQ(sfi_morton_order(points, count, &allocator, order), SF_OK);
        for (size_t i = 0; i < count; i++) {
            CHECK(order[i] < count);
            seen[order[i] % 300]++;
        }
        for (size_t i = 0; i < count; i++) {
            CHECK_EQ(seen[i], 1);
        }
    }
}

static void equal_places_keep_their_order(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    double points[30] = {0};
    uint32_t order[10];
    CHECK_EQ(sfi_morton_order(points, 10, &allocator, order), SF_OK);
    for (uint32_t i = 0; i < 10; i++) {
        CHECK_EQ(order[i], i);
    }
}

// The eight octants of a cube come one after the other, x fastest.
static void octants_follow_each_other(void)
{
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    double points[24];
    uint32_t order[8];
    for (unsigned i = 0; i < 8; i++) {
        unsigned octant = 7 - i;
        points[3 * i] = octant & 1;
        points[3 * i + 1] = octant >> 1 & 1;
        points[3 * i + 2] = octant >> 2;
    }
    CHECK_EQ(sfi_morton_order(points, 8, &allocator, order), SF_OK);
    for (uint32_t i = 0; i < 8; i++) {
        CHECK_EQ(order[i], 7 - i);
    }
}

static void neighbours_are_near(void)
{
    enum { SIDE = 32, COUNT = SIDE * SIDE * SIDE };
    static double points[3 * COUNT];
    static uint32_t order[COUNT], place[COUNT];
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    for (int i = 0; i < COUNT; i++) {
        points[3 * i] = i % SIDE;
        points[3 * i + 1] = i / SIDE % SIDE;
        points[3 * i + 2] = i / SIDE / SIDE;
    }
    CHECK_EQ(sfi_morton_order(points, COUNT, &allocator, order), SF_OK);
    for (uint32_t i = 0; i < COUNT; i++) {
        place[order[i]] = i;
    }
    double far = 0;
    for (int i = 0; i + SIDE * SIDE < COUNT; i++) {
        far += fabs((double)place[i] - place[i + SIDE * SIDE]);
    }
    CHECK(far / COUNT < COUNT / 3.0 / 8); // at random they are a third of all apart
}

static void memory_may_fail(void)
{
    double points[3] = {1, 2, 3};
    uint32_t order[1];
    for (long k = 0; k < 2; k++) {
        failing_allocator failing;
        failing_begin(&failing, k);
        CHECK_EQ(sfi_morton_order(points, 1, &failing.allocator, order), SF_ERR_MEMORY);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
}

int main(void)
{
    TEST(every_point_once);
    TEST(equal_places_keep_their_order);
    TEST(octants_follow_each_other);
    TEST(neighbours_are_near);
    TEST(memory_may_fail);
    return test_finish();
}
