// SPDX-License-Identifier: MIT
// Refinement and sampling. The limit of an update reads each value and each number of a column
// once, and writes the new values; that of a slice reads and writes the planes that it fills.

#include "bench.h"

#include <sf/cage_build.h>
#include <sf/sample.h>

#include <stdlib.h>
#include <string.h>

enum { SIDE = 22 }; // 10,648 cells: as many as rockerarm has

typedef struct grade_work {
    sf_cage *cage;
    sf_refinement *refined;
    sf_limit *limit;
    sf_sampler *sampler;
    sf_grid *grid; // of one layer
    double *values, *plane;
    size_t count;      // points of the cage
    uint32_t *numbers; // stands for the matrices' columns
    size_t number_count, fine_count;
    double *fine;
    uint32_t layer;
} grade_work;

static sf_cage *make_cage(uint32_t side, size_t *count)
{
    const uint32_t counts[3] = {side, side, side};
    const double low[3] = {0, 0, 0}, high[3] = {10, 10, 10};
    sf_cage *cage;
    bench_must(sf_cage_block(counts, low, high, NULL, &cage));
    sf_cage_view v = sf_cage_get_view(cage);
    double *values = bench_memory(v.point_count * sizeof *values);
    for (size_t i = 0; i < v.point_count; i++) {
        values[i] = (double)(i * 7919 % 1000);
    }
    sf_channel density = {sf_property_density(), v.point_count, values, NULL};
    bench_must(sf_cage_add_property(cage, &density, NULL));
    free(values);
    *count = v.point_count;
    return cage;
}

static void update(void *user)
{
    grade_work *w = user;
    bench_must(sf_refinement_update_values(w->refined, 0, w->values, NULL));
}

static void refine(void *user)
{
    grade_work *w = user;
    sf_refine_options options = sf_refine_options_default();
    sf_refinement *r;
    options.steps = 2;
    bench_must(sf_refine(w->cage, &options, NULL, NULL, &r));
    sf_refinement_destroy(r);
}

static void read_columns(void *user)
{
    grade_work *w = user;
    uint64_t sum = 0;
    for (size_t i = 0; i < w->number_count; i++) {
        sum += w->numbers[i];
    }
    for (size_t i = 0; i < w->fine_count; i++) {
        w->fine[i] = (double)(sum & 1);
    }
}

static void bench_update(void)
{
    grade_work w;
    sf_cage_view fine;
    sf_refine_options options = sf_refine_options_default();
    memset(&w, 0, sizeof w);
    options.steps = 2;
    w.cage = make_cage(SIDE, &w.count);
    w.values = bench_memory(w.count * sizeof *w.values);
    memcpy(w.values, sf_cage_get_view(w.cage).channels[0].values, w.count * sizeof *w.values);
    bench_must(sf_refine(w.cage, &options, NULL, NULL, &w.refined));
    bench_must(sf_refinement_get_view(w.refined, 2, &fine));
    w.fine_count = fine.point_count;
    w.number_count = 16 * fine.point_count; // some 15.6 columns a row
    w.numbers = bench_memory(w.number_count * sizeof *w.numbers);
    w.fine = bench_memory(w.fine_count * sizeof *w.fine);
    memset(w.numbers, 1, w.number_count * sizeof *w.numbers);
    bench_work updating = {NULL, update, read_columns, &w}, anew = {NULL, refine, read_columns, &w};
    bench_measure("refine update", "10,648x2", 0, 1, "update", &updating);
    bench_measure("refine anew", "10,648x2", 0, 1, "cage", &anew);
    free(w.numbers);
    free(w.fine);
    free(w.values);
    sf_refinement_destroy(w.refined);
    sf_cage_destroy(w.cage);
}

static void slice(void *user)
{
    grade_work *w = user;
    bench_must(sf_sampler_slice(w->sampler, w->layer, sf_grid_slice(w->grid, 0), &w->plane));
    w->layer = (w->layer + 1) % 128 + 64; // neighbours, as a printer's layers are
}

static void fill_plane(void *user)
{
    grade_work *w = user;
    sf_lattice l = sf_grid_lattice(w->grid);
    for (size_t i = 0; i < (size_t)l.nx * l.ny; i++) {
        w->plane[i] += 1;
    }
}

static void bench_sampling(const char *size, uint32_t cells)
{
    grade_work w;
    size_t zero = 0;
    memset(&w, 0, sizeof w);
    w.cage = make_cage(cells, &w.count);
    sf_lattice l = {258,        258,        258,  10.0 / 256,
                    10.0 / 256, 10.0 / 256, NULL, {-10.0 / 256, -10.0 / 256, -10.0 / 256}};
    sf_lattice one = l;
    one.nz = 1;
    bench_must(sf_limit_create(w.cage, SF_REFINE_STANDARD, NULL, NULL, &w.limit));
    bench_must(sf_sampler_create(w.limit, &l, NULL, 1, &zero, NULL, NULL, &w.sampler, NULL));
    bench_must(sf_grid_create(&one, NULL, &w.grid));
    w.plane = bench_memory(sizeof *w.plane * l.nx * l.ny);
    memset(w.plane, 0, sizeof *w.plane * l.nx * l.ny);
    w.layer = 64;
    bench_work work = {NULL, slice, fill_plane, &w};
    bench_measure("grade slice", size, 0, 256 * 256 * 1e-6, "Mvoxel", &work);
    free(w.plane);
    sf_grid_destroy(w.grid);
    sf_sampler_destroy(w.sampler);
    sf_limit_destroy(w.limit);
    sf_cage_destroy(w.cage);
}

void bench_grade(void)
{
    if (bench_wants("refine update") || bench_wants("refine anew")) {
        bench_update();
    }
    if (bench_wants("grade slice")) {
        bench_sampling("256^2, 8^3", 8);
        bench_sampling("256^2, 1^3", 1);
    }
}
