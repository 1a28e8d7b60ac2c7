// SPDX-License-Identifier: MIT
// Scenes that the program makes itself.
//
// A scene is a table of solids in millimetres; a voxel is solid when its centre lies in one of them
// and not below 0, where the scene stands. The garden has one of each thing that a printer stumbles
// over: the crown of an arch, a flat underside, an arm that sticks out, a lantern that begins in
// the air and is joined only further up, a bird that is joined nowhere; and beside them a tree and
// a leaning post that print as they are.

#include "scene.h"

#include <string.h>

typedef enum solid_kind {
    BLOCK, // from a to b
    POLE,  // swept ball from a (radius r) to b (radius s)
    CAP,   // upper half of the ball around a with radius r
    ARCH   // upper half of a ring in the xz plane around a: radius r, thickness s
} solid_kind;

typedef struct solid {
    solid_kind kind;
    double a[3], b[3];
    double r, s;
} solid;

typedef struct scene {
    const char *name;
    double size_mm[3];
    const solid *solids;
    size_t count;
} scene;

static const solid garden[] = {
    {BLOCK, {2, 2, 0}, {94, 54, 3}, 0, 0},
    // the gate
    {POLE, {14, 28, 0}, {14, 28, 26}, 3.5, 3.5},
    {POLE, {38, 28, 0}, {38, 28, 26}, 3.5, 3.5},
    {ARCH, {26, 28, 26}, {0, 0, 0}, 12, 3.5},
    // the mushroom
    {POLE, {58, 16, 0}, {58, 16, 20}, 4.5, 3.5},
    {CAP, {58, 16, 20}, {0, 0, 0}, 12, 0},
    // the lamp
    {POLE, {84, 40, 0}, {84, 40, 50}, 3, 2},
    {POLE, {84, 40, 50}, {62, 40, 50}, 2, 1.5},
    {POLE, {62, 40, 50}, {62, 40, 36}, 1, 1},
    {POLE, {62, 40, 33}, {62, 40, 29}, 4, 5.5},
    // the bird
    {POLE, {24, 42, 52}, {35, 42, 53}, 1.2, 2.6},
    {POLE, {29, 42, 53}, {27, 33, 57}, 1.6, 0.9},
    {POLE, {29, 42, 53}, {27, 51, 57}, 1.6, 0.9},
    // the tree and the leaning post
    {POLE, {82, 14, 2}, {82, 14, 36}, 9, 0.6},
    {POLE, {10, 44, 1}, {20, 46, 26}, 3, 2},
};

static const scene scenes[] = {
    {"garden", {96, 56, 60}, garden, sizeof garden / sizeof garden[0]},
};

static double square(double x)
{
    return x * x;
}

static double distance_squared(const double p[3], const double q[3])
{
    return square(p[0] - q[0]) + square(p[1] - q[1]) + square(p[2] - q[2]);
}

static int in_pole(const solid *s, const double p[3])
{
    double along = 0, length = distance_squared(s->a, s->b), foot[3];
    for (int i = 0; i < 3; i++) {
        along += (p[i] - s->a[i]) * (s->b[i] - s->a[i]);
    }
    along = along < 0 ? 0 : along > length ? 1 : along / length;
    for (int i = 0; i < 3; i++) {
        foot[i] = s->a[i] + along * (s->b[i] - s->a[i]);
    }
    return distance_squared(p, foot) <= square(s->r + along * (s->s - s->r));
}

// In the ring where the distance d from its axis has (d - r)^2 + dy^2 <= s^2, which needs no root:
// d^2 + r^2 + dy^2 - s^2 <= 2 r d, both sides positive when squared.
static int in_arch(const solid *s, const double p[3])
{
    double axis = square(p[0] - s->a[0]) + square(p[2] - s->a[2]);
    double left = axis + square(s->r) + square(p[1] - s->a[1]) - square(s->s);
    return p[2] >= s->a[2] && (left <= 0 || square(left) <= 4 * square(s->r) * axis);
}

static int in_solid(const solid *s, const double p[3])
{
    switch (s->kind) {
    case BLOCK:
        return p[0] >= s->a[0] && p[0] < s->b[0] && p[1] >= s->a[1] && p[1] < s->b[1] &&
               p[2] >= s->a[2] && p[2] < s->b[2];
    case POLE:
        return in_pole(s, p);
    case CAP:
        return p[2] >= s->a[2] && distance_squared(p, s->a) <= square(s->r);
    case ARCH:
        return in_arch(s, p);
    }
    return 0;
}

static const scene *find(const char *name)
{
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        if (strcmp(scenes[i].name, name) == 0) {
            return &scenes[i];
        }
    }
    return NULL;
}

int scene_size(const char *name, double size_mm[3])
{
    const scene *found = find(name);
    if (found != NULL) {
        memcpy(size_mm, found->size_mm, sizeof found->size_mm);
    }
    return found != NULL;
}

typedef struct drawing {
    const scene *scene;
    sf_grid *grid;
    sf_lattice lattice;
    uint32_t first; // layer of index 0
} drawing;

static void draw_layer(void *context, size_t index)
{
    const drawing *d = context;
    const sf_lattice *l = &d->lattice;
    uint32_t k = d->first + (uint32_t)index;
    sf_slice slice = sf_grid_slice(d->grid, k);
    double p[3];
    p[2] = sf_lattice_layer_bottom(l, k) + 0.5 * sf_lattice_layer_height(l, k);
    for (uint32_t y = 0; y < l->ny; y++) {
        p[1] = l->origin_mm[1] + (y + 0.5) * l->pitch_y_mm;
        for (uint32_t x = 0; x < l->nx; x++) {
            int inside = 0;
            p[0] = l->origin_mm[0] + (x + 0.5) * l->pitch_x_mm;
            for (size_t i = 0; i < d->scene->count && !inside && p[2] >= 0; i++) {
                inside = in_solid(&d->scene->solids[i], p);
            }
            slice.words[(size_t)y * slice.stride + x / 64] |= (uint64_t)inside << (x % 64);
        }
    }
}

sf_status scene_draw(const char *name, sf_grid *grid, sf_task *task)
{
    enum { LAYERS_AT_ONCE = 16 };
    drawing d = {find(name), grid, sf_grid_lattice(grid), 0};
    if (d.scene == NULL) {
        return SF_ERR_ARGUMENT;
    }
    while (d.first < d.lattice.nz) {
        uint32_t left = d.lattice.nz - d.first;
        size_t count = left < LAYERS_AT_ONCE ? left : LAYERS_AT_ONCE;
        if (sf_task_is_cancelled(task)) {
            return SF_ERR_CANCELLED;
        }
        if (task != NULL && task->parallel_for != NULL) {
            task->parallel_for(task->user, count, draw_layer, &d);
        } else {
            for (size_t i = 0; i < count; i++) {
                draw_layer(&d, i);
            }
        }
        d.first += (uint32_t)count;
        if (task != NULL && task->progress != NULL) {
            task->progress(task->user, (double)d.first / d.lattice.nz);
        }
    }
    return SF_OK;
}
