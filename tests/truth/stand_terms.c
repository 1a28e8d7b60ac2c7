// SPDX-License-Identifier: MIT
// Why: the paper's figure 14 says what each of its terms is for, by leaving them out. The same must
// show here, with the same handles, wall, voxels and tilt: without carving a shape must change its
// size far more, without the Laplacian term it loses its shape, at its foot too, and without both
// it loses it most. A switch that is not heard, or a term that holds nothing, would show as two
// results that are alike.

#include "balls.h"
#include "terms.h"

static void say(const char *costs, int way, const terms_result *r, double size)
{
    printf("# %s, %s: margin %.2f to %.2f degrees, %.1f %% out, moved %.1f %%, shape %.4f, at the "
           "foot %.4f, size %.4f, above %+.4f, least volume %.2f, %u rounds\n",
           costs, terms_names[way], r->report.margin_before_rad / STANDING_DEGREE, r->margin_deg,
           100 * r->report.carved_mm3 / (r->report.carved_mm3 + r->report.mass),
           100 * r->report.displacement_mm / size, r->all.shape, r->low.shape, r->all.size,
           r->up.growth, r->report.least_det, r->report.rounds);
}

static void compare(const terms_result r[TERMS_WAYS])
{
    const terms_result *all = &r[TERMS_ALL], *solid = &r[TERMS_NO_CARVING];
    const terms_result *loose = &r[TERMS_NO_LAPLACIAN], *neither = &r[TERMS_NEITHER];
    // Sizes change where nothing can be carved, and what is above shrinks.
    CHECK(solid->all.size > 3 * all->all.size);
    CHECK(solid->up.growth < 2 * all->up.growth && all->up.growth <= 0);
    CHECK(solid->report.displacement_mm > 2 * all->report.displacement_mm);
    // The Laplacian term keeps the shape, and most where bending is free to shift: at the foot.
    CHECK(loose->all.shape > 1.5 * all->all.shape);
    CHECK(loose->low.shape > 1.5 * all->low.shape);
    CHECK(neither->all.shape > 1.5 * solid->all.shape);
    // Carving keeps it too.
    CHECK(solid->all.shape > 2 * all->all.shape);
    CHECK(neither->all.shape > 2 * loose->all.shape);
    CHECK(neither->report.least_det < fmin(solid->report.least_det, loose->report.least_det));
}

static void leave_out(const standing_model *m, const sf_stance_options *stance,
                      const sf_handle *handles, size_t count, const terms_costs *costs)
{
    terms_result r[TERMS_WAYS];
    const double asked = stance->gamma_rad / STANDING_DEGREE;
    for (int way = 0; way < TERMS_WAYS; way++) {
        r[way] = terms_run(m, stance, handles, count, costs, way);
        say(costs->name, way, &r[way], m->size);
        CHECK(r[way].report.margin_before_rad < 0);
        CHECK((r[way].report.carved_mm3 > 0) == (way != TERMS_NO_CARVING && way != TERMS_NEITHER));
        if (way != TERMS_ALONE) {
            CHECK(r[way].report.succeeded && r[way].margin_deg >= asked - 0.01);
        }
    }
    // Carving alone is not enough, and changes nothing outside.
    CHECK(!r[TERMS_ALONE].report.safe && r[TERMS_ALONE].margin_deg < asked - 0.1);
    CHECK(r[TERMS_ALONE].all.shape < 1e-3 && r[TERMS_ALONE].all.size < 1e-3);
    compare(r);
    for (int way = 0; way < TERMS_WAYS; way++) {
        sf_stand_destroy(r[way].stand);
    }
}

static const terms_costs ours = {"all costs", SF_STAND_PROGRAMS, 0.3, 0.05};

static void balls_on(const terms_costs *costs)
{
    standing_model m = balls_make();
    sf_stance_options stance = balls_stance();
    sf_handle handles[BALLS];
    size_t count = balls_handles(handles);
    leave_out(&m, &stance, handles, count, costs);
    sf_mesh_destroy(m.mesh);
}

static void each_term_has_its_use(void)
{
    balls_on(&ours);
}

static void so_it_is_with_the_papers_costs_alone(void)
{
    const terms_costs papers = {"the paper's costs", SF_STAND_PROGRAMS, 0, 0};
    balls_on(&papers);
}

static void so_it_is_with_the_papers_descent(void)
{
    const terms_costs papers = {"the paper's descent", SF_STAND_DESCENT, 0, 0};
    balls_on(&papers);
}

static void so_it_is_with_the_papers_model(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set, and this is a real model");
    }
    standing_model m = standing_read("characters/spheres_outer.stl", 1);
    sf_stance_options stance = sf_stance_options_default();
    sf_handle handles[16];
    stance.gamma_rad = 7 * STANDING_DEGREE;
    size_t count = standing_handles(&m, &stance, m.size / 64, 3, handles);
    leave_out(&m, &stance, handles, count, &ours);
    sf_mesh_destroy(m.mesh);
}

int main(void)
{
    TEST(each_term_has_its_use);
    TEST(so_it_is_with_the_papers_costs_alone);
    TEST(so_it_is_with_the_papers_descent);
    TEST(so_it_is_with_the_papers_model);
    return test_finish();
}
