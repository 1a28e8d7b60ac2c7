// SPDX-License-Identifier: MIT
// Why: dilation and erosion by any element, with either border, must be what the definition says,
// and erosion must be the dual and the adjoint of dilation (TRUST 32); padding is zero afterwards
// and without influence before (TRUST 31); aliases that would go wrong are refused (TRUST 84).

#include "random_slice.h"
#include "simd/kernels.h"

#define MAX_WORDS 4096

static uint64_t memory[4][MAX_WORDS];

static sf_slice make(int which, uint32_t width, uint32_t height, size_t stride)
{
    sf_slice slice = {memory[which], width, height, stride};
    return slice;
}

static int at(sf_slice slice, long x, long y, int outside)
{
    if (x < 0 || y < 0 || x >= (long)slice.width || y >= (long)slice.height) {
        return outside;
    }
    return sf_slice_get(slice, (uint32_t)x, (uint32_t)y);
}

static int naive(sf_slice src, const sf_element *e, uint32_t px, uint32_t py, int outside,
                 int erode)
{
    long x = (long)px, y = (long)py;
    for (long dy = -(long)e->reach_y; dy <= (long)e->reach_y; dy++) {
        long w = e->half_width[dy < 0 ? -dy : dy];
        for (long dx = -w; dx <= w; dx++) {
            if (at(src, x + dx, y + dy, outside) != erode) {
                return !erode;
            }
        }
    }
    return erode;
}

static sf_element random_element(unsigned most)
{
    sf_element e = {(uint16_t)test_random_below(most + 1), {(uint16_t)test_random_below(most + 1)}};
    for (unsigned dy = 1; dy <= e.reach_y; dy++) {
        e.half_width[dy] = (uint16_t)test_random_below(e.half_width[dy - 1] + 1u);
    }
    return e;
}

static void padding_is_zero(sf_slice s)
{
    for (uint32_t y = 0; y < s.height; y++) {
        CHECK((s.words[y * s.stride + (s.width - 1) / 64] & ~sfi_tail_mask(s.width)) == 0);
    }
}

static void one_size(uint32_t width, uint32_t height, sf_element e, uint32_t density)
{
    size_t stride = (width + 63) / 64 + test_random_below(2);
    sf_slice src = make(0, width, height, stride), dst = make(1, width, height, stride);
    random_slice(src, density);
    for (int border = 0; border < 2; border++) {
        for (int erode = 0; erode < 2; erode++) {
            CHECK_EQ((erode ? sf_slice_erode : sf_slice_dilate)(dst, src, &e, (sf_border)border),
                     SF_OK);
            padding_is_zero(dst);
            for (uint32_t y = 0; y < height; y++) {
                for (uint32_t x = 0; x < width; x++) {
                    CHECK_EQ(sf_slice_get(dst, x, y), naive(src, &e, x, y, border, erode));
                }
            }
        }
    }
}

static void equals_the_definition(void)
{
    for (uint32_t width = 1; width <= 140; width++) {
        one_size(width, 1 + test_random_below(7), random_element(5), test_random_below(9));
    }
    one_size(300, 9, random_element(70), 1);
    one_size(4200, 2, random_element(3), 1); // more than one block of columns
    sf_element widest = {SF_REACH_MAX, {0}};
    for (unsigned dy = 0; dy <= SF_REACH_MAX; dy++) {
        widest.half_width[dy] = SF_REACH_MAX;
    }
    one_size(4300, 1, widest, 0);
    sf_slice lone = make(0, 600, 1, 10), grown = make(1, 600, 1, 10);
    memset(memory[0], 0, sizeof memory[0]);
    CHECK_EQ(sf_slice_set(lone, 300, 0, 1), SF_OK);
    CHECK_EQ(sf_slice_dilate(grown, lone, &widest, SF_BORDER_EMPTY), SF_OK);
    sf_rect bounds = sf_slice_bounds(grown);
    CHECK_EQ(bounds.x0, 45);
    CHECK_EQ(bounds.x1, 556);
    CHECK_EQ(sf_slice_popcount(grown), 511);
}

static void equals_the_definition_on_every_instruction_set(void)
{
    for (int isa = 0; isa < SF_ISA_COUNT; isa++) {
        sf_isa_limit((sf_isa)isa);
        for (uint32_t width = 60; width <= 70; width++) {
            one_size(width, 5, random_element(4), 2);
        }
    }
    sf_isa_limit(SF_ISA_COUNT);
}

// delta(X) within Y if and only if X within epsilon(Y), where erosion takes outside for matter.
static void erosion_is_adjoint_to_dilation(void)
{
    for (int round = 0; round < 300; round++) {
        uint32_t width = 1 + test_random_below(70), height = 1 + test_random_below(6);
        sf_element e = random_element(2);
        sf_slice x = make(0, width, height, 2), y = make(1, width, height, 2);
        sf_slice grown = make(2, width, height, 2), shrunk = make(3, width, height, 2);
        random_slice(x, 1);
        CHECK_EQ(sf_slice_dilate(grown, x, &e, SF_BORDER_EMPTY), SF_OK);
        random_slice(y, 7);
        if (round % 2 == 0) {
            CHECK_EQ(sf_slice_or(y, y, grown), SF_OK); // make the left side true half of the time
        }
        CHECK_EQ(sf_slice_erode(shrunk, y, &e, SF_BORDER_SOLID), SF_OK);
        CHECK_EQ(sf_slice_subtract(grown, grown, y), SF_OK);
        int left = sf_slice_popcount(grown) == 0;
        CHECK_EQ(sf_slice_subtract(shrunk, x, shrunk), SF_OK);
        CHECK_EQ(left, sf_slice_popcount(shrunk) == 0);
    }
}

static void and_dilate_is_dilate_then_and(void)
{
    for (int round = 0; round < 400; round++) {
        uint32_t width = 1 + test_random_below(300), height = 1 + test_random_below(5);
        size_t stride = (width + 63) / 64;
        sf_element e = round % 3 == 0   ? sf_element_box3()
                       : round % 3 == 1 ? sf_element_plus3()
                                        : random_element(6);
        sf_slice src = make(0, width, height, stride), below = make(1, width, height, stride);
        sf_slice got = make(2, width, height, stride), want = make(3, width, height, stride);
        random_slice(src, 4);
        random_slice(below, 1);
        CHECK_EQ(sf_slice_and_dilate(got, src, below, &e), SF_OK);
        CHECK_EQ(sf_slice_dilate(want, below, &e, SF_BORDER_EMPTY), SF_OK);
        CHECK_EQ(sf_slice_and(want, want, src), SF_OK);
        CHECK(sf_slice_equal(got, want));
        padding_is_zero(got);
        CHECK_EQ(sf_slice_and_dilate(src, src, below, &e), SF_OK);
        CHECK(sf_slice_equal(src, want));
    }
}

static void elements_are_what_they_say(void)
{
    for (uint64_t rx = 0; rx < 9 << 16; rx += 17001) {
        for (uint64_t ry = 0; ry < 9 << 16; ry += 23003) {
            sf_element e;
            CHECK_EQ(sf_element_ellipse(rx, ry, &e), SF_OK);
            double a = (double)rx / 65536, b = (double)ry / 65536;
            CHECK_EQ(e.reach_y, (int)b);
            for (int dy = 0; dy <= e.reach_y; dy++) {
                for (int dx = 0; dx < 10; dx++) {
                    int inside = dx * dx * b * b + dy * dy * a * a <= a * a * b * b && dx <= a;
                    CHECK_EQ(dx <= e.half_width[dy], inside);
                }
            }
        }
    }
    sf_element three;
    CHECK_EQ(sf_element_ellipse(3 << 16, 3 << 16, &three), SF_OK);
    int size = 0;
    for (int dy = -3; dy <= 3; dy++) {
        size += 2 * three.half_width[dy < 0 ? -dy : dy] + 1;
    }
    CHECK_EQ(size, 29); // lattice points within distance 3 (TRUST 20)
}

static void sums_dilate_like_one_after_the_other(void)
{
    for (int round = 0; round < 200; round++) {
        sf_element a = random_element(4), b = random_element(4), sum;
        CHECK_EQ(sf_element_sum(&a, &b, &sum), SF_OK);
        sf_slice src = make(0, 100, 20, 2), once = make(1, 100, 20, 2);
        sf_slice twice = make(2, 100, 20, 2), both = make(3, 100, 20, 2);
        memset(memory[0], 0, sizeof memory[0]);
        CHECK_EQ(sf_slice_set(src, 50, 10, 1), SF_OK);
        CHECK_EQ(sf_slice_dilate(once, src, &a, SF_BORDER_EMPTY), SF_OK);
        CHECK_EQ(sf_slice_dilate(twice, once, &b, SF_BORDER_EMPTY), SF_OK);
        CHECK_EQ(sf_slice_dilate(both, src, &sum, SF_BORDER_EMPTY), SF_OK);
        CHECK(sf_slice_equal(twice, both));
    }
}

static void wrong_calls_are_refused_and_write_nothing(void)
{
    sf_slice a = make(0, 64, 4, 1), b = make(1, 64, 5, 1), c = make(0, 64, 4, 2), none = {0};
    sf_element box = sf_element_box3(), growing = {1, {0, 1}};
    random_slice(a, 4);
    uint64_t before[8];
    memcpy(before, memory[0], sizeof before);
    CHECK_EQ(sf_slice_dilate(a, b, &box, SF_BORDER_EMPTY), SF_ERR_SHAPE);
    CHECK_EQ(sf_slice_dilate(a, a, &box, SF_BORDER_EMPTY), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_dilate(a, c, &box, SF_BORDER_EMPTY), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_dilate(a, none, &box, SF_BORDER_EMPTY), SF_ERR_ARGUMENT);
    sf_slice d = make(1, 64, 4, 1);
    CHECK_EQ(sf_slice_dilate(a, d, &growing, SF_BORDER_EMPTY), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_dilate(a, d, NULL, SF_BORDER_EMPTY), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_dilate(a, d, &box, (sf_border)7), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_and_dilate(a, d, a, &box), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_slice_and(a, c, c), SF_ERR_ARGUMENT);
    CHECK(memcmp(before, memory[0], sizeof before) == 0);
}

int main(void)
{
    TEST(equals_the_definition);
    TEST(equals_the_definition_on_every_instruction_set);
    TEST(erosion_is_adjoint_to_dilation);
    TEST(and_dilate_is_dilate_then_and);
    TEST(elements_are_what_they_say);
    TEST(sums_dilate_like_one_after_the_other);
    TEST(wrong_calls_are_refused_and_write_nothing);
    return test_finish();
}
