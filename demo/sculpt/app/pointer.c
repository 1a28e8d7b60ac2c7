// SPDX-License-Identifier: MIT
// The pointer: what it is over, and what its buttons do.

#include "pointer.h"

#include <math.h>
#include <string.h>

#include "stroke.h"
#include "view/pick.h"

// Places lie no farther than this beside the space, in voxels, which is farther than brushes reach.
#define BESIDE 128.0

// Where the pointer's ray crosses a plane at right angles to an axis; 0 where it does not.
static int cross_plane(const view_frame *f, const double way[3], int axis, double at, double to[3])
{
    double t = (at - f->eye[axis]) / way[axis];
    if (!(t > 0) || !isfinite(t)) {
        return 0;
    }
    for (int i = 0; i < 3; i++) {
        to[i] = f->eye[i] + t * way[i];
    }
    return 1;
}

// The ray under the pointer, as long as it comes out.
static view_frame find_ray(const editor *e, double way[3])
{
    view_frame f = view_camera_frame(&e->camera, editor_aspect(e));
    double u = e->width > 0 ? 2 * (e->x + 0.5) / e->width - 1 : 0;
    double v = e->height > 0 ? 1 - 2 * (e->y + 0.5) / e->height : 0;
    for (int i = 0; i < 3; i++) {
        way[i] = f.forward[i] + u * f.right[i] + v * f.up[i];
    }
    return f;
}

// The place below the pointer: on a sketch plane, on the shape, or on the bed.
static void find_place(editor *e)
{
    sf_lattice l = sf_sculpt_options_of(e->model).lattice;
    double way[3];
    view_frame f = find_ray(e, way);
    view_hit hit;
    double bed = l.origin_mm[2] + sf_sculpt_options_of(e->model).bed_layer * l.layer_mm;
    if (e->brush.plane >= 0 && e->has_place) {
        (void)cross_plane(&f, way, e->brush.plane, e->at_mm[e->brush.plane], e->at_mm);
    } else if (view_pick(e->base, f.eye, way, &hit)) {
        memcpy(e->at_mm, hit.at_mm, sizeof e->at_mm);
        e->has_place = 1;
    } else {
        e->has_place = cross_plane(&f, way, 2, bed, e->at_mm);
    }
    const double pitch[3] = {l.pitch_x_mm, l.pitch_y_mm, l.layer_mm};
    int32_t *const parts[3] = {&e->place.x, &e->place.y, &e->place.z};
    const uint32_t counts[3] = {l.nx, l.ny, l.nz};
    for (int i = 0; i < 3 && e->has_place; i++) {
        double at = floor((e->at_mm[i] - l.origin_mm[i]) / pitch[i]);
        *parts[i] = (int32_t)fmax(-BESIDE, fmin(counts[i] + BESIDE, at));
    }
}

static void to_unit(const double from[3], double to[3])
{
    double length = sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]);
    for (int i = 0; i < 3; i++) {
        to[i] = from[i] / length;
    }
}

static desk_pointer desk_pointer_of(const editor *e, unsigned mods)
{
    desk_pointer p;
    double way[3];
    view_frame f = find_ray(e, way);
    memcpy(p.eye_mm, f.eye, sizeof p.eye_mm);
    to_unit(way, p.along);
    to_unit(f.forward, p.forward);
    to_unit(f.right, p.right);
    to_unit(f.up, p.up);
    p.spread = 2 * tan(0.5 * e->camera.fov) / (e->height > 0 ? e->height : 1);
    p.mods = mods;
    return p;
}

void pointer_find(editor *e)
{
    desk *d = editor_desk(e);
    if (d == NULL) {
        find_place(e);
    } else if (e->drag == DRAG_NONE) {
        desk_pointer p = desk_pointer_of(e, 0);
        d->is->hover(d, &p);
    }
}

static void turn_camera(editor *e, double dx, double dy)
{
    double scale = 1.0 / (e->height > 0 ? e->height : 1);
    if (e->drag == DRAG_ORBIT) {
        view_camera_orbit(&e->camera, -4 * dx * scale, 4 * dy * scale);
    } else if (e->drag == DRAG_PAN) {
        view_camera_pan(&e->camera, 2 * dx * scale / editor_aspect(e), -2 * dy * scale,
                        editor_aspect(e));
    } else if (e->drag == DRAG_ZOOM) {
        view_camera_zoom(&e->camera, exp(3 * dy * scale));
    }
}

void pointer_move(editor *e, const app_event *event)
{
    double dx = event->x - e->x, dy = event->y - e->y;
    e->x = event->x;
    e->y = event->y;
    turn_camera(e, dx, dy);
    pointer_find(e);
    if (e->drag != DRAG_STROKE) {
        return;
    }
    if (editor_desk(e) != NULL) {
        desk_pointer p = desk_pointer_of(e, event->mods);
        editor_desk(e)->is->drag(editor_desk(e), &p);
    } else {
        editor_stroke_on(e);
    }
}

void pointer_press(editor *e, const app_event *event)
{
    e->x = event->x;
    e->y = event->y;
    if (editor_desk(e) == NULL) {
        find_place(e);
    }
    if (e->drag != DRAG_NONE) {
        return;
    }
    e->button = event->code;
    int turns =
        event->code == BUTTON_RIGHT || (event->code == BUTTON_LEFT && (event->mods & MOD_ALT) != 0);
    if (turns) {
        e->drag = (event->mods & MOD_SHIFT) != 0     ? DRAG_PAN
                  : (event->mods & MOD_CONTROL) != 0 ? DRAG_ZOOM
                                                     : DRAG_ORBIT;
    } else if (event->code == BUTTON_MIDDLE) {
        e->drag = DRAG_PAN;
    } else if (editor_desk(e) != NULL) {
        desk_pointer p = desk_pointer_of(e, event->mods);
        e->drag = DRAG_STROKE;
        editor_desk(e)->is->press(editor_desk(e), &p);
    } else if (e->has_place) {
        editor_stroke_begin(e, event->mods);
    }
}

void pointer_release(editor *e, const app_event *event)
{
    if (event->code != e->button) {
        return; // another one, which began nothing
    }
    if (e->drag == DRAG_STROKE && editor_desk(e) != NULL) {
        editor_desk(e)->is->release(editor_desk(e));
    } else if (e->drag == DRAG_STROKE) {
        editor_stroke_end(e);
    }
    e->drag = DRAG_NONE;
}
