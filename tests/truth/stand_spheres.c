// SPDX-License-Identifier: MIT
// Why: on the paper's own example carving alone has a known reach. With a thin wall it must leave a
// margin of four degrees by planes and three without supports, with a thicker one three and a half
// and two and a half, on the meshes that are written and not on voxels; and the outside must come
// out as it went in.

#include "standing.h"

typedef struct carving {
    double wall_mm, pitch_mm;
    sf_carve_mode mode;
    sf_rule_kind rule;
    const char *name;
} carving;

static double carved(const carving *c, double asked)
{
    standing_model m = standing_read("characters/spheres_outer.stl", 1);
    sf_mesh_view given = sf_mesh_get_view(m.mesh);
    sf_stance_options stance = sf_stance_options_default();
    sf_stand_options o = standing_options(&m, c->mode);
    stance.gamma_rad = asked * STANDING_DEGREE;
    o.rule = c->rule;
    o.wall_mm = c->wall_mm;
    o.pitch_mm = c->pitch_mm;
    o.deform = 0;
    sf_stand *stand = standing_create(&m, &stance, 1, NULL, 0, &o);
    double ms = standing_run(stand), margin = standing_margin(stand, &stance);
    sf_stand_report r = sf_stand_describe(stand);
    printf("# wall %.3f, %s, %.1f asked: %.0f voxels, %.0f ms, margin %.2f to %.2f, bound %.2f "
           "degrees, %.1f %% out, hanging %llu\n",
           c->wall_mm, c->name, asked,
           (double)sf_grid_popcount(sf_stand_grid(stand)) +
               floor(r.carved_mm3 / pow(c->pitch_mm, 3) + 0.5),
           ms, r.margin_before_rad / STANDING_DEGREE, margin / STANDING_DEGREE,
           r.bound_rad / STANDING_DEGREE, 100 * r.carved_mm3 / (r.carved_mm3 + r.mass),
           (unsigned long long)r.hanging_voxels);
    CHECK_NEAR(margin, r.margin_rad, 1e-3);
    CHECK(margin <= r.bound_rad + 1e-3);
    CHECK(r.safe == (margin >= stance.gamma_rad - 1e-6));
    CHECK(c->mode == SF_CARVE_PLANE || r.hanging_voxels == 0);
    // Contacts are put onto the ground: a millionth of the diagonal, and all else stays.
    sf_mesh_view now = sf_stand_outer(stand);
    for (size_t i = 0; i < 3 * given.vertex_count; i++) {
        CHECK(fabs(now.vertices[i] - given.vertices[i]) <= 2e-6 * m.size);
    }
    sf_stand_destroy(stand);
    sf_mesh_destroy(m.mesh);
    return margin / STANDING_DEGREE;
}

// More than there is: carving goes as far as it can.
#define TOO_MUCH 5

// The paper's rule of what supports what.
static void carvings(double wall_mm, double pitch_mm, double by_planes, double without_supports)
{
    const carving planes = {wall_mm, pitch_mm, SF_CARVE_PLANE, SF_RULE_BOX3, "planes"};
    const carving free = {wall_mm, pitch_mm, SF_CARVE_SUPPORT_FREE, SF_RULE_BOX3,
                          "support-free by box3"};
    CHECK(carved(&planes, by_planes) >= by_planes);
    CHECK(carved(&free, without_supports) >= without_supports);
    CHECK(carved(&planes, TOO_MUCH) >= by_planes);
    CHECK(carved(&free, TOO_MUCH) >= without_supports);
}

// About 82 000 voxels.
static void a_thin_wall(void)
{
    const carving octagon = {0.010, 0.0107, SF_CARVE_SUPPORT_FREE, SF_RULE_OCTAGON,
                             "support-free by octagon"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set, and this is a real model");
    }
    carvings(0.010, 0.0107, 4, 3);
    // A stricter rule leaves more standing inside.
    CHECK(carved(&octagon, TOO_MUCH) >= 2.9);
}

static void a_thicker_wall_and_finer_voxels(void)
{
    const carving octagon = {0.015, 0.005, SF_CARVE_SUPPORT_FREE, SF_RULE_OCTAGON,
                             "support-free by octagon"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set, and this is a real model");
    }
    carvings(0.015, 0.005, 3.5, 2.5);
    CHECK(carved(&octagon, TOO_MUCH) >= 3);
}

int main(void)
{
    TEST(a_thin_wall);
    TEST(a_thicker_wall_and_finer_voxels);
    return test_finish();
}
