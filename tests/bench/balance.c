// SPDX-License-Identifier: MIT
// Balancing: what one step costs at the size of the paper's horse, 172 k triangles and six handles.
// The limit reads every vertex, weight and triangle once.

#include "bench.h"
#include "scenes.h"

#include "balance/bend/sqp.h"
#include "base/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HANDLES = 6, SIZE = 100 };

typedef struct bend_work {
    sf_mesh *mesh;
    sf_mesh_view view;
    double *weights, centres[3 * HANDLES];
    uint32_t *held;
    uint8_t free[SFI_POSE_SIZE * HANDLES];
    sf_pose poses[HANDLES], start[HANDLES];
    sf_halfspace safe[32];
    sfi_incidence incidence;
    sfi_energy energy;
    sfi_skin skin;
    sfi_standing standing;
    sfi_posture posture;
    sfi_posture_scratch scratch;
    sf_allocator allocator;
    double sum;
} bend_work;

// Smooth weights of handles on a ring and one in the foot.
static void weigh_points(bend_work *w)
{
    for (size_t v = 0; v < w->view.vertex_count; v++) {
        const double *p = w->view.vertices + 3 * v;
        double sum = 0, *to = w->weights + HANDLES * v;
        for (size_t j = 0; j < HANDLES; j++) {
            double square = 0;
            for (size_t d = 0; d < 3; d++) {
                square += (p[d] - w->centres[3 * j + d]) * (p[d] - w->centres[3 * j + d]);
            }
            to[j] = 1 / (SIZE + square);
            sum += to[j];
        }
        for (size_t j = 0; j < HANDLES; j++) {
            to[j] /= sum;
        }
    }
}

// A foot that lies aside of the middle, so that there is something to do.
static void stand(bend_work *w)
{
    for (int e = 0; e < 32; e++) {
        double angle = e * 6.283185307179586 / 32;
        sf_halfspace h = {{cos(angle), sin(angle), -0.05}, 0};
        double length = sqrt(1 + 0.05 * 0.05);
        for (int d = 0; d < 3; d++) {
            h.normal[d] /= length;
        }
        h.offset_mm = h.normal[0] * 0.6 * SIZE + h.normal[1] * 0.5 * SIZE - 0.04 * SIZE;
        w->safe[e] = h;
    }
    sfi_standing standing = {{0, 0, 1}, 0, 0, 32};
    w->standing = standing;
}

static void begin(bend_work *w)
{
    memset(w, 0, sizeof *w);
    w->allocator = sfi_allocator_or_default(NULL);
    w->mesh = scene_bumpy_sphere(93, SIZE);
    w->view = sf_mesh_get_view(w->mesh);
    w->weights = bench_memory(w->view.vertex_count * HANDLES * sizeof *w->weights);
    w->held = bench_memory(w->view.vertex_count * sizeof *w->held);
    memset(w->held, 0, w->view.vertex_count * sizeof *w->held);
    for (int j = 0; j < HANDLES; j++) {
        const double at[3] = {50 + 30 * cos(j * 1.3), 50 + 30 * sin(j * 1.3), j == 0 ? 5 : 60};
        memcpy(w->centres + 3 * j, at, sizeof at);
        const sf_pose at_rest = {1, {1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
        w->start[j] = w->poses[j] = at_rest;
        for (int p = 0; p < SFI_POSE_TURN; p++) {
            w->free[SFI_POSE_SIZE * j + p] = j > 0;
        }
    }
    weigh_points(w);
    stand(w);
    const double weights[3] = {1, 0.3, 0.05};
    sf_blend basis = {w->view.vertices, w->weights, w->view.vertex_count, w->centres, HANDLES};
    bench_must(sfi_incidence_make(w->view, &w->allocator, &w->incidence));
    bench_must(sfi_energy_make(w->view, &w->incidence, &basis, SIZE, weights, &w->allocator, NULL,
                               &w->energy));
    sfi_skin skin = {basis, w->view.triangles, &w->incidence};
    w->skin = skin;
    sfi_posture posture = {.energy = &w->energy,
                           .skins = &w->skin,
                           .skin_count = 1,
                           .safe = w->safe,
                           .safe_count = 32,
                           .standings = &w->standing,
                           .standing_count = 1,
                           .held = w->held,
                           .clearance_mm = -SIZE,
                           .size_mm = SIZE};
    w->posture = posture;
    bench_must(sfi_posture_scratch_make(&w->posture, &w->allocator, &w->scratch));
}

static void end(bend_work *w)
{
    sfi_posture_scratch_free(&w->scratch);
    sfi_energy_free(&w->energy);
    sfi_incidence_free(&w->allocator, &w->incidence);
    free(w->weights);
    free(w->held);
    sf_mesh_destroy(w->mesh);
}

static void read_once(void *user)
{
    bend_work *w = user;
    double sum = 0;
    size_t indices = 0;
    for (size_t i = 0; i < 3 * w->view.vertex_count; i++) {
        sum += w->view.vertices[i];
    }
    for (size_t i = 0; i < HANDLES * w->view.vertex_count; i++) {
        sum += w->weights[i];
    }
    for (size_t i = 0; i < 3 * w->view.triangle_count; i++) {
        indices += w->view.triangles[i];
    }
    w->sum = sum + (double)indices;
}

static void make_energy(void *user)
{
    bend_work *w = user;
    const double weights[3] = {1, 0.3, 0.05};
    sfi_energy energy;
    bench_must(sfi_energy_make(w->view, &w->incidence, &w->skin.basis, SIZE, weights, &w->allocator,
                               NULL, &energy));
    sfi_energy_free(&energy);
}

static void look(void *user)
{
    bend_work *w = user;
    sfi_posture_state state;
    bench_must(sfi_posture_look(&w->posture, w->poses, NULL, &w->scratch, &state));
}

static void start_again(void *user)
{
    bend_work *w = user;
    memcpy(w->poses, w->start, sizeof w->poses);
}

// Four steps, whatever comes of them.
static void step(void *user)
{
    bend_work *w = user;
    sfi_freedom freedom = {w->free, 0.7, 1.4, 1e9, 0.3};
    sfi_sqp_report report;
    bench_must(sfi_sqp_run(&w->posture, &freedom, 4, &w->allocator, NULL, w->poses, &report));
}

void bench_balance(void)
{
    const char *jobs[] = {"bend energy", "bend look", "bend 4 steps"};
    void (*const runs[])(void *) = {make_energy, look, step};
    bend_work w;
    if (!bench_wants(jobs[0]) && !bench_wants(jobs[1]) && !bench_wants(jobs[2])) {
        return;
    }
    begin(&w);
    for (int i = 0; i < 3; i++) {
        bench_work work = {i == 2 ? start_again : NULL, runs[i], read_once, &w};
        if (bench_wants(jobs[i])) {
            bench_measure(jobs[i], "172k", 0, (double)w.view.triangle_count * 1e-6, "Mtriangle",
                          &work);
        }
    }
    end(&w);
}
