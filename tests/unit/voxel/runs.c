// SPDX-License-Identifier: MIT
// Why: runs and bits must say the same, for every pattern of a small slice and for widths on both
// sides of a word's border, whatever stands in the padding; a buffer that is too small is refused
// with the need and stays untouched (TRUST 31, 85, 87).

#include "random_slice.h"

static uint64_t memory[2][4096];
static sf_run runs[8192];

// Bits -> runs -> bits, and the runs are those that a bit-at-a-time scan finds.
static void round_trip(sf_slice slice)
{
    size_t count = 0, need = 0, at = 0;
    CHECK_EQ(sf_slice_run_count(slice, &need), SF_OK);
    CHECK_EQ(sf_slice_runs(slice, runs, need, &count), SF_OK);
    CHECK_EQ(count, need);
    for (uint32_t y = 0; y < slice.height; y++) {
        for (uint32_t x = 0; x < slice.width; x++) {
            int begins = sf_slice_get(slice, x, y) && (x == 0 || !sf_slice_get(slice, x - 1, y));
            if (begins) {
                uint32_t end = x;
                while (sf_slice_get(slice, end, y)) { // outside counts as empty
                    end++;
                }
                CHECK(at < count && runs[at].x0 == x && runs[at].x1 == end && runs[at].y == y &&
                      runs[at].label == 0);
                at++;
            }
        }
    }
    CHECK_EQ(at, count);
    sf_slice back = {memory[1], slice.width, slice.height, slice.stride};
    memset(memory[1], 0xa5, sizeof memory[1]);
    CHECK_EQ(sf_slice_from_runs(back, runs, count), SF_OK);
    CHECK(sf_slice_equal(back, slice));
    if (need > 0) {
        runs[0].x0 = 77777;
        CHECK_EQ(sf_slice_runs(slice, runs, need - 1, &count), SF_ERR_CAPACITY);
        CHECK_EQ(count, need);
        CHECK_EQ(runs[0].x0, 77777);
    }
}

static void every_four_by_four(void)
{
    for (uint32_t pattern = 0; pattern < 65536; pattern++) {
        sf_slice slice = {memory[0], 4, 4, 1};
        for (uint32_t y = 0; y < 4; y++) {
            memory[0][y] = (pattern >> 4 * y & 15) | ~UINT64_C(15); // poisoned padding
        }
        round_trip(slice);
    }
}

static void widths_around_words(void)
{
    for (uint32_t width = 1; width <= 257; width++) {
        for (uint32_t of_eight = 0; of_eight <= 8; of_eight += 2) {
            sf_slice slice = {memory[0], width, 5, (width + 63) / 64 + width % 3};
            random_slice(slice, of_eight);
            round_trip(slice);
        }
    }
}

static void nonsense_is_refused(void)
{
    sf_slice slice = {memory[0], 10, 10, 1};
    sf_run outside[] = {{2, 11, 0, 0}}, empty[] = {{3, 3, 0, 0}}, low[] = {{3, 4, 10, 0}};
    memset(memory[0], 0, sizeof memory[0]);
    CHECK_EQ(sf_slice_set(slice, 4, 4, 1), SF_OK);
    CHECK_EQ(sf_slice_from_runs(slice, outside, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_from_runs(slice, empty, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_from_runs(slice, low, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_from_runs(slice, NULL, 1), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_popcount(slice), 1);
    CHECK_EQ(sf_slice_run_count(slice, NULL), SF_ERR_ARGUMENT);
}

int main(void)
{
    TEST(every_four_by_four);
    TEST(widths_around_words);
    TEST(nonsense_is_refused);
    return test_finish();
}
