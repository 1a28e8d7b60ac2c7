// SPDX-License-Identifier: MIT
// Why: struts of a least width are squares that must lie in the solid. Corners and fillings of
// squares are held, for all widths, against their definitions, a voxel at a time; padding is zero
// afterwards.

#include "voxel/square.h"
#include "random_slice.h"
#include "simd/kernels.h"

#define MAX_WORDS 4096

static uint64_t memory[3][MAX_WORDS];

static int all_of(sf_slice s, uint32_t x, uint32_t y, uint32_t width)
{
    for (uint32_t i = 0; i < width * width; i++) {
        if (!sf_slice_get(s, x + i % width, y + i / width)) {
            return 0;
        }
    }
    return 1;
}

static int any_corner(sf_slice s, uint32_t x, uint32_t y, uint32_t width)
{
    for (uint32_t i = 0; i < width * width; i++) {
        uint32_t dx = i % width, dy = i / width;
        if (x >= dx && y >= dy && sf_slice_get(s, x - dx, y - dy)) {
            return 1;
        }
    }
    return 0;
}

static void one_size(uint32_t width, uint32_t height, uint32_t square, uint32_t percent)
{
    size_t stride = (width + 63) / 64 + test_random_below(2);
    sf_slice s = {memory[0], width, height, stride}, corners = {memory[1], width, height, stride},
             full = {memory[2], width, height, stride};
    memset(memory, 0, sizeof memory);
    for (uint32_t i = 0; i < width * height; i++) {
        CHECK_EQ(sf_slice_set(s, i % width, i / width, test_random_below(100) < percent), SF_OK);
    }
    CHECK_EQ(sf_slice_copy(corners, s), SF_OK);
    CHECK_EQ(sf_slice_copy(full, s), SF_OK);
    sfi_square_corners(corners, square);
    sfi_square_fill(full, square);
    int good = 1;
    for (uint32_t i = 0; i < width * height; i++) {
        uint32_t x = i % width, y = i / width;
        good &= sf_slice_get(corners, x, y) == all_of(s, x, y, square);
        good &= sf_slice_get(full, x, y) == any_corner(s, x, y, square);
    }
    for (uint32_t y = 0; y < height; y++) {
        size_t last = y * stride + (width - 1) / 64;
        good &= ((corners.words[last] | full.words[last]) & ~sfi_tail_mask(width)) == 0;
    }
    CHECK(good);
}

static void squares_are_what_they_are_called(void)
{
    static const uint32_t widths[] = {1, 2, 3, 5, 31, 63, 64, 65, 127, 128, 129, 200};
    for (size_t i = 0; i < sizeof widths / sizeof widths[0]; i++) {
        for (uint32_t square = 1; square < 8; square++) {
            one_size(widths[i], 1 + test_random_below(9), square, square < 3 ? 70 : 97);
        }
        one_size(widths[i], 3, 70 + test_random_below(90), 100);
    }
}

int main(void)
{
    TEST(squares_are_what_they_are_called);
    return test_finish();
}
