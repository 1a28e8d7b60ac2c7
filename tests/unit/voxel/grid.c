// SPDX-License-Identifier: MIT
// Why: a grid owns memory, so it must begin empty, keep to its rows of 64 bytes, copy what it was
// given, and give everything back when a request is refused, whichever it is (TRUST 85); and what
// it says of its voxels must be what they are.

#include "voxel/grid.h"
#include "failing_allocator.h"
#include "test.h"

#include <sf/voxel.h>

static const double heights[5] = {0.1, 0.2, 0.3, 0.2, 0.1};

static sf_lattice lattice_of(uint32_t nx, uint32_t ny, const double *h)
{
    sf_lattice lattice = {nx, ny, 5, 0.1, 0.2, 0.3, h, {1, 2, 3}};
    return lattice;
}

static void a_grid_begins_empty_on_its_lattice(void)
{
    double own[5];
    for (uint32_t nx = 1; nx <= 1030; nx += nx < 70 ? 1 : 60) {
        sf_lattice l = lattice_of(nx, 3, own);
        sf_grid *grid = NULL;
        memcpy(own, heights, sizeof own);
        CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
        memset(own, 0, sizeof own); // heights were copied
        sf_lattice kept = sf_grid_lattice(grid);
        CHECK(kept.nx == nx && kept.ny == 3 && kept.nz == 5 && kept.heights_mm != own);
        CHECK(memcmp(kept.heights_mm, heights, sizeof heights) == 0);
        for (uint32_t k = 0; k < 5; k++) {
            sf_slice s = sf_grid_slice(grid, k);
            CHECK(s.width == nx && s.height == 3 && s.stride == sf_slice_stride(nx));
            CHECK_EQ((uintptr_t)s.words % 64, 0);
            for (size_t i = 0; i < s.stride * s.height; i++) { // padding too
                CHECK_EQ(s.words[i], 0);
            }
        }
        CHECK(sf_grid_slice(grid, 5).words == NULL);
        CHECK_EQ(sf_grid_popcount(grid), 0);
        sf_grid_destroy(grid);
    }
    sf_grid_destroy(NULL);
    CHECK(sf_grid_slice(NULL, 0).words == NULL);
}

static void what_cannot_be_made_is_refused(void)
{
    sf_lattice l = lattice_of(4, 4, NULL),
               huge = {SF_EXTENT_MAX, SF_EXTENT_MAX, SF_LAYER_MAX, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(NULL, NULL, &grid), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_create(&l, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_clone(NULL, NULL, &grid), SF_ERR_ARGUMENT);
    l.nx = SF_EXTENT_MAX + 1;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_ERR_OVERFLOW);
    failing_allocator none; // so that no machine is asked for 10^18 bytes
    failing_begin(&none, 0);
    sf_status status = sf_grid_create(&huge, &none.allocator, &grid);
    CHECK(status == SF_ERR_OVERFLOW || status == SF_ERR_MEMORY);
    CHECK(grid == NULL && none.live == 0);
}

static sf_grid *random_grid(uint32_t nx, uint32_t ny, uint32_t one_in)
{
    sf_lattice l = lattice_of(nx, ny, heights);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    for (uint32_t i = 0; i < nx * ny * 5; i++) {
        if (test_random_below(one_in) == 0) {
            CHECK_EQ(sf_slice_set(sf_grid_slice(grid, i / nx / ny), i % nx, i / nx % ny, 1), SF_OK);
        }
    }
    return grid;
}

static void bounds_and_counts_are_those_of_the_voxels(void)
{
    for (int round = 0; round < 300; round++) {
        uint32_t nx = 1 + test_random_below(90), ny = 1 + test_random_below(5), count = 0;
        sf_grid *grid = random_grid(nx, ny, 1u << test_random_below(12));
        sf_box box = {UINT32_MAX, UINT32_MAX, UINT32_MAX, 0, 0, 0}, none = {0, 0, 0, 0, 0, 0};
        for (uint32_t i = 0; i < nx * ny * 5; i++) {
            uint32_t x = i % nx, y = i / nx % ny, z = i / nx / ny;
            if (sf_slice_get(sf_grid_slice(grid, z), x, y)) {
                count++;
                box.x0 = x < box.x0 ? x : box.x0;
                box.y0 = y < box.y0 ? y : box.y0;
                box.z0 = z < box.z0 ? z : box.z0;
                box.x1 = x >= box.x1 ? x + 1 : box.x1;
                box.y1 = y >= box.y1 ? y + 1 : box.y1;
                box.z1 = z + 1;
            }
        }
        sf_box said = sf_grid_bounds(grid);
        box = count > 0 ? box : none;
        CHECK(memcmp(&said, &box, sizeof box) == 0);
        CHECK_EQ(sf_grid_popcount(grid), count);
        sf_grid_destroy(grid);
    }
    sf_box said = sf_grid_bounds(NULL);
    CHECK(said.x1 == 0 && sf_grid_popcount(NULL) == 0);
}

static void a_clone_is_equal_and_apart(void)
{
    sf_grid *grid = random_grid(70, 4, 3), *clone = NULL, *other = random_grid(70, 3, 3);
    CHECK_EQ(sf_grid_clone(grid, NULL, &clone), SF_OK);
    CHECK(sf_grid_equal(grid, clone) && sf_grid_equal(clone, grid));
    CHECK(sf_grid_lattice(clone).heights_mm != sf_grid_lattice(grid).heights_mm);
    sf_slice s = sf_grid_slice(clone, 4);
    CHECK_EQ(sf_slice_set(s, 69, 3, !sf_slice_get(s, 69, 3)), SF_OK);
    CHECK(!sf_grid_equal(grid, clone));
    CHECK(!sf_grid_equal(grid, other) && !sf_grid_equal(grid, NULL) && !sf_grid_equal(NULL, grid));
    sf_grid_destroy(grid); // the clone needs it no more
    CHECK(memcmp(sf_grid_lattice(clone).heights_mm, heights, sizeof heights) == 0);
    sf_grid_destroy(clone);
    sf_grid_destroy(other);
}

static void memory_runs_out_anywhere(void)
{
    sf_grid *source = random_grid(9, 9, 2);
    for (int with_heights = 0; with_heights < 2; with_heights++) {
        sf_lattice l = lattice_of(9, 9, with_heights ? heights : NULL);
        for (long n = 0; n <= 6; n++) {
            failing_allocator from;
            sf_grid *grid = NULL;
            failing_begin(&from, n);
            sf_status status = sf_grid_create(&l, &from.allocator, &grid);
            CHECK(status == (n < 2 + with_heights ? SF_ERR_MEMORY : SF_OK));
            CHECK((status == SF_OK) == (grid != NULL));
            CHECK_EQ(sf_grid_popcount(grid), 0); // though memory came full of rubbish
            sf_grid_destroy(grid);
            CHECK(from.live == 0 && from.faults == 0);
        }
    }
    for (long n = 0; n <= 3; n++) {
        failing_allocator from;
        sf_grid *clone = NULL;
        failing_begin(&from, n);
        sf_status status = sf_grid_clone(source, &from.allocator, &clone);
        CHECK(status == (n < 3 ? SF_ERR_MEMORY : SF_OK));
        CHECK(n < 3 ? clone == NULL : sf_grid_equal(clone, source));
        sf_grid_destroy(clone);
        CHECK(from.live == 0 && from.faults == 0);
    }
    sf_grid_destroy(source);
}

static void copies_and_parts(void)
{
    for (int round = 0; round < 300; round++) {
        uint32_t nx = 1 + test_random_below(140), ny = 1 + test_random_below(4), outside = 0;
        sf_grid *a = random_grid(nx, ny, 1u << (4 + test_random_below(8)));
        sf_grid *b = random_grid(nx, ny, 2);
        for (uint32_t i = 0; i < nx * ny * 5; i++) {
            uint32_t x = i % nx, y = i / nx % ny, z = i / nx / ny;
            outside +=
                sf_slice_get(sf_grid_slice(a, z), x, y) && !sf_slice_get(sf_grid_slice(b, z), x, y);
        }
        for (uint32_t k = 0; k < 5; k++) {
            // What lies past the width is nobody's.
            sf_slice s = sf_grid_slice(a, k);
            s.words[(nx - 1) / 64] |= nx % 64 != 0 ? ~UINT64_C(0) << nx % 64 : 0;
        }
        CHECK_EQ(sfi_grid_within(a, b), outside == 0);
        CHECK(sfi_grid_within(a, a));
        CHECK_EQ(sfi_grid_copy(b, a), SF_OK);
        CHECK(sf_grid_equal(a, b));
        sf_grid_destroy(a);
        sf_grid_destroy(b);
    }
}

int main(void)
{
    TEST(a_grid_begins_empty_on_its_lattice);
    TEST(what_cannot_be_made_is_refused);
    TEST(bounds_and_counts_are_those_of_the_voxels);
    TEST(a_clone_is_equal_and_apart);
    TEST(memory_runs_out_anywhere);
    TEST(copies_and_parts);
    return test_finish();
}
