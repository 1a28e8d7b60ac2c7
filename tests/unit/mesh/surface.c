// SPDX-License-Identifier: MIT
// Why: the surface of any grid must be a closed, oriented 2-manifold, also after vertices of equal
// position are merged, which is what every reader of an STL does; its volume must be that of the
// voxels, but for the sixteenths; and voxelising it on the same lattice must give the grid back,
// bit for bit. Every arrangement of eight voxels is tried, and dense random ones, in which every
// pinch there is occurs.

#include "failing_allocator.h"
#include "mesh/fans.h"
#include "test.h"

#include <sf/mesh.h>

#include <limits.h>

static sf_grid *make_grid(uint32_t nx, uint32_t ny, uint32_t nz, const double *heights)
{
    sf_lattice lattice = {nx, ny, nz, 0.3, 0.7, 0.45, heights, {-3.7, 11.1, 0.9}};
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &grid), SF_OK);
    return grid;
}

static void set(sf_grid *grid, uint32_t x, uint32_t y, uint32_t z)
{
    CHECK_EQ(sf_slice_set(sf_grid_slice(grid, z), x, y, 1), SF_OK);
}

static void check_surface(const sf_grid *grid)
{
    sf_mesh *mesh = NULL;
    sf_topology topology;
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &mesh), SF_OK);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    if (view.triangle_count == 0) {
        CHECK_EQ(sf_grid_popcount(grid), 0);
        sf_mesh_destroy(mesh);
        return;
    }
    CHECK_EQ(sf_mesh_validate(view, NULL), SF_OK);
    CHECK_EQ(sf_mesh_analyze(view, NULL, &topology), SF_OK); // merges by position
    CHECK(topology.closed && topology.oriented && !topology.flipped);
    CHECK_EQ(topology.nonmanifold_edges, 0);
    CHECK_EQ(topology.degenerate_triangles, 0);
    CHECK_EQ(topology.vertex_count, view.vertex_count); // no two copies in one place
    sf_lattice lattice = sf_grid_lattice(grid);
    sf_grid *again = NULL;
    CHECK_EQ(sf_grid_create(&lattice, NULL, &again), SF_OK);
    CHECK_EQ(sf_grid_voxelize(again, view, NULL, NULL, NULL, NULL), SF_OK);
    CHECK(sf_grid_equal(again, grid));
    sf_grid_destroy(again);
    sf_mesh_destroy(mesh);
}

static void every_two_by_two_by_two(void)
{
    for (unsigned pattern = 0; pattern < 256; pattern++) {
        sf_grid *grid = make_grid(2, 2, 2, NULL);
        for (unsigned o = 0; o < 8; o++) {
            if ((pattern >> o & 1) != 0) {
                set(grid, o & 1, o >> 1 & 1, o >> 2);
            }
        }
        check_surface(grid);
        sf_grid_destroy(grid);
    }
}

// Every arrangement of eight in the midst of solid matter: hollows that touch.
static void every_hollow(void)
{
    for (unsigned pattern = 0; pattern < 256; pattern++) {
        sf_grid *grid = make_grid(4, 4, 4, NULL);
        for (unsigned v = 0; v < 64; v++) {
            unsigned x = v & 3, y = v >> 2 & 3, z = v >> 4;
            int inner = (x == 1 || x == 2) && (y == 1 || y == 2) && (z == 1 || z == 2);
            if (!inner || (pattern >> ((x - 1) + 2 * (y - 1) + 4 * (z - 1)) & 1) != 0) {
                set(grid, x, y, z);
            }
        }
        check_surface(grid);
        sf_grid_destroy(grid);
    }
}

static void random_grids(void)
{
    static const double heights[7] = {0.2, 0.9, 0.3, 0.3, 0.05, 1.5, 0.6};
    for (int round = 0; round < 120; round++) {
        uint32_t nx = 1 + test_random_below(round % 10 == 0 ? 140 : 9);
        uint32_t ny = 1 + test_random_below(7), nz = 1 + test_random_below(7);
        sf_grid *grid = make_grid(nx, ny, nz, round % 3 == 0 ? heights : NULL);
        uint32_t of_ten = 1 + test_random_below(9);
        for (uint32_t i = 0; i < nx * ny * nz; i++) {
            if (test_random_below(10) < of_ten) {
                set(grid, i % nx, i / nx % ny, i / nx / ny);
            }
        }
        check_surface(grid);
        sf_grid_destroy(grid);
    }
}

// A box has the volume, the box and the number of faces that it should have.
static void a_box_is_a_box(void)
{
    sf_grid *grid = make_grid(70, 6, 5, NULL);
    for (uint32_t z = 1; z < 4; z++) {
        sf_rect rect = {2, 1, 68, 5};
        CHECK_EQ(sf_slice_fill(sf_grid_slice(grid, z), rect, 1), SF_OK);
    }
    sf_mesh *mesh = NULL;
    sf_mass mass;
    double low[3], high[3];
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &mesh), SF_OK);
    sf_mesh_view view = sf_mesh_get_view(mesh);
    CHECK_EQ(view.triangle_count, 4 * (66 * 4 + 66 * 3 + 4 * 3));
    CHECK_EQ(sf_mesh_measure(view, &mass), SF_OK);
    CHECK_NEAR(mass.volume_mm3, 66 * 0.3 * 4 * 0.7 * 3 * 0.45, 1e-9);
    CHECK_EQ(sf_mesh_bounds(view, low, high), SF_OK);
    CHECK_NEAR(low[0], -3.7 + 2 * 0.3, 1e-12);
    CHECK_NEAR(high[1], 11.1 + 5 * 0.7, 1e-12);
    CHECK_NEAR(high[2], 0.9 + 4 * 0.45, 1e-12);
    sf_mesh_destroy(mesh);
    sf_grid_destroy(grid);
}

static void nothing_has_no_surface(void)
{
    sf_grid *grid = make_grid(5, 5, 5, NULL);
    sf_mesh *mesh = NULL;
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &mesh), SF_OK);
    CHECK_EQ(sf_mesh_get_view(mesh).triangle_count, 0);
    sf_mesh_destroy(mesh);
    sf_grid_destroy(grid);
}

// Smoothing keeps connections, stays within half a voxel, and takes area away from stairs.
static void smoothing_keeps_it_closed(void)
{
    sf_grid *grid = make_grid(24, 24, 24, NULL);
    for (uint32_t i = 0; i < 24 * 24 * 24; i++) {
        double x = i % 24 - 11.5, y = i / 24 % 24 - 11.5, z = i / 576 - 11.5;
        if (x * x + y * y + z * z < 100) {
            set(grid, i % 24, i / 24 % 24, i / 576);
        }
    }
    sf_mesh *plain = NULL, *smooth = NULL;
    sf_surface_options options = sf_surface_options_default();
    sf_mass before, after;
    sf_topology topology;
    options.smooth_passes = 8;
    CHECK_EQ(sf_grid_surface(grid, NULL, NULL, NULL, &plain), SF_OK);
    CHECK_EQ(sf_grid_surface(grid, &options, NULL, NULL, &smooth), SF_OK);
    sf_mesh_view a = sf_mesh_get_view(plain), b = sf_mesh_get_view(smooth);
    CHECK_EQ(a.vertex_count, b.vertex_count);
    CHECK(memcmp(a.triangles, b.triangles, 3 * a.triangle_count * sizeof(uint32_t)) == 0);
    const double pitch[3] = {0.3, 0.7, 0.45};
    for (size_t i = 0; i < 3 * a.vertex_count; i++) {
        CHECK(fabs(a.vertices[i] - b.vertices[i]) < 0.5 * pitch[i % 3]);
    }
    CHECK_EQ(sf_mesh_analyze(b, NULL, &topology), SF_OK);
    CHECK(topology.closed && topology.oriented && !topology.flipped);
    CHECK_EQ(sf_mesh_measure(a, &before), SF_OK);
    CHECK_EQ(sf_mesh_measure(b, &after), SF_OK);
    CHECK(after.area_mm2 < 0.85 * before.area_mm2);
    CHECK_NEAR(after.volume_mm3, before.volume_mm3, 0.01 * before.volume_mm3);
    sf_mesh_destroy(plain);
    sf_mesh_destroy(smooth);
    sf_grid_destroy(grid);
}

// Fans are cycles: walk them face by face over the edges around the vertex and compare.
static void fans_are_cycles(void)
{
    static sfi_fans fans;
    sfi_fans_make(&fans);
    for (unsigned around = 0; around < 256; around++) {
        unsigned seen[24] = {0}, cycles = 0;
        for (unsigned start = 0; start < 24; start++) {
            unsigned o = start / 3, axis = start % 3;
            if ((around >> o & 1) == 0 || (around >> (o ^ 1u << axis) & 1) != 0 || seen[start]) {
                continue;
            }
            unsigned fan = fans.fan[around][start], leave = (axis + 1) % 3;
            cycles++;
            do { // leave the face over the half-edge between `axis` and `leave`
                seen[3 * o + axis] = 1;
                CHECK_EQ(fans.fan[around][3 * o + axis], fan);
                unsigned beside = o ^ 1u << leave;
                if ((around >> beside & 1) == 0) { // convex: turn around the same voxel
                    unsigned swap = axis;
                    axis = leave;
                    leave = 3 - swap - leave;
                } else if ((around >> (beside ^ 1u << axis) & 1) == 0) { // flat: go on straight
                    o = beside;
                    leave = 3 - axis - leave;
                } else { // concave: climb the voxel in front
                    unsigned swap = axis;
                    o = beside ^ 1u << axis;
                    axis = leave;
                    leave = 3 - swap - leave;
                }
            } while (!seen[3 * o + axis]);
        }
        CHECK_EQ(cycles, fans.count[around]);
    }
}

static void memory_runs_out_anywhere(void)
{
    sf_grid *grid = make_grid(9, 9, 9, NULL);
    sf_surface_options options = sf_surface_options_default();
    options.smooth_passes = 1;
    for (uint32_t i = 0; i < 9; i++) {
        set(grid, i, i, i);
    }
    for (long n = 0;; n++) {
        failing_allocator from;
        failing_begin(&from, n);
        sf_mesh *mesh = NULL;
        sf_status status = sf_grid_surface(grid, &options, &from.allocator, NULL, &mesh);
        CHECK(status == SF_OK ? mesh != NULL : status == SF_ERR_MEMORY && mesh == NULL);
        sf_mesh_destroy(mesh);
        CHECK(from.live == 0 && from.faults == 0);
        if (status == SF_OK) {
            CHECK(n > 5);
            break;
        }
    }
    sf_grid_destroy(grid);
}

// A host that watches, and cancels once the fraction has reached `stop_at`.
typedef struct host {
    sf_task task;
    double last, stop_at;
    int calls, falls;
} host;

static void watch(void *user, double fraction)
{
    host *h = user;
    h->calls++;
    h->falls += fraction < h->last;
    h->last = fraction;
    if (fraction >= h->stop_at) {
        sf_task_cancel(&h->task);
    }
}

static sf_status watched(const sf_grid *grid, int passes, double stop_at, host *h)
{
    sf_surface_options options = sf_surface_options_default();
    sf_mesh *mesh = NULL;
    memset(h, 0, sizeof *h);
    h->task = sf_task_default();
    h->task.progress = watch;
    h->task.user = h;
    h->stop_at = stop_at;
    options.smooth_passes = passes;
    sf_status status = sf_grid_surface(grid, &options, NULL, &h->task, &mesh);
    CHECK_EQ(status == SF_OK, mesh != NULL);
    CHECK_EQ(h->falls, 0);
    sf_mesh_destroy(mesh);
    return status;
}

// Of two walks and six passes, each an eighth of the work.
static void smoothing_heeds_its_task(void)
{
    sf_grid *grid = make_grid(9, 9, 4, NULL);
    host h;
    set(grid, 3, 3, 1);
    CHECK_EQ(watched(grid, 6, 2, &h), SF_OK);
    CHECK_EQ(h.calls, 2 * 4 + 6);
    CHECK_NEAR(h.last, 1, 0);
    CHECK_EQ(watched(grid, 6, 0.5, &h), SF_ERR_CANCELLED);
    CHECK_NEAR(h.last, 0.5, 0);
    CHECK_EQ(watched(grid, 0, 0.5, &h), SF_ERR_CANCELLED);
    CHECK_EQ(watched(grid, SF_SMOOTH_PASSES_MAX, 2, &h), SF_OK);
    CHECK_EQ(watched(grid, SF_SMOOTH_PASSES_MAX + 1, 2, &h), SF_ERR_ARGUMENT);
    CHECK_EQ(watched(grid, INT_MAX, 2, &h), SF_ERR_ARGUMENT);
    CHECK_EQ(watched(grid, -1, 2, &h), SF_ERR_ARGUMENT);
    sf_grid_destroy(grid);
}

int main(void)
{
    TEST(fans_are_cycles);
    TEST(every_two_by_two_by_two);
    TEST(every_hollow);
    TEST(random_grids);
    TEST(a_box_is_a_box);
    TEST(nothing_has_no_surface);
    TEST(smoothing_keeps_it_closed);
    TEST(smoothing_heeds_its_task);
    TEST(memory_runs_out_anywhere);
    return test_finish();
}
