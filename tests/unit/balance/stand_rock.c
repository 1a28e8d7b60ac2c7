// SPDX-License-Identifier: MIT
// Why: a rocker whose weight lies to one side leans. Carved for rocking it must come to rest as it
// was meant to, within a degree, wherever within twenty degrees it is let go. Its centre of mass is
// computed again from the two meshes, and it is rolled from many starts.

#include "judge.h"
#include "test.h"

#include <sf/stand.h>

#define DEGREE 0.017453292519943295
#define RADIUS 50.0
#define HALF_WIDTH 30.0

enum { FACETS = 240, CORNERS = FACETS + 3 };

static void add(sf_mesh *mesh, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t t[3] = {a, b, c};
    CHECK_EQ(sf_mesh_add_triangles(mesh, t, 1), SF_OK);
}

// An arc of thirty degrees to either side, drawn out along y, with a convex body above that leans
// to +x.
static sf_mesh *rocker(void)
{
    sf_mesh *mesh = NULL;
    CHECK_EQ(sf_mesh_create(NULL, &mesh), SF_OK);
    for (int side = -1; side <= 1; side += 2) {
        for (int i = 0; i < CORNERS; i++) {
            double a = 30 * (2.0 * i / FACETS - 1) * DEGREE;
            double p[3] = {RADIUS * sin(a), side * HALF_WIDTH, RADIUS * (1 - cos(a))};
            if (i > FACETS) {
                p[0] = i == FACETS + 1 ? 23 : -17;
                p[2] = 40;
            }
            CHECK_EQ(sf_mesh_add_vertices(mesh, p, 1), SF_OK);
        }
    }
    for (uint32_t i = 0; i < CORNERS; i++) {
        uint32_t next = (i + 1) % CORNERS;
        add(mesh, i, next, CORNERS + next);
        add(mesh, i, CORNERS + next, CORNERS + i);
        if (i > 0 && next > 0) {
            add(mesh, 0, next, i);
            add(mesh, CORNERS, CORNERS + i, CORNERS + next);
        }
    }
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(sf_mesh_get_view(mesh), &mass), SF_OK);
    if (mass.volume_mm3 > 0) {
        return mesh;
    }
    sf_mesh_view view = sf_mesh_get_view(mesh);
    sf_mesh *turned = NULL;
    CHECK_EQ(sf_mesh_create(NULL, &turned), SF_OK);
    CHECK_EQ(sf_mesh_add_vertices(turned, view.vertices, view.vertex_count), SF_OK);
    for (size_t t = 0; t < view.triangle_count; t++) {
        const uint32_t *i = view.triangles + 3 * t;
        add(turned, i[0], i[2], i[1]);
    }
    sf_mesh_destroy(mesh);
    return turned;
}

// The largest tilt it comes to rest in, from starts all over twenty degrees about.
static double worst_tilt(const sf_stand *stand)
{
    enum { STARTS = 400 };
    static double ups[3 * STARTS];
    static sf_rest rests[STARTS];
    double sums[4] = {0, 0, 0, 0}, worst = 0;
    judge_weight(sf_stand_outer(stand), sums);
    judge_weight(sf_stand_cavity(stand), sums);
    const double com[3] = {sums[1] / sums[0], sums[2] / sums[0], sums[3] / sums[0]};
    for (int i = 0; i < STARTS; i++) {
        double tilt = 20 * DEGREE * (i % 2 ? 1 : test_random_unit());
        double around = 6.283185307179586 * test_random_unit();
        ups[3 * i] = sin(tilt) * cos(around);
        ups[3 * i + 1] = sin(tilt) * sin(around);
        ups[3 * i + 2] = cos(tilt);
    }
    CHECK_EQ(sf_mesh_rest(sf_stand_outer(stand), com, ups, STARTS, NULL, rests, NULL), SF_OK);
    for (int i = 0; i < STARTS; i++) {
        worst = fmax(worst, acos(fmin(1, rests[i].up[2])));
    }
    return worst / DEGREE;
}

static void a_carved_rocker_comes_to_rest_upright(void)
{
    const sf_carve_mode modes[2] = {SF_CARVE_PLANE, SF_CARVE_SUPPORT_FREE};
    for (int m = 0; m < 2; m++) {
        sf_mesh *mesh = rocker();
        sf_stand_options o = sf_stand_options_default();
        sf_stance_options stance = sf_stance_options_default();
        sf_stand *stand = NULL;
        sf_stand_report r;
        sf_fault fault = {SF_OK, 0, 0, ""};
        stance.kind = SF_STANCE_ROCK;
        o.carve_mode = modes[m];
        o.pitch_mm = 1;
        o.wall_mm = 1.5;
        CHECK_EQ(sf_stand_create(sf_mesh_get_view(mesh), &stance, 1, NULL, 0, &o, NULL, NULL,
                                 &stand, &fault),
                 SF_OK);
        CHECK_STR(fault.message, "");
        double before = worst_tilt(stand);
        CHECK_EQ(sf_stand_run(stand, NULL, &r), SF_OK);
        double after = worst_tilt(stand);
        printf("# a rocker, %s: rests at %.2f, then %.2f degrees at worst; safe %d\n",
               m == 0 ? "planes" : "support-free", before, after, r.safe);
        CHECK(before > 2 && after <= 1);
        CHECK(r.safe && r.stands);

        sf_stand_destroy(stand);
        sf_mesh_destroy(mesh);
    }
}

int main(void)
{
    TEST(a_carved_rocker_comes_to_rest_upright);
    return test_finish();
}
