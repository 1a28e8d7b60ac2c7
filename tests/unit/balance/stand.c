// SPDX-License-Identifier: MIT
// Why: this is what a person wants: a model that fell stands. Nothing here is taken from the
// library's own report: from the two meshes that come out, the weight, the tilt that is survived,
// the thickness of the wall and what touches the ground are computed again, from their definitions.

#include "backwards.h"
#include "judge.h"
#include "standing.h"

#define DEGREE 0.017453292519943295

static const double middle_mm[3] = {0, 0, 24};

// --- From the definitions ------------------------------------------------------------------------

// The least tilt that makes it fall: over all directions of a fine fan, the furthest vertex on the
// ground in that direction decides.
static double margin_of(const sf_stand *stand)
{
    sf_mesh_view outer = sf_stand_outer(stand);
    double com[3], least = 1e9;
    judge_com(sf_stand_outer(stand), sf_stand_cavity(stand), com);
    for (int i = 0; i < 3600; i++) {
        double angle = i * 6.283185307179586 / 3600, furthest = -1e9;
        const double x = cos(angle), y = sin(angle);
        for (size_t v = 0; v < outer.vertex_count; v++) {
            const double *p = outer.vertices + 3 * v;
            if (p[2] < 1e-9 && x * p[0] + y * p[1] > furthest) {
                furthest = x * p[0] + y * p[1];
            }
        }
        least = fmin(least, atan2(furthest - (x * com[0] + y * com[1]), com[2]));
    }
    return least;
}

static void check_standing(const sf_stand *stand, double gamma, double wall_mm)
{
    sf_stand_report r = sf_stand_describe(stand);
    double com[3], sums[4] = {0, 0, 0, 0};
    sf_topology topology;
    sf_mesh_view cavity = sf_stand_cavity(stand);
    CHECK(r.ended && r.safe && r.stands && r.folded == 0 && r.overlap_voxels == 0);
    CHECK(margin_of(stand) >= gamma - 1e-4);
    CHECK_NEAR(margin_of(stand), r.margin_rad, 1e-4);
    judge_com(sf_stand_outer(stand), sf_stand_cavity(stand), com);
    for (int d = 0; d < 3; d++) {
        CHECK_NEAR(com[d], r.com_mm[d], 1e-9);
    }
    CHECK(judge_wall(sf_stand_outer(stand), sf_stand_cavity(stand), 7) >= wall_mm - 1e-9);
    CHECK_EQ(sf_mesh_analyze(cavity, NULL, &topology), SF_OK);
    CHECK(topology.closed && topology.oriented);
    judge_weight(cavity, sums);
    CHECK_NEAR(-sums[0], r.carved_mm3, 1e-6);
    CHECK(r.carved_mm3 > 0);
}

// --- Cases ---------------------------------------------------------------------------------------

static void carving_alone(void)
{
    sf_stand_options o = options_of(0, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_stand *stand = make(0.21, &o, 1, &stance);
    CHECK(sf_stand_describe(stand).margin_rad < 3 * DEGREE && margin_of(stand) < 3 * DEGREE);
    stance.gamma_rad = 3 * DEGREE;
    sf_stand_destroy(stand);
    stand = make(0.21, &o, 1, &stance);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    check_standing(stand, 3 * DEGREE, 1.2);
    CHECK_EQ(sf_stand_describe(stand).rounds, 1);
    CHECK(sf_stand_describe(stand).bound_rad > sf_stand_describe(stand).margin_rad);
    CHECK(sf_stand_describe(stand).bound_rad < 30 * DEGREE);
    // The outside is as it was handed in.
    sf_mesh *mesh = bottle(0.21);
    sf_mesh_view given = sf_mesh_get_view(mesh), now = sf_stand_outer(stand);
    CHECK(memcmp(given.vertices, now.vertices, 24 * given.vertex_count) == 0);
    CHECK(memcmp(given.triangles, now.triangles, 12 * given.triangle_count) == 0);
    sf_mesh_destroy(mesh);
    sf_stand_destroy(stand);
}

static void bending_and_carving(void)
{
    const sf_carve_mode modes[2] = {SF_CARVE_PLANE, SF_CARVE_SUPPORT_FREE};
    for (int m = 0; m < 2; m++) {
        sf_stand_options o = options_of(1, modes[m]);
        sf_stance_options stance = sf_stance_options_default();
        sf_stand *stand = make(0.35, &o, 1, &stance);
        CHECK(margin_of(stand) < -5 * DEGREE);
        CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
        check_standing(stand, 4 * DEGREE, 1.2);
        sf_stand_report r = sf_stand_describe(stand);
        CHECK(r.rounds > 1 && r.energy > 0 && r.displacement_mm > 1);
        CHECK(modes[m] == SF_CARVE_PLANE || r.hanging_voxels == 0);
        // The foot is where it was, and nothing else comes near the ground.
        sf_mesh_view now = sf_stand_outer(stand);
        for (size_t v = 0; v < now.vertex_count; v++) {
            int foot = v < BOTTLE_AROUND || v == BOTTLE_RINGS * BOTTLE_AROUND;
            CHECK(foot ? fabs(now.vertices[3 * v + 2]) < 1e-12 : now.vertices[3 * v + 2] > 0.4);
        }
        sf_stand_destroy(stand);
    }
}

static void without_carving(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    o.carve = 0;
    sf_stand *stand = make(0.35, &o, 1, &stance);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    CHECK(sf_stand_describe(stand).safe && margin_of(stand) >= 4 * DEGREE - 1e-4);
    CHECK_EQ(sf_stand_cavity(stand).triangle_count, 0);
    CHECK(sf_stand_describe(stand).carved_mm3 == 0 &&
          !signbit(sf_stand_describe(stand).carved_mm3));
    sf_stand_destroy(stand);
}

// Where the bound says that no carving will do, none does; and where all is asked for, carving
// comes close to it.
static void carving_keeps_to_its_bound(void)
{
    const double leans[] = {0.1, 0.2, 0.3, 0.4};
    for (int i = 0; i < 4; i++) {
        sf_stand_options o = options_of(0, i % 2 == 0 ? SF_CARVE_PLANE : SF_CARVE_SUPPORT_FREE);
        sf_stance_options stance = sf_stance_options_default();
        stance.gamma_rad = 60 * DEGREE;
        sf_stand *stand = make(leans[i], &o, 1, &stance);
        CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
        sf_stand_report r = sf_stand_describe(stand);
        CHECK(!r.safe && r.margin_rad <= r.bound_rad + 1e-3);
        CHECK(r.margin_rad > r.bound_rad - 3 * DEGREE && r.margin_rad >= r.margin_before_rad);
        sf_stand_destroy(stand);
    }
}

// A mass low on the far side does for a bottle what bending would.
static void ballast_counts(void)
{
    sf_ballast magnet = {6000, {-3, 0, 2}};
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    o.carve = 0;
    o.ballast = &magnet;
    o.ballast_count = 1;
    sf_stand *stand = make(0.2, &o, 1, &stance);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    sf_stand_report r = sf_stand_describe(stand);
    CHECK(r.safe && r.rounds == 1 && r.displacement_mm < 1e-9);
    sf_stand_destroy(stand);
}

// What is denser below the middle.
static double heavy_below(void *user, const double p_mm[3])
{
    const double *middle = user;
    return p_mm[2] < middle[2] - 12 ? 6 : 1;
}

static void density_counts(void)
{
    sf_stance_options stance = sf_stance_options_default();
    double energies[2];
    for (int heavy = 0; heavy < 2; heavy++) {
        sf_stand_options o = options_of(1, SF_CARVE_PLANE);
        double middle[3];
        memcpy(middle, middle_mm, sizeof middle);
        o.carve = 0;
        o.density = heavy ? heavy_below : NULL;
        o.density_user = middle;
        sf_stand *stand = make(0.35, &o, 1, &stance);
        CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
        CHECK(sf_stand_describe(stand).safe);
        energies[heavy] = sf_stand_describe(stand).energy;
        sf_stand_destroy(stand);
    }
    CHECK(energies[1] < 0.5 * energies[0]);
}

// Standing on its foot, and hanging from its neck with the neck up.
static void two_stances_at_once(void)
{
    sf_stance_options stances[2] = {sf_stance_options_default(), sf_stance_options_default()};
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    stances[1].kind = SF_STANCE_HANG;
    stances[1].tolerance_rad = 2 * DEGREE;
    stances[1].point_mm[0] = 0.06 * BOTTLE_HEIGHT;
    stances[1].point_mm[2] = BOTTLE_HEIGHT;
    sf_stand *stand = make(0.06, &o, 2, stances);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    sf_stand_report r = sf_stand_describe(stand);
    CHECK(r.succeeded && r.safe && margin_of(stand) >= 4 * DEGREE - 1e-4);
    double com[3];
    judge_com(sf_stand_outer(stand), sf_stand_cavity(stand), com);
    double aside = hypot(com[0] - stances[1].point_mm[0], com[1]);
    CHECK(atan2(aside, BOTTLE_HEIGHT - com[2]) <= 2 * DEGREE + 1e-6);
    sf_stand_destroy(stand);
}

// To stand, and to hang with the head up from a point far outside: no body does both. What comes
// out must say so, and be a shape that one can still look at.
static void two_stances_that_cannot_be(void)
{
    sf_stance_options stances[2] = {sf_stance_options_default(), sf_stance_options_default()};
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    stances[1].kind = SF_STANCE_HANG;
    stances[1].point_mm[0] = 3 * BOTTLE_HEIGHT;
    stances[1].point_mm[2] = BOTTLE_HEIGHT;
    sf_stand *stand = make(0.06, &o, 2, stances);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    sf_stand_report r = sf_stand_describe(stand);
    CHECK(r.ended && !r.safe && !r.succeeded && r.folded == 0);
    for (size_t j = 0; j < 3; j++) {
        sf_pose pose = sf_stand_get_pose(stand, j);
        for (int d = 0; d < 3; d++) {
            CHECK(fabs(pose.shift_mm[d]) <= 0.5 * BOTTLE_HEIGHT * 1.1);
        }
    }
    printf("# moved by %.2f of its height, least det %.2f\n", r.displacement_mm / BOTTLE_HEIGHT,
           r.least_det);
    sf_stand_destroy(stand);
}

static void threads_change_nothing(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_SUPPORT_FREE);
    sf_stance_options stance = sf_stance_options_default();
    sf_task task = sf_task_default();
    task.parallel_for = backwards;
    sf_stand *one = make(0.3, &o, 1, &stance), *other = make(0.3, &o, 1, &stance);
    CHECK_EQ(sf_stand_run(one, NULL, NULL), SF_OK);
    CHECK_EQ(sf_stand_run(other, &task, NULL), SF_OK);
    sf_mesh_view a = sf_stand_outer(one), b = sf_stand_outer(other);
    CHECK(memcmp(a.vertices, b.vertices, 24 * a.vertex_count) == 0);
    CHECK(sf_grid_equal(sf_stand_grid(one), sf_stand_grid(other)));
    sf_stand_destroy(one);
    sf_stand_destroy(other);
}

// A handle that a person has moved stays there when it is locked, and the rest makes up for it.
static void a_person_may_pose(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_stand *stand = make(0.1, &o, 1, &stance);
    sf_pose pose = sf_pose_identity();
    pose.shift_mm[0] = 8;
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    CHECK_EQ(sf_stand_set_pose(stand, 2, &pose, 1), SF_OK);
    CHECK(!sf_stand_describe(stand).ended);
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    CHECK(sf_stand_describe(stand).safe && margin_of(stand) >= 4 * DEGREE - 1e-4);
    CHECK(sf_stand_get_pose(stand, 2).shift_mm[0] == 8);
    CHECK_EQ(sf_stand_set_pose(stand, 3, &pose, 1), SF_ERR_ARGUMENT);
    pose.scale = 0;
    CHECK_EQ(sf_stand_set_pose(stand, 0, &pose, 1), SF_ERR_ARGUMENT);
    CHECK(sf_stand_get_pose(stand, 9).scale == 1);
    sf_stand_destroy(stand);
}

// With everything locked and nothing to carve it cannot stand: it must say so, and change nothing.
static void what_cannot_stand_says_so(void)
{
    sf_stand_options o = options_of(1, SF_CARVE_PLANE);
    sf_stance_options stance = sf_stance_options_default();
    sf_pose pose = sf_pose_identity();
    o.carve = 0;
    sf_stand *stand = make(0.5, &o, 1, &stance);
    for (size_t j = 0; j < 3; j++) {
        CHECK_EQ(sf_stand_set_pose(stand, j, &pose, 1), SF_OK);
    }
    CHECK_EQ(sf_stand_run(stand, NULL, NULL), SF_OK);
    sf_stand_report r = sf_stand_describe(stand);
    CHECK(r.ended && !r.safe && !r.stands && r.margin_rad < 0 && r.displacement_mm < 1e-9);
    CHECK_NEAR(r.margin_rad, r.margin_before_rad, 1e-9);
    sf_stand_destroy(stand);
}

int main(void)
{
    TEST(carving_alone);
    TEST(bending_and_carving);
    TEST(without_carving);
    TEST(carving_keeps_to_its_bound);
    TEST(ballast_counts);
    TEST(density_counts);
    TEST(two_stances_at_once);
    TEST(two_stances_that_cannot_be);
    TEST(threads_change_nothing);
    TEST(a_person_may_pose);
    TEST(what_cannot_stand_says_so);
    return test_finish();
}
