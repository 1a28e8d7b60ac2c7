// SPDX-License-Identifier: MIT
// Sculpting: strokes of one dab of radius 20 on a trimmed shape of 512^3, on its surface or, for
// add-grow, anywhere, and the undo and redo of each. A person feels the worst of a hundred, so
// beside the median stands the 99th percentile. For add-grow the time of a path is taken off: 0.05
// ms for each of its voxels, as the goal has it.

#include "bench.h"
#include "scenes.h"

#include <sf/sculpt.h>
#ifdef SF_HAVE_SCENES
#include "sculpted.h"
#endif

#include <stdio.h>
#include <stdlib.h>

#define DABS 300
#define RADIUS 20

typedef struct sculpt_work {
    sf_sculpt *model;
    sf_tip *tip;
    double stroke_ms[DABS], undo_ms[DABS], redo_ms[DABS];
    int undo_count;
    uint64_t paths;
} sculpt_work;

static uint32_t next_random(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return *state >> 16;
}

// A place on the surface: where a random column enters or leaves matter.
static sf_dab on_surface(const sf_grid *shape, uint32_t *seed)
{
    sf_lattice l = sf_grid_lattice(shape);
    for (;;) {
        uint32_t x = next_random(seed) % l.nx, y = next_random(seed) % l.ny;
        uint32_t z0 = next_random(seed) % l.nz, was = 2;
        for (uint32_t z = z0; z < l.nz; z++) {
            uint32_t is_solid = (uint32_t)sf_slice_get(sf_grid_slice(shape, z), x, y);
            if (was != 2 && is_solid != was) {
                sf_dab dab = {(int32_t)x, (int32_t)y, (int32_t)z};
                return dab;
            }
            was = is_solid;
        }
    }
}

static void stroke_once(sculpt_work *w, const sf_brush *brush, sf_dab at, int i)
{
    sf_sculpt_change change;
    size_t before = sf_sculpt_history_of(w->model).undo_count;
    double start = bench_now_ms();
    bench_must(sf_sculpt_stroke(w->model, brush, &at, 1, &change));
    double end = bench_now_ms();
    w->stroke_ms[i] = end - start - 0.05 * (double)change.path_voxels;
    w->paths += change.path_voxels;
    if (sf_sculpt_history_of(w->model).undo_count > before) {
        start = bench_now_ms();
        bench_must(sf_sculpt_undo(w->model, NULL));
        w->undo_ms[w->undo_count] = bench_now_ms() - start;
        start = bench_now_ms();
        bench_must(sf_sculpt_redo(w->model, NULL));
        w->redo_ms[w->undo_count++] = bench_now_ms() - start;
        bench_must(sf_sculpt_undo(w->model, NULL));
    }
}

static void measure(sculpt_work *w, sf_brush_kind kind, const char *job, double goal_ms)
{
    if (!bench_wants(job)) {
        return;
    }
    uint32_t seed = 7, n = sf_sculpt_options_of(w->model).lattice.nx;
    sf_brush brush = sf_brush_default();
    brush.kind = kind;
    brush.tip = w->tip;
    brush.material = 2;
    w->undo_count = 0;
    w->paths = 0;
    for (int i = 0; i < DABS; i++) {
        sf_dab at = {(int32_t)(next_random(&seed) % n), (int32_t)(next_random(&seed) % n),
                     (int32_t)(next_random(&seed) % (n - 60))};
        if (kind != SF_BRUSH_ADD_GROW) {
            at = on_surface(sf_sculpt_printable(w->model), &seed);
        }
        stroke_once(w, &brush, at, i);
    }
    bench_spread(job, "512^3 r=20", goal_ms, w->stroke_ms, DABS);
    if (w->undo_count > 0) {
        char undo[32], redo[32];
        snprintf(undo, sizeof undo, "%s undo", job);
        snprintf(redo, sizeof redo, "%s redo", job);
        bench_spread(undo, "512^3 r=20", 0.5, w->undo_ms, w->undo_count);
        bench_spread(redo, "512^3 r=20", 0.5, w->redo_ms, w->undo_count);
    }
    if (w->paths > 0) {
        printf("%-20s paths of %.1f voxels on average\n", "", (double)w->paths / DABS);
    }
}

#ifdef SF_HAVE_SCENES
// A whole session of the sheep's, 151 strokes, model and all.
static void measure_session(void)
{
    enum { ROUNDS = 9 };
    double times[ROUNDS];
    sf_session *session = NULL;
    if (!bench_wants("sculpt session")) {
        return;
    }
    bench_must(sculpted_session("shaun", 512, NULL, &session));
    for (int i = 0; i < ROUNDS; i++) {
        sf_sculpt *model = NULL;
        bench_must(sf_session_begin(session, NULL, &model));
        double start = bench_now_ms();
        for (size_t k = 0; k < sf_session_count(session).steps; k++) {
            bench_must(sf_session_play(session, k, NULL, model, NULL));
        }
        times[i] = bench_now_ms() - start;
        sf_sculpt_destroy(model);
    }
    sf_session_destroy(session);
    bench_spread("sculpt session", "shaun 512", 500, times, ROUNDS);
}
#else
static void measure_session(void)
{
}
#endif

void bench_sculpt(void)
{
    if (!bench_wants("sculpt")) {
        return;
    }
    measure_session();
    const double radius[3] = {RADIUS, RADIUS, RADIUS};
    sf_sculpt_options options = sf_sculpt_options_default();
    sf_grid *scene = scene_balls(options.lattice.nx);
    sculpt_work *w = bench_memory(sizeof *w);
    bench_must(sf_tip_create(SF_TIP_SPHERE, radius, NULL, &w->tip));
    bench_must(sf_sculpt_create(&options, NULL, &w->model));
    bench_must(sf_sculpt_replace(w->model, scene, NULL, NULL));
    sf_grid_destroy(scene);
    measure(w, SF_BRUSH_ADD_TRIM, "sculpt add-trim", 1);
    measure(w, SF_BRUSH_REMOVE_TRIM, "sculpt remove-trim", 1);
    measure(w, SF_BRUSH_REMOVE_PRESERVE, "sculpt remove-pres.", 2);
    measure(w, SF_BRUSH_ADD_GROW, "sculpt add-grow", 2);
    measure(w, SF_BRUSH_SMOOTH_TRIM, "sculpt smooth-trim", 3);
    measure(w, SF_BRUSH_PAINT, "sculpt paint", 1);
    sf_sculpt_destroy(w->model);
    sf_tip_destroy(w->tip);
    free(w);
}
