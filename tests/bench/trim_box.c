// SPDX-License-Identifier: MIT
// Trim after an edit: a ball of radius 20 taken out of a large shape, again and again at other
// places, and what rests on it brought up to date. The limit reads and writes the edited box once.

#include "bench.h"
#include "limits.h"
#include "scenes.h"

#include <stdio.h>

#define RADIUS 20u
#define PLACES 16

typedef struct edit_work {
    sf_grid *drawn, *printable;
    sf_rule rule;
    sf_box box;
    uint32_t centre[PLACES][3]; // within matter
    int at;
} edit_work;

// Fill or empty the ball.
static void draw_ball(edit_work *w, int value)
{
    const uint32_t *c = w->centre[w->at];
    sf_box box = {c[0] - RADIUS,     c[1] - RADIUS,     c[2] - RADIUS,
                  c[0] + RADIUS + 1, c[1] + RADIUS + 1, c[2] + RADIUS + 1};
    w->box = box;
    for (uint32_t z = box.z0; z < box.z1; z++) {
        for (uint32_t y = box.y0; y < box.y1; y++) {
            uint32_t dy = y > c[1] ? y - c[1] : c[1] - y, dz = z > c[2] ? z - c[2] : c[2] - z,
                     x = 0;
            while (x <= RADIUS && x * x + dy * dy + dz * dz <= RADIUS * RADIUS) {
                x++;
            }
            if (x > 0) {
                sf_rect row = {c[0] - x + 1, y, c[0] + x, y + 1};
                bench_must(sf_slice_fill(sf_grid_slice(w->drawn, z), row, value));
            }
        }
    }
}

// Put the last ball back, take the next one out.
static void prepare(void *user)
{
    edit_work *w = user;
    draw_ball(w, 1);
    bench_must(sf_grid_trim_box(w->drawn, w->printable, &w->rule, 0, w->box, NULL));
    w->at = (w->at + 1) % PLACES;
    draw_ball(w, 0);
}

static void update(void *user)
{
    edit_work *w = user;
    bench_must(sf_grid_trim_box(w->drawn, w->printable, &w->rule, 0, w->box, NULL));
}

static void pass(void *user)
{
    edit_work *w = user;
    for (uint32_t z = w->box.z0; z < w->box.z1; z++) {
        sf_slice slice = sf_grid_slice(w->drawn, z);
        for (uint32_t y = w->box.y0; y < w->box.y1; y++) {
            volatile uint64_t *row = slice.words + y * slice.stride;
            for (uint32_t x = w->box.x0 / 64; x <= (w->box.x1 - 1) / 64; x++) {
                row[x] = row[x];
            }
        }
    }
}

// Places whose whole ball is matter, at various heights.
static int find_places(edit_work *w, uint32_t n)
{
    int found = 0;
    for (uint32_t i = 0; i < 200000 && found < PLACES; i++) {
        uint32_t c[3], whole = 1;
        for (int j = 0; j < 3; j++) {
            uint32_t mixed = (i * 3 + (uint32_t)j + 1) * 2654435761u;
            c[j] = RADIUS + 1 + (mixed >> 8) % (n - 2 * RADIUS - 2);
        }
        for (uint32_t z = c[2] - RADIUS; whole && z <= c[2] + RADIUS; z += RADIUS) {
            for (uint32_t y = c[1] - RADIUS; whole && y <= c[1] + RADIUS; y += RADIUS) {
                for (uint32_t x = c[0] - RADIUS; whole && x <= c[0] + RADIUS; x += RADIUS) {
                    whole = (uint32_t)sf_slice_get(sf_grid_slice(w->printable, z), x, y);
                }
            }
        }
        for (int j = 0; whole && j < 3; j++) {
            w->centre[found][j] = c[j];
        }
        found += (int)whole;
    }
    return found;
}

void bench_trim_box(void)
{
    if (!bench_wants("trim edit")) {
        return;
    }
    edit_work w = {.drawn = scene_balls(512), .rule = sf_rule_box3()};
    // Balls on columns: all of it prints.
    for (uint32_t k = 511; k-- > 0;) {
        sf_slice slice = sf_grid_slice(w.drawn, k);
        bench_must(sf_slice_or(slice, slice, sf_grid_slice(w.drawn, k + 1)));
    }
    bench_must(sf_grid_clone(w.drawn, NULL, &w.printable));
    if (find_places(&w, 512) == PLACES) {
        bench_work work = {prepare, update, pass, &w};
        bench_measure("trim edit r=20", "512^3", 0, 1, "edit", &work);
    } else {
        fprintf(stderr, "sf-bench: no room for the edits\n");
    }
    sf_grid_destroy(w.drawn);
    sf_grid_destroy(w.printable);
}
