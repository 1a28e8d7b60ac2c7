// SPDX-License-Identifier: MIT
// What reads voxels and tells numbers: moments and components. The limit reads the same words.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <stdio.h>
#include <stdlib.h>

static void measure_moments(void *user)
{
    sf_moments moments;
    bench_must(sf_grid_measure(user, NULL, &moments));
}

static void read_grid(void *user)
{
    limit_read(user);
}

static void bench_moments(const char *job, sf_grid *grid)
{
    bench_work work = {NULL, measure_moments, read_grid, grid};
    uint32_t n = sf_grid_lattice(grid).nx;
    char size[32];
    snprintf(size, sizeof size, "%u^3", n);
    bench_measure(job, size, 0, (double)n * n * n * 1e-9, "Gvoxel", &work);
    sf_grid_destroy(grid);
}

typedef struct component_work {
    sf_slice slice;
    sf_run *runs;
    sf_component *components;
    size_t capacity;
} component_work;

// From bits to the area and the box of every component.
static void find_components(void *user)
{
    component_work *w = user;
    size_t count;
    uint32_t found;
    bench_must(sf_slice_runs(w->slice, w->runs, w->capacity, &count));
    bench_must(sf_runs_label(w->runs, count, SF_CONNECT_CORNERS, &found));
    bench_must(sf_runs_measure(w->runs, count, w->components, found));
}

static void read_slice(void *user)
{
    limit_read_slice(((component_work *)user)->slice);
}

static void bench_components(const char *job, const char *size, sf_slice slice)
{
    component_work w = {slice, NULL, NULL, 0};
    bench_must(sf_slice_run_count(slice, &w.capacity));
    w.runs = bench_memory(w.capacity * sizeof *w.runs);
    w.components = bench_memory(w.capacity * sizeof *w.components);
    bench_work work = {NULL, find_components, read_slice, &w};
    bench_measure(job, size, 0, (double)w.capacity * 1e-6, "Mrun", &work);
    free(w.runs);
    free(w.components);
    free(slice.words);
}

void bench_sums(void)
{
    if (bench_wants("moments blob")) {
        bench_moments("moments blob", scene_balls(512));
    }
    if (bench_wants("moments noise")) {
        bench_moments("moments noise", scene_noise(512));
    }
    if (bench_wants("components plate")) {
        bench_components("components plate", "3840x2160", scene_plate(3840, 2160));
    }
    if (bench_wants("components noise")) {
        bench_components("components noise", "512x512", scene_noise_slice(512, 512));
    }
}
