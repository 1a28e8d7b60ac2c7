// SPDX-License-Identifier: MIT
// Why: mass, centre of mass and inertia of a voxel shape are these sums. They must be exact, also
// where 64 bits would not hold them, and the same for any number of threads (TRUST 89).

#include "backwards.h"
#include "random_slice.h"
#include "voxel/wide.h"

#include <sf/voxel.h>

static uint64_t memory[4096];

static void slices_equal_a_naive_sum(void)
{
    for (uint32_t width = 1; width <= 200; width += 1 + width / 64) {
        sf_slice slice = {memory, width, 7, (width + 63) / 64 + 1};
        sf_slice_sums got, want = {0, 0, 0, 0, 0, 0};
        random_slice(slice, test_random_below(9));
        for (uint32_t y = 0; y < slice.height; y++) {
            for (uint32_t x = 0; x < slice.width; x++) {
                uint64_t bit = (uint64_t)sf_slice_get(slice, x, y);
                want.count += bit, want.x += bit * x, want.y += bit * y;
                want.xx += bit * x * x, want.yy += bit * y * y, want.xy += bit * x * y;
            }
        }
        CHECK_EQ(sf_slice_measure(slice, &got), SF_OK);
        CHECK(memcmp(&got, &want, sizeof got) == 0);
    }
}

// The largest slice there is, full: closed forms, and no overflow.
static void the_largest_slice_fits(void)
{
    const uint64_t n = SF_EXTENT_MAX;
    size_t stride = (n + 63) / 64;
    sf_slice slice = {malloc(stride * n * 8), SF_EXTENT_MAX, SF_EXTENT_MAX, stride};
    sf_slice_sums got;
    if (slice.words == NULL) {
        SKIP("no 512 MiB of memory");
    }
    memset(slice.words, 0xff, stride * n * 8);
    CHECK_EQ(sf_slice_measure(slice, &got), SF_OK);
    uint64_t line = n * (n - 1) / 2, squares = (n - 1) * n / 2 * (2 * n - 1) / 3;
    CHECK(got.count == n * n && got.x == n * line && got.y == n * line);
    CHECK(got.xx == n * squares && got.yy == n * squares && got.xy == line * line);
    free(slice.words);
}

static void grids_sum_their_slices(void)
{
    sf_lattice lattice = {70, 9, 150, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    sf_task task = sf_task_default();
    sf_moments got, again;
    uint64_t want[10] = {0};
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 0; k < lattice.nz; k++) {
        sf_slice slice = sf_grid_slice(grid, k);
        for (uint32_t y = 0; y < lattice.ny; y++) {
            for (uint32_t x = 0; x < lattice.nx; x++) {
                uint64_t bit = test_random_below(3) == 0;
                CHECK_EQ(sf_slice_set(slice, x, y, (int)bit), SF_OK);
                const uint64_t term[10] = {1, x, y, k, x * x, y * y, k * k, x * y, x * k, y * k};
                for (int i = 0; i < 10; i++) {
                    want[i] += bit * term[i];
                }
            }
        }
    }
    CHECK_EQ(sf_grid_measure(grid, NULL, &got), SF_OK);
    const sf_wide *wide[9] = {&got.x,  &got.y,  &got.z,  &got.xx, &got.yy,
                              &got.zz, &got.xy, &got.xz, &got.yz};
    CHECK_EQ(got.count, want[0]);
    for (int i = 0; i < 9; i++) {
        CHECK(wide[i]->low == want[i + 1] && wide[i]->high == 0);
    }
    task.parallel_for = backwards;
    CHECK_EQ(sf_grid_measure(grid, &task, &again), SF_OK);
    CHECK(memcmp(&got, &again, sizeof got) == 0);
    sf_task_cancel(&task);
    again.count = 5;
    CHECK_EQ(sf_grid_measure(grid, &task, &again), SF_ERR_CANCELLED);
    CHECK_EQ(again.count, 5);
    sf_grid_destroy(grid);
}

// (2^64 - 1)^2 = 2^128 - 2^65 + 1, and a carry into the high word.
static void wide_sums_carry(void)
{
    sf_wide square = sfi_wide_product(UINT64_MAX, UINT64_MAX);
    CHECK(square.low == 1 && square.high == UINT64_MAX - 1);
    sf_wide sum = {UINT64_MAX, 3}, one = {1, 0};
    sfi_wide_add(&sum, one);
    CHECK(sum.low == 0 && sum.high == 4);
    for (int i = 0; i < 1000; i++) { // by halves: (a1 2^32 + a0) b in two products that fit
        uint64_t a = test_random(), b = test_random() >> 32;
        sf_wide got = sfi_wide_product(a, b), low = {(a & UINT32_MAX) * b, 0};
        uint64_t high = (a >> 32) * b;
        sf_wide shifted = {high << 32, high >> 32};
        sfi_wide_add(&low, shifted);
        CHECK(got.low == low.low && got.high == low.high);
    }
}

int main(void)
{
    TEST(slices_equal_a_naive_sum);
    TEST(the_largest_slice_fits);
    TEST(grids_sum_their_slices);
    TEST(wide_sums_carry);
    return test_finish();
}
