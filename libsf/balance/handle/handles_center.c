// SPDX-License-Identifier: MIT
// The middle of the solid behind a point: a walk along a ray, from voxel to voxel.
//
// The ray is cut to the box of the lattice. From there on the next wall of the present voxel along
// each axis is known as a length along the ray; the nearest of the three is crossed. A stretch of
// solid voxels begins where the first one is entered and ends where an empty one is, or where the
// box ends. A ray that runs along a slanted surface cuts slivers off its steps; so a stretch
// shorter than half a voxel's edge is passed over when a longer one follows.
//
// Source: J. Amanatides, A. Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987.

#include <sf/handles.h>

#include "base/status.h"

#include <math.h>

#define FARTHEST 1e12 // mm, as in a lattice

typedef struct walk {
    const sf_grid *solid;
    sf_lattice lattice;
    double from[3], unit[3];
    double begin, end; // lengths along the ray within the box
    int64_t at[3], step[3];
    double wall[3];   // length at which the next wall is met, or infinite
    double low, high; // of the present layer, in mm
} walk;

static double edge_of(const walk *w, int axis)
{
    return axis == 0 ? w->lattice.pitch_x_mm : w->lattice.pitch_y_mm;
}

static int64_t count_of(const walk *w, int axis)
{
    return axis == 0 ? w->lattice.nx : axis == 1 ? w->lattice.ny : w->lattice.nz;
}

// Cut the ray to the box. Returns 0 where it misses it.
static int cut(walk *w)
{
    w->begin = 0;
    w->end = INFINITY;
    for (int axis = 0; axis < 3; axis++) {
        double low = w->lattice.origin_mm[axis];
        double high = axis == 2 ? sf_lattice_layer_bottom(&w->lattice, w->lattice.nz)
                                : low + edge_of(w, axis) * (double)count_of(w, axis);
        if (w->unit[axis] == 0) {
            if (w->from[axis] < low || w->from[axis] > high) {
                return 0;
            }
            continue;
        }
        double a = (low - w->from[axis]) / w->unit[axis];
        double b = (high - w->from[axis]) / w->unit[axis];
        double near = a < b ? a : b, far = a < b ? b : a;
        w->begin = near > w->begin ? near : w->begin;
        w->end = far < w->end ? far : w->end;
    }
    return w->begin <= w->end;
}

// The next wall along an axis, never before where the ray is.
static void set_wall(walk *w, int axis, double now)
{
    double plane;
    if (w->step[axis] == 0) {
        w->wall[axis] = INFINITY;
        return;
    }
    if (axis == 2) {
        plane = w->step[2] > 0 ? w->high : w->low;
    } else {
        plane = w->lattice.origin_mm[axis] +
                edge_of(w, axis) * (double)(w->at[axis] + (w->step[axis] > 0));
    }
    double length = (plane - w->from[axis]) / w->unit[axis];
    w->wall[axis] = length > now ? length : now;
}

static void start(walk *w)
{
    double z = w->from[2] + w->begin * w->unit[2];
    for (int axis = 0; axis < 3; axis++) {
        w->step[axis] = w->unit[axis] > 0 ? 1 : w->unit[axis] < 0 ? -1 : 0;
    }
    for (int axis = 0; axis < 2; axis++) {
        double p = w->from[axis] + w->begin * w->unit[axis] - w->lattice.origin_mm[axis];
        double i = floor(p / edge_of(w, axis));
        int64_t last = count_of(w, axis) - 1;
        w->at[axis] = i > 0 ? i < (double)last ? (int64_t)i : last : 0;
    }
    w->at[2] = 0;
    w->low = w->lattice.origin_mm[2];
    w->high = w->low + sf_lattice_layer_height(&w->lattice, 0);
    while (z >= w->high && w->at[2] + 1 < w->lattice.nz) {
        w->at[2]++;
        w->low = w->high;
        w->high += sf_lattice_layer_height(&w->lattice, (uint32_t)w->at[2]);
    }
    for (int axis = 0; axis < 3; axis++) {
        set_wall(w, axis, w->begin);
    }
}

// Cross the nearest wall, of equals all in turn. Returns the length at which that is.
static double advance(walk *w)
{
    int axis = w->wall[0] <= w->wall[1] ? 0 : 1;
    axis = w->wall[axis] <= w->wall[2] ? axis : 2;
    double now = w->wall[axis];
    w->at[axis] += w->step[axis];
    if (axis == 2 && w->at[2] >= 0 && w->at[2] < w->lattice.nz) {
        double height = sf_lattice_layer_height(&w->lattice, (uint32_t)w->at[2]);
        w->low = w->step[2] > 0 ? w->high : w->low - height;
        w->high = w->low + height;
    }
    set_wall(w, axis, now);
    return now;
}

static int is_inside(const walk *w)
{
    return w->at[0] >= 0 && w->at[0] < w->lattice.nx && w->at[1] >= 0 && w->at[1] < w->lattice.ny &&
           w->at[2] >= 0 && w->at[2] < w->lattice.nz;
}

static int is_solid(const walk *w)
{
    return is_inside(w) && sf_slice_get(sf_grid_slice(w->solid, (uint32_t)w->at[2]),
                                        (uint32_t)w->at[0], (uint32_t)w->at[1]);
}

// The first stretch of solid voxels that is long enough, else the first of all. Returns whether
// there is one.
static int find_stretch(walk *w, double enough, double *enter, double *leave)
{
    double now = w->begin, entered = w->begin;
    int was = is_solid(w), found = 0;
    while (is_inside(w)) {
        now = advance(w);
        int is = is_solid(w);
        if (is && !was) {
            entered = now;
        }
        if (was && !is && (!found || now - entered >= enough)) {
            *enter = entered;
            *leave = now;
            found = 1;
            if (now - entered >= enough) {
                break;
            }
        }
        was = is;
    }
    return found;
}

// The direction with length 1; returns 0 where it has none. Squares of what is very long or very
// short are no numbers, so it is brought to a fair length first.
static int make_unit(const double direction[3], double unit[3])
{
    double most = 0, sum = 0;
    for (int axis = 0; axis < 3; axis++) {
        most = fabs(direction[axis]) > most ? fabs(direction[axis]) : most;
    }
    int is_fair = most > 1e-100 && most < 1e100;
    for (int axis = 0; axis < 3; axis++) {
        unit[axis] = is_fair ? direction[axis] : direction[axis] / most;
        sum += unit[axis] * unit[axis];
    }
    double length = sqrt(sum);
    for (int axis = 0; axis < 3; axis++) {
        unit[axis] /= length;
    }
    return length > 0 && isfinite(length);
}

sf_status sf_handle_center(const sf_grid *solid, const double from_mm[3], const double direction[3],
                           double center_mm[3], sf_fault *fault)
{
    double enter = 0, leave = 0;
    if (solid == NULL || from_mm == NULL || direction == NULL || center_mm == NULL) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0, "a pointer is missing");
    }
    walk w = {.solid = solid, .lattice = sf_grid_lattice(solid)};
    int is_place = 1;
    for (int axis = 0; axis < 3; axis++) {
        is_place = is_place && fabs(from_mm[axis]) <= FARTHEST;
        w.from[axis] = from_mm[axis];
    }
    if (!is_place || !make_unit(direction, w.unit)) {
        return sfi_fault_set(fault, SF_ERR_ARGUMENT, 0, 0,
                             "a ray needs a point within 1e12 mm, and a direction that is finite "
                             "and not zero");
    }
    double edge =
        w.lattice.pitch_x_mm < w.lattice.pitch_y_mm ? w.lattice.pitch_x_mm : w.lattice.pitch_y_mm;
    int hit = cut(&w);
    if (hit) {
        start(&w);
        hit = find_stretch(&w, 0.5 * edge, &enter, &leave);
    }
    if (!hit) {
        return sfi_fault_set(fault, SF_ERR_INFEASIBLE, 0, 0,
                             "the ray meets no solid voxel: point it at the solid");
    }
    for (int axis = 0; axis < 3; axis++) {
        center_mm[axis] = w.from[axis] + 0.5 * (enter + leave) * w.unit[axis];
    }
    return SF_OK;
}
