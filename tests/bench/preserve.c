// SPDX-License-Identifier: MIT
// Preserve: a ball of radius 40 taken out of a trimmed shape of 512^3, in every mode, and a ball of
// 256^3 hollowed under slack, where 10^5 voxels are kept at first. The limit
// reads the layers of the ball once in the window of words that holds it, which any way to remove
// it must do; "checked" also looks whether the whole shape is support-free, as is the default.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <sf/preserve.h>

#include <stdio.h>
#include <string.h>

#define RADIUS 40

typedef struct preserve_work {
    sf_grid *shape, *grid, *brush;
    sf_terms terms;
    sf_preserve_options options;
    sf_box box;
    uint64_t kept, removed;
} preserve_work;

// Only the layers of the brush have changed.
static void restore(void *user)
{
    preserve_work *w = user;
    for (uint32_t k = w->box.z0; k < w->box.z1; k++) {
        bench_must(sf_slice_copy(sf_grid_slice(w->grid, k), sf_grid_slice(w->shape, k)));
    }
}

static void preserve(void *user)
{
    preserve_work *w = user;
    sf_preserve_report report;
    bench_must(sf_grid_preserve(w->grid, w->brush, &w->terms, &w->options, NULL, NULL, &report));
    w->kept = report.kept_voxels;
    w->removed = report.removed_voxels;
}

static void read_window(void *user)
{
    preserve_work *w = user;
    for (uint32_t k = w->box.z0; k < w->box.z1; k++) {
        sf_slice s = sf_grid_slice(w->grid, k);
        s.words += w->box.y0 * s.stride;
        s.height = w->box.y1 - w->box.y0;
        limit_read_slice(s);
    }
}

// The matter with the most voxels around it, roughly: the middle of the fullest of some balls.
static void place_brush(preserve_work *w)
{
    uint32_t n = sf_grid_lattice(w->shape).nx, best[3] = {n / 2, n / 2, n / 2};
    uint64_t most = 0;
    for (uint32_t i = 0; i < 5 * 5 * 5; i++) {
        uint32_t at[3] = {n / 6 * (1 + i % 5), n / 6 * (1 + i / 5 % 5), n / 6 * (1 + i / 25)};
        uint64_t count = 0;
        for (uint32_t k = at[2] - RADIUS; k < at[2] + RADIUS; k += 4) {
            for (uint32_t j = 0; j < 20 * 20; j++) {
                count +=
                    (uint64_t)sf_slice_get(sf_grid_slice(w->shape, k), at[0] - RADIUS + j % 20 * 4,
                                           at[1] - RADIUS + j / 20 * 4);
            }
        }
        if (count > most) {
            most = count;
            memcpy(best, at, sizeof best);
        }
    }
    for (int64_t z = -RADIUS; z <= RADIUS; z++) {
        for (int64_t y = -RADIUS; y <= RADIUS; y++) {
            for (int64_t x = -RADIUS; x <= RADIUS; x++) {
                if (x * x + y * y + z * z <= RADIUS * RADIUS) {
                    bench_must(sf_slice_set(sf_grid_slice(w->brush, (uint32_t)(best[2] + z)),
                                            (uint32_t)(best[0] + x), (uint32_t)(best[1] + y), 1));
                }
            }
        }
    }
    w->box = sf_grid_bounds(w->brush);
}

static void measure(preserve_work *w, const char *job, sf_preserve_mode mode, int checked)
{
    char size[32];
    w->options = sf_preserve_options_default();
    w->options.mode = mode;
    w->options.known_support_free = !checked;
    if (!checked) {
        w->options.brush_box = w->box;
    }
    snprintf(size, sizeof size, "%u^3", sf_grid_lattice(w->shape).nx);
    bench_work work = {restore, preserve, read_window, w};
    w->kept = w->removed = 0;
    double gvoxels = 1e-9 * (double)sf_grid_popcount(w->brush);
    bench_measure(job, size, 0, gvoxels, "Gvoxel", &work);
    if (w->kept + w->removed > 0) {
        printf("    kept %llu of %llu voxels\n", (unsigned long long)w->kept,
               (unsigned long long)(w->kept + w->removed));
    }
}

static void measure_all(uint32_t n, const sf_rule *rule, int is_slack)
{
    sf_lattice lattice;
    preserve_work w;
    w.shape = scene_balls(n);
    lattice = sf_grid_lattice(w.shape);
    w.terms = sf_terms_default();
    w.terms.rule = *rule;
    bench_must(sf_grid_trim(w.shape, rule, SF_BED_AUTO, NULL, NULL));
    bench_must(sf_grid_clone(w.shape, NULL, &w.grid));
    bench_must(sf_grid_create(&lattice, NULL, &w.brush));
    place_brush(&w);
    if (is_slack) {
        measure(&w, "preserve slack", SF_PRESERVE_FAST, 1);
        measure(&w, "preserve slack irr", SF_PRESERVE_IRREDUNDANT, 1);
    } else {
        measure(&w, "preserve r40", SF_PRESERVE_FAST, 0);
        measure(&w, "preserve r40 check", SF_PRESERVE_FAST, 1);
        measure(&w, "preserve r40 irr", SF_PRESERVE_IRREDUNDANT, 1);
        measure(&w, "preserve r40 core", SF_PRESERVE_CORE, 1);
    }
    sf_grid_destroy(w.shape);
    sf_grid_destroy(w.grid);
    sf_grid_destroy(w.brush);
}

// A ball and, as the brush, all of it but a skin.
static void measure_hollow(uint32_t n, const sf_rule *rule)
{
    sf_lattice lattice = {n, n, n, 1.0, 1.0, 1.0, NULL, {0.0, 0.0, 0.0}};
    preserve_work w;
    bench_must(sf_grid_create(&lattice, NULL, &w.shape));
    bench_must(sf_grid_create(&lattice, NULL, &w.brush));
    scene_add_ball(w.shape, n / 2.0, n / 2.0, n / 2.0, n * 0.49);
    scene_add_ball(w.brush, n / 2.0, n / 2.0, n / 2.0, n * 0.447);
    w.terms = sf_terms_default();
    w.terms.rule = *rule;
    w.box = sf_grid_bounds(w.brush);
    bench_must(sf_grid_trim(w.shape, rule, SF_BED_AUTO, NULL, NULL));
    bench_must(sf_grid_clone(w.shape, NULL, &w.grid));
    measure(&w, "hollow slack", SF_PRESERVE_FAST, 1);
    measure(&w, "hollow slack irr", SF_PRESERVE_IRREDUNDANT, 1);
    sf_grid_destroy(w.shape);
    sf_grid_destroy(w.grid);
    sf_grid_destroy(w.brush);
}

void bench_preserve(void)
{
    sf_rule rule = sf_rule_box3();
    if (bench_wants("preserve r40")) {
        measure_all(512, &rule, 0);
    }
    sf_lattice lattice = {256, 256, 256, 1.0, 1.0, 1.0, NULL, {0.0, 0.0, 0.0}};
    bench_must(sf_rule_make(SF_RULE_SLACK, 0.78539816339744831, &lattice, NULL, &rule, NULL));
    if (bench_wants("preserve slack")) {
        measure_all(256, &rule, 1);
    }
    if (bench_wants("hollow slack")) {
        measure_hollow(256, &rule);
    }
}
