// SPDX-License-Identifier: MIT
// Why: who turns handles by hand calls rounds one by one, and builds on what each promises: a round
// that fails leaves the shape as it was, the last one too (TRUST 85); what is asked beyond the edge
// of what can be asked, or off a table's edge, gets an answer; and figures mean what they say.

#include "failing_allocator.h"
#include "standing.h"
#include "unit/mesh/shapes.h"

#define DEGREE 0.017453292519943295

static shape s; // too large for the stack

static sf_stand *make_with(const sf_stand_options *o, const sf_stance_options *stance,
                           const sf_allocator *allocator)
{
    sf_handle handles[3];
    sf_stand *stand = NULL;
    sf_mesh *mesh = bottle(0.3);
    CHECK_EQ(sf_stand_create(sf_mesh_get_view(mesh), stance, 1, handles, handles_of(0.3, handles),
                             o, allocator, NULL, &stand, NULL),
             SF_OK);
    sf_mesh_destroy(mesh);
    return stand;
}

static int is_same(const sf_stand *a, const sf_stand *b)
{
    sf_mesh_view u = sf_stand_outer(a), v = sf_stand_outer(b);
    sf_stand_report r = sf_stand_describe(a), t = sf_stand_describe(b);
    return memcmp(u.vertices, v.vertices, 24 * u.vertex_count) == 0 && r.rounds == t.rounds &&
           r.ended == t.ended && r.margin_rad == t.margin_rad && r.energy == t.energy &&
           (sf_stand_grid(a) == NULL) == (sf_stand_grid(b) == NULL);
}

// The first round is the last here, with the carving at the end behind it.
static void a_last_round_that_fails_changes_nothing(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    failing_allocator failing;
    o.pitch_mm = 3;
    o.rounds_max = 1;
    sf_stand *untouched = make_with(&o, &stance, NULL), *whole = make_with(&o, &stance, NULL);
    CHECK_EQ(sf_stand_round(whole, NULL, NULL), SF_OK);
    CHECK_EQ(sf_stand_describe(whole).ended, 1);
    sf_status status = SF_ERR_MEMORY;
    for (long k = 0; status == SF_ERR_MEMORY && k < 100000; k += 1 + k / 16) {
        sf_stand_report report;
        memset(&report, 0x5a, sizeof report);
        failing_begin(&failing, -1);
        sf_stand *stand = make_with(&o, &stance, &failing.allocator);
        failing.fail_at = failing.requests + k;
        status = sf_stand_round(stand, NULL, &report);
        CHECK(status == SF_OK || (status == SF_ERR_MEMORY && is_same(stand, untouched) &&
                                  report.rounds == 0x5a5a5a5a));
        failing.fail_at = -1;
        CHECK_EQ(sf_stand_round(stand, NULL, NULL), SF_OK);
        CHECK(is_same(stand, whole));
        sf_stand_destroy(stand);
        CHECK(failing.live == 0 && failing.faults == 0);
    }
    CHECK_EQ(status, SF_OK);
    sf_stand_destroy(untouched);
    sf_stand_destroy(whole);
}

static void no_other_handle_is_touched(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_pose pose = sf_pose_identity(), moved = pose;
    const size_t none[] = {3, 4, SIZE_MAX, SIZE_MAX - 1, SIZE_MAX / sizeof pose + 1};
    moved.shift_mm[0] = 1;
    sf_stand *stand = make_with(&o, &stance, NULL);
    for (size_t i = 0; i < sizeof none / sizeof none[0]; i++) {
        CHECK_EQ(sf_stand_set_pose(stand, none[i], &moved, 0), SF_ERR_ARGUMENT);
        sf_pose got = sf_stand_get_pose(stand, none[i]);
        CHECK(memcmp(&got, &pose, sizeof got) == 0);
    }
    sf_stand_destroy(stand);
    o.deform = 0;
    stand = make_with(&o, &stance, NULL);
    CHECK_EQ(sf_stand_set_pose(stand, 0, &moved, 0), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_stand_set_pose(stand, SIZE_MAX, &moved, 0), SF_ERR_ARGUMENT);
    sf_stand_destroy(stand);
}

// 80 degrees are the most that a stance may ask for; the reserve does not ask for more.
static void the_steepest_tilt_can_be_asked_for(void)
{
    sf_stand_options o = options_of(0, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    o.pitch_mm = 3;
    stance.gamma_rad = 80 * DEGREE;
    sf_stand *stand = make_with(&o, &stance, NULL);
    CHECK(stand != NULL);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    CHECK(!sf_stand_describe(stand).safe);
    sf_stand_destroy(stand);
}

// A toy that lies on the edge of a table and reaches below it, its weight far down under what it
// lies on: nothing tips it over, and no bound may say that something does.
static void off_the_edge_of_a_table(void)
{
    static const double toy[3][2][3] = {
        {{0, 0, 0}, {10, 10, 3}}, {{9, 0, -40}, {13, 10, 3}}, {{-8, 0, -52}, {13, 10, -39}}};
    sf_stand_options o = options_of(0, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_stand *stand = NULL;
    s.vertex_count = s.triangle_count = 0;
    for (int i = 0; i < 3; i++) {
        shape_box(&s, toy[i][0], toy[i][1], 0);
    }
    stance.region_low_mm[2] = -1;
    o.pitch_mm = 1.3;
    CHECK_EQ(sf_stand_create(shape_view(&s), &stance, 1, NULL, 0, &o, NULL, NULL, &stand, NULL),
             SF_OK);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    sf_stand_report r = sf_stand_describe(stand);
    CHECK(r.com_mm[2] < -20 && r.com_mm[0] > 0 && r.com_mm[0] < 10);
    CHECK_NEAR(r.margin_rad, 90 * DEGREE, 1e-12);
    CHECK(r.stands && r.bound_rad >= r.margin_rad);
    sf_stand_destroy(stand);
}

// A plate with a lip that dips a little below the table: it stands as well as any plate, there is a
// bound, and that is no lower than what it does.
static void a_lip_over_the_edge_of_a_table(void)
{
    static const double plate[2][2][3] = {{{0, 0, 0}, {30, 30, 4}}, {{29, 10, -1}, {31, 13, 4}}};
    sf_stand_options o = options_of(0, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_stand *stand = NULL;
    s.vertex_count = s.triangle_count = 0;
    for (int i = 0; i < 2; i++) {
        shape_box(&s, plate[i][0], plate[i][1], 0);
    }
    stance.region_low_mm[2] = -0.5;
    stance.gamma_rad = 80 * DEGREE;
    CHECK_EQ(sf_stand_create(shape_view(&s), &stance, 1, NULL, 0, &o, NULL, NULL, &stand, NULL),
             SF_OK);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    sf_stand_report r = sf_stand_describe(stand);
    CHECK(r.margin_rad > 75 * DEGREE);
    CHECK(r.bound_rad >= r.margin_rad - 1e-6 && r.bound_rad < 89 * DEGREE);
    sf_stand_destroy(stand);
}

// The bound speaks of the shape as it was given: where a handle was turned first, of nothing.
static void a_bound_is_of_the_shape_as_given(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_pose pose = sf_pose_identity();
    o.pitch_mm = 2;
    sf_stand *stand = make_with(&o, &stance, NULL);
    CHECK_EQ(sf_stand_round(stand, NULL, NULL), SF_OK);
    double bound = sf_stand_describe(stand).bound_rad;
    CHECK(bound < 45 * DEGREE);
    sf_stand_destroy(stand);
    stand = make_with(&o, &stance, NULL);
    CHECK_EQ(sf_stand_set_pose(stand, 2, &pose, 0), SF_OK); // where it is
    CHECK_EQ(sf_stand_round(stand, NULL, NULL), SF_OK);
    CHECK_NEAR(sf_stand_describe(stand).bound_rad, bound, 0);
    sf_stand_destroy(stand);
    stand = make_with(&o, &stance, NULL);
    pose.shift_mm[0] = -6;
    CHECK_EQ(sf_stand_set_pose(stand, 2, &pose, 1), SF_OK);
    CHECK_EQ(sf_stand_round(stand, NULL, NULL), SF_OK);
    CHECK_NEAR(sf_stand_describe(stand).bound_rad, 90 * DEGREE, 1e-12);
    sf_stand_destroy(stand);
}

// Files hold vertices that no triangle uses. They stand nowhere, weigh nothing, and bend nothing:
// all is as it is without them, and they stay where they are.
static void vertices_of_no_triangle_do_not_count(void)
{
    static const double strays[3][3] = {{0, 0, -500}, {200, 0, -0.5}, {30, 0, 2}};
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_handle handles[3];
    size_t count = handles_of(0.3, handles);
    o.pitch_mm = 2;
    sf_stand *whole = make_with(&o, &stance, NULL), *stand = NULL;
    sf_mesh *mesh = bottle(0.3), *more = NULL;
    sf_mesh_view view = sf_mesh_get_view(mesh);
    CHECK_EQ(sf_mesh_create(NULL, &more), SF_OK);
    CHECK_EQ(sf_mesh_add_vertices(more, strays[0], 1), SF_OK); // before all others, and after
    CHECK_EQ(sf_mesh_add_vertices(more, view.vertices, view.vertex_count), SF_OK);
    CHECK_EQ(sf_mesh_add_vertices(more, strays[1], 2), SF_OK);
    for (size_t t = 0; t < view.triangle_count; t++) {
        const uint32_t *c = view.triangles + 3 * t, moved[3] = {c[0] + 1, c[1] + 1, c[2] + 1};
        CHECK_EQ(sf_mesh_add_triangles(more, moved, 1), SF_OK);
    }
    CHECK_EQ(sf_stand_create(sf_mesh_get_view(more), &stance, 1, handles, count, &o, NULL, NULL,
                             &stand, NULL),
             SF_OK);
    CHECK_EQ(sf_stand_run(whole, NULL, NULL), SF_OK);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    sf_stand_report r = sf_stand_describe(stand), q = sf_stand_describe(whole);
    CHECK(r.succeeded && q.succeeded && r.sunk_mm == q.sunk_mm && r.energy == q.energy);
    CHECK(r.displacement_mm > 1 && r.displacement_mm == q.displacement_mm);
    const double *now = sf_stand_outer(stand).vertices;
    CHECK(memcmp(now + 3, sf_stand_outer(whole).vertices, 24 * view.vertex_count) == 0);
    CHECK(memcmp(now, strays[0], 24) == 0);
    CHECK(memcmp(now + 3 * (view.vertex_count + 1), strays[1], 48) == 0);
    sf_stand_destroy(whole);
    sf_stand_destroy(stand);
    sf_mesh_destroy(mesh);
    sf_mesh_destroy(more);
}

// Masses belong to the shape: what becomes of the caller's array does not matter.
static void masses_are_kept(void)
{
    sf_ballast magnets[2] = {{3000, {-3, 0, 2}}, {3000, {-3, 0, 3}}};
    sf_stand_options o = options_of(0, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    o.pitch_mm = 2;
    o.ballast = magnets;
    o.ballast_count = 2;
    sf_stand *kept = make_with(&o, &stance, NULL), *stand = make_with(&o, &stance, NULL);
    CHECK_EQ(sf_stand_run(kept, NULL, NULL), SF_OK);
    memset(magnets, 0xff, sizeof magnets);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    CHECK(is_same(stand, kept));
    sf_stand_destroy(kept);
    sf_stand_destroy(stand);
}

// Far beyond what squares and cubes of lengths can hold, the unit is wrong, and that is said.
static void too_large_is_said_to_be(void)
{
    const double sizes[] = {2e12, 1e120, 1e200, 1e308};
    for (int i = 0; i < 4; i++) {
        double r = sizes[i];
        const double low[3] = {-r, -r, -r}, high[3] = {r, r, r};
        sf_stance_options stance = sf_stance_options_default();
        sf_fault fault = {SF_OK, 0, 0, ""};
        sf_stand *stand = NULL;
        s.vertex_count = s.triangle_count = 0;
        shape_box(&s, low, high, 0);
        CHECK_EQ(
            sf_stand_create(shape_view(&s), &stance, 1, NULL, 0, NULL, NULL, NULL, &stand, &fault),
            SF_ERR_OVERFLOW);
        CHECK(stand == NULL && strstr(fault.message, "units") != NULL);
    }
}

int main(void)
{
    TEST(a_last_round_that_fails_changes_nothing);
    TEST(no_other_handle_is_touched);
    TEST(the_steepest_tilt_can_be_asked_for);
    TEST(off_the_edge_of_a_table);
    TEST(a_lip_over_the_edge_of_a_table);
    TEST(a_bound_is_of_the_shape_as_given);
    TEST(vertices_of_no_triangle_do_not_count);
    TEST(masses_are_kept);
    TEST(too_large_is_said_to_be);
    return test_finish();
}
