// SPDX-License-Identifier: MIT
// Why: slices are what everything else is made of. Each call is compared with a loop over voxels,
// on memory whose padding is poisoned; what is no slice is refused with nothing written (TRUST 84,
// 85), and results may go into an input but not across one.

#include "voxel/slice.h"
#include "random_slice.h"

#define WORDS 256

static uint64_t memory[3][WORDS], before[WORDS];

static sf_slice random_one(int which, uint32_t width, uint32_t height, size_t stride)
{
    sf_slice slice = {memory[which], width, height, stride};
    random_slice(slice, test_random_below(9));
    return slice;
}

static void a_stride_is_whole_lines(void)
{
    for (uint32_t width = 1; width <= SF_EXTENT_MAX; width += width < 2000 ? 1 : 997) {
        size_t stride = sf_slice_stride(width);
        CHECK(stride % 8 == 0 && 64 * stride >= width && 64 * (stride - 8) < width);
    }
}

static void what_is_no_slice_is_refused(void)
{
    sf_slice good = random_one(0, 70, 5, 3);
    const sf_slice bad[] = {{NULL, 70, 5, 3},
                            {memory[1], 0, 5, 3},
                            {memory[1], 70, 0, 3},
                            {memory[1], SF_EXTENT_MAX + 1, 5, 2000},
                            {memory[1], 70, SF_EXTENT_MAX + 1, 3},
                            {memory[1], 70, 5, 1},
                            {memory[1], 70, 5, SIZE_MAX / 8}};
    sf_slice_sums sums;
    sf_rect all = {0, 0, 1, 1};
    memcpy(before, memory[0], sizeof before);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        CHECK_EQ(sf_slice_set(bad[i], 0, 0, 1), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_slice_fill(bad[i], all, 1), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_slice_copy(bad[i], good), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_slice_copy(good, bad[i]), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_slice_and(good, good, bad[i]), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_slice_measure(bad[i], &sums), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_slice_equal(bad[i], bad[i]), 0);
        CHECK_EQ(sf_slice_popcount(bad[i]), 0);
        CHECK_EQ(sf_slice_bounds(bad[i]).x1, 0);
    }
    sf_slice narrow = {memory[1], 69, 5, 3}, low = {memory[1], 70, 4, 3};
    CHECK_EQ(sf_slice_copy(good, narrow), SF_ERR_SHAPE);
    CHECK_EQ(sf_slice_or(good, good, low), SF_ERR_SHAPE);
    CHECK_EQ(sf_slice_equal(good, narrow), 0);
    CHECK(memcmp(before, memory[0], sizeof before) == 0);
}

static void one_voxel_is_set_and_no_other(void)
{
    for (int round = 0; round < 500; round++) {
        uint32_t width = 1 + test_random_below(130), height = 1 + test_random_below(6);
        sf_slice s = random_one(0, width, height, 4);
        uint32_t x = test_random_below(width), y = test_random_below(height);
        int value = (int)test_random_below(2);
        uint64_t bit = UINT64_C(1) << x % 64, *word = &before[y * 4 + x / 64];
        memcpy(before, memory[0], sizeof before);
        *word = value ? *word | bit : *word & ~bit;
        CHECK_EQ(sf_slice_set(s, x, y, value ? -7 : 0), SF_OK);
        CHECK_EQ(sf_slice_get(s, x, y), value);
        CHECK(memcmp(before, memory[0], sizeof before) == 0);
        CHECK_EQ(sf_slice_set(s, width, y, 1), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_slice_set(s, x, height, 1), SF_ERR_ARGUMENT);
        CHECK_EQ(sf_slice_get(s, width, y), 0);
        CHECK_EQ(sf_slice_get(s, x, height), 0);
    }
}

static void a_rectangle_is_filled_and_no_more(void)
{
    for (int round = 0; round < 2000; round++) {
        uint32_t width = 1 + test_random_below(200), height = 1 + test_random_below(6);
        sf_slice s = random_one(0, width, height, 4);
        sf_rect r = {test_random_below(width + 1), test_random_below(height + 1),
                     test_random_below(width + 2), test_random_below(height + 2)};
        int value = (int)test_random_below(2), good = r.x1 <= width && r.y1 <= height;
        memcpy(before, memory[0], sizeof before);
        sf_slice old = {before, width, height, 4};
        CHECK_EQ(sf_slice_fill(s, r, value), good ? SF_OK : SF_ERR_ARGUMENT);
        for (uint32_t i = 0; i < width * height; i++) {
            uint32_t x = i % width, y = i / width;
            int in = good && r.x0 <= x && x < r.x1 && r.y0 <= y && y < r.y1;
            CHECK_EQ(sf_slice_get(s, x, y), in ? value : sf_slice_get(old, x, y));
        }
    }
}

typedef sf_status (*combination)(sf_slice dst, sf_slice a, sf_slice b);

static sf_status copy(sf_slice dst, sf_slice a, sf_slice b)
{
    (void)b;
    return sf_slice_copy(dst, a);
}

// Result for a and b, as bits 3 (both), 2 (a alone), 1 (b alone), 0 (neither).
static const struct {
    combination call;
    unsigned truth;
} combinations[] = {
    {sf_slice_and, 8}, {sf_slice_or, 14}, {sf_slice_xor, 6}, {sf_slice_subtract, 4}, {copy, 12}};

static void combinations_are_their_truth_tables(void)
{
    static uint64_t first[WORDS], second[WORDS];
    for (int round = 0; round < 1000; round++) {
        uint32_t width = 1 + test_random_below(200), height = 1 + test_random_below(6);
        size_t i = test_random_below(5);
        sf_slice a = random_one(0, width, height, 4), b = random_one(1, width, height, 5);
        sf_slice dst = round % 3 == 0 ? a : round % 3 == 1 ? b : random_one(2, width, height, 6);
        memcpy(first, memory[0], sizeof first);
        memcpy(second, memory[1], sizeof second);
        sf_slice p = {first, width, height, 4}, q = {second, width, height, 5};
        CHECK_EQ(combinations[i].call(dst, a, b), SF_OK);
        for (uint32_t v = 0; v < width * height; v++) {
            uint32_t x = v % width, y = v / width;
            unsigned row = 2 * (unsigned)sf_slice_get(p, x, y) + (unsigned)sf_slice_get(q, x, y);
            CHECK_EQ(sf_slice_get(dst, x, y), combinations[i].truth >> row & 1);
        }
        for (uint32_t y = 0; y < height; y++) { // padding
            CHECK((dst.words[y * dst.stride + (width - 1) / 64] & ~sfi_tail_mask(width)) == 0);
        }
    }
}

static void results_across_an_input_are_refused(void)
{
    sf_slice a = random_one(0, 100, 4, 3), b = random_one(1, 100, 4, 3);
    sf_slice shifted = {memory[0] + 1, 100, 4, 3}, wider = {memory[0], 100, 4, 4};
    memcpy(before, memory[0], sizeof before);
    for (size_t i = 0; i < 5; i++) {
        CHECK_EQ(combinations[i].call(shifted, a, a), SF_ERR_ARGUMENT);
        CHECK_EQ(combinations[i].call(wider, a, a), SF_ERR_ARGUMENT);
    }
    CHECK_EQ(sf_slice_or(shifted, b, a), SF_ERR_ARGUMENT);
    CHECK(memcmp(before, memory[0], sizeof before) == 0);
    // Rows after the last of the other slice are apart.
    sf_slice after = {memory[0] + 3 * 3 + 2, 100, 4, 3};
    CHECK_EQ(sf_slice_copy(after, a), SF_OK);
    CHECK(sf_slice_equal(after, a));
}

static void counts_and_bounds_are_those_of_the_voxels(void)
{
    for (int round = 0; round < 1000; round++) {
        uint32_t width = 1 + test_random_below(200), height = 1 + test_random_below(6);
        sf_slice s = random_one(0, width, height, 4), t = random_one(1, width, height, 5);
        sf_rect r = {UINT32_MAX, UINT32_MAX, 0, 0}, none = {0, 0, 0, 0};
        uint64_t count = 0;
        if (round % 2 == 0) { // few voxels
            CHECK_EQ(sf_slice_xor(s, s, s), SF_OK);
            CHECK_EQ(sf_slice_set(s, test_random_below(width), test_random_below(height), 1),
                     SF_OK);
        }
        for (uint32_t v = 0; v < width * height; v++) {
            uint32_t x = v % width, y = v / width;
            if (sf_slice_get(s, x, y)) {
                count++;
                r.x0 = x < r.x0 ? x : r.x0;
                r.y0 = y < r.y0 ? y : r.y0;
                r.x1 = x >= r.x1 ? x + 1 : r.x1;
                r.y1 = y + 1;
            }
            CHECK_EQ(sf_slice_set(t, x, y, sf_slice_get(s, x, y)), SF_OK);
        }
        sf_rect bounds = sf_slice_bounds(s);
        r = count > 0 ? r : none;
        CHECK_EQ(sf_slice_popcount(s), count);
        CHECK(memcmp(&bounds, &r, sizeof r) == 0);
        CHECK_EQ(sf_slice_equal(s, t), 1);
        uint32_t x = test_random_below(width), y = test_random_below(height);
        CHECK_EQ(sf_slice_set(t, x, y, !sf_slice_get(t, x, y)), SF_OK);
        CHECK_EQ(sf_slice_equal(s, t), 0);
    }
}

int main(void)
{
    TEST(a_stride_is_whole_lines);
    TEST(what_is_no_slice_is_refused);
    TEST(one_voxel_is_set_and_no_other);
    TEST(a_rectangle_is_filled_and_no_more);
    TEST(combinations_are_their_truth_tables);
    TEST(results_across_an_input_are_refused);
    TEST(counts_and_bounds_are_those_of_the_voxels);
    return test_finish();
}
