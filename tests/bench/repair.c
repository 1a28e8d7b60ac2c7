// SPDX-License-Identifier: MIT
// Repair of four balls, three of them in the air: until the first result, and until it gets no
// better; and of two shapes that hang as a whole, far above the bed, with more to share than any
// other: a slab high in a cube, and a roof. The limit reads and writes the grid once. Every round
// starts from the shape as drawn.
//
// The roof is 580 x 580 voxels, the least of those where very much hangs; one of 1980 x 1980 at the
// same height has twelve times as many and takes nine times as long, which is too long for rounds.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <sf/repair.h>

#include <stdio.h>
#include <string.h>

#define GOAL_FIRST_MS 1200 // at 512^3, one core
#define GOAL_MS 4000
#define GOAL_SLAB_MS 5000
#define GOAL_ROOF_MS 3000 // of the large roof's 30 s

typedef struct repair_work {
    sf_grid *shape, *grid;
    sf_repair_options options;
    sf_repair_report report;
} repair_work;

static void restore(void *user)
{
    repair_work *w = user;
    sf_slice from = sf_grid_slice(w->shape, 0), to = sf_grid_slice(w->grid, 0);
    size_t slices = sf_grid_lattice(w->grid).nz;
    memcpy(to.words, from.words, to.stride * to.height * slices * sizeof(uint64_t));
}

static void repair(void *user)
{
    repair_work *w = user;
    bench_must(sf_grid_repair(w->grid, &w->options, NULL, NULL, NULL, &w->report));
}

static void pass(void *user)
{
    limit_pass(((repair_work *)user)->grid);
}

static void measure(const char *job, sf_grid *shape, uint32_t rounds, int goal_ms)
{
    repair_work w = {.shape = shape, .options = sf_repair_options_default()};
    sf_lattice lattice = sf_grid_lattice(shape);
    char size[32];
    w.options.rounds = rounds;
    w.options.terms.bed_layer = 0;
    bench_must(sf_grid_clone(w.shape, NULL, &w.grid));
    snprintf(size, sizeof size, lattice.nx == lattice.nz ? "%u^3" : "%u^2*%u", lattice.nx,
             lattice.nz);
    bench_work work = {restore, repair, pass, &w};
    double voxels = (double)lattice.nx * lattice.ny * lattice.nz;
    bench_measure(job, size, 0, voxels * 1e-9, "Gvoxel", &work);
    printf("  cost %llu (trim %llu), %u rounds, %.0f MB at most; goal %d ms\n",
           (unsigned long long)w.report.cost, (unsigned long long)w.report.trim_cost,
           w.report.rounds, (double)w.report.peak_memory * 1e-6, goal_ms);
    sf_grid_destroy(w.grid);
    sf_grid_destroy(w.shape);
}

void bench_repair(void)
{
    if (bench_wants("repair first")) {
        measure("repair first", scene_four_balls(512), SF_REPAIR_FIRST, GOAL_FIRST_MS);
    }
    if (bench_wants("repair whole")) {
        measure("repair whole", scene_four_balls(512), 0, GOAL_MS);
    }
    if (bench_wants("repair slab")) {
        measure("repair slab", scene_slab(256, 256, 240, 2), 0, GOAL_SLAB_MS);
    }
    if (bench_wants("repair roof")) {
        measure("repair roof", scene_slab(600, 110, 100, 10), 0, GOAL_ROOF_MS);
    }
}
