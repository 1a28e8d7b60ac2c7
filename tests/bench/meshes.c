// SPDX-License-Identifier: MIT
// From triangles to voxels and back. The limit of voxelising clears the grid and goes over it once;
// that of surfacing reads the grid twice, once to count and once to write, and fills the arrays.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct voxelize_work {
    sf_mesh *mesh;
    sf_grid *grid;
} voxelize_work;

static void voxelize(void *user)
{
    voxelize_work *w = user;
    bench_must(sf_grid_voxelize(w->grid, sf_mesh_get_view(w->mesh), NULL, NULL, NULL, NULL));
}

static void clear_and_pass(void *user)
{
    voxelize_work *w = user;
    limit_clear(w->grid);
    limit_pass(w->grid);
}

static void bench_voxelize(uint32_t n, double goal)
{
    sf_lattice lattice = {n, n, n, 1.0, 1.0, 1.0, NULL, {0, 0, 0}};
    voxelize_work w = {scene_bumpy_sphere(64, n), NULL};
    char size[32];
    bench_must(sf_grid_create(&lattice, NULL, &w.grid));
    snprintf(size, sizeof size, "%u^3", n);
    bench_work work = {NULL, voxelize, clear_and_pass, &w};
    double triangles = (double)sf_mesh_get_view(w.mesh).triangle_count;
    bench_measure("voxelize 82k", size, goal, triangles * 1e-6, "Mtriangle", &work);
    sf_grid_destroy(w.grid);
    sf_mesh_destroy(w.mesh);
}

typedef struct surface_work {
    sf_grid *grid;
    unsigned char *bytes; // as many as the mesh takes
    size_t size;
} surface_work;

static void surface(void *user)
{
    surface_work *w = user;
    sf_mesh *mesh = NULL;
    bench_must(sf_grid_surface(w->grid, NULL, NULL, NULL, &mesh));
    sf_mesh_destroy(mesh);
}

static void read_and_fill(void *user)
{
    surface_work *w = user;
    limit_read(w->grid);
    limit_read(w->grid);
    memset(w->bytes, 1, w->size);
}

static void bench_surface(uint32_t n)
{
    surface_work w = {scene_balls(n), NULL, 0};
    sf_mesh *mesh = NULL;
    bench_must(sf_grid_surface(w.grid, NULL, NULL, NULL, &mesh));
    sf_mesh_view view = sf_mesh_get_view(mesh);
    w.size = view.vertex_count * 3 * sizeof(double) + view.triangle_count * 3 * sizeof(uint32_t);
    double faces = (double)view.triangle_count / 2;
    sf_mesh_destroy(mesh);
    w.bytes = bench_memory(w.size);
    char size[32];
    snprintf(size, sizeof size, "%u^3", n);
    bench_work work = {NULL, surface, read_and_fill, &w};
    bench_measure("surface", size, 0, faces * 1e-6, "Mface", &work);
    free(w.bytes);
    sf_grid_destroy(w.grid);
}

void bench_meshes(void)
{
    if (bench_wants("voxelize 82k")) {
        bench_voxelize(512, 10);
    }
    if (bench_wants("surface")) {
        bench_surface(256);
    }
}
