// SPDX-License-Identifier: MIT
// Why: what is printed is what slices say. Voxels are held one by one against a search that shares
// no step with the walk that found them: the place of their centre, and the property there; solid
// ones must lie within the shape and empty ones outside, but for those that the stated tolerance
// leaves open. Promises: properties within 1e-6 of their range on all kinds of cages; each side of
// a jump has exactly its value; a slice is the same bytes whatever was sliced before.

#include "failing_allocator.h"
#include "slices.h"

#include <sf/locate.h>

// Each voxel of a slice against a search for its centre.
static void check_slice(const sf_limit *limit, const sf_locator *locator, const sf_lattice *l,
                        uint32_t k, sf_slice slice, const double *plane, double error,
                        double *worst)
{
    for (uint32_t i = 0; i < l->nx * l->ny; i++) {
        uint32_t x = i % l->nx, y = i / l->nx;
        double at[3] = {l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm,
                        l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm,
                        l->origin_mm[2] + (k + 0.5) * l->layer_mm};
        double distance, value;
        sf_place place;
        CHECK_EQ(sf_locator_find(locator, 1, at, 0, NULL, NULL, &place, &distance), SF_OK);
        if (place.piece == SF_NO_PIECE) {
            if (bit(slice, x, y)) { // then it lies between the surface and the shape
                CHECK_EQ(sf_locator_find(locator, 1, at, 2 * error, NULL, NULL, &place, &distance),
                         SF_OK);
                CHECK(place.piece != SF_NO_PIECE);
            }
        } else if (bit(slice, x, y)) {
            CHECK_EQ(sf_limit_values(limit, 0, 1, &place, NULL, NULL, &value, NULL), SF_OK);
            *worst = fmax(*worst, fabs(value - plane[i]));
        } else {
            CHECK(plane[i] == 0);
        }
    }
}

static void voxels_are_what_a_search_finds(void)
{
    double worst = 0;
    uint64_t solid = 0, located = 0, filled = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        test_cage c = kind_of(kind);
        if (kind > 0 && kind < 5) { // not inside out anywhere
            static const uint32_t around[5] = {0, 3, 5, 6, 8};
            test_cage straight = test_cage_wheel(around[kind], 3, 0);
            memcpy(c.positions, straight.positions, 3 * c.points * sizeof *c.positions);
            test_cage_free(&straight);
        }
        sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
        sf_lattice l = lattice_around(&c, 0.1);
        sf_locator *locator = NULL;
        CHECK_EQ(sf_locator_create(limit, NULL, &locator), SF_OK);
        sf_sampler *sampler = sampler_of(limit, &l, 1);
        sf_grid *grid = NULL;
        CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
        double *plane = calloc((size_t)l.nx * l.ny, sizeof *plane), error = 0;
        CHECK(sf_sampler_surface(sampler, &error).triangle_count > 0);
        CHECK(error <= 0.05 * l.layer_mm);
        for (uint32_t k = 2; k < l.nz; k += 5) {
            sf_slice slice = sf_grid_slice(grid, k);
            CHECK_EQ(sf_sampler_slice(sampler, k, slice, &plane), SF_OK);
            check_slice(limit, locator, &l, k, slice, plane, error, &worst);
        }
        sf_sample_report report;
        CHECK_EQ(sf_sampler_report(sampler, &report), SF_OK);
        solid += report.solid;
        located += report.located;
        filled += report.filled;
        free(plane);
        sf_grid_destroy(grid);
        sf_sampler_destroy(sampler);
        sf_locator_destroy(locator);
        sf_limit_destroy(limit);
        test_cage_free(&c);
    }
    printf(
        "# %llu voxels, properties of 0 to 1 at most %.2g apart; %llu searched for, %llu filled\n",
        (unsigned long long)solid, worst, (unsigned long long)located, (unsigned long long)filled);
    CHECK(worst < 1e-6 && solid > 10000 && located < solid / 20);
}

static void a_jump_is_exact_and_slices_do_not_depend_on_each_other(void)
{
    test_cage c = test_cage_block(4, 2, 2);
    double two[2] = {0.1, 0.7};
    c.values = malloc(sizeof two);
    memcpy(c.values, two, sizeof two);
    c.value_count = 2;
    c.indices = calloc(8 * c.cells, sizeof *c.indices);
    for (size_t i = 0; i < 8 * c.cells; i++) {
        c.indices[i] = i / 8 % 4 >= 2; // x >= 2
    }
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    sf_lattice l = lattice_around(&c, 0.07);
    sf_sampler *up = sampler_of(limit, &l, 1), *down = sampler_of(limit, &l, 1);
    sf_grid *a = NULL, *b = NULL;
    CHECK_EQ(sf_grid_create(&l, NULL, &a), SF_OK);
    CHECK_EQ(sf_grid_create(&l, NULL, &b), SF_OK);
    size_t plane = (size_t)l.nx * l.ny;
    double *p = calloc(plane * l.nz, sizeof *p), *q = calloc(plane * l.nz, sizeof *q);
    for (uint32_t k = 0; k < l.nz; k++) {
        double *x = p + plane * k, *y = q + plane * (l.nz - 1 - k);
        CHECK_EQ(sf_sampler_slice(up, k, sf_grid_slice(a, k), &x), SF_OK);
        CHECK_EQ(sf_sampler_slice(down, l.nz - 1 - k, sf_grid_slice(b, l.nz - 1 - k), &y), SF_OK);
    }
    CHECK(memcmp(p, q, plane * l.nz * sizeof *p) == 0);
    for (uint32_t k = 0; k < l.nz; k++) {
        sf_slice s = sf_grid_slice(a, k), t = sf_grid_slice(b, k);
        for (uint32_t i = 0; i < plane; i++) {
            uint32_t x = i % l.nx, y = i / l.nx;
            double middle = l.origin_mm[0] + (x + 0.5) * l.pitch_x_mm;
            CHECK_EQ(bit(s, x, y), bit(t, x, y));
            if (bit(s, x, y) && fabs(middle - 2) > 1e-9) { // the shape is symmetric there
                CHECK(p[plane * k + i] == (middle > 2 ? 0.7 : 0.1));
            }
        }
    }
    free(p);
    free(q);
    sf_grid_destroy(a);
    sf_grid_destroy(b);
    sf_sampler_destroy(up);
    sf_sampler_destroy(down);
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

static void a_box_holds_the_shape_and_is_hardly_larger(void)
{
    for (int kind = 0; kind < KINDS; kind++) {
        test_cage c = kind_of(kind);
        sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
        double low[3], high[3], least[3] = {1e9, 1e9, 1e9}, most[3] = {-1e9, -1e9, -1e9};
        CHECK_EQ(sf_limit_bounds(limit, NULL, NULL, low, high), SF_OK);
        for (int i = 0; i < 3000; i++) {
            sf_place place = random_place(limit);
            double p[3];
            CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, p, NULL), SF_OK);
            for (int axis = 0; axis < 3; axis++) {
                CHECK(p[axis] >= low[axis] && p[axis] <= high[axis]);
                least[axis] = fmin(least[axis], p[axis]);
                most[axis] = fmax(most[axis], p[axis]);
            }
        }
        for (int axis = 0; axis < 3; axis++) { // places at random are not the outermost
            CHECK(least[axis] - low[axis] < 0.05 && high[axis] - most[axis] < 0.05);
        }
        CHECK_EQ(sf_limit_bounds(limit, NULL, NULL, NULL, high), SF_ERR_ARGUMENT);
        sf_limit_destroy(limit);
        test_cage_free(&c);
    }
}

static void what_cannot_be_sampled_is_refused(void)
{
    test_cage c = kind_of(0), flat = test_cage_begin(2, 4, 1, 4);
    for (uint32_t i = 0; i < 4; i++) {
        flat.corners[i] = i;
    }
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD), *surface = limit_of(&flat, 0);
    sf_lattice l = lattice_around(&c, 0.3), huge = l;
    sf_sampler *none = NULL;
    sf_fault fault = {0};
    size_t zero = 0, one = 1;
    huge.nx = huge.ny = huge.nz = 1 << 14;
    CHECK_EQ(sf_sampler_create(limit, &huge, NULL, 0, NULL, NULL, NULL, &none, &fault),
             SF_ERR_OVERFLOW);
    CHECK(strstr(fault.message, "2^40") != NULL);
    CHECK_EQ(sf_sampler_create(surface, &l, NULL, 0, NULL, NULL, NULL, &none, &fault),
             SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_sampler_create(limit, &l, NULL, 1, &one, NULL, NULL, &none, &fault),
             SF_ERR_ARGUMENT);
    CHECK(strstr(fault.message, "property 1") != NULL);
    sf_sample_options options = sf_sample_options_default();
    options.tolerance = 0;
    CHECK_EQ(sf_sampler_create(limit, &l, &options, 0, NULL, NULL, NULL, &none, NULL),
             SF_ERR_ARGUMENT);
    l.pitch_x_mm = -1;
    CHECK_EQ(sf_sampler_create(limit, &l, NULL, 0, NULL, NULL, NULL, &none, NULL), SF_ERR_ARGUMENT);
    l = lattice_around(&c, 0.3);
    failing_allocator memory;
    for (long k = 0;; k += k < 60 ? 1 : 211) {
        failing_begin(&memory, k);
        sf_status status =
            sf_sampler_create(limit, &l, NULL, 1, &zero, &memory.allocator, NULL, &none, NULL);
        sf_sampler_destroy(none);
        none = NULL;
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            break;
        }
        CHECK_EQ(status, SF_ERR_MEMORY);
    }
    sf_sampler *sampler = sampler_of(limit, &l, 1);
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&l, NULL, &grid), SF_OK);
    double *missing = NULL;
    CHECK_EQ(sf_sampler_slice(sampler, l.nz, sf_grid_slice(grid, 0), &missing), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_sampler_slice(sampler, 0, sf_grid_slice(grid, 0), &missing), SF_ERR_ARGUMENT);
    sf_sampler_destroy(sampler);
    sf_sampler_destroy(NULL);
    sf_grid_destroy(grid);
    sf_limit_destroy(limit);
    sf_limit_destroy(surface);
    test_cage_free(&flat);
    test_cage_free(&c);
}

// Two tetrahedra that have all four faces in common hang together as a cage may, and enclose
// nothing.
static void without_a_boundary_there_is_nothing_to_slice(void)
{
    static const uint32_t corners[8] = {0, 1, 2, 3, 1, 0, 2, 3};
    test_cage c = test_cage_begin(3, 4, 2, 4);
    memcpy(c.corners, corners, sizeof corners);
    for (uint32_t i = 0; i < 4; i++) {
        test_cage_place(&c, i, i == 1, i == 2, i == 3);
    }
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    sf_lattice l = lattice_around(&c, 0.3);
    sf_sampler *none = NULL;
    double low[3] = {1, 2, 3}, high[3] = {4, 5, 6};
    CHECK_EQ(sf_sampler_create(limit, &l, NULL, 0, NULL, NULL, NULL, &none, NULL),
             SF_ERR_UNSUPPORTED);
    CHECK_EQ(sf_limit_bounds(limit, NULL, NULL, low, high), SF_ERR_UNSUPPORTED);
    CHECK(none == NULL && low[0] == 1 && high[2] == 6);
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

int main(void)
{
    TEST(voxels_are_what_a_search_finds);
    TEST(a_jump_is_exact_and_slices_do_not_depend_on_each_other);
    TEST(a_box_holds_the_shape_and_is_hardly_larger);
    TEST(what_cannot_be_sampled_is_refused);
    TEST(without_a_boundary_there_is_nothing_to_slice);
    return test_finish();
}
