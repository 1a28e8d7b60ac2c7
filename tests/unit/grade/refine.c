// SPDX-License-Identifier: MIT
// Why: everything in grade stands on the rules of subdivision. On regular blocks they are held
// against the refinement of cubic B-splines, one axis after the other; around a line against a
// surface rule times a curve rule, written out here; on triangles and open meshes against what the
// other tests of this folder read from files. Promises: weights sum to 1 and are none below 0, the
// outside does not depend on the inside, what is constant stays so to the bit, an update gives the
// bytes of a refinement made anew, and without memory there is none.

#include <sf/refine.h>

#include "cages.h"
#include "failing_allocator.h"

static sf_refinement *refine(const test_cage *c, uint32_t steps, sf_refine_rules rules)
{
    sf_cage *cage = test_cage_make(c);
    sf_refine_options options = sf_refine_options_default();
    options.steps = steps;
    options.rules = rules;
    sf_refinement *r = NULL;
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_OK);
    sf_cage_destroy(cage);
    return r;
}

static sf_cage_view view_of(const sf_refinement *r, uint32_t step)
{
    sf_cage_view view = {0};
    CHECK_EQ(sf_refinement_get_view(r, step, &view), SF_OK);
    return view;
}

// ---------------------------------------------------------------------------------------------
// Regular blocks
// ---------------------------------------------------------------------------------------------

enum { N = 5 }; // points of a block along each axis

// One axis of cubic B-spline refinement: ends stay, as a natural end has it.
static double spline(const double *p, size_t stride, int i, int count)
{
    const double *q = p + stride * (size_t)(i / 2);
    if (i % 2 == 1) {
        return (q[0] + q[stride]) / 2;
    }
    if (i == 0 || i == 2 * (count - 1)) {
        return q[0];
    }
    return (q[-(ptrdiff_t)stride] + 6 * q[0] + q[stride]) / 8;
}

// Values of a cube of N^3 after one step, axis by axis. The ends of an axis are crease rules, which
// hold nowhere on a smooth boundary: only points at least one cell away from it are compared.
static void refine_axes(const double *from, double *to)
{
    static double x[N * N * (2 * N - 1)], y[N * (2 * N - 1) * (2 * N - 1)];
    const int m = 2 * N - 1;
    for (int j = 0; j < N * N; j++) {
        for (int i = 0; i < m; i++) {
            x[j * m + i] = spline(from + j * N, 1, i, N);
        }
    }
    for (int k = 0; k < N; k++) {
        for (int j = 0; j < m; j++) {
            for (int i = 0; i < m; i++) {
                y[(k * m + j) * m + i] = spline(x + k * N * m + i, (size_t)m, j, N);
            }
        }
    }
    for (int k = 0; k < m; k++) {
        for (int j = 0; j < m; j++) {
            for (int i = 0; i < m; i++) {
                to[(k * m + j) * m + i] = spline(y + j * m + i, (size_t)(m * m), k, N);
            }
        }
    }
}

// Refined points are looked up by a second channel of places: the lattice is refined to itself.
static void regular_blocks_are_refined_as_splines(void)
{
    test_cage c = test_cage_block(N - 1, N - 1, N - 1);
    c.values = calloc(c.points, sizeof *c.values);
    for (size_t i = 0; i < c.points; i++) {
        c.values[i] = test_random_unit();
    }
    static double expected[(2 * N - 1) * (2 * N - 1) * (2 * N - 1)];
    refine_axes(c.values, expected);
    sf_refinement *r = refine(&c, 1, SF_REFINE_STANDARD);
    sf_cage_view v = view_of(r, 1);
    int compared = 0;
    for (size_t i = 0; i < v.point_count; i++) {
        const double *p = v.positions + 3 * i;
        int at[3], inside = 1;
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = (int)lround(2 * p[axis]);
            inside &= at[axis] >= 1 && at[axis] <= 2 * N - 3;
        }
        if (inside) { // there the lattice keeps its places, and faces next to it their rules
            CHECK_NEAR(p[0], at[0] / 2.0, 1e-15);
            double value = expected[(at[2] * (2 * N - 1) + at[1]) * (2 * N - 1) + at[0]];
            CHECK_NEAR(v.channels[0].values[i], value, 1e-15);
            compared++;
        }
    }
    CHECK_EQ(compared, (2 * N - 3) * (2 * N - 3) * (2 * N - 3));
    sf_refinement_destroy(r);
    test_cage_free(&c);
}

// ---------------------------------------------------------------------------------------------
// Around a line
// ---------------------------------------------------------------------------------------------

// The separable rule of the middle point: a surface with n faces, times a curve.
static double surface_point(const double *ring, uint32_t n)
{
    double faces = 0, edges = 0;
    for (uint32_t k = 0; k < n; k++) {
        double a = ring[1 + 2 * k], b = ring[2 + 2 * k], c = ring[1 + (2 * k + 2) % (2 * n)];
        faces += (ring[0] + a + b + c) / 4 / n;
        edges += (ring[0] + a) / 2 / n;
    }
    return (faces + 2 * edges + (n - 3.0) * ring[0]) / n;
}

static void separable_rules_are_a_surface_times_a_curve(void)
{
    for (uint32_t n = 3; n < 9; n++) {
        test_cage c = test_cage_wheel(n, 4, 0);
        uint32_t ring = 2 * n + 1;
        c.values = calloc(c.points, sizeof *c.values);
        for (size_t i = 0; i < c.points; i++) {
            c.values[i] = test_random_unit();
        }
        sf_refinement *both[2] = {refine(&c, 1, SF_REFINE_STANDARD),
                                  refine(&c, 1, SF_REFINE_SEPARABLE)};
        for (uint32_t z = 1; z < 4; z++) {
            double below = surface_point(c.values + (z - 1) * ring, n);
            double here = surface_point(c.values + z * ring, n);
            double above = surface_point(c.values + (z + 1) * ring, n);
            double found = view_of(both[1], 1).channels[0].values[z * ring];
            CHECK_NEAR(found, (below + 6 * here + above) / 8, 1e-15);
            double standard = view_of(both[0], 1).channels[0].values[z * ring];
            CHECK(n == 4 ? fabs(standard - found) < 1e-15 : fabs(standard - found) > 1e-6);
        }
        sf_refinement_destroy(both[0]);
        sf_refinement_destroy(both[1]);
        test_cage_free(&c);
    }
}

// ---------------------------------------------------------------------------------------------
// Weights
// ---------------------------------------------------------------------------------------------

static test_cage mixed(int kind)
{
    test_cage c =
        kind == 0 ? test_cage_block(3, 2, 2) : test_cage_wheel((uint32_t)kind + 2, 2, 0.1);
    c.creases = 1; // half sharp, so that rules are mixed
    c.crease[0].points[0] = 1;
    c.crease[0].points[1] = 2;
    c.crease[0].sharpness = 1.3;
    c.sharps = 1;
    c.sharp[0].point = 2;
    c.sharp[0].sharpness = 0.4;
    return c;
}

static void weights_sum_to_1_and_are_none_below_0(void)
{
    for (int kind = 0; kind < 8; kind++) {
        test_cage c = mixed(kind);
        for (int rules = 0; rules < 2; rules++) {
            sf_refinement *r = refine(&c, 2, rules ? SF_REFINE_SEPARABLE : SF_REFINE_STANDARD);
            sf_cage_view v = view_of(r, 2);
            static uint32_t points[4096];
            static double weights[4096];
            for (size_t i = 0; i < v.point_count; i += 7) {
                size_t count = 0;
                CHECK_EQ(sf_refinement_stencil(r, 2, i, NULL, 4096, points, weights, &count),
                         SF_OK);
                double sum = 0, place[3] = {0, 0, 0};
                for (size_t j = 0; j < count; j++) {
                    CHECK(weights[j] > 0);
                    sum += weights[j];
                    for (int axis = 0; axis < 3; axis++) {
                        place[axis] += weights[j] * c.positions[3 * points[j] + (size_t)axis];
                    }
                }
                CHECK_NEAR(sum, 1, 1e-14);
                CHECK_NEAR(place[0], v.positions[3 * i], 1e-14);
                CHECK_NEAR(place[2], v.positions[3 * i + 2], 1e-14);
                if (count > 1) {
                    size_t need = 0;
                    CHECK_EQ(sf_refinement_stencil(r, 2, i, NULL, 1, points, weights, &need),
                             SF_ERR_CAPACITY);
                    CHECK_EQ(need, count);
                }
            }
            sf_refinement_destroy(r);
        }
        test_cage_free(&c);
    }
}

static void what_is_constant_stays_so_to_the_bit(void)
{
    for (int kind = 0; kind < 8; kind++) {
        test_cage c = mixed(kind);
        c.values = calloc(c.points, sizeof *c.values);
        for (size_t i = 0; i < c.points; i++) {
            c.values[i] = 0.1;
        }
        sf_refinement *r = refine(&c, 3, SF_REFINE_STANDARD);
        sf_cage_view v = view_of(r, 3);
        for (size_t i = 0; i < v.point_count; i++) {
            CHECK(v.channels[0].values[i] == 0.1);
        }
        sf_refinement_destroy(r);
        test_cage_free(&c);
    }
}

static void the_outside_does_not_depend_on_the_inside(void)
{
    for (int kind = 0; kind < 8; kind++) {
        test_cage c =
            kind == 0 ? test_cage_block(3, 3, 3) : test_cage_wheel((uint32_t)kind + 2, 3, 0);
        sf_refinement *r = refine(&c, 2, SF_REFINE_STANDARD);
        sf_cage *fine = NULL;
        sf_cage_view v = view_of(r, 2);
        v.channel_count = 0;
        CHECK_EQ(sf_cage_create(&v, NULL, &fine, NULL), SF_OK); // refined cages are cages
        double *before = malloc(3 * v.point_count * sizeof *before);
        memcpy(before, v.positions, 3 * v.point_count * sizeof *before);
        for (size_t i = 0; i < c.points; i++) { // what lies inside is moved far away
            double x = c.positions[3 * i], y = c.positions[3 * i + 1], z = c.positions[3 * i + 2];
            if (kind == 0 ? x > 0 && x < 3 && y > 0 && y < 3 && z > 0 && z < 3
                          : z > 0 && z < 3 && x * x + y * y < 0.1) {
                test_cage_place(&c, i, 1000, 1000, 1000);
            }
        }
        CHECK_EQ(sf_refinement_update_positions(r, c.positions, NULL), SF_OK);
        size_t same = 0;
        for (size_t i = 0; i < v.point_count; i++) {
            same += memcmp(before + 3 * i, v.positions + 3 * i, 3 * sizeof(double)) == 0;
        }
        sf_cage_report report;
        CHECK_EQ(sf_cage_check(fine, NULL, &report, NULL), SF_OK);
        CHECK(same >= report.boundary_points && same < v.point_count);
        sf_cage_destroy(fine);
        free(before);
        sf_refinement_destroy(r);
        test_cage_free(&c);
    }
}

// ---------------------------------------------------------------------------------------------
// Jumps
// ---------------------------------------------------------------------------------------------

static void a_property_jumps_where_neighbours_disagree(void)
{
    test_cage c = test_cage_block(4, 2, 2);
    double two[2] = {0, 1};
    c.values = malloc(sizeof two);
    memcpy(c.values, two, sizeof two);
    c.value_count = 2;
    c.indices = calloc(8 * c.cells, sizeof *c.indices);
    for (size_t i = 0; i < 8 * c.cells; i++) {
        c.indices[i] = i / 8 % 4 >= 2; // the right half
    }
    sf_refinement *r = refine(&c, 3, SF_REFINE_STANDARD);
    sf_cage_view v = view_of(r, 3);
    CHECK(v.channels[0].indices != NULL);
    for (size_t i = 0; i < v.cell_count; i++) {
        for (size_t j = 0; j < 8; j++) {
            double value = v.channels[0].values[v.channels[0].indices[8 * i + j]];
            CHECK(value == (i / 512 % 4 >= 2));
        }
    }
    // The shape is the same as without the property.
    test_cage plain = test_cage_block(4, 2, 2);
    sf_refinement *without = refine(&plain, 3, SF_REFINE_STANDARD);
    CHECK(memcmp(view_of(without, 3).positions, v.positions, 3 * v.point_count * sizeof(double)) ==
          0);
    sf_refinement_destroy(without);
    sf_refinement_destroy(r);
    test_cage_free(&plain);
    test_cage_free(&c);
}

static void indices_that_agree_change_nothing(void)
{
    test_cage c = test_cage_wheel(5, 2, 0);
    c.values = calloc(c.points, sizeof *c.values);
    for (size_t i = 0; i < c.points; i++) {
        c.values[i] = test_random_unit();
    }
    sf_refinement *plain = refine(&c, 2, SF_REFINE_STANDARD);
    c.indices = malloc(8 * c.cells * sizeof *c.indices);
    memcpy(c.indices, c.corners, 8 * c.cells * sizeof *c.indices);
    c.value_count = c.points;
    sf_refinement *indexed = refine(&c, 2, SF_REFINE_STANDARD);
    sf_cage_view a = view_of(plain, 2), b = view_of(indexed, 2);
    CHECK(b.channels[0].indices == NULL && b.channels[0].value_count == b.point_count);
    CHECK(memcmp(a.channels[0].values, b.channels[0].values, a.point_count * sizeof(double)) == 0);
    sf_refinement_destroy(plain);
    sf_refinement_destroy(indexed);
    test_cage_free(&c);
}

// ---------------------------------------------------------------------------------------------
// Calls
// ---------------------------------------------------------------------------------------------

static void an_update_is_a_refinement_made_anew(void)
{
    test_cage c = mixed(3);
    c.values = calloc(c.points, sizeof *c.values);
    sf_refinement *r = refine(&c, 2, SF_REFINE_STANDARD);
    for (size_t i = 0; i < 3 * c.points; i++) {
        c.positions[i] += 0.1 * test_random_unit();
        c.values[i / 3] = test_random_unit();
    }
    CHECK_EQ(sf_refinement_update_positions(r, c.positions, NULL), SF_OK);
    CHECK_EQ(sf_refinement_update_values(r, 0, c.values, NULL), SF_OK);
    sf_refinement *anew = refine(&c, 2, SF_REFINE_STANDARD);
    for (uint32_t step = 0; step <= 2; step++) {
        sf_cage_view a = view_of(r, step), b = view_of(anew, step);
        CHECK(memcmp(a.positions, b.positions, 3 * a.point_count * sizeof(double)) == 0);
        CHECK(memcmp(a.channels[0].values, b.channels[0].values, a.point_count * sizeof(double)) ==
              0);
    }
    c.values[0] = -1;
    c.positions[0] = NAN;
    CHECK_EQ(sf_refinement_update_values(r, 0, c.values, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_refinement_update_values(r, 1, c.values, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_refinement_update_positions(r, c.positions, NULL), SF_ERR_ARGUMENT);
    CHECK(view_of(r, 0).channels[0].values[0] != -1);
    sf_refinement_destroy(anew);
    sf_refinement_destroy(r);
    test_cage_free(&c);
}

static void refined_once_twice_is_refined_twice(void)
{
    test_cage c = mixed(5);
    sf_refinement *twice = refine(&c, 2, SF_REFINE_STANDARD);
    sf_cage_view half = view_of(twice, 1), whole = view_of(twice, 2);
    sf_cage *cage = NULL;
    sf_refinement *once = NULL;
    CHECK_EQ(sf_cage_create(&half, NULL, &cage, NULL), SF_OK);
    CHECK_EQ(sf_refine(cage, NULL, NULL, NULL, &once), SF_OK);
    sf_cage_view again = view_of(once, 1);
    CHECK_EQ(again.point_count, whole.point_count);
    CHECK_EQ(again.cell_count, whole.cell_count);
    CHECK_EQ(again.crease_count, whole.crease_count);
    // Points are numbered by edges and faces, in an order of their own: cells are compared.
    for (size_t i = 0; i < 8 * whole.cell_count; i++) {
        for (uint32_t axis = 0; axis < 3; axis++) {
            CHECK_NEAR(again.positions[3 * again.corners[i] + axis],
                       whole.positions[3 * whole.corners[i] + axis], 1e-14);
        }
    }
    sf_refinement_destroy(once);
    sf_cage_destroy(cage);
    sf_refinement_destroy(twice);
    test_cage_free(&c);
}

static void what_cannot_be_asked_is_refused(void)
{
    test_cage c = test_cage_block(1, 1, 1);
    sf_cage *cage = test_cage_make(&c);
    sf_refinement *r = NULL;
    sf_refine_options options = sf_refine_options_default();
    options.steps = 0;
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_ERR_ARGUMENT);
    options.steps = SF_REFINE_STEP_MAX + 1;
    CHECK_EQ(sf_refine(cage, &options, NULL, NULL, &r), SF_ERR_ARGUMENT);
    options.steps = SF_REFINE_STEP_MAX; // 2^36 cells
    CHECK_EQ(sf_refine(NULL, NULL, NULL, NULL, &r), SF_ERR_ARGUMENT);
    sf_task task = sf_task_default();
    sf_task_cancel(&task);
    CHECK_EQ(sf_refine(cage, &options, NULL, &task, &r), SF_ERR_CANCELLED);
    CHECK(r == NULL);
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

static void without_memory_there_is_no_refinement(void)
{
    test_cage c = mixed(4);
    c.value_count = 2;
    c.values = calloc(2, sizeof *c.values);
    c.indices = calloc(8 * c.cells, sizeof *c.indices);
    c.indices[3] = 1;
    sf_cage *cage = test_cage_make(&c);
    sf_refine_options options = sf_refine_options_default();
    options.steps = 2;
    for (long k = 0;; k++) {
        failing_allocator memory;
        failing_begin(&memory, k);
        sf_refinement *r = NULL;
        sf_status status = sf_refine(cage, &options, &memory.allocator, NULL, &r);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && r == NULL));
        sf_refinement_destroy(r);
        CHECK(memory.live == 0 && memory.faults == 0);
        if (status == SF_OK) {
            CHECK(k > 50);
            break;
        }
    }
    sf_cage_destroy(cage);
    test_cage_free(&c);
}

int main(void)
{
    TEST(regular_blocks_are_refined_as_splines);
    TEST(separable_rules_are_a_surface_times_a_curve);
    TEST(weights_sum_to_1_and_are_none_below_0);
    TEST(what_is_constant_stays_so_to_the_bit);
    TEST(the_outside_does_not_depend_on_the_inside);
    TEST(a_property_jumps_where_neighbours_disagree);
    TEST(indices_that_agree_change_nothing);
    TEST(an_update_is_a_refinement_made_anew);
    TEST(refined_once_twice_is_refined_twice);
    TEST(what_cannot_be_asked_is_refused);
    TEST(without_memory_there_is_no_refinement);
    return test_finish();
}
