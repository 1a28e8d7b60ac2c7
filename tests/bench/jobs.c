// SPDX-License-Identifier: MIT
// Checks of resin jobs, as runs: 500 layers of 3840 x 2160 pixels, some 4,500 runs each, 3 % full.
//
// 75 pillars of 60 rows lean to and fro, a pixel a layer at most, so that all of it rests; then the
// same with an island of three layers every fifty, for which the bits are asked. Layers are runs
// before the clock starts: decoding is apart. The limit reads the runs once.

#include "bench.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 3840, HEIGHT = 2160, LAYERS = 500, PILLARS = 75, RADIUS = 30, ROOM = 50000 };

typedef struct job_work {
    sf_run *runs;
    size_t *starts; // of each layer
    void *memory;
    size_t size;
    sf_check_options options;
    uint64_t sum, unsupported;
} job_work;

static int by_place(const void *a, const void *b)
{
    const sf_run *p = a, *q = b;
    return p->y != q->y ? (p->y < q->y ? -1 : 1) : p->x0 < q->x0 ? -1 : p->x0 > q->x0;
}

// Half the width of a disc in its row.
static uint32_t half_width(int row)
{
    int w = 0;
    while ((w + 1) * (w + 1) + row * row <= RADIUS * RADIUS) {
        w++;
    }
    return (uint32_t)w;
}

static size_t add_layer(sf_run *runs, uint32_t k, const int *shift, int islands)
{
    size_t count = 0;
    for (uint32_t p = 0; p < PILLARS; p++) {
        uint32_t x = 150 + p % 15 * 245 + (uint32_t)(shift[p] + 100), y = 200 + p / 15 * 400;
        for (int row = -RADIUS; row < RADIUS; row++) {
            uint32_t w = half_width(row);
            sf_run run = {x - w, x + w + 1, y + (uint32_t)(row + RADIUS), 0};
            runs[count++] = run;
        }
    }
    if (islands && k % 50 >= 20 && k % 50 < 23) {
        for (uint32_t row = 0; row < 5; row++) {
            sf_run run = {20, 25, 20 + row, 0};
            runs[count++] = run;
        }
    }
    qsort(runs, count, sizeof *runs, by_place);
    return count;
}

static void make(job_work *w, int islands)
{
    int shift[PILLARS] = {0};
    uint64_t state = 1;
    w->runs = bench_memory((size_t)LAYERS * (PILLARS * 2 * RADIUS + 8) * sizeof *w->runs);
    w->starts = bench_memory((LAYERS + 1) * sizeof *w->starts);
    w->starts[0] = 0;
    for (uint32_t k = 0; k < LAYERS; k++) {
        for (int p = 0; p < PILLARS; p++) {
            state = state * 6364136223846793005u + 1442695040888963407u;
            shift[p] += (int)(state >> 33) % 3 - 1;
            shift[p] = shift[p] < -80 ? -80 : shift[p] > 80 ? 80 : shift[p];
        }
        w->starts[k + 1] = w->starts[k] + add_layer(w->runs + w->starts[k], k, shift, islands);
    }
    w->options = sf_check_options_default();
    w->options.width = WIDTH;
    w->options.height = HEIGHT;
    w->options.layer_run_capacity = ROOM;
    bench_must(sf_checker_size(&w->options, &w->size));
    w->memory = bench_memory(w->size + 64);
}

static void check(void *user)
{
    job_work *w = user;
    sf_checker *checker;
    sf_check_report report;
    char *aligned = (char *)w->memory + (64 - (uintptr_t)w->memory % 64) % 64;
    bench_must(sf_checker_place(&w->options, aligned, w->size, &checker));
    for (size_t k = 0; k < LAYERS; k++) {
        bench_must(
            sf_checker_push_runs(checker, w->runs + w->starts[k], w->starts[k + 1] - w->starts[k]));
    }
    bench_must(sf_checker_report(checker, &report, NULL));
    w->unsupported = report.unsupported_voxels;
}

static void read_runs(void *user)
{
    job_work *w = user;
    for (size_t i = 0; i < w->starts[LAYERS]; i++) {
        w->sum += w->runs[i].x1 - w->runs[i].x0 + w->runs[i].y;
    }
}

static void measure(const char *job, int islands, uint64_t expected)
{
    job_work w = {0};
    make(&w, islands);
    bench_work work = {NULL, check, read_runs, &w};
    bench_measure(job, "4500 runs", 0, (double)WIDTH * HEIGHT * LAYERS * 1e-9, "Gvoxel", &work);
    if (w.unsupported != expected || w.sum == 0) {
        bench_must(SF_ERR_INTERNAL);
    }
    free(w.runs);
    free(w.starts);
    free(w.memory);
}

void bench_jobs(void)
{
    if (bench_wants("job rests")) {
        measure("job rests", 0, 0);
    }
    if (bench_wants("job islands")) {
        measure("job islands", 1, (uint64_t)LAYERS / 50 * 25);
    }
}
