// SPDX-License-Identifier: MIT
// Why: a carving that is said to print without supports and to balance must do both. Ten thousand
// random solids under every rule, with masks, densities, other weights and half-spaces: the wall
// stays, nothing is added, nothing hangs that did not hang in the solid, struts are as wide as
// asked but for the voxels that are named, all counts and the body are those that a walk over the
// voxels finds, half-spaces hold as reported, and no bound is passed.

#include "carving.h"

static void check_counts(const carving_scene *c, const sfi_forest_report *r)
{
    uint64_t left = stack_volume(&c->result);
    CHECK_EQ(r->removed_voxels, stack_volume(&c->s) - left);
    CHECK_EQ(r->kept_voxels, left - stack_volume(&c->given));
    if (!stack_equal(&c->result, &c->s)) {
        CHECK(carving_thin(c) <= r->thin_voxels);
    }
}

static void check_body(const carving_scene *c, const sfi_forest_report *r)
{
    sf_body body = naive_body(&c->result, c->options.density, c->options.rest);
    double depth = naive_least_depth(c, &body);
    CHECK_NEAR(r->body.mass, body.mass, 1e-12);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR(r->body.moment[i], body.moment[i], 1e-12);
    }
    CHECK_NEAR(r->depth, depth, 1e-7);
    if (fabs(depth) > 1e-9) {
        CHECK_EQ(r->holds, depth >= 0);
    }
}

static void check_goal(const carving_scene *c, const sfi_forest_report *r)
{
    sf_body all = naive_body(&c->s, c->options.density, c->options.rest);
    if (c->options.count == 0) {
        CHECK_EQ(r->goal, SFI_FOREST_LEAST);
        CHECK(r->body.mass >= r->bound - 1e-12);
    } else if (r->goal == SFI_FOREST_DEEPEST) {
        CHECK(r->depth <= r->bound + 1e-7);
        CHECK(r->depth >= naive_least_depth(c, &all) - 1e-7);
    } else {
        CHECK_EQ(r->goal, c->options.goal);
        CHECK(r->holds);
        CHECK(r->goal == SFI_FOREST_MOST ? r->body.mass <= r->bound + 1e-9
                                         : r->body.mass >= r->bound - 1e-9);
    }
    if (c->options.goal == SFI_FOREST_MOST && naive_least_depth(c, &all) > 1e-9) {
        CHECK(stack_equal(&c->result, &c->s));
    }
}

// Nothing is loose, unless something rests on it over a gap, or it was left as it is.
static void check_pieces(const carving_scene *c, const stack *exempt)
{
    static stack held;
    carving_held(c, &c->result, &held);
    CHECK(stack_volume(&c->given) == 0 || stack_equal(&c->result, &c->s) ||
          stack_equal(&held, &c->result) || !alive_is_free(&c->alive, &held, exempt, c->bed));
}

static void one_scene(int round, int nx, int ny, int nz)
{
    static carving_scene c;
    static stack exempt;
    sfi_forest_report report;
    carving_begin(&c, round, nx, ny, nz);
    sf_status status =
        sfi_carve_forest(c.solid, c.stays, &c.terms, &c.options, NULL, NULL, c.out, &report);
    CHECK_EQ(status, SF_OK);
    if (status == SF_OK) {
        stack_read(&c.result, c.out);
        carving_exempt(&c, &exempt);
        CHECK(stack_within(&c.given, &c.result));
        CHECK(stack_within(&c.result, &c.s));
        CHECK(alive_is_free(&c.alive, &c.result, &exempt, c.bed));
        check_pieces(&c, &exempt);
        check_counts(&c, &report);
        check_body(&c, &report);
        check_goal(&c, &report);
    }
    carving_end(&c);
}

static void small_solids(void)
{
    for (int round = 0; round < 10000; round++) {
        one_scene(round, 2 + (int)test_random_below(8), 1 + (int)test_random_below(7),
                  1 + (int)test_random_below(8));
    }
}

static void wide_solids(void)
{
    for (int round = 0; round < 40; round++) {
        one_scene(round, 60 + (int)test_random_below(20), 3 + (int)test_random_below(5),
                  3 + (int)test_random_below(5));
    }
}

int main(void)
{
    TEST(small_solids);
    TEST(wide_solids);
    return test_finish();
}
