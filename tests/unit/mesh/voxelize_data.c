// SPDX-License-Identifier: MIT
// Why: the meshes of shared/data become the voxels that issue 2 asks for: all closed ones keep
// their volume at resolution 512 within 0.5 %, or where a lattice or the shape itself forbids that,
// what can be said exactly; the horse (all normals inward) is its own flip, blocks with a hole or
// turned triangles are whole blocks, and nothing broken is refused. Procedural twins:
// voxelize_auto, voxelize_exact, voxelize_open.

#include "data_file.h"
#include "solids.h"

#include <dirent.h>

// The lattice of `resolution` cubes on the longest side, one empty voxel around in x and y.
static sf_lattice lattice_around(sf_mesh_view mesh, uint32_t resolution)
{
    double low[3] = {0, 0, 0}, high[3] = {1, 1, 1}, longest = 0;
    CHECK_EQ(sf_mesh_bounds(mesh, low, high), SF_OK);
    for (int i = 0; i < 3; i++) {
        longest = high[i] - low[i] > longest ? high[i] - low[i] : longest;
    }
    double pitch = longest / resolution;
    uint32_t n[3];
    for (int i = 0; i < 3; i++) {
        n[i] = (uint32_t)ceil((high[i] - low[i]) / pitch - 1e-9);
    }
    sf_lattice lattice = {n[0] + 2, n[1] + 2, n[2], pitch,
                          pitch,    pitch,    NULL, {low[0] - pitch, low[1] - pitch, low[2]}};
    return lattice;
}

// Voxel volume of a file, as its meshes' fill decides.
static double voxel_volume(const char *path, uint32_t resolution, sf_voxelize_report *report,
                           double *mesh_volume)
{
    sf_mesh *mesh = data_mesh(path);
    if (mesh == NULL) {
        return 0;
    }
    sf_mesh_view view = sf_mesh_get_view(mesh);
    sf_lattice lattice = lattice_around(view, resolution);
    sf_grid *grid = solid_voxelize(view, &lattice, SF_FILL_AUTO, report);
    CHECK_EQ(report->odd_rows, 0);
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(view, &mass), SF_OK);
    *mesh_volume = mass.volume_mm3;
    double p = lattice.pitch_x_mm;
    sf_grid_destroy(grid);
    sf_mesh_destroy(mesh);
    return (double)report->solid_voxels * p * p * p;
}

static const char *const closed_paths[] = {
    "characters/armadillo.obj",
    "characters/horse.ply",
    "characters/spheres_outer.stl",
    "characters/human_man.obj",
    "characters/koala_low_resolution.obj",
    "characters/penguin_hr.obj",
    "characters/spot_low_resolution.obj",
    "parts/20mmbox-LF.stl",
    "parts/20mmbox-CRLF.stl",
    "parts/20mmbox-nonstandard.stl",
    "parts/A_upsidedown.obj",
    "parts/V_standing.obj",
    "parts/angle_block.STL",
    "parts/cube_with_concave_hole_enlarged_standing.obj",
    "parts/ksr_fdmtest_v4.stl",
    "broken/bad-stl-tardis.stl",
    "broken/block-good.stl",
    "broken/block-remove-unconnected-good.stl",
    "broken/cubes-touching.stl",
    "cages/catmark_cube.obj",
    "cages/catmark_cube_creases0.obj",
    "cages/catmark_cube_creases0_level0.obj",
    "cages/catmark_cube_creases0_level1.obj",
    "cages/catmark_cube_creases0_level2.obj",
    "cages/catmark_cube_level0.obj",
    "cages/catmark_cube_level1.obj",
    "cages/catmark_cube_level2.obj",
    "cages/spot_control_mesh.obj",
};
#define CLOSED_COUNT (sizeof closed_paths / sizeof closed_paths[0])

// Closed, but no lattice or no volume keeps them within 0.5 %: each has a case of its own.
static const char *const special_paths[] = {
    "parts/U_overhang.obj",                   // a_wall_between_voxels
    "slices/pyphotonfile_reference.stl",      // a_plate_of_three_layers
    "broken/self_intersectA.obj",             // what_overlaps_counts_once
    "broken/block-normal-directions-bad.stl", // broken_blocks_are_blocks
};

static int is_listed(const char *path)
{
    int found = 0;
    for (size_t i = 0; i < CLOSED_COUNT; i++) {
        found += strcmp(closed_paths[i], path) == 0;
    }
    for (size_t i = 0; i < sizeof special_paths / sizeof special_paths[0]; i++) {
        found += strcmp(special_paths[i], path) == 0;
    }
    return found;
}

// Whether a file is a mesh that can be read, and is closed.
static int is_closed(const char *path)
{
    sf_mesh *mesh = data_mesh_if(path);
    sf_topology topology = {.closed = 0};
    if (mesh != NULL) {
        CHECK_EQ(sf_mesh_analyze(sf_mesh_get_view(mesh), NULL, &topology), SF_OK);
    }
    sf_mesh_destroy(mesh);
    return topology.closed;
}

// No file is left out: not one that is added to the folders later, either.
static void all_closed_meshes_are_listed(void)
{
    static const char *const folders[] = {"broken", "cages", "characters", "parts", "slices"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (size_t i = 0; i < sizeof folders / sizeof folders[0]; i++) {
        char name[1024];
        snprintf(name, sizeof name, "%s/%s", getenv("SF_DATA"), folders[i]);
        DIR *entries = opendir(name);
        CHECK(entries != NULL);
        for (struct dirent *e; entries != NULL && (e = readdir(entries)) != NULL;) {
            char path[512];
            snprintf(path, sizeof path, "%s/%s", folders[i], e->d_name);
            // A closed mesh is listed once, and no other. Packages are looked at by
            // io/threemf_data.
            int is_right = e->d_name[0] == '.' || strstr(e->d_name, ".3mf") != NULL ||
                           is_closed(path) == is_listed(path);
            CHECK(is_right);
            if (!is_right) {
                printf("# %s\n", path);
            }
        }
        if (entries != NULL) {
            closedir(entries);
        }
    }
}

static void closed_meshes_keep_their_volume(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (size_t i = 0; i < CLOSED_COUNT; i++) {
        sf_voxelize_report report;
        double mesh, voxels = voxel_volume(closed_paths[i], 512, &report, &mesh);
        CHECK_NEAR(voxels, fabs(mesh), 0.005 * fabs(mesh));
        CHECK_EQ(report.flipped, strcmp(closed_paths[i], "characters/horse.ply") == 0);
        printf("# %s: %.6f of the mesh\n", closed_paths[i], voxels / fabs(mesh));
    }
}

// Walls of 46.5 voxels cannot keep their volume to 0.5 %; there, centres in the shape are counted.
// It is a C of thickness 1 in a box of 10 x 10 x 11.
static void a_wall_between_voxels(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    sf_voxelize_report report;
    double mesh;
    voxel_volume("parts/U_overhang.obj", 512, &report, &mesh);
    CHECK_NEAR(mesh, 290, 1e-9);
    uint64_t x = 0, outer = 0, inner = 0;
    double pitch = 11.0 / 512;
    for (uint32_t i = 0; i < 512; i++) {
        double c = (i + 0.5) * pitch;
        x += c < 10;
        outer++;
        inner += c > 1 && c < 10;
    }
    CHECK_EQ(report.solid_voxels, x * (x * outer - inner * inner));
}

// A plate of 90 x 50 x 0.05 mm under a relief of 0.45 mm. A voxel is 90/512 mm, so three layers
// have their centres in it, all three in the relief: three of its upper face, and nothing of the
// plate.
static void a_plate_of_three_layers(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    sf_voxelize_report report;
    double volume,
        voxels = voxel_volume("slices/pyphotonfile_reference.stl", 512, &report, &volume);
    double relief = (volume - 90.0 * 50.0 * 0.05) / 0.45, expected = 3 * (90.0 / 512) * relief;
    CHECK_NEAR(relief, 3613.3, 0.1);
    CHECK_NEAR(voxels, expected, 0.005 * expected);
}

// A mesh that runs through itself has the overlap twice in its volume, and once in its voxels. The
// voxels that lie in an odd number of its parts tell the one from the other.
static void what_overlaps_counts_once(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    sf_mesh *mesh = data_mesh("broken/self_intersectA.obj");
    if (mesh == NULL) {
        return;
    }
    sf_mesh_view view = sf_mesh_get_view(mesh);
    sf_lattice lattice = lattice_around(view, 512);
    sf_voxelize_report once, odd;
    sf_mass mass;
    CHECK_EQ(sf_mesh_measure(view, &mass), SF_OK);
    sf_grid_destroy(solid_voxelize(view, &lattice, SF_FILL_AUTO, &once));
    sf_grid_destroy(solid_voxelize(view, &lattice, SF_FILL_PARITY, &odd));
    double voxel = pow(lattice.pitch_x_mm, 3), twice = 2.0 * (double)once.solid_voxels;
    CHECK(once.solid_voxels > odd.solid_voxels);
    CHECK_NEAR((twice - (double)odd.solid_voxels) * voxel, mass.volume_mm3,
               0.005 * mass.volume_mm3);
    sf_mesh_destroy(mesh);
}

static void the_horse_is_its_own_flip(void)
{
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    sf_mesh *mesh = data_mesh("characters/horse.ply");
    if (mesh == NULL) {
        return;
    }
    sf_mesh_view view = sf_mesh_get_view(mesh), turned = view;
    uint32_t *triangles = malloc(3 * view.triangle_count * sizeof *triangles);
    CHECK(triangles != NULL);
    for (size_t i = 0; triangles != NULL && i < 3 * view.triangle_count; i++) {
        triangles[i] = view.triangles[i / 3 * 3 + 2 - i % 3];
    }
    turned.triangles = triangles;
    sf_lattice lattice = lattice_around(view, 200);
    sf_voxelize_report inward, outward;
    sf_grid *a = solid_voxelize(view, &lattice, SF_FILL_AUTO, &inward);
    sf_grid *b = solid_voxelize(turned, &lattice, SF_FILL_AUTO, &outward);
    CHECK(sf_grid_equal(a, b));
    CHECK(inward.flipped && !outward.flipped);
    CHECK(inward.solid_voxels > 100000);
    sf_grid_destroy(b);
    sf_grid_destroy(a);
    free(triangles);
    sf_mesh_destroy(mesh);
}

static void broken_blocks_are_blocks(void)
{
    static const char *const paths[] = {"broken/block-fill-holes-bad.stl",
                                        "broken/block-normal-directions-bad.stl",
                                        "broken/block-nearby-bad.stl", "broken/block-good.stl"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        sf_voxelize_report report;
        double mesh;
        CHECK_NEAR(voxel_volume(paths[i], 128, &report, &mesh), 61.02, 0.02 * 61.02);
    }
}

static void broken_meshes_give_something(void)
{
    static const struct {
        const char *path;
        double least_mm3, most_mm3; // by a direct sum of solid angles at resolution 96
    } files[] = {
        {"broken/self_intersectA.obj", 0.14, 0.145}, {"broken/soup.stl", 0.13, 0.145},
        {"broken/nonmanifold.stl", 0.98, 1.02},      {"broken/many_small_holes.ply", 1e-6, 1.15e-6},
        {"broken/cubes-touching.stl", 1.98, 2.02},   {"broken/non_manif_hole.ply", 4e-7, 5e-7},
        {"broken/bad-stl-tardis.stl", 18000, 20500}, {"characters/stanford-bunny.obj", 7e-4, 8e-4},
    };
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        sf_voxelize_report report;
        double mesh, voxels = voxel_volume(files[i].path, 96, &report, &mesh);
        printf("# %s: %g mm3, %zu boundary edges\n", files[i].path, voxels, report.boundary_edges);
        CHECK(voxels >= files[i].least_mm3 && voxels <= files[i].most_mm3);
    }
}

int main(void)
{
    TEST(all_closed_meshes_are_listed);
    TEST(closed_meshes_keep_their_volume);
    TEST(a_wall_between_voxels);
    TEST(a_plate_of_three_layers);
    TEST(what_overlaps_counts_once);
    TEST(the_horse_is_its_own_flip);
    TEST(broken_blocks_are_blocks);
    TEST(broken_meshes_give_something);
    return test_finish();
}
