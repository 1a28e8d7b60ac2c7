// SPDX-License-Identifier: MIT
// TRUST items 31, 32: the algebra of slices. Operations on bits are those of sets, whatever the
// stride and whatever stands in the padding; dilation is the union of translates, over all 65536
// slices of 4x4; and erosion is its adjoint exactly when the outside counts as solid.

#include "tiny.h"

#define SIDE 3
#define COUNT (1u << (SIDE * SIDE))

// A slice of 3x3 in rows of `stride` words, with rubbish wherever no voxel lies.
static sf_slice slice_of(uint64_t *words, size_t stride, uint32_t bits)
{
    sf_slice s = {words, SIDE, SIDE, stride};
    for (size_t i = 0; i < stride * SIDE; i++) {
        words[i] = test_random();
    }
    for (size_t y = 0; y < SIDE; y++) {
        words[y * stride] = (words[y * stride] & ~UINT64_C(7)) | (bits >> (y * SIDE) & 7);
    }
    return s;
}

// Its voxels; the padding of its rows must be zero.
static uint32_t bits_of(sf_slice s)
{
    uint32_t bits = 0;
    for (uint32_t y = 0; y < SIDE; y++) {
        uint64_t row = s.words[y * s.stride];
        CHECK((row & ~UINT64_C(7)) == 0);
        bits |= (uint32_t)row << (y * SIDE);
    }
    return bits;
}

static void sets_of_all_pairs(void)
{
    uint64_t words[3][12];
    for (uint32_t a = 0; a < COUNT; a++) {
        for (uint32_t b = 0; b < COUNT; b++) {
            sf_slice p = slice_of(words[0], 1 + a % 3, a), q = slice_of(words[1], 1 + b % 4, b);
            sf_slice r = slice_of(words[2], 1 + (a + b) % 4, 0);
            CHECK_EQ(sf_slice_and(r, p, q), SF_OK);
            CHECK_EQ(bits_of(r), a & b);
            uint64_t common = sf_slice_popcount(r);
            CHECK_EQ(sf_slice_or(r, p, q), SF_OK);
            CHECK_EQ(bits_of(r), a | b);
            CHECK_EQ(sf_slice_popcount(r) + common, sf_slice_popcount(p) + sf_slice_popcount(q));
            CHECK_EQ(sf_slice_xor(r, p, q), SF_OK);
            CHECK_EQ(bits_of(r), a ^ b);
            CHECK_EQ(sf_slice_subtract(r, p, q), SF_OK);
            CHECK_EQ(bits_of(r), a & ~b);
            CHECK_EQ(sf_slice_equal(p, q), a == b);
        }
    }
}

// De Morgan, absorption and A xor A = nothing, by the library's own operations.
static void laws_of_all_pairs(void)
{
    uint64_t words[6][3];
    sf_slice all = slice_of(words[5], 1, COUNT - 1);
    for (uint32_t a = 0; a < COUNT; a++) {
        for (uint32_t b = 0; b < COUNT; b++) {
            sf_slice p = slice_of(words[0], 1, a), q = slice_of(words[1], 1, b);
            sf_slice r = slice_of(words[2], 1, 0), s = slice_of(words[3], 1, 0);
            sf_slice t = slice_of(words[4], 1, 0);
            CHECK_EQ(sf_slice_or(r, p, q), SF_OK);
            CHECK_EQ(sf_slice_and(s, p, r), SF_OK);
            CHECK(sf_slice_equal(s, p)); // absorption
            CHECK_EQ(sf_slice_subtract(r, all, r), SF_OK);
            CHECK_EQ(sf_slice_subtract(s, all, p), SF_OK);
            CHECK_EQ(sf_slice_subtract(t, all, q), SF_OK);
            CHECK_EQ(sf_slice_and(s, s, t), SF_OK);
            CHECK(sf_slice_equal(r, s)); // De Morgan
            CHECK_EQ(sf_slice_xor(r, p, p), SF_OK);
            CHECK_EQ(sf_slice_popcount(r), 0);
        }
    }
}

static uint32_t translates(uint32_t slice, const sf_element *e, int side)
{
    uint32_t result = 0;
    for (int u = 0; u < side * side; u++) {
        for (int v = 0; (slice >> u & 1) && v < side * side; v++) {
            result |= (uint32_t)element_has(e, v % side - u % side, v / side - u / side) << v;
        }
    }
    return result;
}

// 4x4: dilation by definition; erosion as dilation of the rest; both sides of each border rule.
static void every_slice_of_four_by_four(void)
{
    sf_element elements[] = {sf_element_box3(), sf_element_plus3(), element_along_x(1),
                             element_along_x(2)};
    for (int i = 0; i < 4; i++) {
        uint32_t *grown = tiny_morph(4, 4, &elements[i], SF_BORDER_EMPTY, TINY_DILATE);
        uint32_t *flooded = tiny_morph(4, 4, &elements[i], SF_BORDER_SOLID, TINY_DILATE);
        uint32_t *kept = tiny_morph(4, 4, &elements[i], SF_BORDER_SOLID, TINY_ERODE);
        uint32_t *shrunk = tiny_morph(4, 4, &elements[i], SF_BORDER_EMPTY, TINY_ERODE);
        for (uint32_t s = 0; s < 65536; s++) {
            uint32_t rest = ~s & 0xffffu;
            CHECK_EQ(grown[s], translates(s, &elements[i], 4));
            CHECK_EQ(kept[s], ~grown[rest] & 0xffffu);
            CHECK_EQ(shrunk[s], ~flooded[rest] & 0xffffu);
            CHECK((s & ~grown[s]) == 0 && (kept[s] & ~s) == 0);
            CHECK_EQ(flooded[s], grown[s] | flooded[0]);
        }
        free(grown);
        free(flooded);
        free(kept);
        free(shrunk);
    }
}

// 32, over all pairs of 3x3: with solid outside always, with nothing outside not.
static void adjunction(void)
{
    sf_element elements[] = {sf_element_box3(), sf_element_plus3(), element_along_x(1)};
    for (int i = 0; i < 3; i++) {
        uint32_t *grown = tiny_morph(3, 3, &elements[i], SF_BORDER_EMPTY, TINY_DILATE);
        uint32_t *solid = tiny_morph(3, 3, &elements[i], SF_BORDER_SOLID, TINY_ERODE);
        uint32_t *empty = tiny_morph(3, 3, &elements[i], SF_BORDER_EMPTY, TINY_ERODE);
        for (uint32_t x = 0; x < COUNT; x++) {
            for (uint32_t y = 0; y < COUNT; y++) {
                CHECK(((grown[x] & ~y) == 0) == ((x & ~solid[y]) == 0));
                CHECK((grown[x] & ~grown[x | y]) == 0);
                CHECK_EQ(grown[x | y], grown[x] | grown[y]);
                CHECK_EQ(solid[x & y], solid[x] & solid[y]);
            }
        }
        // All of the window dilates to itself, but nothing of its rim survives such an erosion.
        uint32_t all = COUNT - 1;
        CHECK((grown[all] & ~all) == 0);
        CHECK((all & ~empty[all]) != 0);
        free(grown);
        free(solid);
        free(empty);
    }
}

int main(void)
{
    TEST(sets_of_all_pairs);
    TEST(laws_of_all_pairs);
    TEST(every_slice_of_four_by_four);
    TEST(adjunction);
    return test_finish();
}
