// SPDX-License-Identifier: MIT
// What a ray meets: a walk from voxel to voxel.
//
// Source: J. Amanatides, A. Woo, "A fast voxel traversal algorithm for ray tracing", 1987.

#include "pick.h"

#include <math.h>

// A ray in voxels.
typedef struct walk {
    double from[3], way[3];
    int64_t voxel[3], count[3];
    int step[3];
    double next[3]; // where the next border along each axis is crossed
} walk;

static walk begin(const sf_lattice *l, const double from_mm[3], const double direction[3])
{
    walk w = {.from = {0, 0, 0}};
    const double pitch[3] = {l->pitch_x_mm, l->pitch_y_mm, l->layer_mm};
    const int64_t count[3] = {l->nx, l->ny, l->nz};
    for (int i = 0; i < 3; i++) {
        w.from[i] = (from_mm[i] - l->origin_mm[i]) / pitch[i];
        w.way[i] = direction[i] / pitch[i];
        w.count[i] = count[i];
    }
    return w;
}

// Where the ray enters the grid, and through which axis; 0 where it misses it.
static int enter(const walk *w, double *at, int *axis)
{
    double low = 0, high = INFINITY;
    *axis = -1;
    for (int i = 0; i < 3; i++) {
        double a = -w->from[i] / w->way[i], b = ((double)w->count[i] - w->from[i]) / w->way[i];
        if (!(w->way[i] < 0) && !(w->way[i] > 0)) {
            if (w->from[i] < 0 || w->from[i] >= (double)w->count[i]) {
                return 0;
            }
            continue;
        }
        if (fmin(a, b) > low) {
            low = fmin(a, b);
            *axis = i;
        }
        high = fmin(high, fmax(a, b));
    }
    *at = low;
    return low < high;
}

static void place(walk *w, double at)
{
    for (int i = 0; i < 3; i++) {
        double p = floor(w->from[i] + at * w->way[i]);
        double most = (double)w->count[i] - 1;
        w->voxel[i] = (int64_t)(p < 0 ? 0 : p > most ? most : p);
        w->step[i] = w->way[i] > 0 ? 1 : w->way[i] < 0 ? -1 : 0;
        double border = (double)w->voxel[i] + (w->way[i] > 0 ? 1 : 0);
        w->next[i] = w->step[i] != 0 ? (border - w->from[i]) / w->way[i] : INFINITY;
    }
}

static int nearest(const walk *w)
{
    int axis = w->next[1] < w->next[0] ? 1 : 0;
    return w->next[2] < w->next[axis] ? 2 : axis;
}

int view_pick(const sf_grid *grid, const double from_mm[3], const double direction[3],
              view_hit *hit)
{
    sf_lattice l = sf_grid_lattice(grid);
    walk w = begin(&l, from_mm, direction);
    double at;
    int axis;
    if (!enter(&w, &at, &axis)) {
        return 0;
    }
    place(&w, at);
    while (!sf_slice_get(sf_grid_slice(grid, (uint32_t)w.voxel[2]), (uint32_t)w.voxel[0],
                         (uint32_t)w.voxel[1])) {
        axis = nearest(&w);
        at = w.next[axis];
        w.voxel[axis] += w.step[axis];
        if (w.voxel[axis] < 0 || w.voxel[axis] >= w.count[axis]) {
            return 0;
        }
        w.next[axis] += fabs(1 / w.way[axis]);
    }
    axis = axis < 0 ? 2 : axis; // the eye is inside
    view_hit made = {(uint32_t)w.voxel[0],
                     (uint32_t)w.voxel[1],
                     (uint32_t)w.voxel[2],
                     axis,
                     w.way[axis] < 0,
                     at,
                     {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
        made.at_mm[i] = from_mm[i] + at * direction[i];
    }
    *hit = made;
    return 1;
}
