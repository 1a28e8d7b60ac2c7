// SPDX-License-Identifier: MIT
// Repair of four balls, three of them in the air: until the first result, and until it gets no
// better. The limit reads and writes the grid once. Every round starts from the shape as drawn.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <sf/repair.h>

#include <stdio.h>
#include <string.h>

#define GOAL_FIRST_MS 1200 // at 512^3, one core
#define GOAL_MS 4000

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

static void measure(const char *job, uint32_t n, uint32_t rounds, int goal_ms)
{
    repair_work w = {.shape = scene_four_balls(n), .options = sf_repair_options_default()};
    char size[32];
    w.options.rounds = rounds;
    bench_must(sf_grid_clone(w.shape, NULL, &w.grid));
    snprintf(size, sizeof size, "%u^3", n);
    bench_work work = {restore, repair, pass, &w};
    bench_measure(job, size, 0, (double)n * n * n * 1e-9, "Gvoxel", &work);
    printf("  cost %llu (trim %llu), %u rounds, %.0f MB at most; goal %d ms\n",
           (unsigned long long)w.report.cost, (unsigned long long)w.report.trim_cost,
           w.report.rounds, (double)w.report.peak_memory * 1e-6, goal_ms);
    sf_grid_destroy(w.grid);
    sf_grid_destroy(w.shape);
}

void bench_repair(void)
{
    if (bench_wants("repair first")) {
        measure("repair first", 512, SF_REPAIR_FIRST, GOAL_FIRST_MS);
    }
    if (bench_wants("repair whole")) {
        measure("repair whole", 512, 0, GOAL_MS);
    }
}
