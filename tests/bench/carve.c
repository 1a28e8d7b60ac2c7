// SPDX-License-Identifier: MIT
// Walls and carving at the size that a person waits for: 83 thousand voxels of a ball with bumps,
// of 173 thousand triangles. The limit of a wall reads the triangles once and writes the grid; that
// of carving goes over the solid and the wall.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <sf/carve.h>

typedef struct carve_work {
    sf_mesh *mesh;
    sf_grid *solid, *wall, *result;
    sf_stance *stance;
    volatile double sum;
} carve_work;

static void find_wall(void *user)
{
    carve_work *w = user;
    bench_must(sf_grid_wall(w->solid, sf_mesh_get_view(w->mesh), 3, NULL, NULL, w->wall));
}

static void read_triangles(void *user)
{
    carve_work *w = user;
    sf_mesh_view view = sf_mesh_get_view(w->mesh);
    double sum = 0;
    for (size_t i = 0; i < 3 * view.triangle_count; i++) {
        sum += view.vertices[3 * (size_t)view.triangles[i]];
    }
    w->sum = sum;
    limit_pass(w->wall);
}

static void find_wall_inside(void *user)
{
    carve_work *w = user;
    bench_must(sf_grid_wall_inside(w->solid, 3, NULL, NULL, w->wall));
}

static void measure_clearance(void *user)
{
    carve_work *w = user;
    double least;
    bench_must(sf_grid_clearance(w->result, sf_mesh_get_view(w->mesh), NULL, NULL, &least));
}

static void carve(void *user)
{
    carve_work *w = user;
    const sf_stance *stances[1] = {w->stance};
    sf_carve_options o = sf_carve_options_default();
    o.mode = SF_CARVE_PLANE;
    o.goal = SF_CARVE_DEEPEST;
    o.stances = stances;
    o.stance_count = 1;
    bench_must(sf_grid_carve(w->solid, w->wall, NULL, &o, NULL, NULL, w->result, NULL));
}

// As many bytes as the solid and the wall have; the pass writes, so it goes over what is made anew.
static void pass_over(void *user)
{
    carve_work *w = user;
    limit_pass(w->result);
    limit_pass(w->result);
}

// A wall, and what lies inside it, for the clearance.
static void take_inside(void *user)
{
    carve_work *w = user;
    bench_must(sf_grid_wall(w->solid, sf_mesh_get_view(w->mesh), 3, NULL, NULL, w->wall));
    for (uint32_t k = 0; k < sf_grid_lattice(w->solid).nz; k++) {
        bench_must(sf_slice_subtract(sf_grid_slice(w->result, k), sf_grid_slice(w->solid, k),
                                     sf_grid_slice(w->wall, k)));
    }
}

static void begin(carve_work *w, uint32_t n)
{
    sf_lattice lattice = {n, n, n, 1.0, 1.0, 1.0, NULL, {0, 0, 0}};
    // Hung up far from its middle, so that there is much to carve.
    sf_stance_options pose = sf_stance_options_default();
    pose.kind = SF_STANCE_HANG;
    pose.point_mm[0] = 0.6 * n;
    pose.point_mm[1] = 0.5 * n;
    pose.point_mm[2] = n;
    w->mesh = scene_bumpy_sphere(93, n);
    bench_must(sf_grid_create(&lattice, NULL, &w->solid));
    bench_must(sf_grid_create(&lattice, NULL, &w->wall));
    bench_must(sf_grid_create(&lattice, NULL, &w->result));
    bench_must(sf_grid_voxelize(w->solid, sf_mesh_get_view(w->mesh), NULL, NULL, NULL, NULL));
    bench_must(sf_stance_create(sf_mesh_get_view(w->mesh), &pose, NULL, &w->stance, NULL));
    take_inside(w);
}

static void end(carve_work *w)
{
    sf_stance_destroy(w->stance);
    sf_grid_destroy(w->solid);
    sf_grid_destroy(w->wall);
    sf_grid_destroy(w->result);
    sf_mesh_destroy(w->mesh);
}

void bench_carve(void)
{
    const char *jobs[] = {"wall 172k", "wall of a stack", "clearance 172k", "carve by a plane"};
    void (*const runs[])(void *) = {find_wall, find_wall_inside, measure_clearance, carve};
    void (*const limits[])(void *) = {read_triangles, pass_over, read_triangles, pass_over};
    carve_work w;
    int any = 0;
    for (int i = 0; i < 4; i++) {
        any = any || bench_wants(jobs[i]);
    }
    if (!any) {
        return;
    }
    begin(&w, 64);
    double voxels = (double)sf_grid_popcount(w.solid) * 1e-6;
    for (int i = 0; i < 4; i++) {
        bench_work work = {i < 2 ? NULL : take_inside, runs[i], limits[i], &w};
        if (bench_wants(jobs[i])) {
            bench_measure(jobs[i], "64^3", 0, voxels, "Mvoxel", &work);
        }
    }
    end(&w);
}
