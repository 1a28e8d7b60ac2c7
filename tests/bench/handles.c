// SPDX-License-Identifier: MIT
// Handles: what weights cost at the size of the paper's models, 20 k voxels and six handles, and
// what it takes to bend, pull and unbend the 86 k vertices of 172 k triangles. The limit reads
// every vertex and weight once.

#include "bench.h"
#include "scenes.h"

#include <sf/blend.h>

#include <stdlib.h>
#include <string.h>

enum { HANDLES = 6, SIZE = 100 };

typedef struct handle_work {
    sf_mesh *mesh;
    sf_mesh_view view;
    sf_grid *covered, *foot;
    sf_handle handles[HANDLES];
    sf_weights *weights;
    sf_pose poses[HANDLES];
    double *w, *bent, *rest, sum;
} handle_work;

static void begin(handle_work *h)
{
    const double up[3] = {0, 0, 1};
    const double at[HANDLES - 1][3] = {
        {20, 50, 50}, {80, 50, 50}, {50, 20, 50}, {50, 80, 50}, {50, 50, 85}};
    memset(h, 0, sizeof *h);
    h->mesh = scene_bumpy_sphere(93, SIZE);
    h->view = sf_mesh_get_view(h->mesh);
    double pitch = SIZE / 33.0;
    sf_lattice lattice = {36, 36, 36, pitch, pitch, pitch, NULL, {-pitch, -pitch, -pitch}};
    sf_grid *solid = NULL;
    bench_must(sf_grid_create(&lattice, NULL, &solid));
    bench_must(sf_grid_voxelize(solid, h->view, NULL, NULL, NULL, NULL));
    bench_must(sf_grid_cover(solid, h->view, NULL, NULL, &h->covered));
    bench_must(sf_grid_foot(h->covered, up, 5, NULL, &h->foot));
    sf_grid_destroy(solid);
    bench_must(sf_handle_base(h->foot, &h->handles[0]));
    for (int j = 0; j < HANDLES; j++) {
        sf_handle point = {SF_HANDLE_POINT, {0, 0, 0}, 0, NULL, 0};
        sf_pose_change change = {0.1, {2, -1, 1}, {0.1, 0.05, 0}};
        h->poses[j] = sf_pose_identity();
        if (j > 0) {
            memcpy(point.at_mm, at[j - 1], sizeof point.at_mm);
            h->handles[j] = point;
            bench_must(sf_pose_move(&h->poses[j], &change));
        }
    }
    bench_must(
        sf_weights_create(h->covered, h->handles, HANDLES, NULL, NULL, NULL, &h->weights, NULL));
    size_t count = h->view.vertex_count;
    h->w = bench_memory(HANDLES * count * sizeof *h->w);
    h->bent = bench_memory(3 * count * sizeof *h->bent);
    h->rest = bench_memory(3 * count * sizeof *h->rest);
    bench_must(sf_weights_sample(h->weights, h->view.vertices, count, NULL, h->w));
}

static void end(handle_work *h)
{
    free(h->w);
    free(h->bent);
    free(h->rest);
    sf_weights_destroy(h->weights);
    sf_grid_destroy(h->covered);
    sf_grid_destroy(h->foot);
    sf_mesh_destroy(h->mesh);
}

static void read_once(void *user)
{
    handle_work *h = user;
    double sum = 0;
    for (size_t i = 0; i < 3 * h->view.vertex_count; i++) {
        sum += h->view.vertices[i];
    }
    for (size_t i = 0; i < HANDLES * h->view.vertex_count; i++) {
        sum += h->w[i];
    }
    h->sum = sum;
}

static void weigh(handle_work *h, sf_weights_method method)
{
    sf_weights *weights = NULL;
    sf_weights_options options = sf_weights_options_default();
    options.method = method;
    bench_must(
        sf_weights_create(h->covered, h->handles, HANDLES, &options, NULL, NULL, &weights, NULL));
    sf_weights_destroy(weights);
}

static void run_clamped(void *user)
{
    weigh(user, SF_WEIGHTS_CLAMPED);
}

static void run_bounded(void *user)
{
    weigh(user, SF_WEIGHTS_BOUNDED);
}

static void run_sample(void *user)
{
    handle_work *h = user;
    bench_must(sf_weights_sample(h->weights, h->view.vertices, h->view.vertex_count, NULL, h->w));
}

static sf_blend blend_of(const handle_work *h)
{
    sf_blend blend = {h->view.vertices, h->w, h->view.vertex_count, sf_weights_centers(h->weights),
                      HANDLES};
    return blend;
}

static void run_apply(void *user)
{
    handle_work *h = user;
    bench_must(sf_blend_apply(blend_of(h), h->poses, NULL, h->bent));
}

static void run_pull(void *user)
{
    handle_work *h = user;
    sf_pose_change changes[HANDLES];
    bench_must(sf_blend_pull(blend_of(h), h->poses, h->view.vertices, NULL, NULL, changes));
}

static void bend_all(void *user)
{
    handle_work *h = user;
    run_apply(h);
    memcpy(h->rest, h->bent, 3 * h->view.vertex_count * sizeof *h->rest);
}

static void run_unbend(void *user)
{
    handle_work *h = user;
    bench_must(sf_weights_unbend(h->weights, h->poses, h->bent, h->view.vertex_count, 1e-6, NULL,
                                 NULL, h->rest, NULL, NULL));
}

void bench_handles(void)
{
    static const struct {
        const char *job;
        void (*prepare)(void *), (*run)(void *);
        int per_cell;
    } jobs[] = {
        {"weights clamped", NULL, run_clamped, 1}, {"weights bounded", NULL, run_bounded, 1},
        {"weights sample", NULL, run_sample, 0},   {"blend apply", NULL, run_apply, 0},
        {"blend pull", NULL, run_pull, 0},         {"blend unbend", bend_all, run_unbend, 0}};
    handle_work h;
    int made = 0;
    for (size_t i = 0; i < sizeof jobs / sizeof *jobs; i++) {
        if (!bench_wants(jobs[i].job)) {
            continue;
        }
        if (!made++) {
            begin(&h);
        }
        double cells = (double)sf_grid_popcount(h.covered), points = (double)h.view.vertex_count;
        bench_work work = {jobs[i].prepare, jobs[i].run, read_once, &h};
        bench_measure(jobs[i].job, jobs[i].per_cell ? "20k" : "86k", 0,
                      (jobs[i].per_cell ? cells : points) * 1e-6,
                      jobs[i].per_cell ? "Mcell" : "Mpoint", &work);
    }
    if (made) {
        end(&h);
    }
}
