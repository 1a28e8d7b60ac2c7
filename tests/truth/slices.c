// SPDX-License-Identifier: MIT
// Why: a resin printer's own slices of a mesh are a judge from outside. The reference print of a
// slicer, sliced again on its pixels, must have the slicer's components in every layer and its
// pixel counts within 0.1 % (TRUTH.md beside the data). The twin that always runs is a plate with
// pegs, whose counts are known by arithmetic.

#include "data_file.h"

static void count_layer(sf_slice slice, uint64_t *pixels, uint32_t *components)
{
    size_t count = 0;
    CHECK_EQ(sf_slice_run_count(slice, &count), SF_OK);
    sf_run *runs = malloc((count + 1) * sizeof *runs);
    CHECK(runs != NULL);
    CHECK_EQ(sf_slice_runs(slice, runs, count, &count), SF_OK);
    CHECK_EQ(sf_runs_label(runs, count, SF_CONNECT_CORNERS, components), SF_OK);
    *pixels = sf_slice_popcount(slice);
    free(runs);
}

static sf_grid *slice_mesh(sf_mesh_view view, double pitch, double layer)
{
    double low[3] = {0, 0, 0}, high[3] = {1, 1, 1};
    CHECK_EQ(sf_mesh_bounds(view, low, high), SF_OK);
    sf_lattice lattice = {(uint32_t)ceil((high[0] - low[0]) / pitch - 1e-6) + 2,
                          (uint32_t)ceil((high[1] - low[1]) / pitch - 1e-6) + 2,
                          (uint32_t)ceil((high[2] - low[2]) / layer - 1e-6),
                          pitch,
                          pitch,
                          layer,
                          NULL,
                          {low[0] - pitch, low[1] - pitch, low[2]}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    CHECK_EQ(sf_grid_voxelize(grid, view, NULL, NULL, NULL, NULL), SF_OK);
    return grid;
}

static void the_reference_print(void)
{
    static const double white[10] = {2016336, 1618752, 1618751, 1618747, 1618753,
                                     1618749, 1618755, 1618758, 1618753, 1618755};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA is not set");
    }
    sf_mesh *mesh = data_mesh("slices/pyphotonfile_reference.stl");
    sf_grid *grid = slice_mesh(sf_mesh_get_view(mesh), 0.04725, 0.05);
    CHECK_EQ(sf_grid_lattice(grid).nz, 10);
    for (uint32_t k = 0; k < 10; k++) {
        uint64_t pixels = 0;
        uint32_t components = 0;
        count_layer(sf_grid_slice(grid, k), &pixels, &components);
        CHECK_EQ(components, k == 0 ? 1 : 17);
        CHECK_NEAR((double)pixels, white[k], 1e-3 * white[k]);
        printf("# layer %u: %u components, %llu pixels, %+.4f %%\n", (unsigned)k,
               (unsigned)components, (unsigned long long)pixels,
               100 * ((double)pixels / white[k] - 1));
    }
    sf_grid_destroy(grid);
    sf_mesh_destroy(mesh);
}

static void add_box(sf_mesh *mesh, const double low[3], const double high[3])
{
    static const uint32_t faces[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                       2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    double corners[24];
    uint32_t triangles[36], first = (uint32_t)sf_mesh_get_view(mesh).vertex_count;
    for (int i = 0; i < 24; i++) {
        corners[i] = (i / 3 >> i % 3 & 1) != 0 ? high[i % 3] : low[i % 3];
    }
    for (int i = 0; i < 36; i++) {
        triangles[i] = first + faces[i];
    }
    CHECK_EQ(sf_mesh_add_vertices(mesh, corners, 8), SF_OK);
    CHECK_EQ(sf_mesh_add_triangles(mesh, triangles, 12), SF_OK);
}

// A plate of 6 x 5 x 0.1 mm with 12 pegs of 0.5 x 0.5 mm up to 0.4 mm, pixels of 0.05 mm.
static void a_plate_with_pegs(void)
{
    sf_mesh *mesh = NULL;
    CHECK_EQ(sf_mesh_create(NULL, &mesh), SF_OK);
    const double low[3] = {1, 2, 3}, high[3] = {7, 7, 3.1};
    add_box(mesh, low, high);
    for (int i = 0; i < 12; i++) {
        const double foot[3] = {1.5 + 1.25 * (i % 4), 2.5 + 1.5 * (i / 4), 3.1};
        const double top[3] = {foot[0] + 0.5, foot[1] + 0.5, 3.4};
        add_box(mesh, foot, top);
    }
    sf_grid *grid = slice_mesh(sf_mesh_get_view(mesh), 0.05, 0.1);
    CHECK_EQ(sf_grid_lattice(grid).nz, 4);
    for (uint32_t k = 0; k < 4; k++) {
        uint64_t pixels = 0;
        uint32_t components = 0;
        count_layer(sf_grid_slice(grid, k), &pixels, &components);
        CHECK_EQ(components, k == 0 ? 1 : 12);
        CHECK_EQ(pixels, k == 0 ? 120 * 100 : 12 * 10 * 10);
    }
    sf_grid_destroy(grid);
    sf_mesh_destroy(mesh);
}

int main(void)
{
    TEST(a_plate_with_pegs);
    TEST(the_reference_print);
    return test_finish();
}
