// SPDX-License-Identifier: MIT
// Why: support-freeness is promised on the lattice that it was made on, and people take the mesh
// elsewhere. A trimmed shape is made a mesh and voxelised again: on its own lattice nothing may
// hang (the surface gives the same voxels back); on a lattice moved by half a voxel, on one of half
// the pitch, and after smoothing, what then hangs is counted, at the angle and at ten degrees more.
// The table of docs/rules.md is printed here; what is asserted is the promise, and that there is
// something to tell. Models lie in the folder that SF_DATA names; the scene is the twin that always
// runs.

#include "data_file.h"

#include "scene.h"

#define RESOLUTION 128
#define RADIAN (3.14159265358979323846 / 180.0)

static sf_lattice lattice_around(sf_mesh_view mesh)
{
    double low[3], high[3], longest = 0.0;
    CHECK_EQ(sf_mesh_bounds(mesh, low, high), SF_OK);
    for (int i = 0; i < 3; i++) {
        longest = high[i] - low[i] > longest ? high[i] - low[i] : longest;
    }
    double p = longest / RESOLUTION;
    sf_lattice lattice = {(uint32_t)ceil((high[0] - low[0]) / p - 1e-6) + 2,
                          (uint32_t)ceil((high[1] - low[1]) / p - 1e-6) + 2,
                          (uint32_t)ceil((high[2] - low[2]) / p - 1e-6),
                          p,
                          p,
                          p,
                          NULL,
                          {low[0] - p, low[1] - p, low[2]}};
    return lattice;
}

static uint64_t hanging(const sf_grid *grid, sf_rule_kind kind, double degrees)
{
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_check_options options = sf_check_options_default();
    sf_check_report report;
    CHECK_EQ(sf_rule_make(kind, degrees * RADIAN, &lattice, NULL, &options.rule, NULL), SF_OK);
    CHECK_EQ(sf_grid_check(grid, &options, NULL, NULL, &report, NULL), SF_OK);
    return report.unsupported_voxels;
}

// Voxelise a surface on a lattice; print and return what hangs at the angle.
static uint64_t judge(const char *name, const char *how, sf_mesh_view mesh, sf_lattice lattice,
                      sf_rule_kind kind, double degrees)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    CHECK_EQ(sf_grid_voxelize(grid, mesh, NULL, NULL, NULL, NULL), SF_OK);
    uint64_t same = hanging(grid, kind, degrees), more = hanging(grid, kind, degrees + 10);
    printf("# %-14s %-8s %-16s %9llu voxels, hanging %6llu, at +10 degrees %6llu\n", name,
           sf_rule_kind_name(kind), how, (unsigned long long)sf_grid_popcount(grid),
           (unsigned long long)same, (unsigned long long)more);
    sf_grid_destroy(grid);
    return same;
}

// Moved down, left and to the front by a part of a voxel.
static sf_lattice moved(sf_lattice lattice, double part)
{
    lattice.nx++;
    lattice.ny++;
    lattice.nz++;
    lattice.origin_mm[0] -= part * lattice.pitch_x_mm;
    lattice.origin_mm[1] -= part * lattice.pitch_y_mm;
    lattice.origin_mm[2] -= part * lattice.layer_mm;
    return lattice;
}

static sf_lattice halved(sf_lattice lattice)
{
    lattice.nx *= 2;
    lattice.ny *= 2;
    lattice.nz *= 2;
    lattice.pitch_x_mm /= 2;
    lattice.pitch_y_mm /= 2;
    lattice.layer_mm /= 2;
    return lattice;
}

static void take_elsewhere(const char *name, const sf_grid *shape, sf_rule_kind kind,
                           double degrees)
{
    sf_lattice lattice = sf_grid_lattice(shape);
    sf_surface_options smooth = sf_surface_options_default();
    sf_mesh *sharp = NULL, *soft = NULL;
    sf_grid *grid = NULL;
    sf_rule rule;
    smooth.smooth_passes = 3;
    CHECK_EQ(sf_rule_make(kind, degrees * RADIAN, &lattice, NULL, &rule, NULL), SF_OK);
    CHECK_EQ(sf_grid_clone(shape, NULL, &grid), SF_OK);
    CHECK_EQ(sf_grid_trim(grid, &rule, SF_BED_AUTO, NULL, NULL), SF_OK);
    CHECK(hanging(shape, kind, degrees) > 0);
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &sharp), SF_OK);
    CHECK_EQ(sf_grid_surface(grid, &smooth, NULL, NULL, &soft), SF_OK);
    sf_mesh_view mesh = sf_mesh_get_view(sharp);
    uint64_t elsewhere = 0;
    CHECK_EQ(judge(name, "its own lattice", mesh, lattice, kind, degrees), 0);
    elsewhere += judge(name, "half a voxel off", mesh, moved(lattice, 0.5), kind, degrees);
    elsewhere += judge(name, "half the pitch", mesh, halved(lattice), kind, degrees);
    elsewhere += judge(name, "smoothed", sf_mesh_get_view(soft), lattice, kind, degrees);
    CHECK(elsewhere > 0);
    sf_mesh_destroy(sharp);
    sf_mesh_destroy(soft);
    sf_grid_destroy(grid);
}

static void the_scene(void)
{
    double size[3];
    CHECK(scene_size("garden", size));
    double p = size[0] / RESOLUTION;
    sf_lattice lattice = {
        RESOLUTION, (uint32_t)(size[1] / p), (uint32_t)(size[2] / p), p, p, p, NULL, {0, 0, 0}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    CHECK_EQ(scene_draw("garden", grid, NULL), SF_OK);
    take_elsewhere("scene:garden", grid, SF_RULE_OCTAGON, 45);
    take_elsewhere("scene:garden", grid, SF_RULE_SLACK, 45);
    sf_grid_destroy(grid);
}

static void models(void)
{
    static const char *const names[] = {"characters/armadillo.obj", "characters/stanford-bunny.obj",
                                        "parts/frog_legs.obj"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        sf_mesh *mesh = data_mesh(names[i]), *merged = NULL;
        sf_grid *grid = NULL;
        CHECK_EQ(sf_mesh_merge(sf_mesh_get_view(mesh), NULL, &merged), SF_OK);
        sf_lattice lattice = lattice_around(sf_mesh_get_view(merged));
        CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
        CHECK_EQ(sf_grid_voxelize(grid, sf_mesh_get_view(merged), NULL, NULL, NULL, NULL), SF_OK);
        take_elsewhere(strrchr(names[i], '/') + 1, grid, SF_RULE_OCTAGON, 45);
        take_elsewhere(strrchr(names[i], '/') + 1, grid, SF_RULE_SLACK, 45);
        sf_grid_destroy(grid);
        sf_mesh_destroy(merged);
        sf_mesh_destroy(mesh);
    }
}

int main(void)
{
    TEST(the_scene);
    TEST(models);
    return test_finish();
}
