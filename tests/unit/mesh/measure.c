// SPDX-License-Identifier: MIT
// Why: mass properties are what balance will stand on; they must agree with closed forms, move with
// the mesh, and keep their digits far from the origin.

#include "shapes.h"
#include "test.h"

static shape s;

static void a_box_has_its_textbook_values(void)
{
    memset(&s, 0, sizeof s);
    double low[3] = {1, 2, 3}, high[3] = {3, 7, 11};
    shape_box(&s, low, high, 0);
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(shape_view(&s), &mass), SF_OK);
    CHECK_NEAR(mass.volume_mm3, 80, 1e-12);
    CHECK_NEAR(mass.area_mm2, 2 * (10 + 16 + 40), 1e-12);
    CHECK_NEAR(mass.com_mm[0], 2, 1e-13);
    CHECK_NEAR(mass.com_mm[1], 4.5, 1e-13);
    CHECK_NEAR(mass.com_mm[2], 7, 1e-13);
    CHECK_NEAR(mass.inertia_mm5[0], 80.0 / 12 * (25 + 64), 1e-10);
    CHECK_NEAR(mass.inertia_mm5[1], 80.0 / 12 * (4 + 64), 1e-10);
    CHECK_NEAR(mass.inertia_mm5[2], 80.0 / 12 * (4 + 25), 1e-10);
    for (int k = 3; k < 6; k++) {
        CHECK_NEAR(mass.inertia_mm5[k], 0, 1e-10);
    }
}

static void an_inverted_box_has_negative_volume(void)
{
    memset(&s, 0, sizeof s);
    double low[3] = {-1, -1, -1}, high[3] = {1, 1, 1};
    shape_box(&s, low, high, 1);
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(shape_view(&s), &mass), SF_OK);
    CHECK_NEAR(mass.volume_mm3, -8, 1e-13);
    CHECK_NEAR(mass.com_mm[0], 0, 1e-13);
}

static void a_fine_sphere_nears_the_ball(void)
{
    memset(&s, 0, sizeof s);
    double centre[3] = {1e6, -2e6, 3e6};
    shape_sphere(&s, centre, 10, 100);
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(shape_view(&s), &mass), SF_OK);
    double ball = 4.0 / 3 * 3.14159265358979 * 1000;
    CHECK_NEAR(mass.volume_mm3, ball, 2e-3 * ball);
    CHECK_NEAR(mass.com_mm[0], 1e6, 1e-7);
    CHECK_NEAR(mass.com_mm[1], -2e6, 1e-7);
    CHECK_NEAR(mass.com_mm[2], 3e6, 1e-7);
    CHECK_NEAR(mass.inertia_mm5[0], 0.4 * ball * 100, 4e-3 * 0.4 * ball * 100);
    CHECK_NEAR(mass.inertia_mm5[3], 0, 1e-3);
}

// A tetrahedron with the products of inertia known by direct integration: xy over the unit corner
// tetrahedron is 1/120, the centre of mass (1/4, 1/4, 1/4), volume 1/6.
static void products_of_inertia_have_the_right_sign(void)
{
    memset(&s, 0, sizeof s);
    shape_vertex(&s, 0, 0, 0);
    shape_vertex(&s, 1, 0, 0);
    shape_vertex(&s, 0, 1, 0);
    shape_vertex(&s, 0, 0, 1);
    shape_triangle(&s, 0, 2, 1);
    shape_triangle(&s, 0, 1, 3);
    shape_triangle(&s, 0, 3, 2);
    shape_triangle(&s, 1, 2, 3);
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(shape_view(&s), &mass), SF_OK);
    CHECK_NEAR(mass.volume_mm3, 1.0 / 6, 1e-15);
    CHECK_NEAR(mass.com_mm[2], 0.25, 1e-15);
    CHECK_NEAR(mass.inertia_mm5[3], -(1.0 / 120 - 1.0 / 6 / 16), 1e-15);
    CHECK_NEAR(mass.inertia_mm5[0], 2 * (1.0 / 60 - 1.0 / 6 / 16), 1e-15);
}

int main(void)
{
    TEST(a_box_has_its_textbook_values);
    TEST(an_inverted_box_has_negative_volume);
    TEST(a_fine_sphere_nears_the_ball);
    TEST(products_of_inertia_have_the_right_sign);
    return test_finish();
}
