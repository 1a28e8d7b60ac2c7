// SPDX-License-Identifier: MIT
// Why: a wall that is too thin is a hole, so the promise is one-sided: what is not wall has no
// point nearer to the surface than the thickness (TRUST 64, 68). Walls are held against the
// distance of each voxel to every triangle, against points strewn over voxels and surface, and
// against whole numbers of voxels where the surface lies along the lattice; on oblong voxels,
// layers of any height, surfaces that leave the lattice, for thicknesses from nothing to all.

#include "backwards.h"
#include "distances.h"
#include "failing_allocator.h"
#include "unit/mesh/solids.h"

#include <sf/carve.h>

static solid s;
static const double heights[] = {1, 0.5, 0.75, 1.5, 0.5, 1, 1, 2, 0.5, 0.75, 1, 0.5};

static sf_lattice lattice_of(int kind)
{
    sf_lattice cubes = {14, 13, 12, 1, 1, 1, NULL, {0, 0, 0}};
    sf_lattice oblong = {20, 9, 8, 0.7, 1.5, 1.625, NULL, {0, -0.5, 0}};
    sf_lattice layers = {14, 13, 12, 1, 1, 7, heights, {0, 0, 0}};
    sf_lattice inside = {5, 70, 4, 1, 0.2, 1, NULL, {4, -0.5, 4}}; // the surface goes on beyond it
    return kind == 0 ? cubes : kind == 1 ? oblong : kind == 2 ? layers : inside;
}

static void make_solid(int kind)
{
    double center[3] = {6.5 + test_random_unit(), 6 + test_random_unit(), 6};
    double low[3] = {1.5, 2.25, 2}, high[3] = {12.25, 11, 9};
    s.vertex_count = s.triangle_count = 0;
    if (kind % 3 == 0) {
        solid_sphere(&s, center, 5.5, 7, 9, 0.3);
    } else if (kind % 3 == 1) {
        solid_box(&s, low, high);
    } else {
        double corners[4][3];
        for (int i = 0; i < 12; i++) {
            corners[i / 3][i % 3] = 13 * test_random_unit();
        }
        solid_tetra(&s, corners);
    }
}

static sf_grid *grid_of(const sf_lattice *lattice)
{
    sf_grid *grid = NULL;
    CHECK_EQ(sf_grid_create(lattice, NULL, &grid), SF_OK);
    return grid;
}

static sf_grid *fill(const sf_lattice *lattice)
{
    sf_grid *grid = grid_of(lattice);
    CHECK_EQ(sf_grid_voxelize(grid, solid_view(&s), NULL, NULL, NULL, NULL), SF_OK);
    return grid;
}

static int get(const sf_grid *grid, uint32_t x, uint32_t y, uint32_t k)
{
    return sf_slice_get(sf_grid_slice(grid, k), x, y);
}

// ---------------------------------------------------------------------------------------------
// With a mesh
// ---------------------------------------------------------------------------------------------

static void compare(const sf_grid *grid, double wall_mm)
{
    sf_lattice l = sf_grid_lattice(grid);
    sf_grid *wall = grid_of(&l);
    CHECK_EQ(sf_grid_wall(grid, solid_view(&s), wall_mm, NULL, NULL, wall), SF_OK);
    for (uint32_t i = 0; i < l.nx * l.ny * l.nz; i++) {
        uint32_t x = i % l.nx, y = i / l.nx % l.ny, k = i / l.nx / l.ny;
        double low[3], high[3];
        if (!get(grid, x, y, k)) {
            CHECK(!get(wall, x, y, k));
            continue;
        }
        voxel_box(&l, x, y, k, low, high);
        double distance = box_mesh(low, high, solid_view(&s));
        if (fabs(distance - wall_mm) > 1e-9) {
            CHECK_EQ(get(wall, x, y, k), distance < wall_mm);
        }
    }
    sf_grid_destroy(wall);
}

static void distances_decide(void)
{
    for (int i = 0; i < 36; i++) {
        sf_lattice lattice = lattice_of(i % 4);
        make_solid(i / 4);
        sf_grid *grid = fill(&lattice);
        compare(grid, 6 * test_random_unit() * test_random_unit());
        compare(grid, 1 + i % 3);
        sf_grid_destroy(grid);
    }
}

// The least distance of all solid voxels, of cavities and of noise; none where nothing is solid.
static void clearance_is_the_least_distance(void)
{
    for (int i = 0; i < 24; i++) {
        sf_lattice l = lattice_of(i % 4);
        make_solid(i / 4);
        sf_grid *grid = fill(&l), *wall = grid_of(&l);
        double least = 7, want = INFINITY;
        CHECK_EQ(sf_grid_wall(grid, solid_view(&s), i % 5 * 0.6, NULL, NULL, wall), SF_OK);
        for (uint32_t j = 0; j < l.nx * l.ny * l.nz; j++) {
            uint32_t x = j % l.nx, y = j / l.nx % l.ny, k = j / l.nx / l.ny;
            double low[3], high[3];
            int in = get(grid, x, y, k) && !get(wall, x, y, k) && test_random_below(9) > 0;
            CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), x, y, in), SF_OK);
            voxel_box(&l, x, y, k, low, high);
            want = in ? fmin(want, box_mesh(low, high, solid_view(&s))) : want;
        }
        CHECK_EQ(sf_grid_clearance(grid, solid_view(&s), NULL, NULL, &least), SF_OK);
        CHECK(least == want || fabs(least - want) < 1e-5);
        sf_grid_destroy(grid);
        sf_grid_destroy(wall);
    }
}

// A thickness of more voxels than an element reaches.
static void very_fine_voxels(void)
{
    sf_lattice lattice = {700, 3, 3, 0.01, 1, 1, NULL, {3, 5, 5}};
    make_solid(1);
    sf_grid *grid = fill(&lattice);
    compare(grid, 2.605);
    compare(grid, 3.5);
    sf_grid_destroy(grid);
}

// Points of what is not wall, and points of the surface: none of the first is near any of the
// second.
static void no_point_is_nearer(void)
{
    for (int round = 0; round < 12; round++) {
        sf_lattice l = lattice_of(round % 3);
        double wall_mm = 0.5 + 2 * test_random_unit();
        make_solid(round);
        sf_grid *grid = fill(&l), *wall = grid_of(&l);
        CHECK_EQ(sf_grid_wall(grid, solid_view(&s), wall_mm, NULL, NULL, wall), SF_OK);
        for (int i = 0; i < 20000; i++) {
            uint32_t x = test_random_below(l.nx), y = test_random_below(l.ny);
            uint32_t k = test_random_below(l.nz);
            double low[3], high[3], u = test_random_unit(), v = test_random_unit();
            if (!get(grid, x, y, k) || get(wall, x, y, k)) {
                continue;
            }
            voxel_box(&l, x, y, k, low, high);
            const uint32_t *t = s.triangles + 3 * test_random_below((uint32_t)s.triangle_count);
            vec a = vec_of(s.vertices + 3 * t[0]), b = vec_of(s.vertices + 3 * t[1]);
            vec c = vec_of(s.vertices + 3 * t[2]), in;
            u = u + v > 1 ? 1 - u : u;
            v = u + v > 1 ? 1 - v : v;
            vec on = vec_add(vec_add(a, u, vec_add(b, -1, a)), v, vec_add(c, -1, a));
            for (int j = 0; j < 3; j++) { // the nearest point of the voxel, corners included
                in.v[j] = fmin(high[j], fmax(low[j], on.v[j]));
            }
            CHECK(vec_far(in, on) >= wall_mm - 1e-9);
        }
        sf_grid_destroy(grid);
        sf_grid_destroy(wall);
    }
}

// A box along the lattice has walls of whole voxels, however its lengths are written.
static void whole_voxels(void)
{
    static const double pitches[] = {0.1, 0.3, 0.7, 1.0 / 3, 25.4 / 128};
    for (int i = 0; i < 5; i++) {
        double p = pitches[i], low[3] = {7 * p, -3 * p, 11 * p};
        double high[3] = {19 * p, 9 * p, 23 * p};
        sf_lattice lattice = {14, 14, 12, p, p, p, NULL, {low[0] - p, low[1] - p, low[2]}};
        s.vertex_count = s.triangle_count = 0;
        solid_box(&s, low, high);
        sf_grid *grid = fill(&lattice), *wall = grid_of(&lattice), *inner = grid_of(&lattice);
        CHECK_EQ(sf_grid_popcount(grid), 12 * 12 * 12);
        for (int n = 0; n <= 7; n++) {
            uint64_t rest = n < 6 ? (uint64_t)(12 - 2 * n) : 0;
            double wall_mm = n * p;
            CHECK_EQ(sf_grid_wall(grid, solid_view(&s), wall_mm, NULL, NULL, wall), SF_OK);
            CHECK_EQ(sf_grid_popcount(wall), 12 * 12 * 12 - rest * rest * rest);
            CHECK_EQ(sf_grid_wall_inside(grid, wall_mm, NULL, NULL, inner), SF_OK);
            CHECK(sf_grid_equal(wall, inner));
        }
        sf_grid_destroy(grid);
        sf_grid_destroy(wall);
        sf_grid_destroy(inner);
    }
}

// ---------------------------------------------------------------------------------------------
// Without a mesh
// ---------------------------------------------------------------------------------------------

static double gap(double low, double high, double other_low, double other_high)
{
    return fmax(0, fmax(other_low - high, low - other_high));
}

// The least gap between a voxel and one that is not solid; beyond the grid, one around it is
// enough.
static double gap_of(const sf_grid *grid, const sf_lattice *l, uint32_t x, uint32_t y, uint32_t k)
{
    double low[3], high[3], a[3], b[3];
    voxel_box(l, x, y, k, low, high);
    double end[3] = {l->origin_mm[0] + l->nx * l->pitch_x_mm,
                     l->origin_mm[1] + l->ny * l->pitch_y_mm, sf_lattice_layer_bottom(l, l->nz)};
    double least = 1e300;
    for (int i = 0; i < 3; i++) {
        least = fmin(least, fmin(low[i] - l->origin_mm[i], end[i] - high[i]));
    }
    for (uint32_t i = 0; i < l->nx * l->ny * l->nz; i++) {
        uint32_t u = i % l->nx, v = i / l->nx % l->ny, w = i / l->nx / l->ny;
        if (!get(grid, u, v, w)) {
            voxel_box(l, u, v, w, a, b);
            double g[3];
            for (int j = 0; j < 3; j++) {
                g[j] = gap(low[j], high[j], a[j], b[j]);
            }
            least = fmin(least, sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]));
        }
    }
    return least;
}

static void gaps_decide(void)
{
    for (int i = 0; i < 12; i++) {
        sf_lattice l = lattice_of(i % 3);
        make_solid(i);
        sf_grid *grid = fill(&l), *wall = grid_of(&l);
        double wall_mm = i % 2 ? 3 * test_random_unit() : i % 4;
        CHECK_EQ(sf_grid_wall_inside(grid, wall_mm, NULL, NULL, wall), SF_OK);
        for (uint32_t j = 0; j < l.nx * l.ny * l.nz; j++) {
            uint32_t x = j % l.nx, y = j / l.nx % l.ny, k = j / l.nx / l.ny;
            if (!get(grid, x, y, k)) {
                CHECK(!get(wall, x, y, k));
                continue;
            }
            double distance = gap_of(grid, &l, x, y, k);
            if (fabs(distance - wall_mm) > 1e-9) {
                CHECK_EQ(get(wall, x, y, k), distance < wall_mm);
            } else {
                CHECK_EQ(get(wall, x, y, k), 0); // just as far is not nearer
            }
        }
        sf_grid_destroy(grid);
        sf_grid_destroy(wall);
    }
}

// ---------------------------------------------------------------------------------------------
// Calls
// ---------------------------------------------------------------------------------------------

static sf_status call(const sf_grid *grid, int inside, const sf_allocator *allocator, sf_task *task,
                      sf_grid *wall)
{
    return inside ? sf_grid_wall_inside(grid, 1.5, allocator, task, wall)
                  : sf_grid_wall(grid, solid_view(&s), 1.5, allocator, task, wall);
}

static sf_grid *scribbled(const sf_lattice *lattice)
{
    sf_grid *grid = grid_of(lattice);
    for (uint32_t k = 0; k < lattice->nz; k++) {
        CHECK_EQ(sf_slice_set(sf_grid_slice(grid, k), k % 5, k % 7, 1), SF_OK);
    }
    return grid;
}

static void failures_change_nothing(void)
{
    sf_lattice lattice = {30, 28, 260, 0.5, 0.5, 0.0625, NULL, {0, 0, 0}};
    make_solid(3);
    sf_grid *grid = fill(&lattice), *wall = scribbled(&lattice), *was = scribbled(&lattice);
    for (int inside = 0; inside < 3; inside++) {
        sf_status status = SF_ERR_MEMORY;
        for (long at = 0; status != SF_OK && at < 100; at++) {
            failing_allocator f;
            sf_grid *out = scribbled(&lattice);
            failing_begin(&f, at);
            status = call(grid, inside, &f.allocator, NULL, out);
            CHECK(status == SF_OK || (status == SF_ERR_MEMORY && sf_grid_equal(out, was)));
            CHECK_EQ(f.live, 0);
            CHECK_EQ(f.faults, 0);
            sf_grid_destroy(out);
        }
        CHECK_EQ(status, SF_OK);
        sf_task task = sf_task_default();
        sf_task_cancel(&task);
        CHECK_EQ(call(grid, inside, NULL, &task, wall), SF_ERR_CANCELLED);
        CHECK(sf_grid_equal(wall, was));
    }
    sf_grid_destroy(grid);
    sf_grid_destroy(wall);
    sf_grid_destroy(was);
}

static void any_order_of_pieces(void)
{
    sf_lattice lattice = {30, 28, 260, 0.5, 0.5, 0.0625, NULL, {0, 0, 0}};
    make_solid(3);
    sf_grid *grid = fill(&lattice), *a = grid_of(&lattice), *b = scribbled(&lattice);
    sf_task task = sf_task_default();
    task.parallel_for = backwards;
    CHECK_EQ(call(grid, 0, NULL, NULL, a), SF_OK);
    CHECK_EQ(call(grid, 0, NULL, &task, b), SF_OK);
    CHECK(sf_grid_equal(a, b));
    sf_grid_destroy(grid);
    sf_grid_destroy(a);
    sf_grid_destroy(b);
}

static void nonsense_is_refused(void)
{
    sf_lattice l = lattice_of(0), small = lattice_of(1), fine = {300, 4, 4, 0.01, 1, 1, NULL, {0}};
    make_solid(1);
    sf_grid *grid = fill(&l), *wall = scribbled(&l), *was = scribbled(&l), *other = grid_of(&small);
    sf_grid *thin = grid_of(&fine), *thin_wall = grid_of(&fine);
    sf_mesh_view mesh = solid_view(&s), none = {NULL, 0, NULL, 0}, wrong = mesh;
    CHECK_EQ(sf_grid_wall(NULL, mesh, 1, NULL, NULL, wall), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall(grid, mesh, 1, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall(grid, mesh, 1, NULL, NULL, grid), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall(grid, mesh, -1, NULL, NULL, wall), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall(grid, mesh, NAN, NULL, NULL, wall), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall(grid, mesh, INFINITY, NULL, NULL, wall), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall(grid, none, 1, NULL, NULL, wall), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall(grid, mesh, 1, NULL, NULL, other), SF_ERR_SHAPE);
    s.vertices[0] = 2e12;
    CHECK_EQ(sf_grid_wall(grid, mesh, 1, NULL, NULL, wall), SF_ERR_OVERFLOW);
    make_solid(1);
    wrong.vertex_count = 2;
    CHECK_EQ(sf_grid_wall(grid, wrong, 1, NULL, NULL, wall), SF_ERR_ARGUMENT);
    double least = 7;
    CHECK_EQ(sf_grid_clearance(NULL, mesh, NULL, NULL, &least), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_clearance(grid, mesh, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_clearance(grid, none, NULL, NULL, &least), SF_ERR_ARGUMENT);
    CHECK(least == 7);
    CHECK_EQ(sf_grid_wall_inside(NULL, 1, NULL, NULL, wall), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall_inside(grid, 1, NULL, NULL, NULL), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall_inside(grid, 1, NULL, NULL, grid), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall_inside(grid, -1, NULL, NULL, wall), SF_ERR_ARGUMENT);
    CHECK_EQ(sf_grid_wall_inside(grid, 1, NULL, NULL, other), SF_ERR_SHAPE);
    CHECK_EQ(sf_grid_wall_inside(thin, 2.6, NULL, NULL, thin_wall), SF_ERR_UNSUPPORTED);
    CHECK(sf_grid_equal(wall, was));
    CHECK_EQ(sf_grid_wall(grid, mesh, 1e9, NULL, NULL, wall), SF_OK);
    CHECK(sf_grid_equal(wall, grid));
    sf_grid *all[6] = {grid, wall, was, other, thin, thin_wall};
    for (int i = 0; i < 6; i++) {
        sf_grid_destroy(all[i]);
    }
}

int main(void)
{
    TEST(distances_decide);
    TEST(clearance_is_the_least_distance);
    TEST(very_fine_voxels);
    TEST(no_point_is_nearer);
    TEST(whole_voxels);
    TEST(gaps_decide);
    TEST(failures_change_nothing);
    TEST(any_order_of_pieces);
    TEST(nonsense_is_refused);
    return test_finish();
}
