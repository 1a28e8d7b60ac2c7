// SPDX-License-Identifier: MIT
// Why: every call that takes a lattice trusts sf_lattice_validate() to have refused what has no
// place in millimetres, with the code that the header names; and z is the same sum everywhere.

#include "test.h"

#include <sf/voxel.h>

static sf_lattice good(void)
{
    sf_lattice lattice = {4, 5, 6, 0.1, 0.2, 0.3, NULL, {-1, 2, 0.5}};
    return lattice;
}

static void counts_are_held_to_their_limits(void)
{
    sf_lattice l = good();
    CHECK_EQ(sf_lattice_validate(&l), SF_OK);
    CHECK_EQ(sf_lattice_validate(NULL), SF_ERR_ARGUMENT);
    uint32_t *counts[] = {&l.nx, &l.ny, &l.nz};
    const uint32_t most[] = {SF_EXTENT_MAX, SF_EXTENT_MAX, SF_LAYER_MAX};
    for (int i = 0; i < 3; i++) {
        uint32_t kept = *counts[i];
        *counts[i] = 0;
        CHECK_EQ(sf_lattice_validate(&l), SF_ERR_ARGUMENT);
        *counts[i] = most[i];
        CHECK_EQ(sf_lattice_validate(&l), SF_OK);
        *counts[i] = most[i] + 1;
        CHECK_EQ(sf_lattice_validate(&l), SF_ERR_OVERFLOW);
        *counts[i] = UINT32_MAX;
        CHECK_EQ(sf_lattice_validate(&l), SF_ERR_OVERFLOW);
        *counts[i] = kept;
    }
}

static void lengths_are_positive_and_finite(void)
{
    const double bad[] = {0, -0.0, -1, 1.0000001e12, INFINITY, -INFINITY, NAN};
    const double fine[] = {1e12, 1e-300, 0x1p-1074};
    sf_lattice l = good();
    double heights[6] = {1, 1, 1, 1, 1, 1};
    double *lengths[] = {&l.pitch_x_mm, &l.pitch_y_mm, &l.layer_mm, &heights[0], &heights[5]};
    for (int i = 0; i < 5; i++) {
        l.heights_mm = i < 3 ? NULL : heights;
        double kept = *lengths[i];
        for (size_t b = 0; b < sizeof bad / sizeof *bad; b++) {
            *lengths[i] = bad[b];
            CHECK_EQ(sf_lattice_validate(&l), SF_ERR_ARGUMENT);
        }
        for (size_t f = 0; f < sizeof fine / sizeof *fine; f++) {
            *lengths[i] = fine[f];
            CHECK_EQ(sf_lattice_validate(&l), SF_OK);
        }
        *lengths[i] = kept;
    }
    l.layer_mm = NAN; // unused where there are heights
    CHECK_EQ(sf_lattice_validate(&l), SF_OK);
}

static void origins_are_within_reach(void)
{
    const double bad[] = {1.0000001e12, -1.0000001e12, INFINITY, NAN};
    for (int axis = 0; axis < 3; axis++) {
        sf_lattice l = good();
        for (size_t b = 0; b < sizeof bad / sizeof *bad; b++) {
            l.origin_mm[axis] = bad[b];
            CHECK_EQ(sf_lattice_validate(&l), SF_ERR_ARGUMENT);
        }
        l.origin_mm[axis] = -1e12;
        CHECK_EQ(sf_lattice_validate(&l), SF_OK);
    }
}

static void layers_stand_on_each_other(void)
{
    const double heights[6] = {0.1, 0.2, 0.4, 0.3, 0.7, 0.05};
    sf_lattice l = good();
    for (uint32_t k = 0; k <= 6; k++) {
        CHECK_NEAR(sf_lattice_layer_bottom(&l, k), 0.5 + k * 0.3, 1e-15);
    }
    CHECK_NEAR(sf_lattice_layer_height(&l, 5), 0.3, 0);
    l.heights_mm = heights;
    double z = 0.5;
    for (uint32_t k = 0; k <= 6; k++) {
        CHECK_NEAR(sf_lattice_layer_bottom(&l, k), z, 0); // the same sum, term by term
        if (k < 6) {
            CHECK_NEAR(sf_lattice_layer_height(&l, k), heights[k], 0);
            z += heights[k];
        }
    }
}

int main(void)
{
    TEST(counts_are_held_to_their_limits);
    TEST(lengths_are_positive_and_finite);
    TEST(origins_are_within_reach);
    TEST(layers_stand_on_each_other);
    return test_finish();
}
