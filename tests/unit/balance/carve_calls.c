// SPDX-License-Identifier: MIT
// Why: carving as callers meet it: a part that falls over and is carved until its stance holds, in
// the frame and with the half-spaces of a real stance; what must stay by the terms stays; arguments
// that make no sense are refused, and then nothing is changed.

#include "law/stack.h"
#include "unit/mesh/shapes.h"

#include <sf/carve.h>

static shape s;

// A T that leans over: a foot, and a beam that reaches out to one side.
static void leaning(void)
{
    const double foot[2][3] = {{0, 0, 0}, {8, 8, 20}}, beam[2][3] = {{0, 0, 20}, {25, 8, 32}};
    s.vertex_count = s.triangle_count = 0;
    shape_box(&s, foot[0], foot[1], 0);
    shape_box(&s, beam[0], beam[1], 0);
}

typedef struct calls {
    sf_grid *solid, *wall, *result, *was;
    sf_stance *stance;
    sf_carve_options options;
    const sf_stance *stances[1];
} calls;

static void begin(calls *c)
{
    sf_lattice lattice = {27, 10, 32, 1, 1, 1, NULL, {-1, -1, 0}};
    sf_stance_options pose = sf_stance_options_default();
    leaning();
    pose.gamma_rad = 0.02;
    CHECK_EQ(sf_stance_create(shape_view(&s), &pose, NULL, &c->stance, NULL), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &c->solid), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &c->wall), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &c->result), SF_OK);
    CHECK_EQ(sf_grid_voxelize(c->solid, shape_view(&s), NULL, NULL, NULL, NULL), SF_OK);
    CHECK_EQ(sf_grid_wall_inside(c->solid, 1, NULL, NULL, c->wall), SF_OK);
    CHECK_EQ(sf_slice_set(sf_grid_slice(c->result, 4), 4, 4, 1), SF_OK);
    CHECK_EQ(sf_grid_clone(c->result, NULL, &c->was), SF_OK);
    c->options = sf_carve_options_default();
    c->options.mode = SF_CARVE_PLANE;
    c->stances[0] = c->stance;
    c->options.stances = c->stances;
    c->options.stance_count = 1;
}

static void end(calls *c)
{
    sf_grid *all[4] = {c->solid, c->wall, c->result, c->was};
    for (int i = 0; i < 4; i++) {
        sf_grid_destroy(all[i]);
    }
    sf_stance_destroy(c->stance);
}

static void a_leaning_part_stands(void)
{
    calls c;
    sf_carve_report r;
    sf_stance_verdict before, after;
    double com[3];
    begin(&c);
    CHECK_EQ(sf_grid_carve(c.solid, c.wall, NULL, &c.options, NULL, NULL, c.result, &r), SF_OK);
    CHECK_EQ(sf_body_com(r.before, com), SF_OK);
    CHECK_EQ(sf_stance_judge(c.stance, com, &before), SF_OK);
    CHECK_EQ(sf_body_com(r.after, com), SF_OK);
    CHECK_EQ(sf_stance_judge(c.stance, com, &after), SF_OK);
    CHECK(!before.stands && after.stands && after.safe && r.safe);
    CHECK_NEAR(r.slack_before_mm, before.slack_mm, 1e-9);
    CHECK_NEAR(r.slack_mm, after.slack_mm, 1e-9);
    CHECK(r.removed_voxels > 100 && r.floating_pieces == 0);
    CHECK_NEAR(r.removed_mm3, (double)r.removed_voxels, 1e-9);
    // One voxel less would not do: it is the first prefix that stands.
    CHECK(r.slack_mm < 0.02);
    end(&c);
}

// The same part, carved for every goal so that it prints as it did.
static void a_leaning_part_stands_and_prints(void)
{
    static const sf_carve_goal goals[4] = {SF_CARVE_ENOUGH, SF_CARVE_NEAREST, SF_CARVE_DEEPEST,
                                           SF_CARVE_LIGHTEST};
    uint64_t left[4] = {0, 0, 0, 0};
    double slack[4] = {0, 0, 0, 0};
    for (int i = 0; i < 4; i++) {
        calls c;
        sf_carve_report r;
        sf_terms terms = sf_terms_default();
        sf_check_options check = sf_check_options_default();
        sf_check_report before = {.unsupported_voxels = 0}, after = before;
        begin(&c);
        c.options.mode = SF_CARVE_SUPPORT_FREE;
        c.options.goal = goals[i];
        CHECK_EQ(sf_grid_carve(c.solid, c.wall, &terms, &c.options, NULL, NULL, c.result, &r),
                 SF_OK);
        CHECK_EQ(sf_grid_check(c.solid, &check, NULL, NULL, &before, NULL), SF_OK);
        CHECK_EQ(sf_grid_check(c.result, &check, NULL, NULL, &after, NULL), SF_OK);
        CHECK_EQ(after.unsupported_voxels, before.unsupported_voxels);
        CHECK(r.safe && r.slack_mm >= 0 && r.slack_before_mm < 0 && r.floating_pieces == 0);
        left[i] = sf_grid_popcount(c.result);
        slack[i] = r.slack_mm;
        end(&c);
    }
    CHECK_EQ(left[0], left[1]);
    CHECK(left[3] < left[0] && left[2] < left[0]);
    CHECK(slack[2] > slack[0] && slack[2] > slack[3]);
}

static void what_must_stay_stays(void)
{
    calls c;
    sf_grid *keep = NULL, *act = NULL;
    sf_terms terms = sf_terms_default();
    begin(&c);
    CHECK_EQ(sf_grid_clone(c.was, NULL, &keep), SF_OK);
    CHECK_EQ(sf_grid_clone(c.was, NULL, &act), SF_OK);
    sf_rect most = {0, 0, 27, 10}, some = {14, 0, 20, 10};
    for (uint32_t k = 0; k < 32; k++) {
        CHECK_EQ(sf_slice_fill(sf_grid_slice(act, k), most, k < 28), SF_OK);
        CHECK_EQ(sf_slice_fill(sf_grid_slice(keep, k), some, 1), SF_OK);
    }
    terms.keep = keep;
    terms.act = act;
    for (int mode = 0; mode < 2; mode++) {
        c.options.mode = (sf_carve_mode)mode;
        c.options.goal = SF_CARVE_DEEPEST;
        c.options.stance_count = mode == SF_CARVE_PLANE;
        CHECK_EQ(sf_grid_carve(c.solid, c.wall, &terms, &c.options, NULL, NULL, c.result, NULL),
                 SF_OK);
        CHECK(sf_grid_popcount(c.result) < sf_grid_popcount(c.solid));
        for (uint32_t i = 0; i < 27 * 10 * 32; i++) {
            uint32_t x = i % 27, y = i / 27 % 10, k = i / 270;
            int was = sf_slice_get(sf_grid_slice(c.solid, k), x, y);
            int is = sf_slice_get(sf_grid_slice(c.result, k), x, y);
            CHECK(was || !is);
            CHECK(is || !was || (k < 28 && (x < 14 || x >= 20)));
        }
    }
    sf_grid_destroy(keep);
    sf_grid_destroy(act);
    end(&c);
}

static void without_stances(void)
{
    calls c;
    sf_carve_report r;
    begin(&c);
    c.options.stance_count = 0;
    CHECK_EQ(sf_grid_carve(c.solid, c.wall, NULL, &c.options, NULL, NULL, c.result, &r), SF_OK);
    CHECK(sf_grid_equal(c.solid, c.result) && r.safe && r.removed_voxels == 0);
    end(&c);
}

// Densities are in any unit: what is so many times as dense everywhere is carved the same, also
// where the unit is a strange one.
static void the_unit_of_densities_does_not_matter(void)
{
    static const float units[] = {1, 0x1p-120f, 0x1p-30f, 0x1p50f, 0x1p100f, 0x1p127f};
    static float density[27 * 10 * 32];
    for (int mode = 0; mode < 2; mode++) {
        calls c;
        sf_grid *first = NULL;
        sf_terms terms = sf_terms_default();
        begin(&c);
        CHECK_EQ(sf_grid_clone(c.was, NULL, &first), SF_OK);
        c.options.mode = (sf_carve_mode)mode;
        c.options.density = density;
        for (int i = 0; i < 6; i++) {
            sf_carve_report r;
            for (uint32_t j = 0; j < 27 * 10 * 32; j++) {
                density[j] = units[i] * (j % 27 < 9 ? 1.0f : 0.75f);
            }
            CHECK_EQ(sf_grid_carve(c.solid, c.wall, &terms, &c.options, NULL, NULL,
                                   i == 0 ? first : c.result, &r),
                     SF_OK);
            CHECK(r.safe && r.removed_voxels > 0);
            CHECK(i == 0 || sf_grid_equal(first, c.result));
        }
        sf_grid_destroy(first);
        end(&c);
    }
}

#define CARVE(solid, wall, terms, result)                                                          \
    sf_grid_carve(solid, wall, terms, &c.options, NULL, NULL, result, &r)

static void wrong_options(calls *c)
{
    sf_carve_options bad[9];
    const sf_stance *none[1] = {NULL};
    float density[27 * 10 * 32] = {0};
    sf_carve_report r;
    for (int i = 0; i < 9; i++) {
        bad[i] = c->options;
    }
    bad[0].struct_size = 4;
    bad[1].mode = (sf_carve_mode)2;
    bad[2].goal = (sf_carve_goal)3;
    bad[3].strut_width_vx = 0;
    bad[4].strut_width_vx = SF_REACH_MAX + 1;
    bad[5].rest.mass = NAN;
    bad[6].stances = none;
    bad[7].density = density; // of nothing
    bad[8].rest.mass = -1e9;
    for (int i = 0; i < 9; i++) {
        CHECK_EQ(sf_grid_carve(c->solid, c->wall, NULL, &bad[i], NULL, NULL, c->result, &r),
                 SF_ERR_ARGUMENT);
    }
    bad[7].stances = NULL;
    CHECK_EQ(sf_grid_carve(c->solid, c->wall, NULL, &bad[7], NULL, NULL, c->result, &r),
             SF_ERR_ARGUMENT);
}

static void nonsense_is_refused(void)
{
    calls c;
    sf_carve_report r;
    sf_lattice small = {3, 3, 3, 1, 1, 1, NULL, {0, 0, 0}};
    sf_grid *other = NULL;
    begin(&c);
    CHECK_EQ(sf_grid_create(&small, NULL, &other), SF_OK);
    CHECK_EQ(CARVE(NULL, c.wall, NULL, c.result), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, NULL, NULL, c.result), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.wall, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.solid, NULL, c.result), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.wall, NULL, c.solid), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, c.wall, NULL, c.wall), SF_ERR_ARGUMENT);
    CHECK_EQ(CARVE(c.solid, other, NULL, c.result), SF_ERR_SHAPE);
    CHECK_EQ(CARVE(c.solid, c.wall, NULL, other), SF_ERR_SHAPE);
    CHECK_EQ(CARVE(c.wall, c.solid, NULL, c.result), SF_ERR_INFEASIBLE);
    sf_terms terms = sf_terms_default();
    terms.keep = c.result;
    CHECK_EQ(CARVE(c.solid, c.wall, &terms, c.result), SF_ERR_ARGUMENT);
    terms.keep = other;
    CHECK_EQ(CARVE(c.solid, c.wall, &terms, c.result), SF_ERR_SHAPE);
    wrong_options(&c);
    c.options.mode = SF_CARVE_SUPPORT_FREE;
    c.options.stance_count = 0;
    CHECK_EQ(CARVE(c.solid, c.wall, NULL, c.result), SF_ERR_ARGUMENT);
    CHECK(sf_grid_equal(c.result, c.was));
    sf_grid_destroy(other);
    end(&c);
}

int main(void)
{
    TEST(a_leaning_part_stands);
    TEST(a_leaning_part_stands_and_prints);
    TEST(what_must_stay_stays);
    TEST(without_stances);
    TEST(the_unit_of_densities_does_not_matter);
    TEST(nonsense_is_refused);
    return test_finish();
}
