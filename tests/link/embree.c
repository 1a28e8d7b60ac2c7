// SPDX-License-Identifier: MIT
// Why: rays are judged by shapes whose distances and thicknesses are known by heart; and the voxels
// that Embree's rays find must be those of the library's own voxeliser, which shares no code with
// them: within 0.01 % on models that people made, and nearly all the same ones. Guards: issue 8
// part 4.

#include <sf/io.h>
#include <sf/link/embree.h>

#include "../failing_allocator.h"
#include "../test.h"

// A box from 0 to (2, 3, 5), each face two triangles.
static const double box_points[24] = {0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0,
                                      0, 0, 5, 2, 0, 5, 2, 3, 5, 0, 3, 5};
static const uint32_t box_corners[36] = {0, 3, 2, 0, 2, 1, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                                         1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7};
static const sf_mesh_view box = {box_points, 8, box_corners, 12};

static sf_embree *prepare(sf_mesh_view mesh)
{
    sf_embree *e = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    CHECK_EQ(sf_embree_create(mesh, NULL, &e, &fault), SF_OK);
    if (e == NULL) {
        printf("# %s\n", fault.message);
        exit(1);
    }
    return e;
}

static void rays_hit_the_nearest_face(void)
{
    sf_embree *e = prepare(box);
    double from[12] = {1, 1, 9, 1, 1, 2, 1, 1, 9, -4, 1.5, 2.5};
    double direction[12] = {0, 0, -2, 0, 3, 0, 0, 0, 1, 0.5, 0, 0}, along[4];
    uint32_t triangle[4];
    CHECK_EQ(sf_embree_nearest(e, 4, from, direction, along, triangle), SF_OK);
    CHECK_NEAR(along[0], 2, 1e-6);
    CHECK(triangle[0] == 2 || triangle[0] == 3);
    CHECK_NEAR(along[1], 2.0 / 3, 1e-6);
    CHECK(triangle[1] == 8 || triangle[1] == 9);
    CHECK(isinf(along[2]) && triangle[2] == SF_EMBREE_NONE);
    CHECK_NEAR(along[3], 8, 1e-5);
    CHECK_EQ(sf_embree_nearest(e, 1, from, direction, along, NULL), SF_OK);
    sf_embree_destroy(e);
}

// No ray slips between triangles, however it runs: random ones from inside of a ball always end.
static void no_ray_slips_through(void)
{
    sf_mesh *mesh = NULL;
    sf_lattice lattice = {24, 24, 24, 1, 1, 1, NULL, {1000, -1000, 500}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    for (uint32_t k = 2; k < 22; k++) {
        sf_rect rect = {2 + k % 3, 2, 22, 20 + k % 2};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, k), rect, 1), SF_OK);
    }
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &mesh), SF_OK);
    sf_embree *e = prepare(sf_mesh_get_view(mesh));
    int slipped = 0;
    for (int i = 0; i < 20000; i++) {
        double from[3] = {1012, -988, 512}, direction[3], along;
        for (int k = 0; k < 3; k++) {
            direction[k] = test_random_unit() - 0.5;
            direction[k] = i % 4 == k ? 0 : direction[k];
        }
        CHECK_EQ(sf_embree_nearest(e, 1, from, direction, &along, NULL), SF_OK);
        slipped += isinf(along) != 0;
    }
    CHECK_EQ(slipped, 0);
    sf_embree_destroy(e);
    sf_mesh_destroy(mesh);
    sf_grid_destroy(grid);
}

// Of a box, with one ray: the distance to the other side. Of a thin plate with many: near it.
static void thickness_is_that_of_boxes(void)
{
    sf_embree *e = prepare(box);
    sf_embree_thickness_options one = sf_embree_thickness_options_default();
    double thick[12];
    one.rays = 1;
    CHECK_EQ(sf_embree_thickness(e, &one, NULL, thick), SF_OK);
    static const double expected[12] = {5, 5, 5, 5, 3, 3, 2, 2, 3, 3, 2, 2};
    for (int i = 0; i < 12; i++) {
        CHECK_NEAR(thick[i], expected[i], 1e-4);
    }
    sf_embree_destroy(e);
    double plate[24];
    for (int i = 0; i < 24; i++) {
        plate[i] = box_points[i] * (i % 3 == 2 ? 0.2 : 100); // 1 mm thick
    }
    sf_mesh_view view = {plate, 8, box_corners, 12};
    e = prepare(view);
    CHECK_EQ(sf_embree_thickness(e, NULL, NULL, thick), SF_OK);
    for (int i = 0; i < 4; i++) {
        CHECK(thick[i] > 1 && thick[i] < 1.5);
    }
    // The same inside out: the mesh is turned as a whole.
    uint32_t turned[36];
    for (int i = 0; i < 36; i++) {
        turned[i] = box_corners[i / 3 * 3 + (3 - i % 3) % 3];
    }
    sf_mesh_view inverse = {plate, 8, turned, 12};
    double again[12];
    sf_embree_destroy(e);
    e = prepare(inverse);
    CHECK_EQ(sf_embree_thickness(e, NULL, NULL, again), SF_OK);
    for (int i = 0; i < 4; i++) {
        CHECK_NEAR(again[i], thick[i], 0.05);
    }
    sf_embree_destroy(e);
}

static void handles_are_put_behind_a_pointer(void)
{
    sf_embree *e = prepare(box);
    double from[3] = {1, 1, 20}, down[3] = {0, 0, -0.5}, inside[3] = {1, 1, 1}, at[3];
    double away[3] = {0, 0, 1}, aside[3] = {9, 9, 9};
    sf_ray_caster caster = sf_embree_caster(e);
    CHECK_EQ(sf_handle_center_by_rays(caster, from, down, at, NULL), SF_OK);
    CHECK(fabs(at[0] - 1) < 1e-6 && fabs(at[1] - 1) < 1e-6 && fabs(at[2] - 2.5) < 1e-5);
    CHECK_EQ(sf_handle_center_by_rays(caster, inside, away, at, NULL), SF_OK);
    CHECK_NEAR(at[2], 3, 1e-5);
    CHECK_EQ(sf_handle_center_by_rays(caster, aside, away, at, NULL), SF_ERR_INFEASIBLE);
    CHECK(sf_embree_caster(NULL).next == NULL);
    sf_embree_destroy(e);
}

// ---------------------------------------------------------------------------------------------
// Voxels
// ---------------------------------------------------------------------------------------------

static uint64_t count(const sf_grid *grid, const sf_grid *other, uint64_t *differ)
{
    sf_lattice l = sf_grid_lattice(grid);
    uint64_t solid = 0;
    *differ = 0;
    for (uint32_t k = 0; k < l.nz; k++) {
        sf_slice a = sf_grid_slice(grid, k), b = sf_grid_slice(other, k);
        for (uint32_t y = 0; y < l.ny; y++) {
            for (uint32_t x = 0; x < l.nx; x++) {
                uint64_t in_a = a.words[y * a.stride + x / 64] >> x % 64 & 1;
                uint64_t in_b = b.words[y * b.stride + x / 64] >> x % 64 & 1;
                solid += in_a;
                *differ += in_a != in_b;
            }
        }
    }
    return solid;
}

// Both voxelisers on `cells` voxels along the longest side. Centres lie aside by another part of a
// voxel along each axis: else whole rows of them lie in chamfers, where a rounding decides.
static void compare(sf_mesh_view mesh, const char *name, uint32_t cells, double most)
{
    static const double aside[3] = {1.31, 1.37, 1.43};
    double low[3], high[3], longest = 0;
    sf_lattice l = {0, 0, 0, 0, 0, 0, NULL, {0, 0, 0}};
    sf_grid *ours = NULL, *theirs = NULL;
    uint64_t differ, unused;
    CHECK_EQ(sf_mesh_bounds(mesh, low, high), SF_OK);
    for (int i = 0; i < 3; i++) {
        longest = fmax(longest, high[i] - low[i]);
    }
    l.pitch_x_mm = l.pitch_y_mm = l.layer_mm = longest / cells;
    for (int i = 0; i < 3; i++) {
        l.origin_mm[i] = low[i] - aside[i] * l.layer_mm;
    }
    l.nx = (uint32_t)((high[0] - low[0]) / l.layer_mm) + 4;
    l.ny = (uint32_t)((high[1] - low[1]) / l.layer_mm) + 4;
    l.nz = (uint32_t)((high[2] - low[2]) / l.layer_mm) + 4;
    CHECK_EQ(sf_grid_create(&l, NULL, &ours), SF_OK);
    CHECK_EQ(sf_grid_create(&l, NULL, &theirs), SF_OK);
    CHECK_EQ(sf_grid_voxelize(ours, mesh, NULL, NULL, NULL, NULL), SF_OK);
    sf_embree *e = prepare(mesh);
    CHECK_EQ(sf_embree_voxelize(e, theirs, NULL), SF_OK);
    uint64_t a = count(ours, theirs, &differ), b = count(theirs, ours, &unused);
    double off = a > b ? (double)(a - b) : (double)(b - a);
    printf("# %s: %llu voxels, Embree's %llu: %.4f %% off, %llu differ\n", name,
           (unsigned long long)a, (unsigned long long)b, 100 * off / (double)a,
           (unsigned long long)differ);
    CHECK(a > 1000 && off <= most * (double)a && (double)differ <= 2e-3 * (double)a);
    sf_embree_destroy(e);
    sf_grid_destroy(ours);
    sf_grid_destroy(theirs);
}

// On a lattice whose centres lie in the box's faces: those on the low side are in, as ours.
static void voxels_of_a_box_are_the_same(void)
{
    sf_lattice l = {12, 14, 16, 0.5, 0.5, 0.5, NULL, {-1.25, -1.25, -1.25}};
    sf_grid *ours = NULL, *theirs = NULL;
    uint64_t differ;
    CHECK_EQ(sf_grid_create(&l, NULL, &ours), SF_OK);
    CHECK_EQ(sf_grid_create(&l, NULL, &theirs), SF_OK);
    CHECK_EQ(sf_grid_voxelize(ours, box, NULL, NULL, NULL, NULL), SF_OK);
    sf_embree *e = prepare(box);
    CHECK_EQ(sf_embree_voxelize(e, theirs, NULL), SF_OK);
    CHECK_EQ(count(ours, theirs, &differ), 4 * 6 * 10);
    CHECK_EQ(differ, 0);
    sf_embree_destroy(e);
    sf_grid_destroy(ours);
    sf_grid_destroy(theirs);
}

static void voxels_of_models_are_ours(void)
{
    // The last has walls that run along the lattice's axes: where one lies within the 1/512 of a
    // voxel to which the library rounds corners, all of its voxels go to one side.
    static const char *const paths[] = {"characters/armadillo.obj",  "characters/horse.ply",
                                        "characters/penguin_hr.obj", "characters/human_man.obj",
                                        "parts/A_upsidedown.obj",    "parts/ksr_fdmtest_v4.stl"};
    if (getenv("SF_DATA") == NULL) {
        SKIP("SF_DATA names no folder");
    }
    for (size_t i = 0; i < sizeof paths / sizeof paths[0]; i++) {
        char path[1024];
        sf_file *file = NULL;
        sf_mesh *mesh = NULL;
        snprintf(path, sizeof path, "%s/%s", getenv("SF_DATA"), paths[i]);
        CHECK_EQ(sf_file_open(path, NULL, &file, NULL), SF_OK);
        CHECK_EQ(sf_mesh_read(sf_file_source(file), SF_MESH_FORMAT_AUTO, NULL, NULL, &mesh, NULL),
                 SF_OK);
        sf_file_close(file);
        compare(sf_mesh_get_view(mesh), paths[i], 300, i < 5 ? 1e-4 : 1e-3);
        sf_mesh_destroy(mesh);
    }
}

// ---------------------------------------------------------------------------------------------
// The adapter itself
// ---------------------------------------------------------------------------------------------

static void threads(void *user, size_t count, sf_task_body body, void *context)
{
    for (size_t i = count; i > 0; i--) { // another order than one after the other
        body(context, i - 1);
    }
    ++*(int *)user;
}

static double last;

static void note(void *user, double fraction)
{
    (void)user;
    CHECK(fraction >= last && fraction <= 1);
    last = fraction;
}

static void tells_stops_and_takes_threads(void)
{
    sf_grid *grid = NULL;
    sf_mesh *mesh = NULL;
    sf_lattice lattice = {20, 20, 20, 1, 1, 1, NULL, {0, 0, 0}};
    sf_rect rect = {3, 3, 15, 17};
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, 4), rect, 1), SF_OK);
    CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, 5), rect, 1), SF_OK);
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &mesh), SF_OK);
    sf_embree *e = prepare(sf_mesh_get_view(mesh));
    size_t size = sf_mesh_get_view(mesh).triangle_count;
    double *plain = calloc(size, sizeof *plain), *threaded = calloc(size, sizeof *threaded);
    int calls = 0;
    sf_task task = sf_task_default();
    task.progress = note;
    task.parallel_for = threads;
    task.user = &calls;
    last = 0;
    CHECK_EQ(sf_embree_thickness(e, NULL, NULL, plain), SF_OK);
    CHECK_EQ(sf_embree_thickness(e, NULL, &task, threaded), SF_OK);
    CHECK(memcmp(plain, threaded, size * sizeof *plain) == 0);
    CHECK(last == 1 && size > 256);
    last = 0;
    CHECK_EQ(sf_embree_voxelize(e, grid, &task), SF_OK);
    CHECK(last == 1);
    sf_task_cancel(&task);
    CHECK_EQ(sf_embree_thickness(e, NULL, &task, threaded), SF_ERR_CANCELLED);
    CHECK_EQ(sf_embree_voxelize(e, grid, &task), SF_ERR_CANCELLED);
    free(plain);
    free(threaded);
    sf_embree_destroy(e);
    sf_mesh_destroy(mesh);
    sf_grid_destroy(grid);
}

static void refuses(void)
{
    sf_embree *e = NULL;
    sf_fault fault = {SF_OK, 0, 0, ""};
    sf_mesh_view empty = {box_points, 8, NULL, 0}, none = {NULL, 8, box_corners, 12};
    double far[24], from[3] = {0, 0, 0}, direction[3] = {0, 0, 1}, along = 7;
    double tiny[3] = {1e-300, 0, 0}, nan[3] = {0, NAN, 0};
    memcpy(far, box_points, sizeof far);
    far[4] = 2e12;
    sf_mesh_view beyond = {far, 8, box_corners, 12};
    CHECK_EQ(sf_embree_create(empty, NULL, &e, &fault), SF_ERR_UNSUPPORTED);
    CHECK(fault.message[0] != '\0');
    CHECK_EQ(sf_embree_create(beyond, NULL, &e, &fault), SF_ERR_UNSUPPORTED);
    CHECK(sf_embree_create(none, NULL, &e, &fault) != SF_OK && e == NULL);
    CHECK_EQ(sf_embree_create(box, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    e = prepare(box);
    CHECK_EQ(sf_embree_nearest(NULL, 1, from, direction, &along, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_embree_nearest(e, 1, from, tiny, &along, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_embree_nearest(e, 1, nan, direction, &along, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_embree_nearest(e, 1, from, NULL, &along, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_embree_nearest(e, 0, NULL, NULL, NULL, NULL), SF_OK);
    CHECK(along == 7);
    sf_embree_thickness_options how = sf_embree_thickness_options_default();
    how.rays = 0;
    CHECK_EQ(sf_embree_thickness(e, &how, NULL, far), SF_ERR_ARGUMENT);
    how.rays = 3;
    how.cone_rad = 1.5;
    CHECK_EQ(sf_embree_thickness(e, &how, NULL, far), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_embree_thickness(e, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_embree_voxelize(e, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_embree_voxelize(NULL, NULL, NULL), SF_ERR_ARGUMENT);
    sf_embree_destroy(e);
    sf_embree_destroy(NULL);
    failing_allocator memory;
    failing_begin(&memory, 0);
    e = NULL;
    CHECK_EQ(sf_embree_create(box, &memory.allocator, &e, NULL), SF_ERR_MEMORY);
    CHECK(e == NULL && memory.live == 0);
    failing_begin(&memory, -1);
    CHECK_EQ(sf_embree_create(box, &memory.allocator, &e, NULL), SF_OK);
    sf_embree_destroy(e);
    CHECK(memory.live == 0 && memory.faults == 0);
}

int main(void)
{
    TEST(rays_hit_the_nearest_face);
    TEST(no_ray_slips_through);
    TEST(thickness_is_that_of_boxes);
    TEST(handles_are_put_behind_a_pointer);
    TEST(voxels_of_a_box_are_the_same);
    TEST(voxels_of_models_are_ours);
    TEST(tells_stops_and_takes_threads);
    TEST(refuses);
    return test_finish();
}
