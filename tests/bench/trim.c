// SPDX-License-Identifier: MIT
// Trim, whole, of shapes and of noise. The limit reads and writes the grid once where it stands:
// there is no way to trim without doing so. Every round starts from the untrimmed shape.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct trim_work {
    sf_grid *shape, *grid;
    sf_rule rule;
} trim_work;

static void restore(void *user)
{
    trim_work *w = user;
    sf_slice from = sf_grid_slice(w->shape, 0), to = sf_grid_slice(w->grid, 0);
    size_t slices = sf_grid_lattice(w->grid).nz;
    memcpy(to.words, from.words, to.stride * to.height * slices * sizeof(uint64_t));
}

static void trim(void *user)
{
    trim_work *w = user;
    bench_must(sf_grid_trim(w->grid, &w->rule, 0, NULL, NULL));
}

static void pass(void *user)
{
    limit_pass(((trim_work *)user)->grid);
}

static void measure(const char *job, sf_grid *shape, sf_rule rule, double goal)
{
    trim_work w = {shape, NULL, rule};
    uint32_t n = sf_grid_lattice(shape).nx;
    char size[32];
    bench_must(sf_grid_clone(shape, NULL, &w.grid));
    snprintf(size, sizeof size, "%u^3", n);
    bench_work work = {restore, trim, pass, &w};
    bench_measure(job, size, goal, (double)n * n * n * 1e-9, "Gvoxel", &work);
    sf_grid_destroy(w.grid);
    sf_grid_destroy(shape);
}

void bench_trim(void)
{
    static const uint32_t sizes[3] = {256, 512, 1024};
    static const double goals[3] = {0, 1.6, 1.5};
    for (int i = 0; i < 3; i++) {
        if (bench_wants("trim blob")) {
            measure("trim blob", scene_balls(sizes[i]), sf_rule_box3(), goals[i]);
        }
        if (bench_wants("trim noise")) {
            measure("trim noise", scene_noise(sizes[i]), sf_rule_box3(), goals[i]);
        }
    }
    if (bench_wants("trim slack")) {
        sf_grid *shape = scene_balls(512);
        sf_lattice lattice = sf_grid_lattice(shape);
        sf_rule rule;
        bench_must(sf_rule_make(SF_RULE_SLACK, atan(1.0), &lattice, NULL, &rule, NULL));
        measure("trim slack", shape, rule, 0);
    }
    if (bench_wants("trim bridges")) {
        sf_rule rule = sf_rule_box3();
        rule.bridge = (sf_bridge){20, 20, 14, 3, 3, 2};
        measure("trim bridges", scene_balls(512), rule, 0);
    }
}
