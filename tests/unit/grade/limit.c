// SPDX-License-Identifier: MIT
// Why: the shape at a place is worked out from kinds of neighbourhoods and their matrices, none of
// which anybody sees. Here the shape is found the plain way: the cells around a place are cut out
// of the cage, refined by one step as a cage of their own, and so on thirty times, until what is
// left is a point. Promises: both agree within 1e-6 of the cage, for solids and surfaces, creases,
// wedges and jumps; derivatives are those of differences; corners have the weights of the known
// formulas; a regular lattice is mapped to itself; what is constant stays so.

#include "limits.h"
#include "plain.h"

static void compare(const test_cage *c, sf_refine_rules rules, int places, double *worst)
{
    sf_limit *limit = limit_of(c, rules);
    sf_cage *cage = test_cage_make(c);
    for (int i = 0; i < places; i++) {
        sf_place place = random_place(limit);
        double expected[4], position[3], value = NAN;
        plain(cage, rules, place, 34, expected);
        CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, position, NULL), SF_OK);
        CHECK_EQ(sf_limit_values(limit, 0, 1, &place, NULL, NULL, &value, NULL), SF_OK);
        for (int axis = 0; axis < 3; axis++) {
            *worst = fmax(*worst, fabs(position[axis] - expected[axis]));
        }
        *worst = fmax(*worst, fabs(value - expected[3]));
    }
    sf_cage_destroy(cage);
    sf_limit_destroy(limit);
}

static void solids_are_what_refinement_tends_to(void)
{
    double worst = 0;
    for (int kind = 0; kind < KINDS; kind++) {
        test_cage c = kind_of(kind);
        compare(&c, SF_REFINE_STANDARD, 12, &worst);
        if (kind < 5) {
            compare(&c, SF_REFINE_SEPARABLE, 4, &worst);
        }
        test_cage_free(&c);
    }
    printf("# at most %.2g apart, of cages of size 1 to 3\n", worst);
    CHECK(worst < 1e-6);
}

// A pentagon fan and a strip, with an edge that is sharp for a while.
static void surfaces_are_what_refinement_tends_to(void)
{
    double worst = 0;
    for (uint32_t n = 3; n < 7; n++) {
        test_cage wheel = test_cage_wheel(n, 1, 0.2), c = test_cage_begin(2, 2 * n + 1, n, 4);
        memcpy(c.positions, wheel.positions, 3 * c.points * sizeof *c.positions);
        for (size_t i = 0; i < n; i++) {
            memcpy(c.corners + 4 * i, wheel.corners + 8 * i, 4 * sizeof *c.corners);
        }
        c.values = calloc(c.points, sizeof *c.values);
        for (size_t i = 0; i < c.points; i++) {
            c.values[i] = test_random_unit();
        }
        sf_crease crease = {{0, 1}, n - 2.5};
        c.crease[0] = crease;
        c.creases = n % 2;
        c.sharp[0].point = 2; // a corner of the border
        c.sharp[0].sharpness = SF_SHARP;
        c.sharps = 1;
        compare(&c, SF_REFINE_STANDARD, 12, &worst);
        test_cage_free(&wheel);
        test_cage_free(&c);
    }
    printf("# at most %.2g apart, of cages of size 3\n", worst);
    CHECK(worst < 1e-6);
}

// ---------------------------------------------------------------------------------------------
// What is known
// ---------------------------------------------------------------------------------------------

static void derivatives_are_those_of_differences(void)
{
    const double h = 1e-5;
    for (int kind = 0; kind < KINDS; kind++) {
        test_cage c = kind_of(kind);
        sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
        for (int i = 0; i < 40; i++) {
            sf_place place = random_place(limit), ends[2];
            double at[3], d[9], value, slope[3], p[6], v[2];
            for (int axis = 0; axis < 3; axis++) { // away from what is irregular
                place.u[axis] = 0.1 + 0.8 * test_random_unit();
            }
            CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, at, d), SF_OK);
            CHECK_EQ(sf_limit_values(limit, 0, 1, &place, NULL, NULL, &value, slope), SF_OK);
            for (int axis = 0; axis < 3; axis++) {
                ends[0] = ends[1] = place;
                ends[0].u[axis] -= h;
                ends[1].u[axis] += h;
                CHECK_EQ(sf_limit_positions(limit, 2, ends, NULL, NULL, p, NULL), SF_OK);
                CHECK_EQ(sf_limit_values(limit, 0, 2, ends, NULL, NULL, v, NULL), SF_OK);
                for (int x = 0; x < 3; x++) {
                    CHECK_NEAR(d[3 * x + axis], (p[3 + x] - p[x]) / (2 * h), 1e-7);
                }
                CHECK_NEAR(slope[axis], (v[1] - v[0]) / (2 * h), 1e-7);
            }
        }
        sf_limit_destroy(limit);
        test_cage_free(&c);
    }
}

// The limit of the point in the middle of a wheel of n faces, after Halstead, Kass and DeRose.
static void corners_have_the_weights_of_the_known_formula(void)
{
    for (uint32_t n = 3; n < 12; n++) {
        test_cage wheel = test_cage_wheel(n, 1, 0.3), c = test_cage_begin(2, 2 * n + 1, n, 4);
        memcpy(c.positions, wheel.positions, 3 * c.points * sizeof *c.positions);
        for (size_t i = 0; i < n; i++) {
            memcpy(c.corners + 4 * i, wheel.corners + 8 * i, 4 * sizeof *c.corners);
        }
        sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
        double expected[3] = {0, 0, 0}, found[3];
        for (uint32_t axis = 0; axis < 3; axis++) {
            for (uint32_t k = 1; k <= 2 * n; k++) { // edge points have odd numbers
                expected[axis] += (k % 2 ? 4 : 1) * c.positions[3 * k + axis];
            }
            expected[axis] = (expected[axis] + n * n * c.positions[axis]) / (n * (n + 5.0));
        }
        sf_place place = {0, {0, 0, 0}};
        CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, found, NULL), SF_OK);
        for (uint32_t axis = 0; axis < 3; axis++) {
            CHECK_NEAR(found[axis], expected[axis], 1e-12);
        }
        sf_limit_destroy(limit);
        test_cage_free(&wheel);
        test_cage_free(&c);
    }
}

// At a cube's corner three faces meet: (9 V + 4 sum of E + sum of F) / 24.
static void a_cube_comes_to_its_known_corner(void)
{
    test_cage c = test_cage_block(1, 1, 1);
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    static const double first[3] = {0, 0, 0}, last[3] = {1, 1, 1};
    const double corner = (4.0 * 1 + 1 * 2) / 24; // of three E one lies at 1, of three F two
    sf_place places[2];
    double p[6];
    CHECK_EQ(sf_limit_place(limit, 0, first, &places[0]), SF_OK);
    CHECK_EQ(sf_limit_place(limit, 0, last, &places[1]), SF_OK);
    CHECK_EQ(sf_limit_positions(limit, 2, places, NULL, NULL, p, NULL), SF_OK);
    for (int i = 0; i < 6; i++) {
        CHECK_NEAR(p[i], i < 3 ? corner : 1 - corner, 1e-12);
    }
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

static void a_lattice_is_mapped_to_itself(void)
{
    test_cage c = test_cage_block(5, 5, 5);
    sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
    for (int i = 0; i < 200; i++) {
        double u[3], p[3], d[9];
        sf_place place;
        for (int axis = 0; axis < 3; axis++) {
            u[axis] = test_random_unit();
        }
        CHECK_EQ(sf_limit_place(limit, 2 + 5 * (2 + 5 * 2), u, &place), SF_OK); // the middle
        CHECK_EQ(sf_limit_positions(limit, 1, &place, NULL, NULL, p, d), SF_OK);
        for (int axis = 0; axis < 3; axis++) {
            CHECK_NEAR(p[axis], 2 + u[axis], 1e-14);
            for (int other = 0; other < 3; other++) {
                CHECK_NEAR(d[3 * axis + other], axis == other ? 0.5 : 0, 1e-13); // half a cell
            }
        }
    }
    sf_limit_destroy(limit);
    test_cage_free(&c);
}

// The sides of a solid are the surface that its boundary makes by itself.
static void the_boundary_is_a_surface_of_its_own(void)
{
    static const uint32_t sides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                         {1, 3, 7, 5}, {3, 2, 6, 7}, {2, 0, 4, 6}};
    test_cage solid = test_cage_block(1, 1, 1), skin = test_cage_begin(2, 8, 6, 4);
    for (size_t i = 0; i < 24; i++) {
        solid.positions[i] += 0.3 * test_random_unit();
    }
    memcpy(skin.positions, solid.positions, 24 * sizeof(double));
    memcpy(skin.corners, sides, sizeof sides);
    sf_limit *a = limit_of(&solid, SF_REFINE_STANDARD), *b = limit_of(&skin, SF_REFINE_STANDARD);
    for (int i = 0; i < 50; i++) {
        double u = test_random_unit(), v = test_random_unit(), p[3], q[3];
        double below[3] = {u, v, 0}, flat[3] = {v, u, 7}; // the first side's axes are y and x
        sf_place x, y;
        CHECK_EQ(sf_limit_place(a, 0, below, &x), SF_OK);
        CHECK_EQ(sf_limit_place(b, 0, flat, &y), SF_OK);
        CHECK_EQ(sf_limit_positions(a, 1, &x, NULL, NULL, p, NULL), SF_OK);
        CHECK_EQ(sf_limit_positions(b, 1, &y, NULL, NULL, q, NULL), SF_OK);
        for (int axis = 0; axis < 3; axis++) {
            CHECK_NEAR(p[axis], q[axis], 1e-12);
        }
    }
    sf_limit_destroy(a);
    sf_limit_destroy(b);
    test_cage_free(&solid);
    test_cage_free(&skin);
}

static void each_side_of_a_jump_has_its_value(void)
{
    for (int kind = 0; kind < 5; kind++) {
        test_cage c = kind_of(kind);
        c.value_count = 2;
        c.values[0] = 0.1;
        c.values[1] = 0.7;
        c.indices = calloc(8 * c.cells, sizeof *c.indices);
        for (size_t i = 0; i < 8 * c.cells; i++) {
            c.indices[i] = i / 8 >= c.cells / 3; // the lower third, and the rest
        }
        sf_limit *limit = limit_of(&c, SF_REFINE_STANDARD);
        for (int i = 0; i < 100; i++) {
            sf_place place = random_place(limit);
            double value = NAN;
            CHECK_EQ(sf_limit_values(limit, 0, 1, &place, NULL, NULL, &value, NULL), SF_OK);
            CHECK(value == c.values[place.piece / 8 >= c.cells / 3]);
        }
        sf_limit_destroy(limit);
        test_cage_free(&c);
    }
}

int main(void)
{
    TEST(solids_are_what_refinement_tends_to);
    TEST(surfaces_are_what_refinement_tends_to);
    TEST(derivatives_are_those_of_differences);
    TEST(corners_have_the_weights_of_the_known_formula);
    TEST(a_cube_comes_to_its_known_corner);
    TEST(a_lattice_is_mapped_to_itself);
    TEST(the_boundary_is_a_surface_of_its_own);
    TEST(each_side_of_a_jump_has_its_value);
    return test_finish();
}
