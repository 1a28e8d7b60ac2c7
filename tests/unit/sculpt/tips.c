// SPDX-License-Identifier: MIT
// Tips cover the voxels that their shape says, and nothing else; masks and images become tips as
// they are; a refused call makes none, and none leaks when memory runs out at any request.

#include <sf/sf.h>

#include "failing_allocator.h"
#include "test.h"

static int has(const sf_tip *tip, int dx, int dy, int dz)
{
    sf_dab a;
    const sf_grid *mask = sf_tip_mask(tip, &a);
    sf_lattice l = sf_grid_lattice(mask);
    int x = dx + a.x, y = dy + a.y, z = dz + a.z;
    int is_in = x >= 0 && x < (int)l.nx && y >= 0 && y < (int)l.ny && z >= 0 && z < (int)l.nz;
    return is_in && sf_slice_get(sf_grid_slice(mask, (uint32_t)z), (uint32_t)x, (uint32_t)y);
}

// The shape by its equation, in squares multiplied out.
static int inside(sf_tip_shape shape, const double r[3], int x, int y, int z)
{
    double around = x * x * r[1] * r[1] + y * y * r[0] * r[0], whole = r[0] * r[0] * r[1] * r[1];
    double slope = (r[2] - z) / (2 * r[2]);
    int is_between = abs(z) <= r[2];
    switch (shape) {
    case SF_TIP_SPHERE:
        return around * r[2] * r[2] + z * z * whole <= whole * r[2] * r[2];
    case SF_TIP_BOX:
        return abs(x) <= r[0] && abs(y) <= r[1] && is_between;
    case SF_TIP_CYLINDER:
        return around <= whole && is_between;
    default:
        return is_between && around <= whole * slope * slope;
    }
}

// Radii with fractions, so that no centre lies on the border, where rounding would decide.
static void formulas(void)
{
    static const double radii[4][3] = {
        {3.3, 3.3, 3.3}, {5.7, 2.2, 4.9}, {1.1, 8.6, 2.3}, {20.1, 19.7, 20.3}};
    for (int shape = SF_TIP_SPHERE; shape <= SF_TIP_CONE; shape++) {
        for (int i = 0; i < 4; i++) {
            sf_tip *tip = NULL;
            CHECK(sf_tip_create((sf_tip_shape)shape, radii[i], NULL, &tip) == SF_OK);
            for (int z = -22; z <= 22; z++) {
                for (int y = -22; y <= 22; y++) {
                    for (int x = -22; x <= 22; x++) {
                        CHECK_EQ(has(tip, x, y, z), inside((sf_tip_shape)shape, radii[i], x, y, z));
                    }
                }
            }
            sf_tip_destroy(tip);
        }
    }
}

// Known numbers: a single voxel, the seven of radius 1, the 33 of radius 2, 33,401 of radius 20.
static void counts(void)
{
    static const double radii[4] = {0, 1, 2, 20};
    static const uint64_t expected[4] = {1, 7, 33, 33401};
    for (int i = 0; i < 4; i++) {
        double r[3] = {radii[i], radii[i], radii[i]};
        sf_tip *tip = NULL;
        CHECK(sf_tip_create(SF_TIP_SPHERE, r, NULL, &tip) == SF_OK);
        CHECK_EQ(sf_grid_popcount(sf_tip_mask(tip, NULL)), expected[i]);
        sf_tip_destroy(tip);
    }
}

static void masks(void)
{
    sf_lattice l = {90, 20, 9, 0.3, 0.3, 0.3, NULL, {5, 5, 5}};
    sf_grid *mask = NULL;
    sf_tip *tip = NULL;
    sf_dab anchor = {70, 3, 4};
    CHECK(sf_grid_create(&l, NULL, &mask) == SF_OK);
    CHECK(sf_tip_create_mask(mask, anchor, NULL, &tip) == SF_ERR_ARGUMENT); // nothing is solid
    CHECK(sf_slice_set(sf_grid_slice(mask, 4), 71, 3, 1) == SF_OK);
    CHECK(sf_slice_set(sf_grid_slice(mask, 6), 60, 9, 1) == SF_OK);
    CHECK(sf_tip_create_mask(mask, anchor, NULL, &tip) == SF_OK);
    CHECK_EQ(sf_grid_popcount(sf_tip_mask(tip, NULL)), 2);
    CHECK(has(tip, 1, 0, 0) && has(tip, -10, 6, 2));
    sf_tip_destroy(tip);
    sf_grid_destroy(mask);
}

static void stamps(void)
{
    static const uint8_t heights[2][4] = {{0, 255, 128, 99}, {12, 13, 40, 99}};
    sf_tip *tip = NULL;
    CHECK(sf_tip_create_stamp(heights[0], 4, 3, 2, 10, NULL, &tip) == SF_OK);
    for (int y = 0; y < 2; y++) {
        for (int x = 0; x < 3; x++) {
            int top = (int)floor(heights[y][x] * 10 / 255.0 + 0.5);
            for (int z = 0; z < 12; z++) {
                CHECK_EQ(has(tip, x - 1, y - 1, z), z < top);
            }
        }
    }
    sf_tip_destroy(tip);
}

// A mesh becomes a tip by way of its voxels.
static void meshes(void)
{
    static const double corners[8][3] = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0},
                                         {0, 0, 2}, {4, 0, 2}, {4, 3, 2}, {0, 3, 2}};
    static const uint32_t faces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7},
                                          {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5},
                                          {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    sf_mesh_view view = {
        .vertices = corners[0], .triangles = faces[0], .vertex_count = 8, .triangle_count = 12};
    sf_lattice l = {8, 6, 4, 0.5, 0.5, 0.5, NULL, {0, 0, 0}};
    sf_grid *mask = NULL;
    sf_tip *tip = NULL;
    sf_dab anchor = {4, 3, 2};
    CHECK(sf_grid_create(&l, NULL, &mask) == SF_OK);
    CHECK(sf_grid_voxelize(mask, view, NULL, NULL, NULL, NULL) == SF_OK);
    CHECK(sf_tip_create_mask(mask, anchor, NULL, &tip) == SF_OK);
    CHECK_EQ(sf_grid_popcount(sf_tip_mask(tip, NULL)), 8 * 6 * 4);
    sf_tip_destroy(tip);
    sf_grid_destroy(mask);
}

static void refusals(void)
{
    sf_tip *tip = (sf_tip *)1;
    const double good[3] = {1, 1, 1}, less[3] = {1, -1, 1}, nan[3] = {1, NAN, 1},
                 far[3] = {1, 1, 1025};
    const uint8_t zero[4] = {0, 0, 0, 0}, low[1] = {12};
    CHECK(sf_tip_create(SF_TIP_SPHERE, NULL, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create(SF_TIP_SPHERE, good, NULL, NULL) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create((sf_tip_shape)4, good, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create((sf_tip_shape)-1, good, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create(SF_TIP_BOX, less, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create(SF_TIP_BOX, nan, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create(SF_TIP_BOX, far, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create_stamp(NULL, 2, 2, 2, 4, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create_stamp(zero, 2, 2, 2, 4, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create_stamp(low, 1, 1, 1, 4, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create_stamp(low, 0, 1, 1, 4, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(sf_tip_create_stamp(low, 1, 1, 4097, 4, NULL, &tip) == SF_ERR_ARGUMENT);
    CHECK(tip == (sf_tip *)1);
    CHECK(sf_tip_mask(NULL, NULL) == NULL);
    sf_tip_destroy(NULL);
}

// A mask that looks different in all four ways, so that all grids are made.
static void out_of_memory(void)
{
    sf_lattice l = {5, 5, 2, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *mask = NULL;
    CHECK(sf_grid_create(&l, NULL, &mask) == SF_OK);
    CHECK(sf_slice_set(sf_grid_slice(mask, 0), 0, 1, 1) == SF_OK);
    CHECK(sf_slice_set(sf_grid_slice(mask, 1), 4, 4, 1) == SF_OK);
    sf_status status = SF_ERR_MEMORY;
    long k = 0;
    for (; status == SF_ERR_MEMORY && k < 100; k++) {
        failing_allocator f;
        sf_tip *tip = NULL;
        sf_dab anchor = {2, 2, 0};
        failing_begin(&f, k);
        status = sf_tip_create_mask(mask, anchor, &f.allocator, &tip);
        CHECK((status == SF_OK) == (tip != NULL));
        sf_tip_destroy(tip);
        CHECK(f.live == 0 && f.faults == 0);
    }
    CHECK(status == SF_OK && k > 4);
    sf_grid_destroy(mask);
}

int main(void)
{
    TEST(formulas);
    TEST(counts);
    TEST(masks);
    TEST(stamps);
    TEST(meshes);
    TEST(refusals);
    TEST(out_of_memory);
    return test_finish();
}
