// SPDX-License-Identifier: MIT
// Why: the three balls of "Make It Stand" fall over as they are, and no carving was known that
// makes them stand and prints. At the paper's 83,000 voxels and at 808,000 they must stand with the
// margins that were promised, close to what no carving can pass; so must any margin that can be
// asked for be met. The paper's carving is made beside it: it may not take out much more, and
// hangs. Other models are hollowed. docs/balance.md has the figures that this prints.

#include <sf/carve.h>

#include "balance/forest/forest.h"
#include "base/memory.h"
#include "data_file.h"
#include "voxel/pieces.h"

#include <time.h>

#define DEGREE (3.14159265358979323846 / 180)

typedef struct model {
    sf_mesh *mesh;
    sf_grid *solid, *wall, *out;
    sf_stance *stance;
    sf_halfspace halfspaces[256], slopes[256];
    sf_terms terms;
    sf_body rest; // the mesh less its voxels
    sfi_forest_options options;
    uint64_t hanging; // voxels of the solid that hang
    uint32_t pieces;  // of the solid
} model;

static double seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static uint64_t unsupported(const sf_grid *grid)
{
    sf_check_options options = sf_check_options_default();
    sf_check_report report = {.unsupported_voxels = 0};
    CHECK_EQ(sf_grid_check(grid, &options, NULL, NULL, &report, NULL), SF_OK);
    return report.unsupported_voxels;
}

static uint32_t pieces_of(const sf_grid *grid)
{
    sfi_pieces pieces = {.count = 0};
    sf_allocator allocator = sfi_allocator_or_default(NULL);
    CHECK_EQ(sfi_pieces_create(grid, SFI_PIECES_SOLID, &allocator, NULL, &pieces), SF_OK);
    uint32_t count = pieces.count;
    sfi_pieces_destroy(&pieces, &allocator);
    return count;
}

static sf_lattice lattice_around(sf_mesh_view mesh, double pitch)
{
    double low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
    CHECK_EQ(sf_mesh_bounds(mesh, low, high), SF_OK);
    sf_lattice l = {(uint32_t)ceil((high[0] - low[0]) / pitch) + 2,
                    (uint32_t)ceil((high[1] - low[1]) / pitch) + 2,
                    (uint32_t)ceil((high[2] - low[2]) / pitch - 1e-9),
                    pitch,
                    pitch,
                    pitch,
                    NULL,
                    {low[0] - pitch, low[1] - pitch, low[2]}};
    return l;
}

// A stance that needs no margin, and the heights over its ground: depth is the tangent of a margin.
static void stand(model *m)
{
    sf_stance_options pose = sf_stance_options_default();
    size_t count = 0;
    pose.gamma_rad = 0;
    CHECK_EQ(sf_stance_create(sf_mesh_get_view(m->mesh), &pose, NULL, &m->stance, NULL), SF_OK);
    CHECK_EQ(sf_stance_halfspaces(m->stance, m->halfspaces, 256, &count), SF_OK);
    for (size_t e = 0; e < count; e++) {
        sf_halfspace height = {{0, 0, 1}, sf_stance_ground(m->stance)};
        m->slopes[e] = height;
    }
    m->options.halfspaces = m->halfspaces;
    m->options.slopes = m->slopes;
    m->options.count = count;
}

// y of these files is up.
static int begin(model *m, const char *path, double pitch, double wall_mm)
{
    const sf_transform turn = {{1, 0, 0, 0, 0, -1, 0, 1, 0}, {0, 0, 0}};
    sf_body own = {0, {0, 0, 0}};
    memset(m, 0, sizeof *m);
    m->mesh = data_mesh(path);
    if (m->mesh == NULL) {
        return 0;
    }
    CHECK_EQ(sf_mesh_transform(m->mesh, &turn), SF_OK);
    sf_mesh_view view = sf_mesh_get_view(m->mesh);
    sf_lattice lattice = lattice_around(view, pitch);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &m->solid), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &m->wall), SF_OK);
    CHECK_EQ(sf_grid_create(&lattice, NULL, &m->out), SF_OK);
    CHECK_EQ(sf_grid_voxelize(m->solid, view, NULL, NULL, NULL, NULL), SF_OK);
    CHECK_EQ(sf_grid_wall(m->solid, view, wall_mm, NULL, NULL, m->wall), SF_OK);
    CHECK_EQ(sf_mesh_body(view, 1, &m->rest), SF_OK);
    CHECK_EQ(sf_grid_body(m->solid, NULL, NULL, &own), SF_OK);
    m->rest = sf_body_add(m->rest, -1, own);
    m->terms = sf_terms_default();
    m->options.rest = m->rest;
    m->options.strut_width = 2;
    m->hanging = unsupported(m->solid);
    m->pieces = pieces_of(m->solid);
    return 1;
}

static void end(model *m)
{
    sf_stance_destroy(m->stance);
    sf_grid_destroy(m->solid);
    sf_grid_destroy(m->wall);
    sf_grid_destroy(m->out);
    sf_mesh_destroy(m->mesh);
}

// Margin of the result, by its stance.
static double margin_of(const model *m)
{
    sf_body body = {0, {0, 0, 0}};
    sf_stance_verdict verdict = {.margin_rad = -9};
    double com[3] = {0, 0, 0};
    CHECK_EQ(sf_grid_body(m->out, NULL, NULL, &body), SF_OK);
    CHECK_EQ(sf_body_com(sf_body_add(body, 1, m->rest), com), SF_OK);
    CHECK_EQ(sf_stance_judge(m->stance, com, &verdict), SF_OK);
    return verdict.margin_rad / DEGREE;
}

// What holds of every carving: it prints as the solid did, is as many pieces, and the wall is
// whole.
static void check_result(const model *m)
{
    sf_grid *both = NULL;
    CHECK(unsupported(m->out) <= m->hanging);
    CHECK_EQ(pieces_of(m->out), m->pieces);
    CHECK_EQ(sf_grid_clone(m->out, NULL, &both), SF_OK);
    for (uint32_t k = 0; k < sf_grid_lattice(both).nz; k++) {
        sf_slice slice = sf_grid_slice(both, k);
        CHECK_EQ(sf_slice_or(slice, slice, sf_grid_slice(m->wall, k)), SF_OK);
    }
    CHECK(sf_grid_equal(both, m->out));
    sf_grid_destroy(both);
}

static sfi_forest_report carve(model *m, sfi_forest_goal goal)
{
    sfi_forest_report r = {.depth = 0};
    m->options.goal = goal;
    CHECK_EQ(sfi_carve_forest(m->solid, m->wall, &m->terms, &m->options, NULL, NULL, m->out, &r),
             SF_OK);
    check_result(m);
    return r;
}

// The paper's way for the same stance; returns how many voxels it takes out.
static uint64_t carve_by_plane(model *m, double gamma, sf_carve_goal goal)
{
    sf_stance_options pose = sf_stance_get_options(m->stance);
    sf_carve_options options = sf_carve_options_default();
    sf_carve_report report = {.removed_voxels = 0};
    sf_stance *stance = NULL;
    pose.gamma_rad = gamma * DEGREE;
    CHECK_EQ(sf_stance_create(sf_mesh_get_view(m->mesh), &pose, NULL, &stance, NULL), SF_OK);
    const sf_stance *stances[1] = {stance};
    options.mode = SF_CARVE_PLANE;
    options.goal = goal;
    options.rest = m->rest;
    options.stances = stances;
    options.stance_count = 1;
    CHECK_EQ(sf_grid_carve(m->solid, m->wall, NULL, &options, NULL, NULL, m->out, &report), SF_OK);
    printf("#   by planes, %s for %.1f degrees: %llu voxels out, margin %.3f, %llu more hang\n",
           goal == SF_CARVE_DEEPEST ? "deepest" : "nearest", gamma,
           (unsigned long long)report.removed_voxels, margin_of(m),
           (unsigned long long)(unsupported(m->out) - m->hanging));
    sf_stance_destroy(stance);
    return report.removed_voxels;
}

// As much as can be kept at a margin that is asked for; it must be met.
static void ask_for(model *m, double gamma)
{
    sf_halfspace was[256];
    memcpy(was, m->halfspaces, sizeof was);
    double t = tan(gamma * DEGREE), start = seconds();
    for (size_t e = 0; e < m->options.count; e++) {
        m->halfspaces[e].normal[2] -= t;
        m->halfspaces[e].offset_mm -= t * sf_stance_ground(m->stance);
    }
    for (int goal = 0; goal < 2; goal++) {
        sfi_forest_report r = carve(m, (sfi_forest_goal)goal);
        double margin = margin_of(m), took = seconds() - start;
        CHECK(r.holds);
        CHECK(margin >= gamma - 1e-6);
        CHECK(margin <= gamma + 0.02); // no more is given than was asked for
        printf("#   %s at %.1f degrees: mass %.5f, bound %.5f, margin %.4f, %.0f ms\n",
               goal == SFI_FOREST_MOST ? "most" : "least", gamma, r.body.mass, r.bound, margin,
               1000 * took);
        CHECK(goal == SFI_FOREST_MOST ? r.body.mass > 0.96 * r.bound
                                      : r.body.mass < 1.08 * r.bound);
        start = seconds();
    }
    memcpy(m->halfspaces, was, sizeof was);
}

static void balls(double pitch, double wall_mm, double wanted, double of_bound)
{
    model m;
    if (!begin(&m, "characters/spheres_outer.stl", pitch, wall_mm)) {
        return;
    }
    stand(&m);
    CHECK_EQ(m.pieces, 1);
    double start = seconds(), depth = 0, mass = 0;
    sfi_forest_report r = carve(&m, SFI_FOREST_DEEPEST);
    double took = seconds() - start, margin = margin_of(&m);
    uint64_t open = sf_grid_popcount(m.solid) - sf_grid_popcount(m.wall);
    printf("# %llu voxels, %llu may go, wall %.3f, pitch %.4f, %llu ceilings, %.0f ms\n",
           (unsigned long long)sf_grid_popcount(m.solid), (unsigned long long)open, wall_mm, pitch,
           (unsigned long long)r.asked_voxels, 1000 * took);
    printf("#   deepest: margin %.3f of %.3f degrees, %llu voxels out\n", margin,
           atan(r.bound) / DEGREE, (unsigned long long)r.removed_voxels);
    CHECK(margin >= wanted);
    CHECK(margin >= of_bound * atan(r.bound) / DEGREE);
    CHECK_EQ(sfi_carve_bound(m.solid, m.wall, NULL, &m.options, NULL, NULL, &depth, &mass), SF_OK);
    CHECK_NEAR(depth, r.bound, 1e-9);
    CHECK(r.removed_voxels >= carve_by_plane(&m, wanted, SF_CARVE_NEAREST) * 9 / 10);
    CHECK(r.removed_voxels >=
          carve_by_plane(&m, atan(r.bound) / DEGREE, SF_CARVE_DEEPEST) * 9 / 10);
    ask_for(&m, 0);
    ask_for(&m, wanted);
    m.options.count = 0;
    start = seconds();
    r = carve(&m, SFI_FOREST_LEAST);
    printf("#   hollow: %.2f %% of what may go is left, %.0f ms\n",
           100.0 * (double)r.kept_voxels / (double)open, 1000 * (seconds() - start));
    CHECK(r.kept_voxels * 50 < open);
    end(&m);
}

static void balls_as_in_the_paper(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    balls(0.0107, 0.010, 3, 0.87);
}

static void balls_of_many_voxels(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    balls(0.005, 0.015, 2.5, 0.85);
}

static void hollow(const char *path, double pitch, double wall_mm, uint32_t width)
{
    model m;
    if (!begin(&m, path, pitch, wall_mm)) {
        return;
    }
    m.options.strut_width = width;
    double start = seconds();
    sfi_forest_report r = carve(&m, SFI_FOREST_LEAST);
    double took = seconds() - start;
    uint64_t open = r.kept_voxels + r.removed_voxels;
    printf("# %s: %llu voxels, %llu may go, struts %u wide: %.2f %% left, %llu ceilings of the "
           "wall, %.0f ms\n",
           path, (unsigned long long)sf_grid_popcount(m.solid), (unsigned long long)open, width,
           100.0 * (double)r.kept_voxels / (double)open, (unsigned long long)r.asked_voxels,
           1000 * took);
    CHECK(r.kept_voxels * 15 < open);
    CHECK_EQ(r.thin_voxels, 0);
    end(&m);
}

static void other_models_are_hollowed(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (uint32_t width = 1; width <= 3; width++) {
        hollow("characters/armadillo.obj", 0.0107, 0.02, width);
        hollow("characters/stanford-bunny.obj", 0.0018, 0.003, width);
        hollow("characters/penguin_hr.obj", 0.025, 0.05, width);
        hollow("parts/ksr_fdmtest_v4.stl", 0.5, 1, width);
    }
}

int main(void)
{
    TEST(balls_as_in_the_paper);
    TEST(balls_of_many_voxels);
    TEST(other_models_are_hollowed);
    return test_finish();
}
