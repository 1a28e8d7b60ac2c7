// SPDX-License-Identifier: MIT
// Grow: a thousand questions to a path finder, a path map of all voxels, and a whole grid grown.
//
// The questions go to voxels, solid or not, that nothing carries, anywhere in the grid: once among
// balls that fill a third of it, and once among twelve that are far apart, where paths are long.
// What the table says is the time of all questions; mean and worst of one are printed below it, and
// the same of each question's best round, which others on the machine disturb less. Slack is asked
// on layers of one height, and on layers that all differ, where windows are made anew for each. The
// limit of the finder reads the grid once, that of the map reads it and writes half a byte for each
// voxel, that of a growth reads and writes the grid. The memory of the map is kept from round to
// round, as by one who makes maps often; the first touch of fresh memory would add what the system
// takes for that.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <sf/grow.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define QUESTIONS 1000

typedef struct query_work {
    sf_grid *grid;
    sf_path_finder *finder;
    sf_voxel from[QUESTIONS], *path;
    uint64_t layers;            // of all paths
    double least_us[QUESTIONS]; // of each, over all rounds
    double worst_us, sum_us, times, made_ms;
} query_work;

static uint64_t state = 7;

static uint32_t random_below(uint32_t bound)
{
    state = state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((state >> 32) * bound >> 32);
}

static int is_carried(const sf_grid *grid, sf_voxel v)
{
    int any = v.z == 0;
    for (uint32_t i = 0; i < 9 && v.z > 0; i++) {
        any |= sf_slice_get(sf_grid_slice(grid, v.z - 1), v.x + i % 3 - 1, v.y + i / 3 - 1);
    }
    return any;
}

static void choose_questions(query_work *w)
{
    uint32_t n = sf_grid_lattice(w->grid).nx;
    for (int i = 0; i < QUESTIONS;) {
        sf_voxel v = {random_below(n), random_below(n), random_below(n)};
        if (!is_carried(w->grid, v)) {
            w->from[i++] = v;
        }
    }
}

static void ask(void *user)
{
    query_work *w = user;
    w->layers = 0;
    w->worst_us = 0;
    for (int i = 0; i < QUESTIONS; i++) {
        sf_path path;
        double start = 1e3 * bench_now_ms();
        bench_must(sf_path_finder_find(w->finder, w->from[i], w->path, 4096, &path));
        double took = 1e3 * bench_now_ms() - start;
        w->layers += w->from[i].z - path.landing.z;
        w->worst_us = took > w->worst_us ? took : w->worst_us;
        w->least_us[i] = w->times < QUESTIONS || took < w->least_us[i] ? took : w->least_us[i];
        w->sum_us += took;
        w->times++;
    }
}

static void read_grid(void *user)
{
    limit_read(((query_work *)user)->grid);
}

static void print_questions(const query_work *w)
{
    double worst = 0, sum = 0;
    for (int i = 0; i < QUESTIONS; i++) {
        sum += w->least_us[i];
        worst = w->least_us[i] > worst ? w->least_us[i] : worst;
    }
    printf(
        "    of one: mean %.1f us, worst %.1f us in the last round; each at its best %.1f, worst "
        "%.1f;\n    %.0f layers in the mean; the finder took %.1f ms to make\n",
        w->sum_us / w->times, w->worst_us, sum / QUESTIONS, worst, (double)w->layers / QUESTIONS,
        w->made_ms);
}

static void bench_query(const char *job, sf_grid *grid, const sf_rule *rule)
{
    query_work *w = bench_memory(sizeof *w);
    memset(w, 0, sizeof *w);
    w->grid = grid;
    w->path = bench_memory(4096 * sizeof *w->path);
    sf_terms terms = sf_terms_default();
    terms.rule = *rule;
    terms.bed_layer = 0;
    double start = bench_now_ms();
    bench_must(sf_path_finder_create(grid, &terms, SF_LANDING_ANY, NULL, NULL, &w->finder));
    w->made_ms = bench_now_ms() - start;
    choose_questions(w);
    bench_work work = {NULL, ask, read_grid, w};
    bench_measure(job, "512^3", 0, QUESTIONS * 1e-3, "kpath", &work);
    if (w->times > 0) {
        print_questions(w);
    }
    sf_path_finder_destroy(w->finder);
    free(w->path);
    free(w);
}

// Keeps the blocks that are freed and hands them out again.
typedef struct kept_blocks {
    void *blocks[16];
    size_t sizes[16];
} kept_blocks;

static void *take_block(void *user, size_t size, size_t align)
{
    kept_blocks *k = user;
    for (int i = 0; i < 16; i++) {
        if (k->blocks[i] != NULL && k->sizes[i] == size) {
            void *block = k->blocks[i];
            k->blocks[i] = NULL;
            return block;
        }
    }
    // Where the block begins is kept in front of what is handed out.
    unsigned char *base = bench_memory(size + 2 * align);
    unsigned char *block = base + 2 * align - (uintptr_t)base % align;
    memcpy(block - sizeof base, &base, sizeof base);
    return block;
}

static void free_block(void *block)
{
    void *base = NULL;
    if (block != NULL) {
        memcpy(&base, (unsigned char *)block - sizeof base, sizeof base);
    }
    free(base);
}

static void give_block(void *user, void *block, size_t size)
{
    kept_blocks *k = user;
    for (int i = 0; i < 16; i++) {
        if (k->blocks[i] == NULL) {
            k->blocks[i] = block;
            k->sizes[i] = size;
            return;
        }
    }
    free_block(block);
}

typedef struct map_work {
    sf_grid *grid;
    sf_rule rule;
    void *bytes;
    size_t size;
    kept_blocks kept;
} map_work;

static void make_map(void *user)
{
    map_work *w = user;
    sf_terms terms = sf_terms_default();
    sf_path_map_options options = sf_path_map_options_default();
    sf_path_map *map = NULL;
    terms.rule = w->rule;
    terms.bed_layer = 0;
    sf_allocator allocator = {take_block, give_block, &w->kept};
    bench_must(sf_path_map_create(w->grid, &terms, &options, &allocator, NULL, &map));
    sf_path_map_destroy(map);
}

static void read_and_write(void *user)
{
    map_work *w = user;
    limit_read(w->grid);
    memset(w->bytes, 0, w->size);
}

static void bench_map(const char *job, sf_grid *grid, const sf_rule *rule)
{
    map_work w = {grid, *rule, NULL, (size_t)1 << 26, {{NULL}, {0}}};
    w.bytes = bench_memory(w.size);
    bench_work work = {NULL, make_map, read_and_write, &w};
    bench_measure(job, "512^3", 0, 0.134217728, "Gvoxel", &work);
    free(w.bytes);
    for (int i = 0; i < 16; i++) {
        free_block(w.kept.blocks[i]);
    }
}

typedef struct grow_work {
    sf_grid *shape, *grid;
    sf_rule rule;
    sf_grow_report report;
} grow_work;

static void restore(void *user)
{
    grow_work *w = user;
    sf_slice from = sf_grid_slice(w->shape, 0), to = sf_grid_slice(w->grid, 0);
    memcpy(to.words, from.words,
           to.stride * to.height * sf_grid_lattice(w->grid).nz * sizeof(uint64_t));
}

static void grow_all(void *user)
{
    grow_work *w = user;
    sf_terms terms = sf_terms_default();
    terms.rule = w->rule;
    terms.bed_layer = 0;
    bench_must(sf_grid_grow(w->grid, &terms, NULL, NULL, NULL, &w->report));
}

static void pass(void *user)
{
    limit_pass(((grow_work *)user)->grid);
}

static void bench_whole(const char *job, sf_grid *shape, const sf_rule *rule)
{
    grow_work w = {shape, NULL, *rule, {0, 0, 0}};
    bench_must(sf_grid_clone(shape, NULL, &w.grid));
    bench_work work = {restore, grow_all, pass, &w};
    bench_measure(job, "512^3", 0, 0.134217728, "Gvoxel", &work);
    if (w.report.kept_voxels > 0) {
        printf("    %.3f M voxels kept, %.3f M added\n", (double)w.report.kept_voxels * 1e-6,
               (double)w.report.added_voxels * 1e-6);
    }
    sf_grid_destroy(w.grid);
}

void bench_grow(void)
{
    if (!bench_wants("grow") && !bench_wants("path map")) {
        return;
    }
    sf_grid *near = scene_balls(512), *far = scene_far_balls(512);
    sf_lattice lattice = sf_grid_lattice(near);
    sf_rule box = sf_rule_box3(), slack, octagon, uneven;
    static double heights[512];
    static uint64_t table[1024];
    bench_must(sf_rule_make(SF_RULE_SLACK, 0.7853981633974483, &lattice, NULL, &slack, NULL));
    bench_must(sf_rule_make(SF_RULE_OCTAGON, 0.7853981633974483, &lattice, NULL, &octagon, NULL));
    for (int k = 0; k < 512; k++) {
        heights[k] = 0.6 + k * 37 % 100 * 0.008;
    }
    lattice.heights_mm = heights;
    bench_must(sf_rule_make(SF_RULE_SLACK, 0.7853981633974483, &lattice, table, &uneven, NULL));
    bench_query("grow query", near, &box);
    bench_query("grow query far", far, &box);
    bench_query("grow query 45", far, &octagon);
    bench_query("grow query slack", near, &slack);
    bench_query("grow query slack far", far, &slack);
    bench_query("grow query uneven", near, &uneven);
    bench_map("path map", near, &box);
    bench_map("path map 45", near, &octagon);
    bench_whole("grow", near, &box);
    bench_whole("grow 45", far, &octagon);
    bench_whole("grow slack", near, &slack);
    sf_grid_destroy(near);
    sf_grid_destroy(far);
}
