// SPDX-License-Identifier: MIT
// Why: the wall stands on one question, whether a triangle comes nearer to a box than so much. It
// is held against all pairs of features of random triangles and boxes of every size and place, long
// and thin, flat and without area, on the lattice and off it; the tree over triangles against all
// of them; and what is marked as touched against the same judge.

#include "balance/wall/near.h"
#include "balance/wall/touched.h"
#include "base/memory.h"
#include "distances.h"
#include "failing_allocator.h"

static double random_in(double low, double high)
{
    return low + (high - low) * test_random_unit();
}

// Triangles from tiny to huge; every third on a lattice of halves, every fifth a sliver or a point.
static void random_triangle(int kind, vec t[3])
{
    double size = pow(10, random_in(-2, 1.5));
    vec middle = {{random_in(-4, 4), random_in(-4, 4), random_in(-4, 4)}};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            t[i].v[j] = middle.v[j] + size * random_in(-1, 1);
            if (kind % 3 == 0) {
                t[i].v[j] = floor(2 * t[i].v[j] + 0.5) / 2;
            }
        }
    }
    if (kind % 5 == 0) {
        t[2] = vec_add(t[0], random_in(-1, 2), vec_add(t[1], -1, t[0]));
        t[2].v[kind % 2] += kind % 4 == 0 ? 0 : 1e-9;
    }
    if (kind % 50 == 7) {
        t[1] = t[2] = t[0];
    }
}

static int is_near(const double corners[3][3], const double half[3], double limit)
{
    return sfi_triangle_gap(corners, half, limit, limit) < limit * limit;
}

static void check_triangle(int kind)
{
    vec t[3];
    double half[3], corners[3][3], low[3], high[3];
    random_triangle(kind, t);
    for (int j = 0; j < 3; j++) {
        half[j] = kind % 3 == 0 ? 0.5 : pow(10, random_in(-1.5, 0.5));
        low[j] = -half[j];
        high[j] = half[j];
        for (int i = 0; i < 3; i++) {
            corners[i][j] = t[i].v[j];
        }
    }
    double distance = box_triangle(low, high, t);
    double gap = sfi_triangle_gap((const double(*)[3])corners, half, 1e9, 0);
    CHECK_NEAR(sqrt(gap), distance, 1e-7 * (1 + distance));
    for (int i = 0; i < 3; i++) {
        double limit = distance + (i - 1) * (1e-7 + 1e-7 * distance);
        if (limit > 0 && i != 1) {
            CHECK_EQ(is_near((const double(*)[3])corners, half, limit), i == 2);
        }
    }
    CHECK_EQ(is_near((const double(*)[3])corners, half, 0), 0);
    double random = random_in(0, 8);
    if (fabs(random - distance) > 1e-6) {
        CHECK_EQ(is_near((const double(*)[3])corners, half, random), distance < random);
    }
}

static void all_pairs_of_features_agree(void)
{
    for (int i = 0; i < 60000; i++) {
        check_triangle(i);
    }
}

// A box in a plane: distances that are exact, at, just above and just below them.
static void whole_numbers(void)
{
    const double square[3][3] = {{-3, -3, 2.5}, {3, -3, 2.5}, {0, 9, 2.5}};
    const double half[3] = {0.5, 0.5, 0.5};
    CHECK_EQ(is_near(square, half, 2), 0);
    CHECK_EQ(is_near(square, half, nextafter(2, 3)), 1);
    const double corner[3][3] = {{3.5, 4.5, 0}, {9, 9, 0}, {9, 9, 9}};
    CHECK_EQ(is_near(corner, half, 5), 0);
    CHECK_EQ(is_near(corner, half, nextafter(5, 6)), 1);
    const double through[3][3] = {{-9, -9, 0.1}, {9, -9, 0.1}, {0, 9, 0.1}};
    CHECK_EQ(is_near(through, half, 1e-9), 1);
}

// ---------------------------------------------------------------------------------------------
// Many triangles
// ---------------------------------------------------------------------------------------------

enum { MANY = 700 };
static double vertices[9 * MANY];
static uint32_t indices[3 * MANY];

static sf_mesh_view random_soup(size_t count)
{
    for (size_t i = 0; i < count; i++) {
        vec t[3];
        random_triangle((int)test_random_below(1000), t);
        for (size_t j = 0; j < 9; j++) {
            vertices[9 * i + j] = t[j / 3].v[j % 3];
        }
        for (size_t j = 0; j < 3; j++) {
            indices[3 * i + j] = (uint32_t)(3 * i + j);
        }
    }
    sf_mesh_view view = {vertices, 3 * count, indices, count};
    return view;
}

static void a_tree_finds_what_there_is(void)
{
    sf_allocator libc = sfi_allocator_or_default(NULL);
    for (size_t count = 0; count <= MANY; count += count < 20 ? 1 : 170) {
        sf_mesh_view soup = random_soup(count);
        sfi_near near;
        CHECK_EQ(sfi_near_create(soup, &libc, &near), SF_OK);
        for (int i = 0; i < 60; i++) {
            double middle[3], half[3], low[3], high[3], limit = random_in(0, 2);
            for (int j = 0; j < 3; j++) {
                middle[j] = random_in(-12, 12);
                half[j] = random_in(0.01, 1);
                low[j] = middle[j] - half[j];
                high[j] = middle[j] + half[j];
            }
            double distance = box_mesh(low, high, soup);
            if (fabs(distance - limit) > 1e-6) {
                CHECK_EQ(sfi_near_any(&near, middle, half, limit), distance < limit);
            }
            if (count > 0) {
                CHECK_NEAR(sfi_near_least(&near, middle, half, 1e9), distance, 1e-6);
                CHECK_NEAR(sfi_near_least(&near, middle, half, limit), fmin(distance, limit), 1e-6);
            }
            if (count > 0 && distance > 0) {
                CHECK_EQ(sfi_near_any(&near, middle, half, distance * 1.000001 + 1e-6), 1);
                CHECK_EQ(sfi_near_any(&near, middle, half, distance * 0.999999 - 1e-6), 0);
            }
        }
        sfi_near_destroy(&near, &libc);
    }
}

// Voxels that the judge finds to be touched are, and no others, but for what is nearly so.
static void compare_touched(const sf_lattice *lattice, sf_mesh_view soup, double reach)
{
    sf_allocator libc = sfi_allocator_or_default(NULL);
    sfi_touched touched;
    CHECK_EQ(sfi_touched_create(soup, lattice, reach, &libc, NULL, &touched), SF_OK);
    sf_lattice l = sf_grid_lattice(touched.grid);
    CHECK_EQ(touched.before[0] % 64, 0);
    for (uint32_t k = 0; k < l.nz; k++) {
        for (uint32_t i = 0; i < l.nx * l.ny; i++) {
            double low[3], high[3];
            voxel_box(&l, i % l.nx, i / l.nx, 0, low, high);
            low[2] = touched.levels[k];
            high[2] = touched.levels[k + 1];
            double distance = box_mesh(low, high, soup);
            int is = sf_slice_get(sf_grid_slice(touched.grid, k), i % l.nx, i / l.nx);
            if (distance == 0 || distance > 1e-6) {
                CHECK_EQ(is, distance == 0);
            }
        }
    }
    for (uint32_t k = 0; k <= lattice->nz; k++) {
        CHECK(touched.levels[touched.before[2] + k] == sf_lattice_layer_bottom(lattice, k));
    }
    sfi_touched_destroy(&touched, &libc);
}

static void what_is_touched_is_marked(void)
{
    static const double heights[] = {0.5, 1.25, 0.75, 0.5, 1};
    for (int i = 0; i < 12; i++) {
        sf_lattice lattice = {6, 5, 5, 1, 0.75, 1, i % 2 ? heights : NULL, {-3, -2, -2.5}};
        compare_touched(&lattice, random_soup(1 + test_random_below(5)), i % 4);
    }
}

static void failures_leave_nothing(void)
{
    sf_mesh_view soup = random_soup(100);
    sf_lattice lattice = {6, 5, 5, 1, 0.75, 1, NULL, {-3, -2, -2.5}};
    sf_status status = SF_ERR_MEMORY;
    failing_allocator f;
    for (long at = 0; status != SF_OK && at < 20; at++) {
        sfi_near near;
        sfi_touched touched;
        failing_begin(&f, at);
        status = sfi_near_create(soup, &f.allocator, &near);
        if (status == SF_OK) {
            status = sfi_touched_create(soup, &lattice, 2, &f.allocator, NULL, &touched);
            sfi_near_destroy(&near, &f.allocator);
        }
        if (status == SF_OK) {
            sfi_touched_destroy(&touched, &f.allocator);
        }
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && at < 10));
        CHECK_EQ(f.live, 0);
        CHECK_EQ(f.faults, 0);
    }
    CHECK_EQ(status, SF_OK);
    lattice.nx = 65500;
    sfi_touched touched;
    failing_begin(&f, -1);
    CHECK_EQ(sfi_touched_create(soup, &lattice, 20, &f.allocator, NULL, &touched), SF_ERR_OVERFLOW);
    CHECK_EQ(f.live, 0);
}

int main(void)
{
    TEST(all_pairs_of_features_agree);
    TEST(whole_numbers);
    TEST(a_tree_finds_what_there_is);
    TEST(what_is_touched_is_marked);
    TEST(failures_leave_nothing);
    return test_finish();
}
